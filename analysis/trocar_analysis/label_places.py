"""Where names of points stand in a panel, so that none covers another one or a mark. It knows lengths only, in one unit
of its user's."""

from __future__ import annotations

import numpy as np

ANGLES = 16
RINGS = 40  # distances at which a place is looked for, across the panel
PASSES = 20
# What a place costs: what is covered, and the distance from the point, in units of a label's height.
LABEL, MARK, LEADER, BAR, DISTANCE = 1000.0, 300.0, 100.0, 3.0, 1.0


def place_labels(
    points: np.ndarray, sizes: np.ndarray, panel: tuple[float, float], bars: np.ndarray, mark: float
) -> np.ndarray:
    """The middle of each label, [labels, 2], for points [labels, 2] in a panel from 0, 0 to `panel`, with labels of these
    `sizes` (width and height, [labels, 2]). `bars`: lines that a label had better not cover, [bars, two ends, 2].
    `mark`: how far around a point its mark reaches. Each label takes the best of places around its point, in turn, until
    none has a better one."""
    height = sizes[:, 1].mean() if len(sizes) else 0.0
    places = [candidates(point, size, panel, mark, height) for point, size in zip(points, sizes)]
    own_costs = [
        DISTANCE * distances(point, middles, size) / height + cost_of_marks(middles, size, points, mark)
        + cost_of_bars(middles, size, bars) / height
        for point, middles, size in zip(points, places, sizes)
    ]  # fmt: skip
    chosen = np.array([middles[cost.argmin()] for middles, cost in zip(places, own_costs)]).reshape(-1, 2)
    for _ in range(PASSES):
        before = chosen.copy()
        for k, (middles, cost) in enumerate(zip(places, own_costs)):
            others = np.arange(len(points)) != k
            total = cost + cost_of_labels(points[k], middles, sizes[k], points[others], chosen[others], sizes[others])
            chosen[k] = middles[total.argmin()]
        if np.array_equal(before, chosen):
            break
    return chosen


def candidates(point: np.ndarray, size: np.ndarray, panel: tuple[float, float], mark: float, height: float) -> np.ndarray:
    """Middles of the label around its point, at growing distances, the label within the panel."""
    angles = 2 * np.pi * np.arange(ANGLES) / ANGLES
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    # From mark to mark's edge on; beside the point the label begins there, above and below it is centred.
    reach = mark + np.concatenate([[0.15 * height], height * np.arange(0.5, RINGS / 2, 0.5)])
    middles = point + ways * reach[:, None, None] + np.clip(1.6 * ways, -1, 1) * size / 2
    middles = middles.reshape(-1, 2)
    low, high = size / 2, np.array(panel) - size / 2
    inside = ((middles >= low) & (middles <= high)).all(axis=1)
    return middles[inside] if inside.any() else np.clip(point, low, np.maximum(low, high))[None]


def distances(point: np.ndarray, middles: np.ndarray, size: np.ndarray) -> np.ndarray:
    """From the point to the label's nearest edge."""
    beyond = np.maximum(np.abs(middles - point) - size / 2, 0)
    return np.hypot(*beyond.T)


def cost_of_marks(middles: np.ndarray, size: np.ndarray, points: np.ndarray, mark: float) -> np.ndarray:
    away = np.abs(middles[:, None] - points)  # [places, points, 2]
    return MARK * (away < size / 2 + mark).all(axis=2).sum(axis=1)


def cost_of_bars(middles: np.ndarray, size: np.ndarray, bars: np.ndarray) -> np.ndarray:
    """Of the length of each bar, what the label covers."""
    return BAR * sum((covered_length(middles, size, *bar) for bar in bars), np.zeros(len(middles)))


def cost_of_labels(
    point: np.ndarray, middles: np.ndarray, size: np.ndarray, points: np.ndarray, others: np.ndarray, sizes: np.ndarray
) -> np.ndarray:
    """Of covering other labels, and of lines from points to labels across them."""
    cost = np.zeros(len(middles))
    for end, other, extent in zip(points, others, sizes):
        cost += LABEL * (np.abs(middles - other) < (size + extent) / 2).all(axis=1)
        cost += LEADER * (covered_length(middles, size, end, other) > 0)
        cost += LEADER * (covered_length(other, extent, point, middles) > 0)
    return cost


def covered_length(middles: np.ndarray, size: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Of the line from start to end, the length within a box (Liang and Barsky 1984). One of boxes and lines may be
    several, [several, 2]."""
    way = np.asarray(end - start, float)
    low, high = middles - size / 2, middles + size / 2
    moves = np.broadcast_to(way != 0, np.broadcast_shapes(way.shape, low.shape))
    with np.errstate(divide="ignore", invalid="ignore"):
        parts = np.stack([(low - start) / way, (high - start) / way])
    enters = np.where(moves, parts.min(axis=0), -np.inf).max(axis=-1)
    leaves = np.where(moves, parts.max(axis=0), np.inf).min(axis=-1)
    passes_by = (~moves & ((start < low) | (start > high))).any(axis=-1)
    within = np.minimum(leaves, 1) - np.maximum(enters, 0)
    return np.hypot(way[..., 0], way[..., 1]) * np.where(passes_by, 0, np.maximum(within, 0))
