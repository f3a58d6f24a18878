"""A wire model: every edge of the organ, through and through, and the tool as glass. Lines, no pixels."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from .. import palette
from ..camera import Camera
from ..geometry import facet_normals
from ..rendering import Surface, sharp_edges

NEAR_WIDTH, FAR_WIDTH, MARKED_WIDTH = 0.5, 0.5, 0.75  # points


def draw_wire(axes: Axes, camera: Camera, organ: Surface, tool: Surface, marked: np.ndarray) -> None:
    """`marked` flags the organ's facets whose edges stand out. What is turned away from the eye is paler; what lies
    farther behind the picture's centre than the picture's sides are beside it is left out."""
    seen = camera.see(organ.positions)
    shown = (seen[:, 2] > -camera.half_width)[organ.facets].all(axis=1)
    towards = facet_normals(seen, organ.facets)[:, 2] > 0
    near, in_tool = edges_of(organ.facets[shown & towards]), edges_of(organ.facets[marked])
    far = edges_of(organ.facets[shown]) - near - in_tool
    draw_lines(axes, camera, seen, far, palette.ORGAN_SECTION, FAR_WIDTH, 2)
    draw_lines(axes, camera, seen, near - in_tool, palette.ORGAN, NEAR_WIDTH, 3)
    draw_glass(axes, camera, tool)
    draw_lines(axes, camera, seen, in_tool, palette.FACET_IN_TOOL_DARK, MARKED_WIDTH, 5)


def edges_of(facets: np.ndarray) -> set[tuple[int, int]]:
    ends = np.sort(np.concatenate([facets[:, [0, 1]], facets[:, [1, 2]], facets[:, [2, 0]]]), axis=1)
    return set(map(tuple, ends.tolist()))


def draw_lines(
    axes: Axes, camera: Camera, seen: np.ndarray, edges: set[tuple[int, int]], colour: str, width: float, zorder: int
) -> None:
    """Those of the edges that are in the picture, as one path: files stay small."""
    ends = np.array(sorted(edges), int).reshape(-1, 2)
    edge = [camera.half_width, camera.half_height]
    low, high = (choose(seen[:, :2][ends], axis=1) for choose in (np.min, np.max))
    ends = ends[(low < edge).all(axis=1) & (-high < edge).all(axis=1)]
    lines = [Path(seen[trail, :2]) for trail in trails(ends.tolist())]
    if lines:
        axes.add_patch(PathPatch(Path.make_compound_path(*lines), facecolor="none", edgecolor=colour, linewidth=width,
                                 capstyle="round", joinstyle="round", zorder=zorder))  # fmt: skip


def trails(edges: list[list[int]]) -> list[list[int]]:
    """Walks along the edges that together go along each of them once, as lists of vertices. There are few of them."""
    neighbours: dict[int, set[int]] = {}
    for a, b in edges:
        neighbours.setdefault(a, set()).add(b)
        neighbours.setdefault(b, set()).add(a)
    walks = []
    for start in neighbours:
        while neighbours[start]:
            walk = [start]
            while neighbours[walk[-1]]:
                following = min(neighbours[walk[-1]])
                neighbours[walk[-1]].remove(following)
                neighbours[following].remove(walk[-1])
                walk.append(following)
            walks.append(walk)
    return walks


def draw_glass(axes: Axes, camera: Camera, tool: Surface) -> None:
    seen = camera.see(tool.positions)
    towards = facet_normals(seen, tool.facets)[:, 2] > 0
    sides = [Path(corners, closed=False) for corners in seen[tool.facets[towards]][:, :, :2]]
    axes.add_patch(PathPatch(Path.make_compound_path(*sides), facecolor=palette.TOOL, alpha=palette.TOOL_OPACITY,
                             edgecolor="none", zorder=4))  # fmt: skip
    lines = [Path(points) for points in camera.see(sharp_edges(tool).reshape(-1, 3))[:, :2].reshape(-1, 2, 2)]
    axes.add_patch(PathPatch(Path.make_compound_path(*lines), facecolor="none", edgecolor=palette.TOOL_OUTLINE,
                             linewidth=0.8, zorder=4.5))  # fmt: skip
