"""Groups cases and summarises each figure over the complete cases of a group."""

from __future__ import annotations

import re

import numpy as np
import pandas as pd

from .errors import InputError, unknown
from .store import CONDITIONS, INPUTS, OUTCOME

DEFAULT_FIGURES = (
    "depth_max_d_max", "vertices_inside_d_max", "facets_crossing_d_mean", "displacement_mean_mean",
    "flipped_facets_mean", "fallbacks_mean", "time_handle_p50", "time_cycle_p50",
)  # fmt: skip

PERCENTILES = {"median": 50, "q1": 25, "q3": 75, "min": 0, "max": 100}

# <metric>[_<moment>]_<figure>: as columns of /cases are named.
COLUMN = re.compile(r"(?P<series>(?P<metric>.+?)(?:_[hd])?)_(mean|max|final|p50|p95|p99|over_\w+)")


def only_cases(cases: pd.DataFrame, filters: list[str]) -> pd.DataFrame:
    """The cases that match "key=value" filters, as `trocar run --only` has them: filters of one key are
    alternatives, different keys must all match."""
    allowed: dict[str, list[str]] = {}
    for text in filters:
        key, equals, value = text.partition("=")
        if not equals:
            raise InputError(f"--only {text}: expected key=value, such as speed=100")
        if key not in cases:
            raise unknown("key", key, [name for name in (*INPUTS, *OUTCOME) if name in cases])
        allowed.setdefault(key, []).append(value)
    for key, values in allowed.items():
        texts = cases[key].map(lambda cell: f"{cell:g}" if isinstance(cell, float) else str(cell))
        labels = cases["label"] if key == "strategy" else texts
        known = {*texts, *labels}
        for value in values:
            if value not in known:
                raise unknown(key, value, sorted(known))
        cases = cases[texts.isin(values) | labels.isin(values)]
        if cases.empty:
            raise InputError(f"--only {key}={' or '.join(values)}: no case matches this and the filters before it")
    return cases


def choose_keys(cases: pd.DataFrame, asked: list[str] | None) -> list[str]:
    """The columns to group by. When none are asked for: speed, other conditions that differ, and the
    label, so that strategies under equal conditions stand below each other."""
    if asked:
        for name in asked:
            if name not in cases:
                raise unknown("column", name, [name for name in (*INPUTS, *OUTCOME) if name in cases])
        return list(dict.fromkeys(asked))
    differing = [
        name
        for name in CONDITIONS
        if name in cases and name != "seed" and (name == "speed" or cases[name].nunique() > 1)
    ]
    return [*differing, "label"]


def choose_figures(cases: pd.DataFrame, asked: list[str] | None) -> list[str]:
    """The columns to summarise. A name is a column's, or a metric's (with or without its moment): then all of
    its columns. When none is asked for: those of DEFAULT_FIGURES that the file has."""
    numbers = [name for name in cases if pd.api.types.is_numeric_dtype(cases[name])]
    figures = [name for name in numbers if name not in (*INPUTS, "provenance_row")]
    if not asked:
        return [name for name in DEFAULT_FIGURES if name in figures]
    chosen: list[str] = []
    for name in asked:
        found = [name] if name in figures else [column for column in figures if name in metric_names(column)]
        if not found:
            raise unknown("metric", name, {*figures}.union(*map(metric_names, figures)))
        chosen += found
    return list(dict.fromkeys(chosen))


def metric_names(column: str) -> set[str]:
    """The names under which a metric's column may be asked for: "depth_max", "depth_max_d"."""
    match = COLUMN.fullmatch(column)
    return {match["metric"], match["series"]} if match else set()


def summarise(
    cases: pd.DataFrame, keys: list[str], figures: list[str], units: dict[str, str]
) -> pd.DataFrame:
    """One row per group and figure: the keys, `cases` (all of the group), `failed` (those that are not
    complete), `failures` (how they ended), `metric`, `units`, `nan` (complete cases in which the figure does
    not exist), and over the others `median`, the quartiles `q1` and `q3`, `min` and `max`: NaN where there
    are none. Numbers are in the stored unit."""
    rows = []
    for values, group in groups_in_order(cases, keys):
        complete = group[group["status"] == "complete"]
        failures = group.loc[group["status"] != "complete", "status"]
        head = dict(zip(keys, values))
        head |= {"cases": len(group), "failed": len(failures), "failures": tally(failures)}
        for name in figures:
            numbers = complete[name].to_numpy(dtype=float)
            known = numbers[~np.isnan(numbers)]
            figure = {"metric": name, "units": units.get(name, ""), "nan": len(numbers) - len(known)}
            for figure_name, percent in PERCENTILES.items():
                figure[figure_name] = np.percentile(known, percent) if len(known) else np.nan
            rows.append(head | figure)
    return pd.DataFrame(rows)


def tally(statuses: pd.Series) -> str:
    """Such as "2 diverged, 1 crashed"."""
    return ", ".join(f"{count} {status}" for status, count in statuses.value_counts().items())


def groups_in_order(cases: pd.DataFrame, keys: list[str]) -> list[tuple[tuple, pd.DataFrame]]:
    """Groups sorted key by key: numbers ascending, texts in the order in which the file first has them."""
    ranks = []
    for key in keys:
        values = cases[key].unique()
        if pd.api.types.is_numeric_dtype(cases[key]):
            values = np.sort(values)
        ranks.append({value: rank for rank, value in enumerate(values)})
    groups = cases.groupby(keys if len(keys) > 1 else keys[0], sort=False, dropna=False)
    named = [(values if len(keys) > 1 else (values,), group) for values, group in groups]

    def place(item: tuple[tuple, pd.DataFrame]) -> list[int]:
        return [rank.get(value, len(rank)) for rank, value in zip(ranks, item[0])]

    return sorted(named, key=place)
