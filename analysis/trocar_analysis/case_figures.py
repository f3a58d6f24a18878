"""Figures of cases as `sensitivity`, `rank` and `front` take them: a column of /cases, or a quotient of two, with the way
that is better and failed cases as the worst value there is."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import pandas as pd

from .changes import metric_of
from .errors import InputError
from .missing import reasons
from .options import option_columns
from .provenance import is_time, origins, warning
from .store import CONDITIONS, ResultFile
from .subject import CASES, tally
from .summary import choose_figures, only_rows

# By what cases are chosen, beside the options of their strategies.
KEYS = ("organ_facets", *CONDITIONS, "label", "strategy")

# What `sensitivity` shows when nothing is asked for, and its title: what stays inside, side effects, how far vertices
# go, time.
USUAL = {
    "tool_volume_inside_d_max/tool_volume_at_rest_max": "Tool left inside the organ, of the volume there is to clear",
    "facets_crossing_d_mean": "Organ facets that cross the tool's surface",
    "displacement_mean_mean": "How far handling moves a collided vertex",
    "time_cycle_p50": "Time of a cycle",
}
COUNTED = {"facets_crossing": "facets"}  # what a figure without a unit is a number of


@dataclass(frozen=True)
class Cases:
    """The cases of a result file that a user has chosen."""

    path: str
    table: pd.DataFrame  # /cases
    units: dict[str, str]  # of its columns
    words: dict[str, str]  # what its columns are
    origin: pd.DataFrame  # how each was run, with the table's index

    def cautions(self, figures: Iterable[Figure], used: pd.Index | None = None) -> list[str]:
        """What to say of times where the figures hold some: of the cases `used`, or of all."""
        if not any(is_time(part) for figure in figures for part in figure.name.split("/")):
            return []
        return warning(self.origin.loc[self.table.index if used is None else used])


@dataclass(frozen=True)
class Figure:
    """One figure of each case."""

    name: str  # as it is asked for
    title: str
    unit: str  # "%" of a quotient of equal units
    counted: str  # what it is a number of, where it has no unit
    better: str  # "low", "high" or "neither"
    values: pd.Series  # of each case, in `unit`; a failed case has the worst there is; NaN where there is none
    lacking: str  # how many complete cases have no value, and why; "" when all have one


def read_cases(path: str, only: list[str]) -> Cases:
    """The cases of a file that match the filters `only` (see only_rows), which may be of options, too."""
    with ResultFile(path) as results:
        cases, provenance = results.cases_table(), results.provenance_table()
        units, words = results.units(), results.long_names()
    if cases.empty:
        raise InputError(f"{path}: has no cases")
    if missing := {"organ", "seed"} - {*cases}:
        raise InputError(f"{path}: is damaged: /cases has no column {', '.join(sorted(missing))}")
    origin, options = origins(cases, provenance, path), option_columns(cases, path)
    keys = [name for name in (*KEYS, *options) if name in cases or name in options]
    chosen = only_rows(cases.join(options), only, keys).index
    return Cases(path, cases.loc[chosen], units, words, origin.loc[chosen])


def judged_figure(name: str, cases: Cases, better: dict[str, str]) -> Figure:
    """One figure of which one way is better. InputError for a metric that has several columns, and for a figure of
    which neither way is."""
    if "/" not in name and name not in cases.table:
        columns = choose_figures(cases.table, [name], CASES)
        if len(columns) > 1:
            raise InputError(f"{name} has several columns; say which: {', '.join(columns)}")
        (name,) = columns
    figure = figure_of(name, cases.table, cases.units, better)
    if figure.better not in ("low", "high"):
        raise InputError(
            f"{name}: neither way is better, so no strategy is; take a figure of a metric of which `trocar list "
            "metrics` says low or high"
        )
    return figure


def figure_of(name: str, cases: pd.DataFrame, units: dict[str, str], better: dict[str, str]) -> Figure:
    """A column, or a quotient of two. Where neither way is better, a failed case has no value."""
    column, _, divisor = name.partition("/")
    for part in filter(None, (column, divisor)):
        choose_figures(cases, [part], CASES)  # says what is wrong with a name
        if part not in cases:
            raise InputError(f"a quotient is of two columns, and '{part}' in '{name}' is a metric; say {part}_…")
    values, unit = cases[column].astype(float), units.get(column, "")
    if divisor:
        below = cases[divisor].astype(float)
        values, unit = values / below.where(below != 0), f"{unit or '1'}/{units.get(divisor, '') or '1'}"
        if units.get(column) == units.get(divisor):
            values, unit = 100 * values, "%"
    metric = metric_of(column)
    direction = better.get(metric, "neither")
    worst = {"low": np.inf, "high": -np.inf}.get(direction, np.nan)
    is_complete = cases["status"] == "complete"
    lacking = lacking_words(name, cases[is_complete], values[is_complete])
    values = values.where(is_complete, worst)
    return Figure(name, USUAL.get(name, name), unit, COUNTED.get(metric, "1"), direction, values, lacking)


def lacking_words(name: str, complete: pd.DataFrame, values: pd.Series) -> str:
    column, _, divisor = name.partition("/")
    without = complete[values.isna()]
    if without.empty:
        return ""
    divides = without[column].notna()  # then it is the divisor that is NaN or 0
    why = reasons(without[~divides], CASES.name_of(column))
    if divides.any():
        why[f"no {divisor} to divide by"] = int(divides.sum())
    said = tally(why) if len(why) > 1 else next(iter(why))
    return f"{name}: no value in {len(without)} of {len(complete)} complete cases ({said})"


def pooled_words(cases: pd.DataFrame, names: Iterable[str]) -> str:
    """Such as "3 organs, 5 seeds": those of these columns that have several values."""
    several = [name for name in names if name in cases and cases[name].nunique() > 1]
    return ", ".join(f"{cases[name].nunique()} {plural(name)}" for name in several)


def plural(name: str) -> str:
    return name if name.endswith("s") else f"{name}s"
