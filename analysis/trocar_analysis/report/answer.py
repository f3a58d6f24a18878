"""The overview's answer in words. What intervals and ranks do not tell apart it does not tell apart either."""

from __future__ import annotations

import math

from ..sensitivity_table import said
from .main_figures import LEFT_INSIDE, TIME

INSIDE = {one.name for one in LEFT_INSIDE}


def answer(comparisons: list[dict], counts: list[dict]) -> list[str]:
    """@param comparisons as comparison.compared says them
    @param counts of each strategy's cases, as overview.counts_of says them"""
    if sum(one["complete"] for one in counts) == 0:
        return ["No case completed, so the file does not answer it. How the cases ended stands below."]
    main = next((one for one in comparisons if one["name"] in INSIDE and one["rows"]), None)
    if main is None:
        return ["The file does not answer it: no figure of what is left inside has a value of each strategy under the same "
                "conditions." + why_not(comparisons)]  # fmt: skip
    if len(main["rows"]) == 1:
        row = main["rows"][0]
        return [f"{row['label']} is the only strategy in this file: {lowered(main['title'])}, {median(main, row)}. There is "
                "nothing to compare it with."]  # fmt: skip
    first = main["rows"][0]
    sentences = [leading(main), *apart(main), *lowest_median(main), *cost_in_time(main, comparisons)]
    return [*sentences, *worse_in(first["label"], comparisons), *failures(first["label"], counts)]


def why_not(comparisons: list[dict]) -> str:
    reasons = [one["why"] for one in comparisons if one["name"] in INSIDE and one["why"]]
    return f" ({reasons[0]})" if reasons else ""


def leading(main: dict) -> str:
    first, ranks = main["rows"][0], main["ranks"]
    if ranks is None and not math.isfinite(number(first["median"])):
        return f"Half of the cases or more failed with every strategy: there is no median of “{lowered(main['title'])}” to compare."
    if ranks is None:
        return f"Lowest median of “{lowered(main['title'])}”: {first['label']}, {median(main, first)}. Not ranked: {main['why']}."
    return (
        f"{first['label']} ranks first by “{lowered(main['title'])}”: mean rank {first['meanRank']:.2f} of "
        f"{len(main['rows'])} over {ranks['blocks']} blocks, {median(main, first)}."
    )


def apart(main: dict) -> list[str]:
    """From which strategies the first is not told apart, by ranks and by intervals."""
    first, *others = main["rows"]
    if main["ranks"] is None:
        if first["low"] is None:
            return ["There are too few seeds for intervals: another sweep may put the strategies in another order."]
        near = [row for row in others if overlap(first, row)]
        return [f"The interval overlaps with that of {listed(main, near)}: they are not told apart."] if near else []
    near = [row for row in others if row["meanRank"] - first["meanRank"] < main["ranks"]["difference"]]
    if near:
        return [f"The ranks do not tell it apart from {listed(main, near)}."]
    blurred = [row for row in others if overlap(first, row)]
    also = f", but its interval overlaps with that of {listed(main, blurred)}" if blurred else ""
    return [f"The ranks tell it apart from all others{also}."]


def lowest_median(main: dict) -> list[str]:
    """Where another strategy than the first has it."""
    first = main["rows"][0]
    lowest = min(main["rows"], key=lambda row: oriented(main, row["median"]))
    if main["ranks"] is None or oriented(main, lowest["median"]) >= oriented(main, first["median"]):
        return []
    how = "the two intervals overlap" if overlap(first, lowest) else "the two intervals do not overlap"
    if first["low"] is None:
        how = "there are too few seeds for intervals"
    return [f"The best median is that of {lowest['label']}, {value_words(main, lowest)}; {how}."]


def cost_in_time(main: dict, comparisons: list[dict]) -> list[str]:
    times = next((one for one in comparisons if one["name"] == TIME.name and one["rows"]), None)
    if times is None:
        return []
    own = row_of(times, main["rows"][0]["label"])
    if not math.isfinite(number(own["median"])):
        return []
    fastest = min(times["rows"], key=lambda row: oriented(times, row["median"]))
    words = f"In time it costs {value_words(times, own)} of handling (99 % of a case's steps take less)"
    if fastest is own:
        return [f"{words}: no other is faster." if not near(times, own) else
                f"{words}, the lowest median; the interval overlaps with that of {listed(times, near(times, own))}."]  # fmt: skip
    same = "; the two intervals overlap" if overlap(own, fastest) else ""
    left = row_of(main, fastest["label"])
    return [f"{words}. The fastest is {fastest['label']}, {value_words(times, fastest)}{same}; by the "
            f"figure above: {median(main, left)}."]  # fmt: skip


def worse_in(label: str, comparisons: list[dict]) -> list[str]:
    """Other figures in which intervals say that another strategy does better."""
    words = []
    for one in comparisons[1:]:
        if one["name"] == TIME.name or not one["rows"]:
            continue
        own, best = row_of(one, label), min(one["rows"], key=lambda row: oriented(one, row["median"]))
        if not math.isfinite(number(own["median"])):
            continue
        if best is not own and own["low"] is not None and best["low"] is not None and not overlap(own, best):
            words.append(f"{lowered(one['title'])} ({value_words(one, own)}; {best['label']} {value_words(one, best)})")
    return [f"Its interval is clear of the best strategy's, and worse, in: {'; '.join(words)}."] if words else []


def failures(label: str, counts: list[dict]) -> list[str]:
    failed = sum(sum(one["failed"].values()) for one in counts)
    if not failed:
        return []
    own = next(one for one in counts if one["label"] == label)
    return [f"{failed} of {sum(one['cases'] for one in counts)} cases failed, {sum(own['failed'].values())} of them of {label}; "
            "each counts as the worst value there is."]  # fmt: skip


def near(comparison: dict, own: dict) -> list[dict]:
    return [row for row in comparison["rows"] if row is not own and overlap(own, row)]


def overlap(one: dict, other: dict) -> bool:
    """Whether two intervals do; of one that does not exist nothing is said, see there."""
    if one["low"] is None or other["low"] is None:
        return False
    ends = [number(row[end]) for row in (one, other) for end in ("low", "high")]
    return ends[0] <= ends[3] and ends[2] <= ends[1]


def row_of(comparison: dict, label: str) -> dict:
    return next(row for row in comparison["rows"] if row["label"] == label)


def oriented(comparison: dict, value: float | str) -> float:
    """Small is better."""
    return number(value) if comparison["better"] == "low" else -number(value)


def number(value: float | str) -> float:
    """What comparison.finite said."""
    return float(value)


def median(comparison: dict, row: dict) -> str:
    if not math.isfinite(number(row["median"])):
        return "without a median, since half of its cases or more failed"
    return f"median {value_words(comparison, row)}"


def value_words(comparison: dict, row: dict) -> str:
    """The median and its interval."""
    shown = [said(number(row[name]) * comparison["factor"]) for name in ("median", "low", "high") if row[name] is not None]
    interval = f" [{shown[1]}–{shown[2]}]" if len(shown) == 3 else ""
    return f"{shown[0]} {comparison['unit']}".rstrip() + interval


def listed(comparison: dict, rows: list[dict]) -> str:
    words = [f"{row['label']} ({median(comparison, row)}{', intervals overlap' * overlap(comparison['rows'][0], row)})" for row in rows]
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def lowered(title: str) -> str:
    return title[0].lower() + title[1:]
