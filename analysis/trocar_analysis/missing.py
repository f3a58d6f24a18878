"""Why figures do not exist."""

from __future__ import annotations

from collections import Counter

import pandas as pd

from .store import read_reasons
from .subject import Name, Subject, tally


def reasons(rows: pd.DataFrame, name: Name | None) -> dict[str, int]:
    """Why `rows`, none of which has a value for a figure, have none, and how many of them; frequent ones first."""
    nothing, unknown = [""] * len(rows), [None] * len(rows)
    told = zip(rows.get("missing", nothing), rows.get("metrics", nothing), rows.get("window_steps", unknown))
    counts: Counter[str] = Counter()
    for said, count in Counter(told).items():
        counts[reason(*said, name)] += count
    return dict(counts.most_common())


def reason(missing: str, metrics: str, window_steps: int | None, name: Name | None) -> str:
    """Of one row, which has `missing`, `metrics` and `window_steps` in the columns of these names."""
    if window_steps == 0:
        return "the tool meets the organ at rest in no step"
    if name is None:
        return "no reason recorded"
    if known := read_reasons(missing).get(name.series):
        return " and ".join(known)
    is_off = metrics not in ("", "all") and name.metric not in metrics.replace(" ", "").split(",")
    return "the metric was off" if is_off and not name.metric.startswith("time_") else "no reason recorded"


def notes(rows: pd.DataFrame, figures: list[str], subject: Subject) -> list[str]:
    """What to say below a table of `figures` over `rows`: which do not exist in how many rows, and why. Figures of one
    series that lack the same rows share a line."""
    lacking: dict[tuple[str, tuple], list[str]] = {}
    for column in figures:
        if (is_nan := rows[column].isna()).any():
            lacking.setdefault((series_of(column, subject), tuple(rows.index[is_nan])), []).append(column)
    if not lacking:
        return []
    lines = [f"NaN: {subject.usable} in which a figure does not exist; the median is over the others."]
    for (series, where), columns in lacking.items():
        shown = [column for column in figures if series_of(column, subject) == series]
        what = series if columns == shown else ", ".join(columns)
        why = reasons(rows.loc[list(where)], subject.name_of(columns[0]))
        said = tally(why) if len(why) > 1 else next(iter(why))
        lines.append(f"{what}: no value in {len(where)} of {len(rows)} {subject.usable} ({said})")
    return lines


def series_of(column: str, subject: Subject) -> str:
    name = subject.name_of(column)
    return name.series if name else column
