"""Which displacements of neighbours cross: the definition of experiments/metrics/pages/displacement_crossings.md."""

from __future__ import annotations

import numpy as np

NEAR = 0.1  # of the edge's length: segments that come closer cross
STEEP = np.radians(5)  # and their angle is not smaller
INNER = 1e-9  # parts of a segment; what is nearer to its end is no inner point


def crossing_edges(found: np.ndarray, handled: np.ndarray, facets: np.ndarray, moved: np.ndarray) -> np.ndarray:
    """The edges [edges, 2] between moved vertices whose ends change places or pass each other closely. Positions are
    [vertices, 3], mm."""
    sides = np.concatenate([facets[:, [0, 1]], facets[:, [1, 2]], facets[:, [2, 0]]])
    edges = np.unique(np.sort(sides, axis=1), axis=0)
    edges = edges[np.isin(edges, moved).all(axis=1)]
    a, b = edges.T
    before, after = found[b] - found[a], handled[b] - handled[a]
    turned = (before * after).sum(axis=1) < 0
    reach = NEAR * np.linalg.norm(before, axis=1)
    return edges[turned | segments_cross(found[a], handled[a], found[b], handled[b], reach)]


def segments_cross(
    a: np.ndarray, a_end: np.ndarray, b: np.ndarray, b_end: np.ndarray, reach: np.ndarray
) -> np.ndarray:
    """Whether segments come within `reach` of each other at inner points of both, steeply enough. A flag a pair."""
    along_a, along_b, from_b = a_end - a, b_end - b, a - b
    aa, bb, ab = ((u * v).sum(axis=1) for u, v in ((along_a, along_a), (along_b, along_b), (along_a, along_b)))
    cross = (np.cross(along_a, along_b) ** 2).sum(axis=1)
    steep = (cross > 0) & (cross >= aa * bb * np.sin(STEEP) ** 2)
    safe = np.where(steep, cross, 1)
    da, db = ((from_b * along).sum(axis=1) for along in (along_a, along_b))
    part_a, part_b = (ab * db - bb * da) / safe, (aa * db - ab * da) / safe
    gap = np.linalg.norm(from_b + part_a[:, None] * along_a - part_b[:, None] * along_b, axis=1)
    inner = [(part > INNER) & (part < 1 - INNER) for part in (part_a, part_b)]
    return steep & inner[0] & inner[1] & (gap <= reach)
