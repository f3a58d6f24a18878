"""`metrics`: a picture of what a metric counts, from the made-up step that `trocar snapshot --metric` describes."""

from __future__ import annotations

import json
from pathlib import Path
from textwrap import wrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.style import context

from . import palette
from .camera import Camera, camera_from
from .errors import InputError
from .rendering import FINER, Surface, render, sharp_edges, split_by_sight
from .snapshot import MARGIN, add_scale, save

WIDTH = 7.0  # of the picture, inches
DPI = 100  # pages show it at this size
LONE_PANEL_HEIGHT = 3.3
TITLE_HEIGHT, PANEL_TITLE_HEIGHT = 0.42, 0.26
CAPTION_LINE = 0.17
CAPTION_WIDTH = 108  # letters
HALO = [withStroke(linewidth=3.2, foreground="white")]


def draw_metrics(path: str) -> str:
    """Draws each picture that the file describes; returns a line on each."""
    described = json.loads(Path(path).read_text())
    for picture in described:
        if Path(picture["output"]).suffix.lower() not in (".png", ".svg"):
            raise InputError(f"{picture['output']}: a picture's name ends in .png or .svg")
    with context(palette.STYLE):
        for picture in described:
            save(compose(picture), picture["output"])
    return "\n".join(f"{picture['output']}: {statement(picture)}" for picture in described)


def statement(picture: dict) -> str:
    """Such as "depth_max = 2 mm"."""
    units = "" if picture["units"] == "1" else f" {picture['units']}"
    return f"{picture['metric']} = {picture['value']:.4g}{units}".replace("-", "−")


def compose(picture: dict) -> Figure:
    panels, lines = picture["panels"], wrap(picture["caption"], CAPTION_WIDTH)
    panel_width = (WIDTH - MARGIN) / len(panels) - MARGIN
    panel_height = LONE_PANEL_HEIGHT if len(panels) == 1 else panel_width * picture["height"] / picture["width"]
    below = CAPTION_LINE * len(lines) + 2 * MARGIN
    height = TITLE_HEIGHT + PANEL_TITLE_HEIGHT + panel_height + below
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    figure.text(MARGIN / WIDTH, 1 - 0.55 * TITLE_HEIGHT / height, statement(picture), va="center", fontsize=13,
                fontweight="bold")  # fmt: skip
    figure.text(MARGIN / WIDTH, (below - MARGIN) / height, "\n".join(lines), va="top", fontsize=8.6,
                linespacing=1.35, color=palette.INK)  # fmt: skip
    camera = camera_from(
        np.array(picture["towards_eye"]), np.array(picture["centre"]),
        picture["height"] * panel_width / panel_height, picture["height"], round(panel_width * DPI) * FINER,
    )  # fmt: skip
    for number, panel in enumerate(panels):
        left = MARGIN + number * (panel_width + MARGIN)
        axes = figure.add_axes(
            (left / WIDTH, below / height, panel_width / WIDTH, panel_height / height)
        )
        axes.annotate(panel["title"], (0, 1), (0, 5), "axes fraction", "offset points",
                      color=palette.FAINT_INK, fontsize=9)  # fmt: skip
        draw_panel(axes, camera, picture, panel)
    add_scale(figure.axes[0], camera)
    return figure


def draw_panel(axes: Axes, camera: Camera, picture: dict, panel: dict) -> None:
    pose = np.array(panel["tool"])
    positions = np.array(panel["positions"])
    organ = Surface(positions, np.array(picture["organ_facets"]))
    tool_positions = np.array(picture["tool_positions"]) @ pose[:3, :3].T + pose[:3, 3]
    tool = Surface(tool_positions, np.array(picture["tool_facets"]))
    marked = np.array(panel["marked_facets"], int)
    pixels, depth = render(camera, organ, tool, marked, picture["cut"])
    half = (-camera.half_width, camera.half_width, -camera.half_height, camera.half_height)
    axes.imshow(pixels, extent=half, aspect="auto", interpolation="none", zorder=1)
    draw_tool_edges(axes, camera, tool, depth)
    draw_arrows(axes, camera, np.array(panel["arrows_from"]), positions)
    draw_marks(axes, camera, positions, panel)
    axes.set(xlim=half[:2], ylim=half[2:], xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def draw_tool_edges(axes: Axes, camera: Camera, tool: Surface, depth: np.ndarray) -> None:
    seen, hidden = split_by_sight(camera, sharp_edges(tool), depth)
    line = {"colors": palette.TOOL_OUTLINE, "linewidths": palette.OUTLINE_WIDTH, "zorder": 3}
    axes.add_collection(LineCollection(seen, capstyle="round", alpha=0.8, **line), autolim=False)
    axes.add_collection(LineCollection(hidden, linestyles=(0, (1, 2)), alpha=0.7, **line), autolim=False)


def draw_arrows(axes: Axes, camera: Camera, starts: np.ndarray, ends: np.ndarray) -> None:
    """Of the vertices that moved."""
    if not starts.size:
        return
    moved = np.linalg.norm(ends - starts, axis=1) > 1e-9
    start, end = (camera.see(points[moved])[:, :2] for points in (starts, ends))
    axes.quiver(
        *start.T, *(end - start).T,
        angles="xy", scale_units="xy", scale=1, units="inches", width=1.3 * palette.ARROW_WIDTH / 72,
        headwidth=4.5, headlength=5.5, headaxislength=5, minlength=0.1,
        color=palette.DISPLACEMENT, edgecolor="white", linewidth=0.35, zorder=5,
    )  # fmt: skip


def draw_marks(axes: Axes, camera: Camera, positions: np.ndarray, panel: dict) -> None:
    red = palette.PENETRATION
    if panel["marked_segments"]:
        ends = np.array(panel["marked_segments"])
        lines = camera.see(ends.reshape(-1, 3))[:, :2].reshape(-1, 2, 2)
        axes.add_collection(
            LineCollection(lines, colors=red, linewidths=1.8, capstyle="round", path_effects=HALO, zorder=6),
            autolim=False,
        )
    if panel["marked_points"]:
        points = camera.see(np.array(panel["marked_points"]))
        axes.plot(*points[:, :2].T, ".", color=red, markersize=2.6, zorder=7)
    dots = camera.see(positions[panel["marked_vertices"]].reshape(-1, 3))
    axes.plot(
        *dots[:, :2].T, "o", color=red, markersize=5.5, markeredgecolor="white", markeredgewidth=0.7, zorder=8
    )
