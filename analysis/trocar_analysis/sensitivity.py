"""`sensitivity`: what one condition of the cases, such as the speed, does to each strategy: medians and intervals of
figures at each of its values, as a table; sensitivity_plot.py draws them."""

from __future__ import annotations

from dataclasses import dataclass, field

import pandas as pd

from .case_figures import USUAL, Figure, figure_of, read_cases
from .conditions import condition_interval
from .errors import InputError, unknown
from .store import CONDITIONS
from .subject import CASES
from .summary import choose_figures, groups_in_order
from .table import number

# What may be swept: what a case is run with, but for its strategy and its seed.
SWEPT = tuple(name for name in ("organ_facets", *CONDITIONS) if name != "seed")


@dataclass(frozen=True)
class Wishes:
    """What a user asks of `sensitivity`."""

    over: str  # the swept column
    metrics: list[str] | None = None  # columns, metrics, or quotients "a/b" of two columns
    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"


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
    chosen = read_cases(path, asked.only)
    cases, units = chosen.table, chosen.units
    over = asked.over
    check_varies(path, cases, over, units)
    figures = choose(path, cases, asked, units)
    panels = [name for name in ("release",) if name in cases and name != over]
    lines = ["label", *(name for name in ("speed",) if name != over and name in cases and cases[name].nunique() > 1)]
    return Sweep(
        over, chosen.words.get(over, over), units, panels, lines, figures,
        points_of(cases, [*panels, over, *lines], figures), cases, along_with(cases, over, {*panels, *lines}),
        chosen.cautions(figures),
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
