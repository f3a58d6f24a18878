"""Metrics of ways: through the tool undetected, in on one side and out on the other, displacements that cross.

For the oracle alone; it shares nothing with the program's judge.
"""

import numpy as np

from . import geometry, motion
from .answer import ROUNDING
from .case import to_tool
from .vertices import inside_tool

OPPOSITE = -0.7071
NEAR = 0.1  # of the edge's length
PARALLEL = np.radians(5)


class Walls:
    """Which facets of the tool ways in the tool's frame pass, and where; each way is of chords of equal length.

    Verdicts, places and directions are [ways, chords · facets]: a chord's facets side by side.
    """

    def __init__(self, tool, places, slack=ROUNDING):
        """Of ways through `places` [chords + 1, ways, 3], which may be off by `slack` (mm)."""
        chords, ways, self.facets = len(places) - 1, places.shape[1], len(tool)
        start, end = places[:-1].reshape(-1, 3), places[1:].reshape(-1, 3)
        verdicts = np.full((chords * ways, self.facets), -1)
        place, inwards = np.full(verdicts.shape, np.nan), np.zeros(verdicts.shape, bool)
        normals = geometry.area_vectors(tool)
        normals /= geometry.length(normals)[:, None]
        boxes = geometry.box(np.stack([start, end], axis=1), slack), geometry.box(tool)
        rows, facets = geometry.meeting_boxes(*boxes).T
        p, q = start[rows], end[rows]
        verdicts[rows, facets] = geometry.crossings(p, q, tool[facets], slack)
        fall = geometry.dot(q - p, normals[facets])
        height = geometry.dot(p - tool[facets, 0], normals[facets])
        place[rows, facets] = rows // max(ways, 1) + height / np.where(fall == 0, np.nan, -fall)
        inwards[rows, facets] = fall < 0

        def by_way(found):
            return found.reshape(chords, ways, self.facets).swapaxes(0, 1).reshape(ways, chords * self.facets)

        self.verdicts, self.place, self.inwards = by_way(verdicts), by_way(place), by_way(inwards)
        self.doubt = slack / np.maximum(geometry.length(places[1] - places[0]), slack)  # of a chord

    def last(self, way, inwards):
        """Facets that may be the last one that this way goes in (out) through."""
        passed = (self.verdicts[way] >= 0) & (self.inwards[way] == inwards) & np.isfinite(self.place[way])
        sure = passed & (self.verdicts[way] > 0)
        furthest = np.max(self.place[way], where=sure if sure.any() else passed, initial=-np.inf)
        return np.flatnonzero(passed & (self.place[way] >= furthest - self.doubt[way])) % self.facets


def tunnelled(before, now, on_the_way):
    """Whether a vertex that is outside now was in the tool since the step before handled it: a verdict.

    From verdicts on being inside before and after the tool's move, and on passing the tool's facets from one handling
    to the next. metrics.md leaves two things open. "Within the step" is from that handling to the next detection:
    deformation, then the tool's move. "Went through" is having been in it at any time of that, so a vertex that
    deformation pulls in counts too where the tool's move lets it go.
    """
    was_in = np.maximum(before, on_the_way)
    return np.where(now < 0, was_in, np.where(now == 0, np.minimum(was_in, 0), -1))


class Entries:
    """Through which facets of the tool each vertex that is inside may have come in since it was last outside."""

    def __init__(self, case):
        self.case = case
        self.entered = {}

    def follow(self, vertices, walls, starts, ends):
        """Takes the ways of these vertices; verdicts on being inside at the start and the end of each."""
        for way, vertex in enumerate(vertices):
            if ends[way] < 0:
                self.entered.pop(vertex, None)
                continue
            came_in = walls.last(way, inwards=True)
            if starts[way] < 0 or walls.verdicts[way].max(initial=-1) > 0:
                self.entered[vertex] = came_in

    def opposite(self, vertex, out):
        """Whether the vertex was put out through the facets `out` on the side opposite to its entry: a verdict.

        One that is not known to have entered (inside at the start of the scene) did not.
        """
        if vertex not in self.entered:
            return -1
        normals = geometry.area_vectors(self.case.tool)
        normals /= geometry.length(normals)[:, None]
        turned = (normals[self.entered[vertex]] @ normals[out].T).ravel() < OPPOSITE
        if turned.size == 0 or turned.any() != turned.all():
            return 0
        return 1 if turned.all() else -1


def near_tool(case, places, slack):
    """Vertices of whose way in the tool's frame, along these places, the box comes near the tool's."""
    low, high = places.min(axis=0) - slack, places.max(axis=0) + slack
    meet = (low <= case.tool_positions.max(axis=0)) & (high >= case.tool_positions.min(axis=0))
    return np.flatnonzero(meet.all(axis=1))


