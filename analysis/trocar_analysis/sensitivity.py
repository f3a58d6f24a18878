"""`sensitivity`: what one condition of the cases, such as the speed, does to each strategy: medians and intervals of
figures at each of its values, as a table; sensitivity_plot.py draws them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from .changes import metric_of
from .conditions import condition_interval
from .errors import InputError, unknown
from .missing import reasons
from .provenance import is_time, origins, warning
from .store import CONDITIONS, ResultFile
from .subject import CASES, tally
from .summary import choose_figures, groups_in_order, only_rows
from .table import number

# What may be swept: what a case is run with, but for its strategy and its seed.
SWEPT = tuple(name for name in ("organ_facets", *CONDITIONS) if name != "seed")

# What is shown when nothing is asked for, and its title: what stays inside, side effects, how far vertices go, time.
USUAL = {
    "tool_volume_inside_d_max/tool_volume_at_rest_max": "Tool left inside the organ, of the volume there is to clear",
    "facets_crossing_d_mean": "Organ facets that cross the tool's surface",
    "displacement_mean_mean": "How far handling moves a collided vertex",
    "time_cycle_p50": "Time of a cycle",
}
COUNTED = {"facets_crossing": "facets"}  # what a figure without a unit is a number of


@dataclass(frozen=True)
class Wishes:
    """What a user asks of `sensitivity`."""

    over: str  # the swept column
    metrics: list[str] | None = None  # columns, metrics, or quotients "a/b" of two columns
    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"


@dataclass(frozen=True)
class Figure:
    """What one row of panels shows."""

    name: str  # as it is asked for
    title: str
    unit: str  # "%" of a quotient of equal units
    counted: str  # what it is a number of, where it has no unit
    better: str  # "low", "high" or "neither"
    values: pd.Series  # of each case, in `unit`; a failed case has the worst there is; NaN where there is none
    lacking: str  # how many complete cases have no value, and why; "" when all have one


@dataclass(frozen=True)
class Sweep:
    """What is drawn and tabulated."""

    over: str
    over_words: str  # what it is
    units: dict[str, str]  # of the columns of `cases`
    panels: list[str]  # columns of `points` that tell panels apart: the release, or none
    lines: list[str]  # … and lines: the label, and the speed where there are several
    figures: list[Figure]
    points: pd.DataFrame  # see points_of
    cases: pd.DataFrame  # that it is made from
    along: list[str]  # other conditions that vary, and have one value for each of the swept one
    cautions: list[str]  # what to say of times


def read_sweep(path: str, asked: Wishes) -> Sweep:
    """The figures of a result file's cases over the values of a condition. InputError for a condition that there is
    not, or that does not vary, and for a metric that the file lacks."""
    with ResultFile(path) as results:
        cases, provenance = results.cases_table(), results.provenance_table()
        units, words = results.units(), results.long_names()
    if cases.empty:
        raise InputError(f"{path}: has no cases")
    if missing := {"organ", "seed"} - {*cases}:
        raise InputError(f"{path}: is damaged: /cases has no column {', '.join(sorted(missing))}")
    origin = origins(cases, provenance, path)
    cases = only_rows(cases, asked.only, [name for name in (*SWEPT, "seed", "label", "strategy") if name in cases])
    over = asked.over
    check_varies(path, cases, over, units)
    figures = choose(path, cases, asked, units)
    panels = [name for name in ("release",) if name in cases and name != over]
    lines = ["label", *(name for name in ("speed",) if name != over and name in cases and cases[name].nunique() > 1)]
    has_times = any(is_time(figure.name) for figure in figures)
    return Sweep(
        over, words.get(over, over), units, panels, lines, figures,
        points_of(cases, [*panels, over, *lines], figures), cases, along_with(cases, over, {*panels, *lines}),
        warning(origin.loc[cases.index]) if has_times else [],
    )  # fmt: skip


def check_varies(path: str, cases: pd.DataFrame, over: str, units: dict[str, str]) -> None:
    known = [name for name in SWEPT if name in cases]
    if over not in known:
        raise unknown("column to sweep over", over, known)
    if cases[over].nunique() > 1:
        return
    varying = [name for name in known if cases[name].nunique() > 1]
    value = f"{number(cases[over].iloc[0])} {units.get(over, '')}".strip()
    raise InputError(
        f"{path}: {over} is {value} in all cases; "
        + (f"these vary: {', '.join(varying)}" if varying else "no condition varies: run a sweep of several values")
    )


def choose(path: str, cases: pd.DataFrame, asked: Wishes, units: dict[str, str]) -> list[Figure]:
    """The figures that are asked for, else those of USUAL that the file has."""
    names = []
    for name in asked.metrics or [name for name in USUAL if {*name.split("/")} <= {*cases}]:
        names += [name] if "/" in name else choose_figures(cases, [name], CASES)
    if not names:
        raise InputError(f"{path}: has none of the usual figures; name one with --metric")
    return [figure_of(name, cases, units, asked.better) for name in dict.fromkeys(names)]


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


def points_of(cases: pd.DataFrame, keys: list[str], figures: list[Figure]) -> pd.DataFrame:
    """One row per figure and group of cases: the keys; `metric`, `units` and `better` of the figure; `cases` of the
    group, how many of them `failed`, and how many complete ones have `no_value`; of the others, failed ones as the
    worst value there is, `median`, and `low` and `high` of its interval (see condition_interval); NaN where there is
    none."""
    rows = []
    groups = groups_in_order(cases, keys)
    for figure in figures:
        for values, group in groups:
            of_group = figure.values.loc[group.index]
            known = of_group.dropna()
            is_complete = group["status"] == "complete"
            where = group.loc[known.index]
            estimate = condition_interval(known.to_numpy(), where["organ"].to_numpy(), where["seed"].to_numpy())
            rows.append(
                dict(zip(keys, values))
                | {"metric": figure.name, "units": figure.unit, "better": figure.better, "cases": len(group),
                   "failed": int((~is_complete).sum()), "no_value": int((of_group.isna() & is_complete).sum()),
                   "median": estimate.median, "low": estimate.low, "high": estimate.high}
            )  # fmt: skip
    return pd.DataFrame(rows)


def along_with(cases: pd.DataFrame, over: str, told_apart: set[str]) -> list[str]:
    others = [name for name in SWEPT if name in cases and name not in {over, *told_apart}]
    return [name for name in others if cases[name].nunique() > 1 and cases.groupby(over)[name].nunique().eq(1).all()]
