"""Result files for an analysis of one's own, as pandas has tables. From file to plot:

    import sys; sys.path.insert(0, "analysis")        # or share/trocar/analysis of where Trocar is installed
    import matplotlib.pyplot as plt, trocar
    cases = trocar.load("out.h5")
    name = "depth_max_d_max"
    print(cases.groupby(["label", "speed"])[name].median(), cases.attrs["units"][name])
    both = trocar.pairs(cases, "nearest-face", "fuzzy-per-vertex", name)
    print(trocar.median_interval(both, "difference"), both.attrs["counts"])
    plt.scatter(both["a"], both["b"])
    plt.xlabel(f"nearest-face, {both.attrs['unit']}"); plt.ylabel(f"fuzzy-per-vertex, {both.attrs['unit']}")
    plt.savefig("pairs.png")

Every function raises ValueError, with what was expected, what was found and what to do. It needs what the analysis
needs: Debian's python3-numpy, python3-h5py, python3-pandas and python3-scipy."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pandas as pd

from trocar_analysis.case_figures import figure_of
from trocar_analysis.conditions import Estimate, condition_interval
from trocar_analysis.errors import InputError, unknown
from trocar_analysis.paired import paired_differences
from trocar_analysis.store import CONDITIONS, ResultFile, find_case

__all__ = ["load", "pairs", "series", "median_interval"]


def load(path: str | Path) -> pd.DataFrame:
    """The cases of a result file, a row each: what they were run with, `status` ("complete", or how it failed), and the
    figures, NaN where there is none. `label` is the strategy's name where the sweep gave none. In `attrs`: `units` ("" for
    plain numbers and text), `long_names`, and `file`. Which way a figure is better the file does not say; `trocar list
    metrics` does."""
    with said_to_callers(), ResultFile(path) as results:
        cases = results.cases_table()
        cases.attrs |= {"units": results.units(), "long_names": results.long_names(), "file": str(path)}
    if cases.empty:
        raise ValueError(f"{path}: has no cases")
    return cases


def pairs(cases: pd.DataFrame, a: str, b: str, metric: str) -> pd.DataFrame:
    """What strategy `b` does differently from `a`: a row per pair of cases that were run under the same conditions, seed
    included, with these conditions, `a` and `b`, the values of the figure, `difference`, which is b − a, and `case_a` and
    `case_b`.

    Pairs of which a case failed, or has no value, have no row: `attrs["counts"]` says how many of each there are. Mind them:
    a strategy that fails where it is hard would look good by the others. `attrs["metric"]` and `["unit"]` say of what it is.

    @param cases from `load`, or some rows of it
    @param a, b labels of strategies, or their names
    @param metric a column of figures, or a quotient "A/B" of two, in percent where their units are the same"""
    with said_to_callers():
        if lacking := {"label", "strategy", "status", "case_id", "seed"} - {*cases}:
            raise InputError(f"the table has no column {', '.join(sorted(lacking))}; give what trocar.load returned")
        conditions = [name for name in CONDITIONS if name in cases]
        for part in metric.split("/"):
            if part not in cases:
                raise unknown("column", part, numbers_of(cases))
            if part not in numbers_of(cases):
                raise InputError(f"{part} holds text, no figures; columns of figures are such as depth_max_d_max")
        if "units" not in cases.attrs:
            raise InputError("the table has lost its units (attrs), as pandas' merge and concat do; set table.attrs anew")
        figure = figure_of(metric, cases, cases.attrs["units"], {})
        left, right = (side(cases, name, conditions, figure.values, suffix) for name, suffix in ((a, "a"), (b, "b")))
    both = left.merge(right, on=conditions, how="inner")
    failed = {name: both[f"status_{name}"] != "complete" for name in "ab"}
    lacks = {name: both[name].isna() & ~failed[name] for name in "ab"}
    usable = ~(failed["a"] | failed["b"] | lacks["a"] | lacks["b"])
    counts = {
        "pairs": int(usable.sum()), "unpaired_a": len(left) - len(both), "unpaired_b": len(right) - len(both),
        "failed_a": int(failed["a"].sum()), "failed_b": int(failed["b"].sum()),
        "no_value_a": int(lacks["a"].sum()), "no_value_b": int(lacks["b"].sum()),
    }  # fmt: skip
    table = both.loc[usable, [*conditions, "a", "b", "case_a", "case_b"]].reset_index(drop=True)
    table.insert(len(conditions) + 2, "difference", paired_differences(table["a"].to_numpy(), table["b"].to_numpy()))
    table.attrs = {"metric": metric, "unit": figure.unit, "a": a, "b": b, "counts": counts}
    return table


def median_interval(table: pd.DataFrame, column: str) -> Estimate:
    """The median of a column and its 95 % bootstrap interval, seeds drawn within organs, as trocar compare and the other
    commands have it; the interval is NaN where there are fewer than 12 seeds over all organs. Cases without a value are left
    out. The table needs `organ` and `seed`."""
    with said_to_callers():
        if lacking := {"organ", "seed", column} - {*table}:
            raise InputError(f"the table has no column {', '.join(sorted(lacking))}")
    known = table.dropna(subset=[column])
    return condition_interval(*(known[name].to_numpy() for name in (column, "organ", "seed")))


def series(path: str | Path, case_id: str) -> pd.DataFrame:
    """What was measured in each step of a case: a row per step, its index `time` (of the step's end, in s), a column per
    series, NaN where there is no value. In `attrs`: `units`, `long_names`, `missing` (of each series that lacks values: reason
    → ranges of steps from 0, both ends included), `case_id` and `file`.

    @param case_id or the beginning of one that no other case shares"""
    with said_to_callers(), ResultFile(path) as results:
        case = str(find_case(results.cases_table(), case_id)["case_id"])
        stored = results.case_series(case)
        if "time" not in stored.names:
            raise InputError(
                f"{path}: has no series of case {case}: it failed before its first step, or the file holds tables only "
                "(trocar merge --tables-only)"
            )
        words = {name: results.series_words(case, name) for name in stored.names}
        missing = {name: results.missing_steps(case, name) for name, said in zip(stored.names, stored.missing) if said}
    table = pd.DataFrame(dict(zip(stored.names, stored.values))).set_index("time")
    table.attrs = {
        "units": {name: unit for name, (unit, _) in words.items()},
        "long_names": {name: said for name, (_, said) in words.items()},
        "missing": missing, "case_id": case, "file": str(path),
    }  # fmt: skip
    return table


def side(cases: pd.DataFrame, name: str, conditions: list[str], values: pd.Series, suffix: str) -> pd.DataFrame:
    """The cases of one strategy: conditions, value, status and id, the last three called after the side. InputError where
    there is none, and where it has two under one condition."""
    chosen = cases["label"] == name
    if not chosen.any():
        chosen = cases["strategy"] == name
    if not chosen.any():
        raise unknown("strategy", name, {*cases["label"], *cases["strategy"]})
    own = cases[chosen]
    if (again := own.duplicated(conditions, keep=False)).any():
        first, second, *_ = own.loc[again].sort_values(conditions, kind="stable")["case_id"]
        raise InputError(
            f"{name}: cases {first} and {second} were run under the same conditions; take rows of which that is not so, "
            "of one label for example"
        )
    return own[conditions].assign(
        **{suffix: values[own.index], f"status_{suffix}": own["status"], f"case_{suffix}": own["case_id"]}
    )


def numbers_of(cases: pd.DataFrame) -> list[str]:
    return [name for name in cases if pd.api.types.is_numeric_dtype(cases[name]) and name not in CONDITIONS]


@contextmanager
def said_to_callers() -> Iterator[None]:
    """The analysis' own error is for its command line; callers know ValueError."""
    try:
        yield
    except InputError as error:
        raise ValueError(str(error)) from None