def judge_ways(case, answers):
    """A step is three ways in the tool's frame: the tool moves by a screw, handling moves, deformation moves."""
    entries = Entries(case)
    passed = np.full(len(case.rest), -1)  # in the deformation of the step before
    for step in range(case.steps):
        pose, before = case.poses[step], case.pose_before(step)
        states = [(before, case.found), (pose, case.found), (pose, case.handled), (pose, case.deformed)]
        inside = [inside_tool(case, positions[step], at).verdicts for at, positions in states]
        on_screw, slack = motion.screw(before, pose, case.tool_positions)
        poses = [*on_screw, pose, pose]
        moments = [*[case.found] * len(on_screw), case.handled, case.deformed]
        places = np.stack([to_tool(at, positions[step]) for at, positions in zip(poses, moments)])
        near = np.union1d(near_tool(case, places, slack), np.flatnonzero(passed >= 0))
        walls = [
            Walls(case.tool, places[:-2, near], slack),
            Walls(case.tool, places[-3:-1, near]),
            Walls(case.tool, places[-2:, near]),
        ]
        passes = [one.verdicts.max(axis=1, initial=-1) for one in walls]

        on_the_way = np.maximum(passed[near], passes[0])
        answers["tunnelled"].set_count(step, tunnelled(inside[0][near], inside[1][near], on_the_way))
        passed[:] = -1
        passed[near] = passes[2]

        entries.follow(near, walls[0], inside[0][near], inside[1][near])
        answers["tool_crossings"].set_count(step, tool_crossings(entries, near, walls[1], inside[1], inside[2]))
        entries.follow(near, walls[1], inside[1][near], inside[2][near])
        entries.follow(near, walls[2], inside[2][near], inside[3][near])

        answers["displacement_crossings"].set_count(step, displacement_crossings(case, step, inside[1]))


def tool_crossings(entries, near, walls, found, handled):
    """Of vertices found inside and put outside: whether the last facet that the displacement leaves the tool through
    is opposite to the one of the entry. A verdict on each of `near`."""
    verdicts = np.full(len(near), -1)
    for way, vertex in enumerate(near):
        if found[vertex] >= 0 and handled[vertex] <= 0:
            sure = found[vertex] > 0 and handled[vertex] < 0
            verdict = entries.opposite(vertex, walls.last(way, inwards=False))
            verdicts[way] = verdict if sure else min(verdict, 0)
    return verdicts


def displacement_crossings(case, step, collided):
    """Of each edge between collided vertices; its length is the one that handling found.

    Inner points: the ways come closest to one another at an inner point of both.
    """
    verdicts = np.full(len(case.edges), -1)
    both = np.flatnonzero((collided[case.edges] >= 0).all(axis=1))
    if len(both) == 0:
        return verdicts
    a, b = case.edges[both].T
    start, end = case.found[step], case.handled[step]
    edge, after = start[b] - start[a], end[b] - end[a]
    turn = geometry.dot(edge, after)
    bound = 2 * ROUNDING * (geometry.length(edge) + geometry.length(after))
    turned = np.where(np.abs(turn) <= bound, 0, np.where(turn < 0, 1, -1))
    crossed = np.array([ways_cross(start[i], end[i], start[j], end[j]) for i, j in zip(a, b)])
    sure = (collided[case.edges[both]] > 0).all(axis=1)
    verdicts[both] = np.where(sure, np.maximum(turned, crossed), np.minimum(np.maximum(turned, crossed), 0))
    return verdicts


def ways_cross(p, p_end, q, q_end):
    """Whether two displacements pass one another: near, at inner points, and not alongside: a verdict."""
    u, v, apart = p_end - p, q_end - q, q - p
    long_u, long_v, edge = (np.linalg.norm(one) for one in (u, v, apart))
    if min(long_u, long_v) <= 4 * ROUNDING:
        return -1
    normal = np.cross(u, v)
    sine = np.linalg.norm(normal) / (long_u * long_v)
    slack = ROUNDING / min(long_u, long_v)  # rad
    if sine < np.sin(PARALLEL) - 4 * slack:
        return -1
    s = np.dot(np.cross(apart, v), normal) / np.dot(normal, normal)
    t = np.dot(np.cross(apart, u), normal) / np.dot(normal, normal)
    distance = abs(np.dot(apart, normal)) / np.linalg.norm(normal)
    # Each is positive where the condition holds; rounding is worth as much as it moves the crossing point.
    moved = 4 * ROUNDING * (1 + edge / min(long_u, long_v)) / sine
    margins = np.array([
        (sine - np.sin(PARALLEL)) / (4 * slack),
        s * long_u / moved, (1 - s) * long_u / moved, t * long_v / moved, (1 - t) * long_v / moved,
        (NEAR * edge - distance) / moved,
    ])  # fmt: skip
    if margins.min() < -1:
        return -1
    return 1 if margins.min() > 1 else 0
