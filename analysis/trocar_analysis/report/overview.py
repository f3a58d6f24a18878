"""What the page's overview shows: page/src/views/overview_data.ts."""

from __future__ import annotations

import pandas as pd

from ..case_figures import Cases
from ..errors import InputError
from ..front import Front, Wishes, front_of
from ..options import option_columns
from ..provenance import origins, warning
from ..sensitivity_table import shown_unit
from ..store import ResultFile
from ..subject import tally
from ..table import in_one_line
from .answer import INSIDE, answer
from .comparison import compared, finite
from .main_figures import TIME, main_figures

QUESTION = "Which strategy leaves least of the organ in the tool, and what does it cost?"
MOST_FAILURES = 30  # kinds that are listed


def overview_of(file: ResultFile, table: pd.DataFrame, better: dict[str, str]) -> dict:
    """All but the claims."""
    if missing := {"organ", "seed"} - {*table}:
        raise InputError(f"{file.path}: is damaged: /cases has no column {', '.join(sorted(missing))}")
    path = str(file.path)
    option_columns(table, path)  # says what is wrong with them
    origin = origins(table, file.provenance_table(), path)
    cases = Cases(path, table, file.units(), file.long_names(), origin)
    comparisons = [compared(main, cases, better) for main in main_figures(table)]
    counts = counts_of(table)
    return {
        "question": QUESTION,
        "answer": answer(comparisons, counts),
        "counts": counts,
        "comparisons": comparisons,
        "front": front_told(cases, comparisons, better),
        "failures": failures_of(table),
        "cautions": warning(origin),
    }


def counts_of(table: pd.DataFrame) -> list[dict]:
    """How the cases of each strategy ended."""
    counts = []
    for label, own in table.groupby("label", sort=False):
        statuses = own["status"].value_counts()
        failed = {status: int(count) for status, count in statuses.items() if status != "complete"}
        counts.append({"label": label, "cases": len(own), "complete": int(statuses.get("complete", 0)), "failed": failed})
    return counts


def failures_of(table: pd.DataFrame) -> dict:
    """The kinds of failures, the most frequent first, and how many kinds are not told."""
    failed = table[table["status"] != "complete"]
    reasons = failed["reason"].map(in_one_line) if "reason" in failed else pd.Series("", index=failed.index)
    groups = failed.assign(reason=reasons).groupby(["status", "reason"], sort=False)
    kinds = [
        {"status": status, "reason": reason, "cases": len(group), "labels": tally(group["label"].value_counts().to_dict()),
         "example": group["case_id"].iloc[0]}
        for (status, reason), group in groups
    ]  # fmt: skip
    kinds.sort(key=lambda kind: -kind["cases"])
    return {"kinds": kinds[:MOST_FAILURES], "more": max(0, len(kinds) - MOST_FAILURES)}


def front_told(cases: Cases, comparisons: list[dict], better: dict[str, str]) -> dict:
    """Of what is left inside against time; `why` there is none."""
    inside = next((one for one in comparisons if one["name"] in INSIDE and one["rows"]), None)
    time = next((one for one in comparisons if one["name"] == TIME.name and one["rows"]), None)
    if inside is None or time is None:
        lacking = "what is left inside" if inside is None else "times of handling"
        return {"points": [], "why": f"there are no figures of {lacking} that all strategies have"}
    try:
        front = front_of(cases, Wishes(inside["name"], time["name"], [], better))
    except InputError as error:
        return {"points": [], "why": str(error).removeprefix(f"{cases.path}: ").partition("; run more")[0]}
    return {"why": "", "notes": [*front.notes, *front.cautions]} | axes_told(front, inside, time)


def axes_told(front: Front, inside: dict, time: dict) -> dict:
    points, ends = front.points, ("median", "low", "high")
    others = points[[f"against_{name}" for name in ends]].set_axis(ends, axis=1)
    axes = {}
    for axis, rows, figure, told in (("y", points, front.figure, inside), ("x", others, front.against, time)):
        unit, factor = shown_unit(figure.unit, rows)
        axes[axis] = {"name": figure.name, "title": told["title"], "unit": unit, "factor": factor, "better": figure.better}
    told_points = [
        {"label": row["label"], "cases": int(row["cases"]), "failed": int(row["failed"]), "onFront": bool(row["on_front"]),
         "y": [finite(row[name]) for name in ends], "x": [finite(other[name]) for name in ends]}
        for (_, row), (_, other) in zip(points.iterrows(), others.iterrows())
    ]  # fmt: skip
    return axes | {"points": told_points}
