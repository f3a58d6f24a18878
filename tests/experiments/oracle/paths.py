"""Metrics of ways: through the tool undetected, in on one side and out on the other, displacements that cross.

For the oracle alone; it shares nothing with the program's judge.
"""

import numpy as np

from . import geometry
from .answer import ROUNDING
from .case import to_tool
from .vertices import inside_tool

OPPOSITE = -0.7071
NEAR = 0.1  # of the edge's length
PARALLEL = np.radians(5)


class Walls:
    """Which facets of the tool a straight way [n] in the tool's frame passes, and where."""

    def __init__(self, tool, start, end):
        count = len(tool)
        self.verdicts = np.full((len(start), count), -1)
        self.place = np.full((len(start), count), np.nan)
        normals = geometry.area_vectors(tool)
        normals /= geometry.length(normals)[:, None]
        ways, facets = geometry.meeting_boxes(geometry.box(np.stack([start, end], axis=1)), geometry.box(tool)).T
        p, q = start[ways], end[ways]
        self.verdicts[ways, facets] = geometry.crossings(p, q, tool[facets])
        fall = geometry.dot(q - p, normals[facets])
        height = geometry.dot(p - tool[facets, 0], normals[facets])
        self.place[ways, facets] = height / np.where(fall == 0, np.nan, -fall)
        self.inwards = np.zeros((len(start), count), bool)
        self.inwards[ways, facets] = fall < 0
        self.long = geometry.length(end - start)

    def last(self, way, inwards):
        """Facets that may be the last one that this way goes in (out) through."""
        passed = (self.verdicts[way] >= 0) & (self.inwards[way] == inwards) & np.isfinite(self.place[way])
        sure = passed & (self.verdicts[way] > 0)
        furthest = np.max(self.place[way], where=sure if sure.any() else passed, initial=-np.inf)
        return np.flatnonzero(passed & (self.place[way] >= furthest - ROUNDING / max(self.long[way], ROUNDING)))


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


def near_tool(case, *ends):
    """Vertices of whose way in the tool's frame the box comes near the tool's."""
    low, high = np.minimum.reduce(ends), np.maximum.reduce(ends)
    meet = (low <= case.tool_positions.max(axis=0) + ROUNDING) & (high >= case.tool_positions.min(axis=0) - ROUNDING)
    return np.flatnonzero(meet.all(axis=1))


def judge_ways(case, answers):
    """A step is three ways in the tool's frame: the tool moves, handling moves, deformation moves."""
    entries = Entries(case)
    passed = np.full(len(case.rest), -1)  # in the deformation of the step before
    for step in range(case.steps):
        pose, before = case.poses[step], case.pose_before(step)
        states = [(before, case.found), (pose, case.found), (pose, case.handled), (pose, case.deformed)]
        places = [to_tool(at, positions[step]) for at, positions in states]
        inside = [inside_tool(case, positions[step], at).verdicts for at, positions in states]
        near = np.union1d(near_tool(case, *places), np.flatnonzero(passed >= 0))
        walls = [Walls(case.tool, start[near], end[near]) for start, end in zip(places, places[1:])]
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
