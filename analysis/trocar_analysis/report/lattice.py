"""Positions of a replay as the report holds them: whole numbers, each moment as its difference from the one before.
The counterpart of page/src/replay/positions.ts.

A position is rounded to a lattice. A vertex that rests gives zeros, which pack to nearly nothing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SPACING = 0.01  # mm, of the lattice
MOST_ERROR = SPACING / 2 * 3**0.5  # mm, of a position: half the lattice in each coordinate
FURTHEST = 1e6  # mm: a position further out is no place that a lattice of whole numbers reaches


@dataclass(frozen=True)
class Lattice:
    """Whole numbers × SPACING from `origin`."""

    origin: np.ndarray  # mm, [3]

    def numbers(self, positions: np.ndarray) -> np.ndarray:
        return np.rint((positions - self.origin) / SPACING).astype(np.int32)

    def positions(self, numbers: np.ndarray) -> np.ndarray:
        return self.origin + SPACING * numbers


def lattice_of(rest_positions: np.ndarray) -> Lattice:
    return Lattice((rest_positions.min(axis=0) + rest_positions.max(axis=0)).round() / 2)


def reachable(positions: np.ndarray) -> np.ndarray:
    """Which of the steps, [steps, vertices, 3], the lattice can hold: those in which every position is a place."""
    with np.errstate(invalid="ignore"):
        return (np.abs(positions) < FURTHEST).all(axis=(1, 2))


def changes(moments: np.ndarray, rest: np.ndarray) -> np.ndarray:
    """Lattice numbers of the moments, [moments, vertices, 3], as their differences from the moment before; the first from
    rest. Signs go into the lowest bit (0, −1, 1, −2, … are 0, 1, 2, 3, …): small differences have no high bytes."""
    differences = np.diff(moments, axis=0, prepend=rest[None])
    return ((differences << 1) ^ (differences >> 31)).astype(np.uint32)


def narrowest(unsigned: np.ndarray) -> str:
    """The kind of block that holds these numbers."""
    return "u2" if unsigned.size == 0 or unsigned.max() < 2**16 else "u4"
