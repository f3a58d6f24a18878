"""The layout of a summary: an aligned table, or Markdown."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pandas as pd

from .subject import Subject

ABSENT = "–"
INCOMPARABLE = "†"  # behind the name of a figure whose values cannot be compared with each other
ROUNDING = 1e-12  # no figure of ours is that small, in its unit or ns, but by rounding; --csv has it in full


@dataclass
class Column:
    """One column of the table that people read. A cell is its value and what follows it, which may be ""."""

    title: tuple[str, str]  # what stands on the first and on the second line of the header
    unit: str
    is_text: bool
    cells: list[tuple[str, str]]


def render(
    summary: pd.DataFrame, keys: list[str], figures: list[str], units: dict[str, str], subject: Subject,
    heading: list[str], notes: list[str], style: str, width: int | None
) -> str:  # fmt: skip
    """A summary for people, in the style "text" or "markdown". Text has `heading` above it; both have `notes`, why
    figures do not exist, below. `width` is the terminal's, in characters: quartiles are left out of a text table
    that would be wider. None: any width fits."""
    columns = lay_out(summary, keys, figures, units, subject)
    if style == "markdown":
        return markdown(columns) + "".join(["\n", *(f"- {note}\n" for note in notes)] if notes else [])
    lines = aligned(columns, with_quartiles=True)
    fits = width is None or max(map(len, lines)) <= width
    if not fits:
        lines = aligned(columns, with_quartiles=False)
    what = "Median (lower–upper quartile)" if fits else "Median"
    above = [*heading, f"{what} over the {subject.usable}.", ""]
    below = ["", *notes] if notes else []
    return "\n".join([*above, *lines, *below, ""])


def lay_out(
    summary: pd.DataFrame, keys: list[str], figures: list[str], units: dict[str, str], subject: Subject
) -> list[Column]:
    """The summary's columns for people: keys, number of cases and of failures, or of states, then one column per
    figure, whose name is marked where its values are not `comparable`."""
    groups = summary[summary["metric"] == figures[0]]
    columns = []
    for key in keys:
        title = "strategy" if key == "label" and "strategy" not in keys else key
        is_text = not pd.api.types.is_numeric_dtype(groups[key])
        cells = [(number(value), "") for value in groups[key]]
        columns.append(Column((title, ""), units.get(key, ""), is_text, cells))
    columns += count_columns(groups)
    for name in figures:
        rows = summary[summary["metric"] == name]
        unit, factor = readable_unit(units.get(name, ""), rows)
        parts = subject.name_of(name)
        shown = name if rows["comparable"].all() else name + INCOMPARABLE
        title = (parts.metric, shown.removeprefix(parts.metric)) if parts else (shown, "")
        cells = [figure_cell(row, factor) for _, row in rows.iterrows()]
        columns.append(Column(title, unit, False, cells))
    return columns


def count_columns(groups: pd.DataFrame) -> list[Column]:
    if "states" in groups:
        return [Column(("states", ""), "", False, [(str(count), "") for count in groups["states"]])]
    failures = zip(groups["failed"], groups["failures"])
    failed = [(str(count), f"({how})" if how else "") for count, how in failures]
    return [
        Column(("cases", ""), "", False, [(str(count), "") for count in groups["cases"]]),
        Column(("failed", ""), "", False, failed),
    ]


def readable_unit(unit: str, rows: pd.DataFrame) -> tuple[str, float]:
    """The unit to print a column in, and the factor to it: times in ns become µs or ms."""
    if unit != "ns":
        return unit, 1
    return ("ms", 1e-6) if rows["median"].max() >= 1e6 else ("µs", 1e-3)


def figure_cell(row: pd.Series, factor: float) -> tuple[str, str]:
    missing = f" [{row['nan']} NaN]" if row["nan"] else ""
    if math.isnan(row["median"]):
        return ABSENT + missing, ""
    median, q1, q3 = (number(row[name] * factor) for name in ("median", "q1", "q3"))
    return median + missing, "" if q1 == q3 else f"({q1}–{q3})"


def number(value: object) -> str:
    """Three significant digits of a fraction; whole numbers and texts as they are. What is below ROUNDING is 0."""
    if not isinstance(value, float):
        return str(value)
    if math.isnan(value):
        return ABSENT
    if abs(value) < ROUNDING:
        return "0"
    if value.is_integer() or abs(value) >= 1000:
        return f"{value:.0f}"
    return f"{value:.3g}"


def in_one_line(said: str) -> str:
    """Text that a file holds, such as the message of an exception, as the terminal may have it."""
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in " ".join(said.split()))


def aligned(columns: list[Column], with_quartiles: bool) -> list[str]:
    """The table's lines. An empty line parts the groups of the first key where they have several rows."""
    blocks = []
    for column in columns:
        value_width = max(len(value) for value, _ in column.cells)
        rest_width = max(len(rest) for _, rest in column.cells) if with_quartiles else 0
        body = [
            pad(value, value_width, column.is_text) + (f" {rest:<{rest_width}}" if rest_width else "")
            for value, rest in column.cells
        ]
        lines = [*column.title, column.unit, *body]
        width = max(map(len, lines))
        blocks.append([pad(line, width, column.is_text) for line in lines])
    lines = ["  ".join(parts).rstrip() for parts in zip(*blocks)]
    head, body = [line for line in lines[:3] if line], lines[3:]
    first = [value for value, _ in columns[0].cells]
    starts = [row for row in range(1, len(first)) if first[row] != first[row - 1]]
    if len(starts) < len(first) - 1:
        for row in reversed(starts):
            body.insert(row, "")
    return [*head, "─" * max(map(len, lines)), *body]


def pad(line: str, width: int, left: bool) -> str:
    return line.ljust(width) if left else line.rjust(width)


def markdown(columns: list[Column]) -> str:
    titles = ["".join(column.title) + (f", {column.unit}" if column.unit else "") for column in columns]
    rules = ["---" if column.is_text else "---:" for column in columns]
    rows = zip(*(column.cells for column in columns))
    body = [[" ".join(filter(None, cell)).replace("|", "\\|") for cell in row] for row in rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in [titles, rules, *body])
