"""`show --failures`: the cases that did not complete, one a line."""

from __future__ import annotations

import pandas as pd

from .subject import tally
from .table import Column, aligned, in_one_line, markdown, number

SHOWN = ("status", "label", "organ", "tool", "scene", "speed", "seed", "release", "case_id", "reason")
ORDER = ("status", "label", "organ", "tool", "scene", "speed", "release", "seed")


def failures_text(path: str, cases: pd.DataFrame, units: dict[str, str], style: str) -> str:
    """What `show --failures` prints of these cases, in the style "text", "markdown" or "csv"."""
    failed = cases[cases["status"] != "complete"]
    failed = failed.sort_values([name for name in ORDER if name in failed], kind="stable")
    failed = failed[[name for name in SHOWN if name in failed]]
    if style == "csv":
        return failed.to_csv(index=False)
    if failed.empty:
        return f"{path}: {len(cases)} cases, no failures\n"
    columns = []
    for name in failed:
        cells = [(in_one_line(number(value)), "") for value in failed[name]]
        is_text = not pd.api.types.is_numeric_dtype(failed[name])
        columns.append(Column((name, ""), units.get(name, ""), is_text, cells))
    if style == "markdown":
        return markdown(columns)
    heading = f"{path}: {len(cases)} cases, {len(failed)} failed"
    return "\n".join([heading, *counts(failed), "", *aligned(columns, with_quartiles=False), ""])


def counts(failed: pd.DataFrame) -> list[str]:
    """A line for each status: how many, and how many of each label."""
    lines = []
    for status, group in failed.groupby("status", sort=False):
        lines.append(f"{len(group)} {status}: {tally(group['label'].value_counts().to_dict())}")
    return lines
