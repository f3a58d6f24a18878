"""Metrics of single vertices and edges: how deep, how far moved, how far off the tool, how coherently.

For the oracle alone; it shares nothing with the program's judge.
"""

from dataclasses import dataclass

import numpy as np

from . import geometry
from .answer import ROUNDING
from .case import mean_normals, to_tool


@dataclass
class Inside:
    """Where each vertex is with respect to the tool."""

    verdicts: np.ndarray  # 1 inside, 0 on the surface within rounding, −1 outside
    distance: np.ndarray  # mm to the tool's surface, inf for vertices far off

    @property
    def decided(self):
        return not np.any(self.verdicts == 0)

    @property
    def vertices(self):
        return np.flatnonzero(self.verdicts > 0)


def inside_tool(case, positions, pose):
    local = to_tool(pose, positions)
    low, high = case.tool_positions.min(axis=0), case.tool_positions.max(axis=0)
    near = np.flatnonzero(np.all((local > low - 1) & (local < high + 1), axis=1))
    verdicts, distance = np.full(len(local), -1), np.full(len(local), np.inf)
    distance[near] = geometry.distances(local[near], case.tool)
    wound = geometry.winding_numbers(local[near], case.tool) > 0.5
    verdicts[near] = np.where(distance[near] <= ROUNDING, 0, np.where(wound, 1, -1))
    return Inside(verdicts, distance)


def judge_depths(answers, step, moment, inside):
    """No vertex inside: depth_max is 0, as the program's list of metrics says; depth_mean has no value."""
    answers[f"vertices_inside{moment}"].set_count(step, inside.verdicts)
    if not inside.decided:
        return
    depths = inside.distance[inside.vertices]
    if len(depths) == 0:
        answers[f"depth_max{moment}"].set_value(step, 0, 0)
        answers[f"depth_mean{moment}"].set_missing(step)
        return
    answers[f"depth_max{moment}"].set_value(step, depths.max(), ROUNDING)
    answers[f"depth_mean{moment}"].set_value(step, depths.mean(), ROUNDING)


def judge_displacements(case, answers, step, collided):
    """Of the collided vertices. Where none collided: no value."""
    names = ("displacement_mean", "displacement_max")
    if len(collided) == 0:
        for name in names:
            answers[name].set_missing(step)
        return
    moved = geometry.length(case.handled[step, collided] - case.found[step, collided])
    for name, value in zip(names, (moved.mean(), moved.max())):
        answers[name].set_value(step, value, ROUNDING)


def judge_spread(case, answers, step, collided):
    """The edge's length is the one that handling found."""
    a, b = case.edges[np.isin(case.edges, collided).all(axis=1)].T
    if len(a) == 0:
        answers["spread"].set_missing(step)
        return
    displacement = case.handled[step] - case.found[step]
    long = geometry.length(case.found[step, a] - case.found[step, b])
    ratio = geometry.length(displacement[a] - displacement[b]) / long
    answers["spread"].set_value(step, ratio.mean(), np.mean(ROUNDING * (2 + ratio) / long))


def judge_edge_ratios(case, answers, step, moment, positions, collided):
    """Of edges with an end that collided in this step, before its handling; at D too."""
    a, b = case.edges[np.isin(case.edges, collided).any(axis=1)].T
    names = [f"edge_ratio_{figure}{moment}" for figure in ("mean", "min")]
    if len(a) == 0:
        for name in names:
            answers[name].set_missing(step)
        return
    rest = geometry.length(case.rest[a] - case.rest[b])
    ratio = geometry.length(positions[a] - positions[b]) / rest
    tolerance = ROUNDING * (1 + ratio.max()) / rest.min()
    for name, value in zip(names, (ratio.mean(), ratio.min())):
        answers[name].set_value(step, value, tolerance)


def judge_gaps(case, answers, step, moment, positions):
    """Of the vertices that handling moved and that are outside the tool now; one that is inside has no gap.

    Where none is left: no value.
    """
    moved = case.moved[step]
    pose = case.poses[step]
    distance = geometry.distances(to_tool(pose, positions[moved]), case.tool)
    outside = geometry.winding_numbers(to_tool(pose, positions[moved]), case.tool) < 0.5
    if np.any(distance <= ROUNDING):
        return
    names = [f"gap_{figure}{moment}" for figure in ("mean", "max")]
    if not outside.any():
        for name in names:
            answers[name].set_missing(step)
        return
    for name, value in zip(names, (distance[outside].mean(), distance[outside].max())):
        answers[name].set_value(step, value, ROUNDING)


def judge_drag(case, answers, step, collided, normals):
    """Mean of max(0, d · τ) over the collided vertices with a τ: where the tool moved, and not along the normal.

    v_m is the way of the tool's material at the vertex as handling found it, from the pose before to the pose now.
    """
    at = case.found[step, collided]
    pose, before = case.poses[step], case.pose_before(step)
    local = to_tool(pose, at)
    way = pose[:3, 3] - before[:3, 3] + local @ (pose[:3, :3] - before[:3, :3]).T
    long = geometry.length(way)
    if not np.any(long > 0):
        answers["drag"].set_missing(step)
        return
    way /= long[:, None]
    normal = normals[collided]
    across = way - geometry.dot(way, normal)[:, None] * normal
    angle = np.degrees(np.arcsin(np.clip(geometry.length(across), 0, 1)))
    off = ROUNDING / long  # rad: by how much rounding may turn v_m
    if np.any(np.abs(angle - 1) <= np.degrees(2 * off)):
        return
    counts = angle > 1
    if not counts.any():
        answers["drag"].set_missing(step)
        return
    across, off = across[counts], off[counts]
    tangent = across / geometry.length(across)[:, None]
    displacement = (case.handled[step] - case.found[step])[collided][counts]
    drags = np.maximum(0, geometry.dot(displacement, tangent))
    # τ turns by what v_m turns, over the sine of its angle to the normal.
    tolerance = ROUNDING + geometry.length(displacement) * 2 * off / geometry.length(across)
    answers["drag"].set_value(step, drags.mean(), tolerance.mean())


def judge_vertices(case, answers):
    normals = mean_normals(case)
    for step in range(case.steps):
        pose = case.poses[step]
        before = inside_tool(case, case.found[step], pose)
        answers["collided_vertices"].set_count(step, before.verdicts)
        if before.decided:
            judge_displacements(case, answers, step, before.vertices)
            judge_spread(case, answers, step, before.vertices)
            judge_drag(case, answers, step, before.vertices, normals)
        for moment, positions in (("_h", case.handled[step]), ("_d", case.deformed[step])):
            judge_depths(answers, step, moment, inside_tool(case, positions, pose))
            judge_gaps(case, answers, step, moment, positions)
            if before.decided:
                judge_edge_ratios(case, answers, step, moment, positions, before.vertices)
