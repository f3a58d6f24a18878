"""A figure as a LaTeX table (booktabs): the strategies over all conditions, then over the values of each condition."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..case_figures import Cases
from ..sensitivity import points_of
from ..sensitivity_table import cell, shown_unit
from ..table import number
from .comparison import Compared
from .latex import latex

LETTERS = 107  # in a line of 16 cm at the size of footnotes
GAP = 2  # letters, between columns
LINES, HEAD_LINES = 56, 2  # of a page, beside the caption; of the head of a part
POWER = re.compile(r"e(-?)\+?0*(\d+)")  # of ten
MARKED = ("low", "high")  # ways that are better, of figures in which the best is marked


@dataclass(frozen=True)
class Part:
    """One of the tabulars that stand below each other."""

    heads: list[str]  # of its columns, but for the first one's; LaTeX
    cells: list[list[str]]  # by strategy; LaTeX, and what is in them counts as so many letters
    over: str  # what stands above the strategies


def table_text(compared: Compared, cases: Cases, conditions: list[str], caption: str, notes: str, label: str) -> str:
    """One float, or several that together are the table where it is too long for a page."""
    names = [latex(name) for name in compared.table["label"]]
    parts = [all_conditions(compared)]
    for name in conditions:
        parts += over_condition(compared, cases, name)
    a_page = max(1, LINES // (len(names) + HEAD_LINES))
    pages = [parts[start : start + a_page] for start in range(0, len(parts), a_page)]
    floats = []
    for place, page in enumerate(pages):
        bodies = "\n\\par\\smallskip\n".join(tabular(part, names) for part in page)
        head = f"\\caption{{{caption}}}\n\\label{{tab:{label}}}\n\\smallskip" if place == 0 else "Continued from the table before."
        below = f"\n\\par\\medskip\n\\parbox{{\\linewidth}}{{\\scriptsize {notes}}}" if page is pages[-1] and notes else ""
        floats.append(
            f"\\begin{{table}}[htbp]\n\\centering\\footnotesize\\setlength{{\\tabcolsep}}{{4pt}}\n{head}\n"
            f"{bodies}{below}\n\\end{{table}}\n"
        )
    return "".join(floats)


def unit_of(compared: Compared) -> tuple[str, float]:
    """The unit of all of a table's numbers, and the factor to it."""
    unit, factor = shown_unit(compared.figure.unit, compared.table)
    return unit or compared.figure.counted.removeprefix("1"), factor


def all_conditions(compared: Compared) -> Part:
    """The strategies over all conditions, with what tells them apart."""
    table, (unit, factor) = compared.table, unit_of(compared)
    best = [best_of(table, compared)] if len(table) > 1 else [None]
    columns = [("median" + (f", {latex(unit)}" if unit else ""), [median_cell(row, factor, k == best[0])
                for k, (_, row) in enumerate(table.iterrows())])]  # fmt: skip
    if table["mean_rank"].notna().any():
        columns.append(("mean rank", [f"{rank:.2f}" for rank in table["mean_rank"]]))
    if table["difference"].notna().any():
        named = table[["difference", "difference_low", "difference_high"]].set_axis(["median", "low", "high"], axis=1)
        columns.append(("difference", [dash_or(median_cell(row, factor, False), row) for _, row in named.iterrows()]))
        columns.append(("$p$", [p_cell(p) for p in table["p"]]))
    columns.append(("failed", [str(failed) for failed in table["failed"]]))
    if table["no_value"].any():
        columns.append(("no value", [str(count) for count in table["no_value"]]))
    return Part([head for head, _ in columns], [[*row] for row in zip(*(cells for _, cells in columns))], "all conditions")


def over_condition(compared: Compared, cases: Cases, name: str) -> list[Part]:
    """The strategies at each value of a condition, in as many parts as there is room for in a line."""
    points = points_of(compared.used, [name, "label"], [compared.figure])
    _, factor = unit_of(compared)
    labels = compared.table["label"]
    heads, columns = [], []
    for value, rows in points.groupby(name, sort=False):
        rows = rows.set_index("label").reindex(labels)
        best = best_of(rows, compared)
        heads.append(latex(f"{number(value)} {cases.units.get(name, '')}".strip()))
        columns.append([dash_or(median_cell(row, factor, k == best), row) for k, (_, row) in enumerate(rows.iterrows())])
    room = LETTERS - max(map(len, labels))
    parts = []
    for chunk in chunks([GAP + max(map(letters, [head, *cells])) for head, cells in zip(heads, columns)], room):
        over = f"by {cases.words.get(name, name)}"
        parts.append(Part(heads[chunk], [[*row] for row in zip(*columns[chunk])], latex(over)))
    return parts


def chunks(widths: list[int], room: int) -> list[slice]:
    """Runs of columns that fit into the room, as equal in number as can be."""
    widest = max(widths)
    runs = -(-len(widths) // max(1, room // widest))
    ends = [round(k * len(widths) / runs) for k in range(runs + 1)]
    return [slice(start, end) for start, end in zip(ends[:-1], ends[1:])]


def best_of(rows: pd.DataFrame, compared: Compared) -> int | None:
    """The row that is better than each other one by more than their intervals; None where there is no such, or where
    strategies are not compared."""
    better = compared.figure.better
    if not compared.is_fair or better not in MARKED or rows[["low", "high"]].isna().any(axis=None) or len(rows) < 2:
        return None
    sign = 1 if better == "low" else -1
    ends = np.sort(sign * rows[["low", "high"]].to_numpy(float), axis=1)
    near, far = ends.T
    best = int(np.argmin(sign * rows["median"].to_numpy(float)))
    return best if (far[best] < np.delete(near, best)).all() else None


def median_cell(row: pd.Series, factor: float, is_best: bool) -> str:
    median, interval = (latex(part) for part in cell(*(float(row[name]) * factor for name in ("median", "low", "high"))))
    median, interval = (POWER.sub(r"$\\times10^{\1\2}$", part) for part in (median, interval))
    median = f"\\textbf{{{median}}}" if is_best else median
    return f"{median} {interval}".rstrip()


def dash_or(text: str, row: pd.Series) -> str:
    return latex("–") if np.isnan(row["median"]) else text


def p_cell(p: float) -> str:
    return latex("–") if np.isnan(p) else "$<$0.001" if p < 0.001 else f"{p:.3f}"


def letters(text: str) -> int:
    """About as wide as so many, when it is set."""
    for command in ("\\textbf{", "$", "\\infty", "\\allowbreak{", "}"):
        text = text.replace(command, "")
    return len(text.replace("--", "-"))


def tabular(part: Part, names: list[str]) -> str:
    rows = [" & ".join([part.over, *part.heads])]
    body = [" & ".join([name, *cells]) for name, cells in zip(names, part.cells)]
    columns = "l" + "r" * len(part.heads)
    lines = [
        f"\\begin{{tabular*}}{{\\linewidth}}{{@{{}}{columns[0]}@{{\\extracolsep{{\\fill}}}}{columns[1:]}@{{}}}}", "\\toprule",
        f"{rows[0]} \\\\", "\\midrule", *(f"{row} \\\\" for row in body), "\\bottomrule", "\\end{tabular*}",
    ]  # fmt: skip
    return "\n".join(lines)
