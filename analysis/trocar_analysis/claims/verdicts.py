"""Which conditions hold, and what that says of the claim."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..conditions import condition_interval
from ..effects import cliffs_delta
from ..paired import median, signed_rank
from .claim_data import Sources, Values, values_of
from .claim_file import Claim, Condition

REPRODUCED, PARTLY, NOT = "reproduced", "partly", "not reproduced"
DESCRIBED, PENDING = "described", "not yet"
NO_DATA, NO_VALUE, TOO_FEW = "not run", "no value", "too few seeds"


@dataclass(frozen=True)
class Judged:
    """A condition under one release. Values are in the stored unit."""

    condition: Condition
    pairs: int  # cases, where the condition compares with a limit
    seeds: int  # places on organs that they are from
    failed: int
    lacking: int  # cases or pairs without a value
    of: float  # median of the figure
    than: float  # … of what it is compared with; NaN
    median: float  # of what has to be on one side of 0: figure − limit, or figure − times × the other's
    low: float  # its 95 % interval
    high: float
    single: int  # cases or pairs of which the condition holds one by one
    p: float  # Wilcoxon's, two-sided; NaN where it compares with a limit
    delta: float  # Cliff's, of the figure against what it is compared with; NaN where that is a limit
    holds: bool | None  # None: described, or there are no data, or too few seeds to say


@dataclass(frozen=True)
class Verdict:
    """Of a claim under one release, on the organs made by formula or on the confirmation set."""

    word: str
    judged: list[Judged] = field(default_factory=list)

    @property
    def held(self) -> int:
        return sum(one.holds is True for one in self.judged)


def judge_claim(claim: Claim, sources: Sources, release: str, confirmation: bool) -> Verdict:
    if claim.pending:
        return Verdict(PENDING)
    judged = [judge(one, values_of(one, sources, release, confirmation)) for one in claim.conditions]
    return Verdict(word_for(judged), judged)


def word_for(judged: list[Judged]) -> str:
    """Where one condition cannot be judged the claim is not: that something did not show is another thing than that it
    was not looked at."""
    if any(one.pairs == 0 and one.lacking == 0 for one in judged):
        return NO_DATA
    if any(one.pairs == 0 for one in judged):
        return NO_VALUE
    asked = [one.holds for one in judged if one.condition.relation]
    if not asked:
        return DESCRIBED
    if any(holds is None for holds in asked):
        return TOO_FEW
    return REPRODUCED if all(asked) else PARTLY if any(asked) else NOT


def judge(condition: Condition, values: Values) -> Judged:
    n = len(values.values)
    if n == 0:
        nothing = float("nan")
        return Judged(condition, 0, 0, values.failed, values.lacking, *[nothing] * 5, 0, nothing, nothing, None)
    estimate = condition_interval(values.values, values.organs, values.seeds)
    single = int(on_side(condition, values.values).sum()) if condition.relation else 0
    holds = None
    if condition.relation and not np.isnan(estimate.low):
        holds = bool(np.all(on_side(condition, np.array([estimate.median, estimate.low, estimate.high]))))
    return Judged(
        condition, n, len(set(zip(values.organs, values.seeds))), values.failed, values.lacking, median(values.of),
        median(values.than) if condition.than else float("nan"), estimate.median, estimate.low, estimate.high, single,
        signed_rank(values.values) if condition.than else float("nan"),
        cliffs_delta(values.of, values.than) if condition.than else float("nan"), holds,
    )  # fmt: skip


def on_side(condition: Condition, values: np.ndarray) -> np.ndarray:
    """Which values are on the side of 0 that the condition asks for; NaN is on none."""
    return {"<": values < 0, ">": values > 0, "<=": values <= 0, ">=": values >= 0}[condition.relation]
