"""Draws one panel of a figure: organ and tool, solid or as wires, and displacement vectors."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from .. import palette
from ..camera import Camera
from ..geometry import facets_in_tool
from ..metric_picture import draw_tool_edges
from ..rendering import Surface, render
from ..store import Step
from .crossing_vectors import crossing_edges
from .figure_file import Panel
from .wire import draw_wire


def draw_panel(axes: Axes, camera: Camera, step: Step, way: np.ndarray, panel: Panel) -> None:
    """`way` is the tool's, of any length."""
    half = (-camera.half_width, camera.half_width, -camera.half_height, camera.half_height)
    axes.set(xlim=half[:2], ylim=half[2:], xticks=[], yticks=[], facecolor=palette.BACKGROUND)
    axes.spines[:].set_visible(False)
    positions = step.positions[panel.moment]
    # A run that diverged may hold positions that are no numbers.
    facets = step.facets[np.isfinite(positions).all(axis=1)[step.facets].all(axis=1)]
    organ, tool = Surface(positions, facets), Surface(step.tool_positions, step.tool_facets)
    # Before handling what collided is in the tool: nothing of that is the strategy's doing.
    in_tool = np.zeros(len(facets), bool)
    if panel.moment != "found":
        in_tool = facets_in_tool(positions, facets, step.tool_positions, step.tool_facets)
    if panel.surface == "wire":
        draw_wire(axes, camera, organ, tool, in_tool)
    else:
        pixels, depth = render(camera, organ, tool, np.flatnonzero(in_tool), False, palette.FACET_IN_TOOL_DARK)
        axes.imshow(pixels, extent=half, aspect="auto", interpolation="none", zorder=1)
        draw_tool_edges(axes, camera, tool, depth)
    if panel.vectors != "none":
        draw_vectors(axes, camera, step, panel.vectors == "crossing")
    draw_motion(axes, camera, step, way)


def draw_motion(axes: Axes, camera: Camera, step: Step, way: np.ndarray) -> None:
    """An arrow on the tool, between its tip and the panel's upper edge: which way it goes."""
    tip = camera.see(step.tool_tip[None])[0, :2]
    across, up = camera.basis[:, :2].T @ way
    length = np.hypot(across, up)
    if length <= 1e-3 * np.linalg.norm(way):
        return
    half = 0.1 * camera.half_height * np.array([across, up]) / length
    middle = np.array([tip[0], 0.8 * camera.half_height])
    axes.annotate(
        "", middle + half, middle - half, zorder=8,
        arrowprops={"arrowstyle": "-|>", "color": palette.TOOL_OUTLINE, "linewidth": 2, "mutation_scale": 11,
                    "shrinkA": 0, "shrinkB": 0},
    )  # fmt: skip


def draw_vectors(axes: Axes, camera: Camera, step: Step, tell_apart: bool) -> None:
    """Arrows from where vertices were found to where the strategy put them; those that cross over the others."""
    found, handled = step.positions["found"], step.positions["handled"]
    crossing = np.unique(crossing_edges(found, handled, step.facets, step.moved)) if tell_apart else []
    apart = np.isin(step.moved, crossing)
    for vertices, colour, line, zorder in (
        (step.moved[~apart], palette.DISPLACEMENT, "white", 6), (step.moved[apart], palette.CROSSING, palette.INK, 7),
    ):  # fmt: skip
        starts, ends = (camera.see(positions[vertices])[:, :2] for positions in (found, handled))
        axes.quiver(
            *starts.T, *(ends - starts).T,
            angles="xy", scale_units="xy", scale=1, units="inches", width=palette.ARROW_WIDTH / 72,
            headwidth=4, headlength=5, headaxislength=4.5, minlength=0.1,
            color=colour, edgecolor=line, linewidth=0.3, zorder=zorder,
        )  # fmt: skip
