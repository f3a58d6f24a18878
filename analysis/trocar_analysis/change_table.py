"""The layout of a comparison, and what is said below it."""

from __future__ import annotations

import numpy as np
import pandas as pd

from .changes import FEW_SEEDS, values_of
from .paired import FEWEST_SEEDS, LEVEL, RESAMPLES
from .pairing import Pairing, listed
from .table import ABSENT, INCOMPARABLE, Column, number, readable_unit


def lay_out(summary: pd.DataFrame, keys: list[str]) -> list[Column]:
    """The summary's columns for people."""
    factors = {}
    for figure, rows in summary.groupby("metric"):
        finite = rows.rename(columns={"median_a": "median"})
        factors[figure] = readable_unit(rows["units"].iloc[0], finite)
    rows = [row for _, row in summary.iterrows()]
    columns = [Column(("figure", ""), "", True, [(figure_name(row, factors[row["metric"]][0]), "") for row in rows])]
    for key in keys:
        is_text = not pd.api.types.is_numeric_dtype(summary[key])
        title = "strategy" if key == "label" and "strategy" not in keys else key
        columns.append(Column((title, ""), "", is_text, [(number(row[key]), "") for row in rows]))
    columns.append(Column(("pairs", ""), "", False, [(str(row["pairs"]), left_out(row)) for row in rows]))
    for title, name in (("median A", "median_a"), ("median B", "median_b")):
        cells = [(amount(row[name] * factors[row["metric"]][1], ""), "") for row in rows]
        columns.append(Column((title, ""), "", False, cells))
    columns.append(Column(("B − A", ""), "", False, [change_cell(row, factors[row["metric"]][1]) for row in rows]))
    columns.append(Column(("change", ""), "", False, [(percent(row["relative"]), "") for row in rows]))
    columns.append(Column(("p", ""), "", False, [(p_text(row["p"]), "") for row in rows]))
    columns.append(Column(("verdict", ""), "", True, [(row["verdict"], "") for row in rows]))
    return columns


def figure_name(row: pd.Series, unit: str) -> str:
    mark = "" if row["comparable"] else INCOMPARABLE
    return f"{row['metric']}{mark}, {unit}".removesuffix(", ")


def left_out(row: pd.Series) -> str:
    """Beside the number of pairs: what failed, and what has no value."""
    lacking = row["no_value_a"] + row["no_value_b"] + row["no_value"]
    failed = row["failed_a"] + row["failed_b"]
    said = [f"{row['failed_a']}→{row['failed_b']} failed"] if failed else []
    said += [f"{lacking} no value"] if lacking else []
    return f"[{', '.join(said)}]" if said else ""


def change_cell(row: pd.Series, factor: float) -> tuple[str, str]:
    if np.isnan(row["difference"]):
        return ABSENT, ""
    low, high = (amount(row[name] * factor, "+") for name in ("low", "high"))
    return amount(row["difference"] * factor, "+"), "" if np.isnan(row["low"]) else f"[{low}, {high}]"


def amount(value: float, sign: str) -> str:
    """Three significant digits; with the sign "+", positive ones have one."""
    if np.isnan(value):
        return ABSENT
    before = "−" if value < 0 else sign if value > 0 else ""
    return before + ("∞" if np.isinf(value) else number(abs(float(value))))


def percent(value: float) -> str:
    return f"{amount(value, '+')} %" if np.isfinite(value) else amount(value, "+")


def p_text(p: float) -> str:
    return "<0.0001" if p < 1e-4 else amount(p, "")


def missing_lines(pairing: Pairing, figures: list[str]) -> list[str]:
    """Which completed pairs have a figure on one side only."""
    complete = (pairing.a["status"] == "complete") & (pairing.b["status"] == "complete")
    lines = []
    for figure in figures:
        a, b, _ = values_of(pairing, figure, pairing.a.index[complete], "neither")
        for side, lacks in (("A", b.isna() & a.notna()), ("B", a.isna() & b.notna())):
            if lacks.any():
                lines.append(f"{figure}: a value in {side} only: {listed([*lacks.index[lacks]])}")
    return lines


def legend(pairing: Pairing, summary: pd.DataFrame) -> list[str]:
    """How to read the table, as far as it needs it."""
    lines = [
        f"B − A: median of the paired differences and its {100 * LEVEL:.0f} % interval ({RESAMPLES:,} resamples of seeds "
        "within organs); change: in % of the median of A; p: Wilcoxon signed rank, zeros after Pratt; verdict: where "
        "the interval lies."
    ]
    if summary["zeros"].any():
        lines.append("A pair that does not differ counts as a difference of 0; equal: no pair differs.")
    if (summary["failed_a"] + summary["failed_b"]).any():
        lines.append(
            "A failed case counts as the worst value, ∞ or −∞, and equals another failed one; where neither direction "
            "is better, its pair is left out. [a→b failed]: in A and in B."
        )
    if (summary["verdict"] == FEW_SEEDS).any():
        lines.append(f"Too few seeds: an interval needs {FEWEST_SEEDS} over all organs, two or more on an organ.")
    if not summary["comparable"].all():
        lines.append(f"{INCOMPARABLE} Times are not comparable ({pairing.times}).")
    return lines
