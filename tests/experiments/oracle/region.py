"""Metrics over the fixed region: strain, jitter, recovery. And the window, which also depends on the scene alone.

For the oracle alone; it shares nothing with the program's judge.
"""

import numpy as np

from . import geometry, motion
from .answer import ROUNDING
from .case import to_tool
from .surfaces import facets_crossing
from .vertices import inside_tool

LOOK = 1 / 16  # of the tool's radius: how far the tool moves between two looks


def looks(case):
    """Poses of the tool along its whole way, the start and all that lies between two steps included."""
    poses = [case.start]
    for step in range(case.steps):
        before, pose = case.pose_before(step), case.poses[step]
        if not np.array_equal(before, pose):
            poses += motion.looks(before, pose, case.tool_positions, LOOK * case.radius)
    return poses


def clearances(case):
    """From each vertex at rest to the tool when it was nearest, in radii; 0 inside, inf beyond the region."""
    low = case.tool_positions.min(axis=0) - 2.1 * case.radius
    high = case.tool_positions.max(axis=0) + 2.1 * case.radius
    nearest = np.full(len(case.rest), np.inf)
    for pose in looks(case):
        local = to_tool(pose, case.rest)
        asked = np.flatnonzero(np.all((local > low) & (local < high), axis=1) & (nearest > 1.5 * case.radius))
        distance = geometry.distances(local[asked], case.tool)
        inside = geometry.winding_numbers(local[asked], case.tool) > 0.5
        nearest[asked] = np.minimum(nearest[asked], np.where(inside, 0, distance))
    return nearest / case.radius


def fixed_region(case):
    """A verdict on each vertex. Looks 1/16 radius apart may overestimate a distance of two by 0.0003 radii, looks
    that are a quarter apart, which the definition allows, by 0.004."""
    nearest = clearances(case)
    return np.where(nearest <= 2 - 0.004, 1, np.where(nearest <= 2 + 1e-4, 0, -1))


def bounds_of_mean(values, verdicts):
    """Least and largest mean of values that belong for certain, with any of those in doubt."""
    sure, doubtful = values[verdicts > 0], np.sort(values[verdicts == 0])
    bounds = []
    for one in (doubtful, doubtful[::-1]):
        sums = sure.sum() + np.concatenate([[0], np.cumsum(one)])
        means = sums / np.maximum(1, len(sure) + np.arange(len(one) + 1))
        bounds.extend([means.min(), means.max()])
    return min(bounds), max(bounds)


def judge_region(case, answers):
    """Strain and jitter at every step, recovery at the last.

    metrics.md leaves two things open. "Vertices (and their edges)": the edges with both ends in the region, not those
    with one. x_k−2 of the second step: the state that the scene begins with, which the first step finds; the first
    has no x_k−2.
    """
    region = fixed_region(case)
    a, b = case.edges.T
    edges = np.minimum(region[a], region[b])
    rest = geometry.length(case.rest[a] - case.rest[b])
    for step, positions in enumerate(case.deformed):
        stretch = geometry.length(positions[a] - positions[b]) / rest - 1
        low, high = np.sqrt(bounds_of_mean(stretch**2, edges))
        tolerance = 2 * ROUNDING / rest.min()
        answers["strain"].set(step, low - tolerance, high + tolerance)
        if step == 0:
            answers["jitter"].set_missing(step)
            continue
        jerk = geometry.length(positions - 2 * case.found[step] + case.found[step - 1])
        low, high = bounds_of_mean(jerk, region)
        answers["jitter"].set(step, low - 2 * ROUNDING, high + 2 * ROUNDING)
    off = geometry.length(case.deformed[-1] - case.rest)
    low, high = np.sqrt(bounds_of_mean(off**2, region))
    answers["recovery"].set(case.steps - 1, low - ROUNDING, high + ROUNDING)


def judge_window(case, answers):
    """1 where the tool at its pose meets the organ at rest: a vertex in it, or a facet through its surface."""
    for step, pose in enumerate(case.poses):
        meets = max(facets_crossing(case, case.rest, pose).max(), inside_tool(case, case.rest, pose).verdicts.max())
        answers["window"].set(step, float(meets > 0), float(meets >= 0))
