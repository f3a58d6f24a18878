"""Points, segments and facets in plain numpy: solid angles, distances, crossings.

For the oracle alone; it shares nothing with the program's judge. Facets come as corners [n, 3, 3]; a verdict is 1 for
certainly, −1 for certainly not, 0 for a decision within `ROUNDING`.
"""

import numpy as np

from .answer import ROUNDING


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def cross(a, b):
    """Three times as fast as numpy.cross on many short vectors."""
    x = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    y = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    z = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return np.stack([x, y, z], axis=-1)


def length(a):
    return np.sqrt(dot(a, a))


def area_vectors(corners):
    """Normals that are twice as long as the facets are large."""
    return cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def volume(corners):
    """Of a closed surface: signed tetrahedra over the facets, seen from a point of the surface."""
    apex = corners[0, 0]
    return dot(corners[:, 0] - apex, cross(corners[:, 1] - apex, corners[:, 2] - apex)).sum() / 6


def winding_numbers(points, corners, chunk=2**18):
    """Generalised winding number of a surface around each point: its solid angle over 4π (Van Oosterom, Strackee)."""
    found = np.empty(len(points))
    rows = max(1, chunk // max(1, len(corners)))
    for start in range(0, len(points), rows):
        a, b, c = np.moveaxis(corners[None] - points[start : start + rows, None, None], 2, 0)
        la, lb, lc = length(a), length(b), length(c)
        above = dot(a, cross(b, c))
        below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
        found[start : start + rows] = np.arctan2(above, below).sum(axis=1) / (2 * np.pi)
    return found


def ray_crossings(points, corners, direction):
    """How often a ray from each point leaves a surface through a facet, less how often it enters: its winding number.

    The facets are looked at along the direction, where a point is in a facet's shadow or not.
    """
    if len(points) == 0:
        return np.zeros(0, int)
    along = direction / np.linalg.norm(direction)
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    across /= np.linalg.norm(across)
    frame = np.stack([across, np.cross(along, across), along])
    points, corners = points @ frame.T, corners @ frame.T
    corners = corners[corners[..., 2].max(axis=1) > points[:, 2].min()]
    flat = points[:, :2]
    where, which = meeting_boxes((flat, flat), box(corners[..., :2])).T
    a, b, c = np.moveaxis(corners[which], 1, 0)
    parts = np.stack([flat_area(flat[where], p, q) for p, q in ((b, c), (c, a), (a, b))])
    facing = np.sign(parts.sum(axis=0))
    height = (parts * np.stack([a, b, c])[..., 2]).sum(axis=0)
    crossed = np.all(facing * parts > 0, axis=0) & (facing * (height - parts.sum(axis=0) * points[where, 2]) > 0)
    return np.bincount(where, weights=facing * crossed, minlength=len(points)).round().astype(int)


def flat_area(o, p, q):
    """Twice the signed area of o, p, q, looked at along z."""
    return (p[:, 0] - o[:, 0]) * (q[:, 1] - o[:, 1]) - (p[:, 1] - o[:, 1]) * (q[:, 0] - o[:, 0])


def segment_distances(points, p, q):
    """From each point to each segment p[m] q[m]: [n, m]."""
    way = q - p
    part = dot(points[:, None] - p, way) / np.maximum(dot(way, way), 1e-300)
    foot = p + np.clip(part, 0, 1)[..., None] * way
    return length(points[:, None] - foot)


def distances(points, corners):
    """From each point to the nearest facet: to its plane where the foot is on the facet, else to its edges."""
    if len(points) == 0:
        return np.empty(0)
    a, b, c = np.moveaxis(corners, 1, 0)
    normal = area_vectors(corners)
    normal = normal / length(normal)[:, None]
    height = dot(points[:, None] - a, normal)
    over = np.ones(height.shape, bool)
    nearest = np.full(height.shape, np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        over &= dot(points[:, None] - p, cross(normal, q - p)) >= 0
        nearest = np.minimum(nearest, segment_distances(points, p, q))
    return np.where(over, np.abs(height), nearest).min(axis=1)


def side(a, b, c, d, slack=ROUNDING):
    """1 where d is on the side of a, b, c that their normal points to, −1 on the other, 0 where `slack` may decide.

    Moving a corner by `slack` changes the spanned volume by no more than that times the area opposite. The areas are
    bounded by lengths first, and computed where that does not do.
    """
    ab, ac, ad = b - a, c - a, d - a
    base = cross(ab, ac)
    spanned = dot(base, ad)
    bound = 2 * slack * (length(base) + length(ad) * (length(ab) + length(ac)))
    signs = np.sign(spanned).astype(int)
    close = np.flatnonzero(np.abs(spanned) <= bound)
    base, left, right = base[close], cross(ac[close], ad[close]), cross(ad[close], ab[close])
    bound = slack * (length(base) + length(left) + length(right) + length(base + left + right))
    signs[close[np.abs(spanned[close]) <= bound]] = 0
    return signs


def apart_in_plane(p, q, corners, slack):
    """Whether a line across the facet's plane divides segment from facet: tells disjoint ones in one plane apart."""
    normal = area_vectors(corners)
    apart = np.zeros(len(p), bool)
    for way in (*np.moveaxis(np.roll(corners, -1, axis=1) - corners, 1, 0), q - p):
        axis = cross(normal, way)
        axis = axis / np.maximum(length(axis), 1e-300)[:, None]
        facet = dot(corners, axis[:, None])
        segment = np.stack([dot(p, axis), dot(q, axis)], axis=1)
        apart |= facet.min(axis=1) - segment.max(axis=1) > 2 * slack
        apart |= segment.min(axis=1) - facet.max(axis=1) > 2 * slack
    return apart


def crossings(p, q, corners, slack=ROUNDING):
    """Whether each segment p[n] q[n] passes through the facet corners[n]: a verdict; ends may be off by `slack` (mm)."""
    verdicts = np.full(len(p), -1)
    a, b, c = np.moveaxis(corners, 1, 0)
    from_p, from_q = side(a, b, c, p, slack), side(a, b, c, q, slack)
    left = np.flatnonzero(from_p * from_q <= 0)
    p, q, a, b, c = p[left], q[left], a[left], b[left], c[left]
    turns = np.stack([side(p, q, *ends, slack) for ends in ((a, b), (b, c), (c, a))])
    missed = (turns.min(axis=0) < 0) & (turns.max(axis=0) > 0)
    sure = (from_p * from_q)[left] < 0
    sure &= np.abs(turns.sum(axis=0)) == 3
    verdicts[left] = np.where(missed, -1, np.where(sure, 1, 0))
    unsure = left[verdicts[left] == 0]
    if len(unsure):
        again = verdicts[left] == 0
        verdicts[unsure] = np.where(apart_in_plane(p[again], q[again], corners[unsure], slack), -1, 0)
    return verdicts


def box(corners, slack=ROUNDING):
    """Lowest and highest coordinates of each set of corners, a little widened."""
    return corners.min(axis=1) - slack, corners.max(axis=1) + slack


def meeting_boxes(first, second):
    """Index pairs (i, j) of boxes first[i], second[j] that meet; each is (lowest, highest) as `box` returns.

    Along the first axis two intervals meet where either begins in the other; the other axes are looked at then.
    """
    (low_1, high_1), (low_2, high_2) = first, second
    begins_in_first = spans(low_2[:, 0], low_1[:, 0], high_1[:, 0], "left")
    begins_in_second = spans(low_1[:, 0], low_2[:, 0], high_2[:, 0], "right")
    pairs = np.concatenate([begins_in_first, begins_in_second[:, ::-1]])
    i, j = pairs.T
    meet = np.ones(len(pairs), bool)
    for axis in range(1, low_1.shape[1]):
        meet &= (low_1[i, axis] <= high_2[j, axis]) & (high_1[i, axis] >= low_2[j, axis])
    return pairs[meet]


def spans(values, lows, highs, edge):
    """Index pairs (i, j) with values[j] from lows[i] to highs[i]; with `edge` "right" one at the low end is out."""
    order = np.argsort(values)
    start = np.searchsorted(values[order], lows, edge)
    count = np.maximum(0, np.searchsorted(values[order], highs, "right") - start)
    i = np.repeat(np.arange(len(lows)), count)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.stack([i, order[start[i] + within]], axis=1)
