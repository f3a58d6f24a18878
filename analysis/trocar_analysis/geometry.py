"""What a picture needs to know of triangle meshes: sections, what is cut away, what is inside. Lengths in mm.

Floating point, made for drawing: figures that are printed as numbers come from the result file."""

from __future__ import annotations

import numpy as np

PAIRS_AT_ONCE = 100_000  # of segments and triangles


def facet_normals(positions: np.ndarray, facets: np.ndarray) -> np.ndarray:
    """Outer unit normals, [facets, 3]; zero for a facet without area."""
    a, b, c = (positions[facets[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)


def behind_plane(
    points: np.ndarray, facets: np.ndarray, heights: np.ndarray
) -> tuple[list[np.ndarray], np.ndarray]:
    """The part of each facet at which `heights` (per point: distance in front of a plane) is not positive.
    Returns polygons of 3 or 4 corners and the row in `facets` that each is from, ascending."""
    behind = heights[facets] <= 0
    rows = np.flatnonzero(behind.any(axis=1))
    polygons = list(points[facets[rows]])
    for index in np.flatnonzero(~behind[rows].all(axis=1)):
        row, corners = rows[index], []
        for start, end in zip(facets[row], np.roll(facets[row], -1)):
            if heights[start] <= 0:
                corners.append(points[start])
            if (heights[start] <= 0) != (heights[end] <= 0):
                corners.append(on_plane(points, heights, start, end))
        polygons[index] = np.array(corners)
    return polygons, rows


def on_plane(points: np.ndarray, heights: np.ndarray, start: int, end: int) -> np.ndarray:
    """Where an edge meets the plane. The same bits whichever end is named first, so that sections close."""
    low, high = min(start, end), max(start, end)
    share = heights[low] / (heights[low] - heights[high])
    return points[low] + share * (points[high] - points[low])


def section(points: np.ndarray, facets: np.ndarray, heights: np.ndarray) -> list[np.ndarray]:
    """The lines along which a mesh meets the plane of zero `heights`, each [points, dimensions]. A line that
    ends where it began is closed. All run the same way around the mesh's inside."""
    behind = heights[facets] <= 0
    next_edge = {}  # edges that meet the plane, as (end behind, end in front) → the next one along the line
    for corners in facets[behind.any(axis=1) & ~behind.all(axis=1)]:
        for start, end in zip(corners, np.roll(corners, -1)):
            if heights[start] <= 0 < heights[end]:
                leaving = (start, end)
            elif heights[end] <= 0 < heights[start]:
                entering = (end, start)
        next_edge[entering] = leaving
    lines = []
    beginnings = sorted(set(next_edge) - set(next_edge.values()))
    while next_edge:
        edge = beginnings.pop() if beginnings else next(iter(next_edge))
        line = [edge]
        while edge in next_edge:
            edge = next_edge.pop(edge)
            line.append(edge)
        lines.append(np.array([on_plane(points, heights, *edge) for edge in line]))
    return lines


def inside(points: np.ndarray, positions: np.ndarray, facets: np.ndarray) -> np.ndarray:
    """Which points are inside a closed mesh, by its winding number (Van Oosterom and Strackee, 1983)."""
    winding = np.zeros(len(points))
    for corners in positions[facets]:
        a, b, c = (corner - points for corner in corners)
        la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        volume = np.einsum("ij,ij->i", a, np.cross(b, c))
        base = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        winding += np.arctan2(volume, base)
    return winding > np.pi  # the sum is half the solid angle: 2π inside, 0 outside


def pierced(starts: np.ndarray, ends: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Which segments pass through which triangles ([triangles, 3, 3]): [segments, triangles] flags (Möller
    and Trumbore, 1997)."""
    hits = np.zeros((len(starts), len(corners)), bool)
    a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    rows = max(1, PAIRS_AT_ONCE // max(1, len(corners)))
    for first in range(0, len(starts), rows):
        part = slice(first, first + rows)
        start, way = starts[part, None], (ends[part] - starts[part])[:, None]
        p = np.cross(way, ac)
        scale = (ab * p).sum(-1)
        scale[scale == 0] = np.nan
        u = ((start - a) * p).sum(-1) / scale
        q = np.cross(start - a, ab)
        v = (way * q).sum(-1) / scale
        t = (ac * q).sum(-1) / scale
        hits[part] = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)
    return hits


def distances(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """From each point to the nearest of the triangles ([triangles, 3, 3])."""
    to_edge = np.full((len(points), len(corners)), np.inf)
    beside = np.zeros(to_edge.shape, bool)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    for end in range(3):
        start, way = corners[:, end], corners[:, (end + 1) % 3] - corners[:, end]
        from_start = points[:, None] - start
        along = (from_start * way).sum(-1) / np.maximum((way * way).sum(-1), 1e-30)
        to_edge = np.minimum(to_edge, np.linalg.norm(from_start - along.clip(0, 1)[..., None] * way, axis=-1))
        beside |= (from_start * np.cross(normals, way)).sum(-1) < 0
    to_plane = np.abs(((points[:, None] - corners[:, 0]) * normals).sum(-1))
    beside |= lengths.T == 0
    return np.where(beside, to_edge, to_plane).min(axis=1)


def facets_in_tool(
    positions: np.ndarray, facets: np.ndarray, tool_positions: np.ndarray, tool_facets: np.ndarray
) -> np.ndarray:
    """Which organ facets cross the tool's surface or lie inside it, a flag per facet."""
    low, high = tool_positions.min(axis=0), tool_positions.max(axis=0)
    corners = positions[facets]
    near = np.flatnonzero(((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1))
    vertices, numbers = np.unique(facets[near], return_inverse=True)
    flags = inside(positions[vertices], tool_positions, tool_facets)[numbers].reshape(-1, 3).any(axis=1)
    ends = np.concatenate([facets[near][:, [0, 1]], facets[near][:, [1, 2]], facets[near][:, [2, 0]]])
    edges, numbers = np.unique(np.sort(ends, axis=1), axis=0, return_inverse=True)
    hits = pierced(positions[edges[:, 0]], positions[edges[:, 1]], tool_positions[tool_facets]).any(axis=1)
    flags |= hits[numbers.reshape(3, -1)].any(axis=0)
    ends = np.concatenate([tool_facets[:, [0, 1]], tool_facets[:, [1, 2]], tool_facets[:, [2, 0]]])
    edges = np.unique(np.sort(ends, axis=1), axis=0)
    flags |= pierced(tool_positions[edges[:, 0]], tool_positions[edges[:, 1]], corners[near]).any(axis=0)
    result = np.zeros(len(facets), bool)
    result[near[flags]] = True
    return result
