"""What cannot be better in one figure without being worse in another."""

from __future__ import annotations

import numpy as np


def pareto_front(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Whether each point is on the Pareto front of two figures that are both better when low, [points]. It is not where
    another one is at least as low in both and lower in one; points that are equal in both are both on it or both not.
    Figures may be infinite, as of a failed case; they are not NaN."""
    lower = first[:, None] < first
    no_higher = first[:, None] <= first
    lower_second = second[:, None] < second
    no_higher_second = second[:, None] <= second
    is_beaten = (lower & no_higher_second) | (no_higher & lower_second)  # [by, point]
    return ~is_beaten.any(axis=0)
