"""Groups rows and summarises each figure over a group: of cases, over the complete ones."""

from __future__ import annotations

import numpy as np
import pandas as pd

from .errors import InputError, unknown
from .missing import reasons
from .store import CONDITIONS
from .subject import Subject, tally
from .table import ABSENT

NOTHING = {ABSENT, "nan"}  # what cells without a value say
PERCENTILES = {"median": 50, "q1": 25, "q3": 75, "min": 0, "max": 100}


def only_rows(rows: pd.DataFrame, filters: list[str], keys: list[str]) -> pd.DataFrame:
    """The rows that match "key=value" filters, as `trocar run --only` has them: filters of one key are
    alternatives, different keys must all match. A strategy goes by its name or its label. `keys`: those that a
    wrong one is compared with."""
    allowed: dict[str, list[str]] = {}
    for text in filters:
        key, equals, value = text.partition("=")
        if not equals:
            raise InputError(f"--only {text}: expected key=value, such as speed=100")
        if key not in rows:
            raise unknown("key", key, keys)
        allowed.setdefault(key, []).append(value)
    every_row = rows
    for key, values in allowed.items():
        texts = every_row[key].map(lambda cell: f"{cell:g}" if isinstance(cell, float) else str(cell))
        labels = every_row[key.replace("strategy", "label")] if key in ("strategy", "run_strategy") else texts
        known = {*texts, *labels} - NOTHING
        for value in values:
            if value not in known:
                raise unknown(key, value, sorted(known))
        matches = texts.isin(values) | labels.isin(values)
        rows = rows[matches[rows.index]]
        if rows.empty:
            raise InputError(f"--only {key}={' or '.join(values)}: nothing matches this and the filters before it")
    return rows


def choose_keys(rows: pd.DataFrame, asked: list[str] | None, keys: list[str]) -> list[str]:
    """The columns to group by, of which a wrong one is compared with `keys`. When none are asked for: speed, other conditions that differ, and the
    label, so that strategies under equal conditions stand below each other."""
    if asked:
        for name in asked:
            if name not in rows:
                raise unknown("column or option", name, keys)
        return list(dict.fromkeys(asked))
    differing = [
        name
        for name in CONDITIONS
        if name in rows and name != "seed" and (name == "speed" or rows[name].nunique() > 1)
    ]
    return [*differing, "label"]


def choose_figures(rows: pd.DataFrame, asked: list[str] | None, subject: Subject) -> list[str]:
    """The columns to summarise. A name is a column's, or a metric's (with or without its moment): then all of
    its columns; if it is both, as order_spread_mean is, all of these. When none is asked for: the usual ones that
    the file has."""
    numbers = [name for name in rows if pd.api.types.is_numeric_dtype(rows[name])]
    names = {column: metric_names(column, subject) for column in numbers if column not in subject.no_figures}
    chosen: list[str] = []
    for name in asked or subject.usual:
        found = [column for column in names if name == column or name in names[column]]
        if not found and asked:
            raise unknown("metric", name, {*names}.union(*names.values()))
        chosen += found
    return list(dict.fromkeys(chosen))


def metric_names(column: str, subject: Subject) -> set[str]:
    """The names under which a metric's column may be asked for: "depth_max", "depth_max_d"."""
    name = subject.name_of(column)
    return {name.metric, name.series} if name else set()


def summarise(
    rows: pd.DataFrame, keys: list[str], figures: list[str], units: dict[str, str], subject: Subject
) -> pd.DataFrame:
    """One row per group and figure: the keys; what the group is counted by: `cases` (all of it), `failed` (those that
    are not complete) and `failures` (how they ended), or `states` and `answers`; `metric`, `units`, `nan` (usable
    rows in which the figure does not exist), `why` (and the reasons), and over the others `median`, the
    quartiles `q1` and `q3`, `min` and `max`: NaN where there are none. Numbers are in the stored unit."""
    summary = []
    for values, group in groups_in_order(rows, keys):
        usable, counts = subject.count(group)
        for name in figures:
            numbers = usable[name].to_numpy(dtype=float)
            unknown_rows = usable[np.isnan(numbers)]
            known = numbers[~np.isnan(numbers)]
            figure = {"metric": name, "units": units.get(name, ""), "nan": len(unknown_rows)}
            figure["why"] = tally(reasons(unknown_rows, subject.name_of(name)))
            for figure_name, percent in PERCENTILES.items():
                figure[figure_name] = np.percentile(known, percent) if len(known) else np.nan
            summary.append(dict(zip(keys, values)) | counts | figure)
    return pd.DataFrame(summary)


def groups_in_order(rows: pd.DataFrame, keys: list[str]) -> list[tuple[tuple, pd.DataFrame]]:
    """Groups sorted key by key: numbers ascending, texts in the order in which the file first has them."""
    ranks = []
    for key in keys:
        values = rows[key].unique()
        if pd.api.types.is_numeric_dtype(rows[key]):
            values = np.sort(values)
        ranks.append({value: rank for rank, value in enumerate(values)})
    groups = rows.groupby(keys if len(keys) > 1 else keys[0], sort=False, dropna=False)
    named = [(values if len(keys) > 1 else (values,), group) for values, group in groups]

    def place(item: tuple[tuple, pd.DataFrame]) -> list[int]:
        return [rank.get(value, len(rank)) for rank, value in zip(ranks, item[0])]

    return sorted(named, key=place)
