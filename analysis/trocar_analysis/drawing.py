"""Draws one step of one case: organ and tool, cut open along the tool's axis, and the displacements."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from . import palette
from .geometry import behind_plane, facet_normals, facets_in_tool, section
from .store import Step
from .view import View

LIGHT = np.array([-0.5, 0.7, 0.5])  # where it comes from: right, along the axis, towards the front


def draw_step(axes: Axes, step: Step, moment: str, view: View) -> None:
    """Draws the organ at `moment`, the tool, and the way from found to handled of each moved vertex."""
    axes.set(xlim=(-view.half_width, view.half_width), ylim=(-view.half_height, view.half_height))
    axes.set(aspect="equal", xticks=[], yticks=[], facecolor=palette.BACKGROUND)
    axes.spines[:].set_visible(False)
    positions = step.positions[moment]
    # A run that diverged may hold positions that are no numbers.
    facets = step.facets[np.isfinite(positions).all(axis=1)[step.facets].all(axis=1)]
    in_tool = facets_in_tool(positions, facets, step.tool_positions, step.tool_facets)
    draw_surface(axes, positions, facets, in_tool, view)
    tool = section_path(step.tool_positions, step.tool_facets, view)
    draw_section(axes, section_path(positions, facets, view), tool)
    draw_displacements(axes, step, view)
    draw_motion(axes, step, view)


def draw_surface(
    axes: Axes, positions: np.ndarray, facets: np.ndarray, in_tool: np.ndarray, view: View
) -> None:
    """The organ's facets behind the section plane and in the picture, lit, from back to front."""
    screen, heights = view.project(positions), view.heights(positions)
    low, high = screen[facets].min(axis=1), screen[facets].max(axis=1)
    edge = [view.half_width, view.half_height]
    seen = np.flatnonzero((low < edge).all(axis=1) & (-high < edge).all(axis=1))
    seen = seen[np.argsort(heights[facets[seen]].mean(axis=1), kind="stable")]
    polygons, rows = behind_plane(screen, facets[seen], heights)
    colours = facet_colours(facet_normals(positions, facets[seen]), in_tool[seen], view)[rows]
    axes.add_collection(
        PolyCollection(polygons, facecolors=colours, edgecolors=0.9 * colours, linewidths=0.25, zorder=1),
        autolim=False,
    )


def facet_colours(normals: np.ndarray, in_tool: np.ndarray, view: View) -> np.ndarray:
    """Lambert's law and some ambient light; facets seen from inside are lit from there."""
    outside = normals @ view.towards_eye >= 0
    colours = np.where(outside[:, None], to_rgb(palette.ORGAN), to_rgb(palette.ORGAN_INSIDE))
    colours[in_tool] = to_rgb(palette.FACET_IN_TOOL)
    lamp = LIGHT / np.linalg.norm(LIGHT) @ np.stack([view.right, view.axis, view.front])
    light = np.clip(np.where(outside, 1, -1) * (normals @ lamp), 0, 1)
    # A facet in the tool is a warning: it does not hide in the shade.
    brightness = np.where(in_tool, 0.9 + 0.2 * light, 0.62 + 0.5 * light)
    return np.clip(colours * brightness[:, None], 0, 1)


def section_path(positions: np.ndarray, facets: np.ndarray, view: View) -> Path:
    """Where a mesh meets the section plane, as a path of the picture. Open lines (a sheet's) are closed far
    below the picture: there the tissue goes on."""
    paths = []
    for line in section(view.project(positions), facets, view.heights(positions)):
        if not np.array_equal(line[0], line[-1]):
            down = [0, 10 * view.half_height]
            line = np.concatenate([line, [line[-1] - down, line[0] - down, line[0]]])
        paths.append(Path(line, closed=True))
    return Path.make_compound_path(*paths) if paths else Path(np.zeros((1, 2)))


def draw_section(axes: Axes, organ: Path, tool: Path) -> None:
    axes.add_patch(PathPatch(organ, facecolor=palette.ORGAN_SECTION, edgecolor="none", zorder=2))
    glass = {"facecolor": palette.TOOL, "alpha": palette.TOOL_OPACITY}
    axes.add_patch(PathPatch(tool, edgecolor="none", zorder=3, **glass))
    overlap = axes.add_patch(PathPatch(organ, facecolor=palette.PENETRATION, edgecolor="none", zorder=4))
    overlap.set_clip_path(tool, axes.transData)
    line = {"facecolor": "none", "linewidth": palette.OUTLINE_WIDTH, "joinstyle": "round"}
    axes.add_patch(PathPatch(organ, edgecolor=palette.ORGAN_OUTLINE, zorder=5, **line))
    axes.add_patch(PathPatch(tool, edgecolor=palette.TOOL_OUTLINE, zorder=6, **line))


def draw_displacements(axes: Axes, step: Step, view: View) -> None:
    """Arrows from found to handled, of the moved vertices that are not cut away."""
    found, handled = (step.positions[moment][step.moved] for moment in ("found", "handled"))
    kept = view.heights(found) <= 0
    starts, ends = view.project(found[kept]), view.project(handled[kept])
    axes.quiver(
        *starts.T, *(ends - starts).T,
        angles="xy", scale_units="xy", scale=1, units="inches", width=palette.ARROW_WIDTH / 72,
        headwidth=4.5, headlength=5.5, headaxislength=5, minlength=0.1,
        color=palette.DISPLACEMENT, edgecolor="white", linewidth=0.35, zorder=7,
    )  # fmt: skip


def draw_motion(axes: Axes, step: Step, view: View) -> None:
    """An arrow in the upper part of the tool: which way its tip went in this step."""
    way = view.project_directions(step.tool_way)
    length = np.linalg.norm(way)
    if length < 1e-3:
        return
    half = 0.13 * view.half_height * way / length
    middle = np.array([0, 0.72 * view.half_height])
    axes.annotate(
        "", middle + half, middle - half, zorder=8,
        arrowprops={"arrowstyle": "-|>", "color": palette.TOOL_OUTLINE, "linewidth": 2, "mutation_scale": 14},
    )  # fmt: skip
