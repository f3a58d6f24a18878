"""The claims and their verdicts for people: a table of all, then each with its conditions."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..change_table import amount, p_text
from ..paired import FEWEST_SEEDS, LEVEL, RESAMPLES
from ..table import Column, aligned, markdown, number, readable_unit
from .claim_file import Claim, Condition, Where
from .verdicts import NO_DATA, NOT, PARTLY, PENDING, REPRODUCED, TOO_FEW, Judged, Verdict

MOST_ROWS = 24  # of a claim; of more only those that do not hold, and those nearest to failing

RELATIONS = {"<": "<", ">": ">", "<=": "≤", ">=": "≥"}
UNITS = {"speed": "mm/s", "rate": "Hz"}


@dataclass(frozen=True)
class Answer:
    """A claim and what came out under each release, on the organs made by formula and on the confirmation set."""

    claim: Claim
    verdicts: dict[str, Verdict]  # by release
    confirmation: dict[str, Verdict]
    without_states: tuple[int, int] = (0, 0)  # runs that had no state to hand out, of how many


def render(answers: list[Answer], units: dict[str, str], style: str, level: str = "##") -> str:
    parts = [block(overview(answers), style)]
    for answer in answers:
        parts.append("\n".join(heading(answer, style, level)) + "\n")
        if any(verdict.judged for verdict in answer.verdicts.values()):
            parts.append(block(conditions_table(answer, units), style))
            if notes := [note for note in (left_out(answer), silent(answer)) if note]:
                parts.append(" ".join(notes) + "\n")
    return "\n".join([*parts, "\n".join(legend(style)) + "\n"])


def block(columns: list[Column], style: str) -> str:
    return markdown(columns) if style == "markdown" else "\n".join(aligned(columns, with_quartiles=True)) + "\n"


def overview(answers: list[Answer]) -> list[Column]:
    releases = [*answers[0].verdicts]
    columns = [
        Column(("claim", ""), "", True, [(answer.claim.id, "") for answer in answers]),
        Column(("place", ""), "", True, [(answer.claim.place, "") for answer in answers]),
    ]
    for title, chosen in (("", "verdicts"), ("confirmation, ", "confirmation")):
        for release in releases:
            verdicts = [getattr(answer, chosen)[release] for answer in answers]
            if chosen == "confirmation" and all(verdict.word in (NO_DATA, PENDING) for verdict in verdicts):
                continue
            cells = [(verdict_text(verdict), "") for verdict in verdicts]
            columns.append(Column((f"{title}release {release}", ""), "", True, cells))
    columns.append(Column(("what it says", ""), "", True, [(answer.claim.says, "") for answer in answers]))
    return columns


def verdict_text(verdict: Verdict) -> str:
    asked = [one for one in verdict.judged if one.condition.relation]
    if verdict.word in (REPRODUCED, PARTLY, NOT):
        return f"{verdict.word} ({verdict.held} of {len(asked)})" if len(asked) > 1 else verdict.word
    unsaid = sum(one.holds is None for one in asked)
    return f"{verdict.word} ({unsaid} of {len(asked)})" if unsaid < len(asked) else verdict.word


def heading(answer: Answer, style: str, level: str) -> list[str]:
    claim = answer.claim
    said = [f"{release}: {verdict_text(verdict)}" for release, verdict in answer.verdicts.items()]
    line = f"{claim.id}, {claim.place}: {claim.says}"
    if claim.pending:
        said = [f"{PENDING}: {claim.pending}"]
    if style == "markdown":
        return [f"{level} {line}", "", "; ".join(said) + ".", ""]
    return [line, "  " + "; ".join(said)]


def conditions_table(answer: Answer, units: dict[str, str]) -> list[Column]:
    rows = shown_rows(answer)
    judged = [one for _, one, _ in rows]
    scales = [scale_of(one, units) for one in judged]
    columns = [
        Column(("condition", ""), "", True, [(condition_text(one.condition, units), "") for one in judged]),
        Column(("release", ""), "", True, [(release, "") for release, _, _ in rows]),
        Column(("unit", ""), "", True, [(unit, "") for unit, _ in scales]),
        Column(("median", ""), "", False, [(figure(one.of, factor), "") for one, (_, factor) in zip(judged, scales)]),
    ]
    if any(one.condition.than for one in judged):
        cells = [(figure(one.than, factor), "") for one, (_, factor) in zip(judged, scales)]
        columns.append(Column(("of the other", ""), "", False, cells))
    columns += result_columns("", judged, scales)
    if any(np.isfinite(one.p) for one in judged):
        columns.append(Column(("two-sided p", ""), "", False, [(p_text(one.p), "") for one in judged]))
        columns.append(Column(("Cliff's δ", ""), "", False, [(amount(one.delta, "+"), "") for one in judged]))
    confirmed = [one for _, _, one in rows]
    if any(one and one.pairs for one in confirmed):
        columns += result_columns("confirmation: ", confirmed, scales)
    return columns


def result_columns(title: str, judged: list[Judged | None], scales: list[tuple[str, float]]) -> list[Column]:
    return [
        Column((f"{title}difference", ""), "", False, [interval(one, factor) for one, (_, factor) in zip(judged, scales)]),
        Column((f"{title}n", ""), "", False, [(counted(one), "") for one in judged]),
        Column((f"{title}seeds", ""), "", False, [(f"{one.seeds}" if one else "–", "") for one in judged]),
        Column((f"{title}singly", ""), "", False, [(singly(one), "") for one in judged]),
        Column((f"{title}holds", ""), "", True, [(holds_text(one), "") for one in judged]),
    ]


def shown_rows(answer: Answer) -> list[tuple[str, Judged, Judged | None]]:
    """Condition by condition the releases below each other, with the confirmation's."""
    rows = []
    for place in range(len(answer.claim.conditions)):
        for release, verdict in answer.verdicts.items():
            if not verdict.judged:
                continue
            confirmed = answer.confirmation[release].judged
            rows.append((release, verdict.judged[place], confirmed[place] if confirmed else None))
    if len(rows) <= MOST_ROWS:
        return rows
    failing = [row for row in rows if row[1].holds is not True]
    held = sorted((row for row in rows if row[1].holds is True), key=lambda row: -margin(row[1]))
    return [*failing, *held[: max(3, MOST_ROWS - len(failing))]]


