"""How large an effect is, and p-values of several tests at once. Small and pure: they know nothing of files."""

from __future__ import annotations

import numpy as np


def cliffs_delta(a: np.ndarray, b: np.ndarray) -> float:
    """Cliff's delta (1993): how much more often a value of `a` is above one of `b` than below it, over all pairs of one
    of each, from −1 to 1. It takes no notice of which were paired. A value may be infinite, as a failed case is, and is
    equal to another that is infinite alike. NaN where either is empty."""
    if len(a) == 0 or len(b) == 0:
        return float("nan")
    ordered = np.sort(b)
    below = np.searchsorted(ordered, a, side="left")
    above = len(b) - np.searchsorted(ordered, a, side="right")
    return float((below - above).sum() / (len(a) * len(b)))


def holm(p: np.ndarray) -> np.ndarray:
    """The p-values adjusted for there being as many as there are, in the order given (Holm 1979): the smallest of n
    times n, the next times n − 1 and so on, none below that of a smaller one, none above 1. Reject what is at most α:
    with probability 1 − α no true hypothesis is rejected, however the tests depend on each other."""
    order = np.argsort(p)
    adjusted = np.empty(len(p))
    adjusted[order] = np.minimum(1, np.maximum.accumulate(np.asarray(p)[order] * np.arange(len(p), 0, -1)))
    return adjusted
