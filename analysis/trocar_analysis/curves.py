"""What a picture marks on curves that share their x."""

from __future__ import annotations

import numpy as np

TELLS_APART = 0.04  # in y: two curves nearer than this look like one


def crossings(x: np.ndarray, curves: np.ndarray) -> list[tuple[float, float]]:
    """Where two of the curves, [curves, points], change places and no third one is above them, from left to right.
    Between two points curves are straight; where the two agree at several points, it is the middle of these."""
    found = set()
    for i in range(len(curves)):
        for j in range(i + 1, len(curves)):
            for place, height in changes(x, curves[i], curves[j]):
                if height > 0 and height >= max(np.interp(place, x, curve) for curve in curves) - 1e-9:
                    found.add((float(place), float(height)))
    return sorted(found)


def changes(x: np.ndarray, one: np.ndarray, other: np.ndarray) -> list[tuple[float, float]]:
    """Where the one curve gets from above to below the other, or back, and how high they are there."""
    difference = one - other
    apart_at = np.flatnonzero(difference)
    places = []
    for a, b in zip(apart_at, apart_at[1:]):
        if difference[a] * difference[b] > 0:
            continue
        share = difference[a] / (difference[a] - difference[b])
        place = x[a] + share * (x[b] - x[a]) if b == a + 1 else (x[a + 1] + x[b - 1]) / 2
        places.append((place, min(np.interp(place, x, one), np.interp(place, x, other))))
    return places


def peak(x: np.ndarray, y: np.ndarray) -> float:
    """Where y is largest; of several places the middle."""
    highest = x[y >= y.max() - 1e-9]
    return float(highest[0] + highest[-1]) / 2


def apart(curves: np.ndarray) -> list[int | None]:
    """For each curve, [curves, points], the point at which the nearest other one is furthest away; none where it lies
    on others throughout."""
    places: list[int | None] = []
    inner = slice(curves.shape[1] // 20, -(curves.shape[1] // 20) or None)  # no mark on the edge
    for k, curve in enumerate(curves):
        others = np.delete(curves, k, axis=0)[:, inner]
        distance = np.abs(others - curve[inner]).min(axis=0) if len(others) else np.zeros_like(curve[inner])
        best = int(distance.argmax())
        places.append(best + inner.start if distance[best] > TELLS_APART else None)
    return places
