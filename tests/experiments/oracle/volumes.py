"""Metrics of what of the tool is in the organ: points of its surface, and its volume, both by sampling.

Inside is where the organ's winding number is at least 1. The samples are the oracle's own: it shares nothing with the
program's judge.
"""

import numpy as np

from . import geometry
from .case import closed_beneath

DENSITY = 8  # samples a mm² of the tool's surface
CELLS = 32000  # of the box in which tool and organ overlap
VOLUME_STEPS = 6  # of a case


def allowed(volume):
    """By how much metrics.md lets the program's volume be off: 1 % or 0.1 mm³."""
    return np.maximum(0.01 * volume, 0.1)


def surface_points(tool, generator):
    """Points spread evenly over the facets, each of which is cut into equal strips with one point in every strip."""
    points = []
    for a, b, c in tool:
        count = int(np.ceil(DENSITY * np.linalg.norm(np.cross(b - a, c - a)) / 2))
        u = np.sqrt((np.arange(count) + generator.random(count)) / count)  # of the way from a to the side b c
        v = (np.arange(count) * 0.6180339887 + generator.random()) % 1
        points.append(a + (u * (1 - v))[:, None] * (b - a) + (u * v)[:, None] * (c - a))
    return np.concatenate(points)


class Sampler:
    def __init__(self, case, generator):
        self.case = case
        self.generator = generator
        self.points = surface_points(case.tool, generator)
        self.area = geometry.length(geometry.area_vectors(case.tool)).sum() / 2
        self.skew = generator.normal(size=3) * 0.05 + [0, 0, 1]  # of the rays, in the tool's frame

    def organ(self, positions, pose):
        corners = closed_beneath(self.case, positions)
        return (corners - pose[:3, 3]) @ pose[:3, :3]

    def in_organ(self, points, organ):
        """Whether each point is inside; the organ is asked about those in its box alone."""
        tested = np.flatnonzero(np.all((points > organ.min(axis=(0, 1))) & (points < organ.max(axis=(0, 1))), axis=1))
        inside = np.zeros(len(points), bool)
        inside[tested] = geometry.ray_crossings(points[tested], organ, self.skew) >= 1
        return inside

    def points_inside(self, organ):
        """How many of one sample a mm² are inside, and how far off another even sample of as many may be.

        In doubt are the samples along the boundary of the part that is inside, one a mm, each by a throw of a coin:
        four standard deviations. The boundary is taken to be twice as long as that of a round patch.
        """
        inside = self.in_organ(self.points, organ).mean() * self.area
        if inside == 0:
            return 0.0, 1.0
        patch = min(inside, self.area - inside)
        return inside, 1 + 4 * np.sqrt(4 * np.sqrt(np.pi * patch)) / 2

    def volume_inside(self, organ):
        """By one random point in each cell of a grid over the box that tool and organ share; with its tolerance.

        Only cells that the common part's surface cuts are in doubt. About half of those that differ from a neighbour
        are cut, at random, so their share has a variance of 1/6. The tolerance is four standard deviations of the
        sum.
        """
        case = self.case
        low = np.maximum(case.tool_positions.min(axis=0), organ.min(axis=(0, 1)))
        high = np.minimum(case.tool_positions.max(axis=0), organ.max(axis=(0, 1)))
        if np.any(low >= high):
            return 0.0, 0.0
        size = np.cbrt(np.prod(high - low) / CELLS)
        shape = np.maximum(1, np.round((high - low) / size)).astype(int)
        cell = (high - low) / shape
        grid = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 3)
        points = low + (grid + self.generator.random(grid.shape)) * cell
        inside = self.in_organ(points, organ)
        inside[inside] = geometry.ray_crossings(points[inside], case.tool, self.skew) > 0
        doubtful = np.count_nonzero(differ_from_neighbour(inside.reshape(shape)))
        return inside.sum() * np.prod(cell), 4 * np.prod(cell) * np.sqrt(doubtful / 12)


def differ_from_neighbour(inside):
    differ = np.zeros(inside.shape, bool)
    for axis in range(inside.ndim):
        for shift in (1, -1):
            beside = np.roll(inside, shift, axis=axis)
            beside.swapaxes(0, axis)[0 if shift == 1 else -1] = False  # nothing lies beyond the box
            differ |= inside != beside
    return differ


def volume_steps(case):
    """Steps of the window, evenly chosen; the first of a case whose tool never meets the organ."""
    window = np.flatnonzero(case.series["window"])
    if len(window) == 0:
        window = np.zeros(1, int)
    return np.unique(window[np.linspace(0, len(window) - 1, VOLUME_STEPS).astype(int)])


def judge_volumes(case, answers, generator):
    names = ("tool_points_inside", "tool_volume_inside")
    sampler = Sampler(case, generator)
    chosen = volume_steps(case)
    for step in range(case.steps):
        rest = answers["tool_volume_at_rest"]
        if not case.closed and not case.heightfield:
            rest.set_missing(step)
        elif step in chosen:
            volume, tolerance = sampler.volume_inside(sampler.organ(case.rest, case.poses[step]))
            rest.set_value(step, volume, tolerance + allowed(volume))
        for moment, positions in (("_h", case.handled[step]), ("_d", case.deformed[step])):
            if not case.closed and not case.heightfield:
                for name in names:
                    answers[name + moment].set_missing(step)
                continue
            organ = sampler.organ(positions, case.poses[step])
            answers[f"tool_points_inside{moment}"].set_value(step, *sampler.points_inside(organ))
            if step in chosen:
                volume, tolerance = sampler.volume_inside(organ)
                answers[f"tool_volume_inside{moment}"].set_value(step, volume, tolerance + allowed(volume))


def compare_sums(name, stored, answer):
    """Complaints about a volume that is off by little but always the same way: errors of sampling cancel in a sum."""
    steps = np.flatnonzero(answer.known & ~np.isnan(answer.low))
    volume, half = (answer.high + answer.low)[steps] / 2, (answer.high - answer.low)[steps] / 2
    off = abs(np.sum(stored[steps] - volume))
    most = np.sqrt(np.sum((half - allowed(volume)) ** 2)) + allowed(volume).sum()
    if off <= most:
        return []
    return [f"{name}: off by {off:.3g} mm³ in the sum of {len(steps)} steps, more than {most:.3g}"]


def rays_agree_with_solid_angles(case, generator):
    """Whether both ways to the winding number say the same of points around the tip, amid the window."""
    steps = volume_steps(case)
    step = steps[len(steps) // 2]
    sampler = Sampler(case, generator)
    organ = sampler.organ(case.handled[step], case.poses[step])
    points = generator.uniform([-8, -8, -4], [8, 8, 16], (200, 3))
    angles = geometry.winding_numbers(points, organ)
    return np.array_equal(np.round(angles), geometry.ray_crossings(points, organ, sampler.skew))
