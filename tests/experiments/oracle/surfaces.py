"""Metrics of facets: which cross the tool, which turned over, which pairs cross each other; and the organ's volume.

For the oracle alone; it shares nothing with the program's judge.
"""

import numpy as np

from . import geometry
from .answer import ROUNDING
from .case import to_tool

SIDES = ((0, 1), (1, 2), (2, 0))


def best(verdicts, of, count):
    """The highest verdict on each of `count` things, −1 for those that none is about."""
    highest = np.full(count, -1)
    np.maximum.at(highest, of, verdicts)
    return highest


def facets_crossing(case, positions, pose):
    """A facet crosses the tool's surface where a side of either passes through the other's facet."""
    organ = to_tool(pose, positions)[case.facets]
    organ_facets, tool_facets = geometry.meeting_boxes(geometry.box(organ), geometry.box(case.tool)).T
    organ_corners, tool_corners = organ[organ_facets], case.tool[tool_facets]
    verdicts = np.full(len(organ), -1)
    for a, b in SIDES:
        through_tool = geometry.crossings(organ_corners[:, a], organ_corners[:, b], tool_corners)
        through_organ = geometry.crossings(tool_corners[:, a], tool_corners[:, b], organ_corners)
        for one in (through_tool, through_organ):
            verdicts = np.maximum(verdicts, best(one, organ_facets, len(organ)))
    return verdicts


def flipped_facets(case, step):
    """Normals before and after handling that are more than 90° apart; a facet without area has not flipped."""
    verdicts = np.full(len(case.facets), -1)
    touched = np.flatnonzero(np.isin(case.facets, case.moved[step]).any(axis=1))
    before, after = (positions[step][case.facets[touched]] for positions in (case.found, case.handled))
    n, m = geometry.area_vectors(before), geometry.area_vectors(after)
    around = [np.sum(geometry.length(one - np.roll(one, 1, axis=1)), axis=1) for one in (before, after)]
    bound = ROUNDING * (around[0] * geometry.length(m) + around[1] * geometry.length(n))
    turned = geometry.dot(n, m)
    verdicts[touched] = np.where(np.abs(turned) <= bound, 0, np.where(turned < 0, 1, -1))
    return verdicts


def others(corners, facets, shared):
    """The corners of each facet that are not `shared`, of which there are equally many in each."""
    left = 3 - (np.count_nonzero(shared[0]) if len(shared) else 0)
    return corners[facets][~shared].reshape(len(facets), left, 3)


def crossing_pairs(case, positions, moved):
    """Pairs of facets that cross: two lists of pairs, those certain and those that rounding leaves open.

    Apart: a side of one passes through the other. With one vertex in common: the side opposite to it does. With two:
    they lie on one another, which is no more than within rounding. Only pairs with a facet in `moved` are looked at.
    """
    corners = positions[case.facets]
    which = np.flatnonzero(moved)
    pairs = geometry.meeting_boxes(geometry.box(corners[which]), geometry.box(corners))
    pairs[:, 0] = which[pairs[:, 0]]
    pairs = pairs[(pairs[:, 0] < pairs[:, 1]) | ~moved[pairs[:, 1]]]
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    same = case.facets[pairs[:, 0]][:, :, None] == case.facets[pairs[:, 1]][:, None, :]
    common = same.sum(axis=(1, 2))
    verdicts = np.full(len(pairs), -1)
    for first, second, shared in ((0, 1, same.any(axis=2)), (1, 0, same.any(axis=1))):
        apart = np.flatnonzero(common == 0)
        one, other = corners[pairs[apart, first]], corners[pairs[apart, second]]
        for a, b in SIDES:
            verdicts[apart] = np.maximum(verdicts[apart], geometry.crossings(one[:, a], one[:, b], other))
        joined = np.flatnonzero(common == 1)
        opposite = others(corners, pairs[joined, first], shared[joined])
        through = geometry.crossings(opposite[:, 0], opposite[:, 1], corners[pairs[joined, second]])
        verdicts[joined] = np.maximum(verdicts[joined], through)
    folded = np.flatnonzero(common == 2)
    verdicts[folded] = np.where(lie_on_one_another(corners, pairs[folded], same[folded]), 0, -1)
    named = np.sort(pairs, axis=1)
    return {tuple(pair) for pair in named[verdicts > 0]}, {tuple(pair) for pair in named[verdicts == 0]}


def lie_on_one_another(corners, pairs, same):
    """Whether facets with a side in common are folded onto each other, within rounding."""
    if len(pairs) == 0:
        return np.zeros(0, bool)
    tip = others(corners, pairs[:, 0], same.any(axis=2))[:, 0]
    other_tip = others(corners, pairs[:, 1], same.any(axis=1))[:, 0]
    side = corners[pairs[:, 0]][same.any(axis=2)].reshape(-1, 2, 3)
    a, b = side[:, 0], side[:, 1]
    flat = geometry.side(a, b, tip, other_tip) == 0
    way = (b - a) / geometry.length(b - a)[:, None]
    up, other_up = (p - a - geometry.dot(p - a, way)[:, None] * way for p in (tip, other_tip))
    return flat & (geometry.dot(up, other_up) > 0)


class SelfCrossings:
    """Counts pairs that cross now and did not at rest. Facets as they are at rest cross none but those of rest."""

    def __init__(self, case):
        self.case = case
        self.at_rest, self.open_at_rest = crossing_pairs(case, case.rest, np.ones(len(case.facets), bool))
        self.last = {}

    def count(self, moment, positions):
        for before, counts in self.last.values():
            if np.array_equal(before, positions):
                return counts
        off = geometry.length(positions - self.case.rest) > 1e-3
        certain, unsure = crossing_pairs(self.case, positions, off[self.case.facets].any(axis=1))
        counts = len(certain - self.at_rest - self.open_at_rest), len((certain | unsure) - self.at_rest)
        self.last[moment] = positions, counts
        return counts


def judge_surfaces(case, answers):
    crossings = SelfCrossings(case)
    volume = geometry.volume(case.rest[case.facets])
    area = geometry.length(geometry.area_vectors(case.rest[case.facets])).sum() / 2
    for step in range(case.steps):
        answers["flipped_facets"].set_count(step, flipped_facets(case, step))
        for moment, positions in (("_h", case.handled[step]), ("_d", case.deformed[step])):
            answers[f"facets_crossing{moment}"].set_count(step, facets_crossing(case, positions, case.poses[step]))
            answers[f"self_crossings{moment}"].set(step, *crossings.count(moment, positions))
        if case.closed:
            now = geometry.volume(case.deformed[step][case.facets])
            answers["volume_change"].set_value(step, now / volume - 1, 2 * ROUNDING * area / volume)
        else:
            answers["volume_change"].set_missing(step)