def margin(one: Judged) -> float:
    """How near to failing a condition that holds is: the end of the interval, counted towards failing."""
    return -one.low if one.condition.asks_for_more else one.high


def left_out(answer: Answer) -> str:
    every = sum(len(verdict.judged) for verdict in answer.verdicts.values())
    shown = len(shown_rows(answer))
    return f"{every - shown} more hold." if shown < every else ""


def silent(answer: Answer) -> str:
    none, every = answer.without_states
    return f"In {none} of {every:,} runs nothing was ever inside the tool: no state to ask about." if none else ""


def condition_text(condition: Condition, units: dict[str, str]) -> str:
    own = {
        column: values for column, values in sorted(condition.of.items(), key=lambda item: item[0] != "label")
        if condition.than.get(column) != values or (column == "label" and column not in condition.each)
    }  # fmt: skip
    other = {column: values for column, values in condition.than.items() if condition.of.get(column) != values}
    words = [" + ".join(condition.figure)]
    if condition.per:
        words.append("per " + " + ".join(condition.per))
    # What both sides have in common is told where a claim has several of it, or where it is the speed.
    shared = [column for column in condition.of if column in condition.each or column == "speed"]
    if not condition.than:
        own = {column: own[column] for column in own if column in ("label", *shared)}
    around = ", ".join(name_of(column, condition.of[column]) for column in shared if column not in own)
    words.append(f"({said(own)})" if own else "")
    if condition.relation:
        words.append(RELATIONS[condition.relation])
        if condition.than:
            words.append(f"{number(condition.times)} × ({said(other)})" if condition.times != 1 else f"({said(other)})")
        else:
            unit, factor = unit_of(condition, units, condition.limit)
            words.append(f"{number(condition.limit * factor)} {unit}".rstrip())
    return " ".join(filter(None, words)) + (f", {around}" if around else "")


def said(where: Where) -> str:
    return ", ".join(name_of(column, values) for column, values in where.items())


def name_of(column: str, values: tuple) -> str:
    return " or ".join(str(value) for value in values) + (f" {UNITS[column]}" if column in UNITS else "")


def unit_of(condition: Condition, units: dict[str, str], value: float) -> tuple[str, float]:
    unit = units.get(condition.figure[0], "")
    if condition.per:
        return ("" if units.get(condition.per[0], "") == unit else unit), 1
    return readable_unit(unit, pd.DataFrame({"median": [abs(value)]}))


def scale_of(one: Judged, units: dict[str, str]) -> tuple[str, float]:
    return unit_of(one.condition, units, max(one.condition.limit, one.of if np.isfinite(one.of) else 0))


def figure(value: float, factor: float) -> str:
    return amount(value * factor, "")


def interval(one: Judged | None, factor: float) -> tuple[str, str]:
    if one is None or one.pairs == 0:
        return "–", ""
    ends = "" if math.isnan(one.low) else f"[{amount(one.low * factor, '+')}, {amount(one.high * factor, '+')}]"
    return amount(one.median * factor, "+"), ends


def counted(one: Judged | None) -> str:
    if one is None:
        return "–"
    beside = [f"{one.failed} failed"] if one.failed else []
    beside += [f"{one.lacking} no value"] if one.lacking else []
    return f"{one.pairs}" + (f" [{', '.join(beside)}]" if beside else "")


def singly(one: Judged | None) -> str:
    return f"{one.single}" if one and one.pairs and one.condition.relation else "–"


def holds_text(one: Judged | None) -> str:
    if one is None or one.pairs == 0 or not one.condition.relation:
        return "–"
    if one.holds is None:
        return TOO_FEW
    return "yes" if one.holds else "no"


def legend(style: str) -> list[str]:
    lines = [
        "difference: median of the figure itself where no limit is set, of (figure − limit), or over the pairs of (figure − times × the other's), and its "
        f"{100 * LEVEL:.0f} % interval ({RESAMPLES:,} resamples of seeds within organs). A condition holds when the median "
        "and the whole interval are on its side of 0.",
        "n: cases, or pairs; seeds: how many places on organs they are from, which is what an interval counts; singly: of "
        "how many the condition holds one by one; two-sided p: Wilcoxon's signed-rank test of no difference at all, whichever "
        "way, with Holm's correction over the conditions of the claim; Cliff's δ: of all pairs of a value and one of the "
        "other, the share in which it is larger less that in which it is smaller. A case that failed counts as the worst value there is.",
        f"An interval needs {FEWEST_SEEDS} seeds over all organs; with fewer ({TOO_FEW}) nothing is said.",
    ]
    return [f"- {line}" for line in lines] if style == "markdown" else lines
