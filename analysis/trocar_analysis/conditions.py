"""What a condition on figures comes to: the median of the values that it is about, and its interval. A condition asks
on which side of 0 that is.

| condition | values |
|---|---|
| a ≥ b | excess(a, b) |
| a ≥ factor · b | excess(a, b, factor) |
| a ≤ threshold | excess(a, threshold) |

`a` and `b` are paired. The values are differences, since a ratio does not exist where b is 0. Nothing is lost by it:
where every b is positive, their interval is above 0 (below, across) just where that of the ratios a / b is above
`factor`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .paired import bootstrap_interval, median, paired_differences


@dataclass(frozen=True)
class Estimate:
    """A median over `cases` values. NaN where there is none."""

    cases: int
    median: float
    low: float  # of its interval; NaN with too few seeds
    high: float


def excess(a: np.ndarray, b: np.ndarray | float, factor: float = 1) -> np.ndarray:
    """a − factor · b of each case. A failed case, infinite, is worse than any value, and no worse than `factor` times
    another failed one: 0."""
    return paired_differences(factor * np.broadcast_to(b, np.shape(a)), np.asarray(a))


def condition_interval(values: np.ndarray, organs: np.ndarray, seeds: np.ndarray) -> Estimate:
    """`values`, `organs` and `seeds` of the cases, [cases] each; values may be infinite, not NaN. The interval is
    paired.bootstrap_interval's: seeds are drawn within organs."""
    if len(values) == 0:
        nothing = float("nan")
        return Estimate(0, nothing, nothing, nothing)
    return Estimate(len(values), median(values), *bootstrap_interval(values, organs, seeds))
