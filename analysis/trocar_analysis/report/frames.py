"""Which steps of a replay the report keeps when they do not all fit."""

from __future__ import annotations

import numpy as np

AROUND = 2  # steps before and after one that matters are kept
LEAST = 16  # steps that a replay has at least: fewer show no motion


def kept_steps(steps: int, marks: list[int], most: int) -> np.ndarray:
    """Numbers of at most `most` (not fewer than LEAST) of `steps` steps: those around the marks, the first and the last,
    and others as evenly as it goes."""
    most = max(most, LEAST)
    if steps <= most:
        return np.arange(steps)
    kept = {0, steps - 1} | {
        step for mark in marks for step in range(mark - AROUND, mark + AROUND + 1) if 0 <= step < steps
    }
    while len(kept) < most:
        known = sorted(kept)
        gap = int(np.argmax(np.diff(known)))  # the first of the widest
        kept.add((known[gap] + known[gap + 1]) // 2)
    return np.array(sorted(kept))
