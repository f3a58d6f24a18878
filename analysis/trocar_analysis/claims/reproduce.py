"""`trocar reproduce`, once its cases are run: every claim judged and told."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np

from ..effects import holm
from .claim_data import Sources, read_sources, runs_without_states
from .claim_file import Claim, choose_claims, read_claims
from .claim_table import Answer, render
from .verdicts import Verdict, judge_claim

RELEASES = ("contact", "step")


def reproduce(
    claims_path: str, path: str, turns_path: str | None, ids: list[str] | None, better: dict[str, str], style: str
) -> str:
    """The claims judged on a result file, as text, "markdown", or "json"."""
    claims = choose_claims(read_claims(claims_path), ids)
    needs_results = any(one.data != "turns" for claim in claims for one in claim.conditions)
    sources = read_sources(path if needs_results else None, turns_path, better)
    answers = [answer_of(claim, sources) for claim in claims]
    if style == "json":
        return json.dumps([as_json(answer) for answer in answers], indent=1, ensure_ascii=False) + "\n"
    return render(answers, sources.units, style)


def answer_of(claim: Claim, sources: Sources) -> Answer:
    return Answer(
        claim,
        {release: corrected(judge_claim(claim, sources, release, False)) for release in RELEASES},
        {release: corrected(judge_claim(claim, sources, release, True)) for release in RELEASES},
        without_states(claim, sources),
    )


def without_states(claim: Claim, sources: Sources) -> tuple[int, int]:
    """Runs without states, of those of all conditions; conditions of one claim differ in what they ask of the same
    runs, or in which."""
    counts = {tuple(map(str, one.each.items())): runs_without_states(one, sources) for one in claim.conditions}
    return sum(none for none, _ in counts.values()), sum(every for _, every in counts.values())


def corrected(verdict: Verdict) -> Verdict:
    """With Holm's correction of p within the claim."""
    compared = [place for place, one in enumerate(verdict.judged) if np.isfinite(one.p)]
    if not compared:
        return verdict
    adjusted = holm(np.array([verdict.judged[place].p for place in compared]))
    judged = list(verdict.judged)
    for place, p in zip(compared, adjusted):
        judged[place] = replace(judged[place], p=float(p))
    return replace(verdict, judged=judged)


def as_json(answer: Answer) -> dict:
    """Numbers as they are, in the stored unit; what is infinite as a text, null for none."""
    return {
        "id": answer.claim.id,
        "says": answer.claim.says,
        "verdicts": {release: verdict_json(one) for release, one in answer.verdicts.items()},
        "confirmation": {release: verdict_json(one) for release, one in answer.confirmation.items()},
    }


def verdict_json(verdict: Verdict) -> dict:
    numbers = {
        "median_of": "of", "median_than": "than", "median": "median", "low": "low", "high": "high", "p": "p",
        "cliffs_delta": "delta",
    }  # fmt: skip
    return {
        "verdict": verdict.word,
        "conditions": [
            {
                "data": one.condition.data, "figure": one.condition.figure, "per": one.condition.per,
                "each": one.condition.each, "of": one.condition.of, "than": one.condition.than,
                "is": one.condition.relation, "limit": one.condition.limit, "times": one.condition.times,
                "n": one.pairs, "seeds": one.seeds, "failed": one.failed, "lacking": one.lacking, "singly": one.single, "holds": one.holds,
            } | {name: finite(getattr(one, attribute)) for name, attribute in numbers.items()}
            for one in verdict.judged
        ],
    }  # fmt: skip


def finite(value: float) -> float | str | None:
    return None if np.isnan(value) else str(value) if np.isinf(value) else value
