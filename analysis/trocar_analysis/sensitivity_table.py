"""A sweep's points as a table, and the notes that stand below it and below its picture."""

from __future__ import annotations

import numpy as np
import pandas as pd
from pandas.api.types import is_numeric_dtype

from .case_figures import pooled_words
from .sensitivity import Sweep
from .store import CONDITIONS
from .table import Column, markdown, number, readable_unit


def notes(sweep: Sweep) -> list[str]:
    """What is said below the picture and the table."""
    points, cases = sweep.points, sweep.cases
    counts = points["cases"]
    n = f"{counts.min()}" if counts.min() == counts.max() else f"{counts.min()} to {counts.max()}"
    apart = {sweep.over, *sweep.panels, *sweep.lines, *sweep.along}
    of = pooled_words(cases, [name for name in CONDITIONS if name not in apart])
    said = [f"A point is the median over n = {n} cases" + (f" ({of})" if of else "") + "; " + interval_words(points)]
    failed = int((cases["status"] != "complete").sum())
    said.append(
        f"{failed} of {len(cases)} cases failed: points with some of them have a ×; a failed case counts as the worst "
        "value there is, at the panel's edge, and is left out where neither way is better."
        if failed else f"None of the {len(cases)} cases failed."
    )  # fmt: skip
    said += [f"{figure.lacking}." for figure in sweep.figures if figure.lacking]
    return said + [f"{along_words(sweep, name)}." for name in sweep.along] + sweep.cautions


def along_words(sweep: Sweep, name: str) -> str:
    values = sweep.cases.sort_values(sweep.over, kind="stable")[name]
    if is_numeric_dtype(values):
        said = f"from {number(values.min())} to {number(values.max())} {sweep.units.get(name, '')}".rstrip()
    else:
        said = ", ".join(values.unique())
    return f"Along with {sweep.over} goes {name}: {said}"


def interval_words(points: pd.DataFrame) -> str:
    without = points["low"].isna().sum()
    if without == len(points):
        return "too few seeds for intervals."
    exceptions = f" ({without} of the {len(points)} points have too few seeds for one)" if without else ""
    return f"its bar the 95 % bootstrap interval, seeds drawn within organs{exceptions}."


def csv_text(sweep: Sweep) -> str:
    """The points, in full precision and the stored unit, quotients in percent."""
    return sweep.points.to_csv(index=False)


def markdown_text(sweep: Sweep) -> str:
    """The points, one row per group and one column per figure: the median and its interval."""
    keys = [*sweep.panels, sweep.over, *sweep.lines]
    groups = sweep.points[sweep.points["metric"] == sweep.figures[0].name]
    columns = [
        Column(("strategy" if key == "label" else key, ""), sweep.units.get(key, ""), not is_numeric_dtype(groups[key]),
               [(number(value), "") for value in groups[key]])
        for key in keys
    ]  # fmt: skip
    columns += [
        Column((name, ""), "", False, [(str(count), "") for count in groups[name]]) for name in ("cases", "failed")
    ]
    for figure in sweep.figures:
        rows = sweep.points[sweep.points["metric"] == figure.name]
        unit, factor = shown_unit(figure.unit, rows)
        cells = [cell(row["median"] * factor, row["low"] * factor, row["high"] * factor) for _, row in rows.iterrows()]
        columns.append(Column((figure.name, ""), unit, False, cells))
    return markdown(columns) + "\n" + "".join(f"- {note}\n" for note in notes(sweep))


def shown_unit(unit: str, rows: pd.DataFrame) -> tuple[str, float]:
    """The unit that people read, and the factor to it (see readable_unit)."""
    return readable_unit(unit, rows[np.isfinite(rows["median"])])


def cell(median: float, low: float, high: float) -> tuple[str, str]:
    return said(median), "" if np.isnan(low) else f"({said(low)}–{said(high)})"


def said(value: float) -> str:
    return number(value).replace("inf", "∞")
