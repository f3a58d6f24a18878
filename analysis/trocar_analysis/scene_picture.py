"""`scene`: a picture of a scene before anything runs, from the description that `trocar snapshot --scene` writes."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.style import context

from . import palette
from .drawing import draw_surface, section_path
from .errors import InputError
from .geometry import facet_normals
from .snapshot import DPI, add_scale, choose_step, save
from .view import View, across, principal

WIDTH, HEIGHT = 11.0, 5.6  # inches
LEGEND = (
    "Left: the state that the scene starts from. Right: the same, cut along the tool's axis; dashed: the tool at the "
    "start, solid: at its deepest.\nLine: the way of the tip, with a dot after each step. Red: the entry point."
)
EYE = (0.25, 0.72, 0.65)  # where the whole is seen from: along t, n × t, n


@dataclass(frozen=True)
class Scene:
    title: str
    organ_positions: np.ndarray  # [vertices, 3] in the state the scene starts from, mm
    organ_facets: np.ndarray
    tool_positions: np.ndarray  # in the tool's frame
    tool_facets: np.ndarray
    start: np.ndarray  # [4, 4], tool to world
    poses: np.ndarray  # [steps, 4, 4], at the end of each step
    entry: np.ndarray
    normal: np.ndarray
    tangent: np.ndarray

    def tool_at(self, pose: np.ndarray) -> np.ndarray:
        return self.tool_positions @ pose[:3, :3].T + pose[:3, 3]

    @property
    def tips(self) -> np.ndarray:
        """The tip's way, from the start on."""
        return np.concatenate([self.start[None, :3, 3], self.poses[:, :3, 3]])


def read_scene(path: str) -> Scene:
    described = json.loads(Path(path).read_text())
    array = {name: np.array(value) for name, value in described.items() if isinstance(value, list)}
    title = " · ".join(
        [described[name] for name in ("scene", "organ", "tool")]
        + [f"{described['speed']:g} mm/s", f"seed {described['seed']}", f"{len(array['poses'])} steps",
           f"{np.count_nonzero(array['window'])} of them count", f"{len(array['organ_facets'])} facets"]
    )  # fmt: skip
    return Scene(title, **{name: array[name] for name in Scene.__dataclass_fields__ if name != "title"})


def draw_scene(path: str, output: str) -> str:
    """Draws the whole and a section along the tool's axis into `output`; returns a line that says so."""
    if Path(output).suffix.lower() not in (".png", ".svg"):
        raise InputError(f"{output}: a picture's name ends in .png or .svg")
    scene = read_scene(path)
    with context(palette.STYLE):
        figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DPI)
        FigureCanvasAgg(figure)
        draw_whole(figure.add_axes((0.005, 0.07, 0.52, 0.86)), scene)
        draw_cut(figure.add_axes((0.53, 0.07, 0.465, 0.86)), scene)
        figure.text(0.01, 0.962, scene.title, va="center", fontsize=10)
        figure.text(0.01, 0.033, LEGEND, va="center", fontsize=8, color=palette.FAINT_INK)
        save(figure, output)
    return f"{output}: {scene.title}"


def draw_whole(axes: Axes, scene: Scene) -> None:
    """Organ and tool at the start, and the tip's way, in parallel projection; nearer facets hide others."""
    towards_eye = np.array(EYE) @ np.stack([scene.tangent, np.cross(scene.normal, scene.tangent), scene.normal])
    towards_eye /= np.linalg.norm(towards_eye)
    right = np.cross(scene.normal, towards_eye)
    right /= np.linalg.norm(right)
    screen = np.stack([right, np.cross(towards_eye, right)], axis=1)

    tool = scene.tool_at(scene.start)
    positions = np.concatenate([scene.organ_positions, tool])
    facets = np.concatenate([scene.organ_facets, scene.tool_facets + len(scene.organ_positions)])
    normals = facet_normals(positions, facets) @ towards_eye
    base = np.where((normals >= 0)[:, None], to_rgb(palette.ORGAN), to_rgb(palette.ORGAN_INSIDE))
    base[len(scene.organ_facets) :] = to_rgb(palette.TOOL)
    light = facet_normals(positions, facets) @ (towards_eye + 0.6 * right + 0.4 * screen[:, 1])
    colours = np.clip(base * (0.55 + 0.42 * np.abs(light) / 1.23)[:, None], 0, 1)
    order = np.argsort((positions[facets] @ towards_eye).max(axis=1))
    fine = len(facets) > 20_000
    axes.add_collection(
        PolyCollection(
            (positions @ screen)[facets[order]], facecolors=colours[order],
            edgecolors=(1 if fine else 0.92) * colours[order], linewidths=0.2, zorder=1,
        )  # fmt: skip
    )
    tips = scene.tips @ screen
    axes.plot(*tips.T, color=palette.INK, linewidth=0.9, zorder=3)
    axes.plot(*(scene.entry @ screen), "o", color=palette.PENETRATION, markersize=4, zorder=4)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(xticks=[], yticks=[], facecolor=palette.BACKGROUND)
    axes.spines[:].set_visible(False)
    axes.autoscale_view()
    axes.margins(0.04)


def draw_cut(axes: Axes, scene: Scene) -> None:
    """A section along the tool's axis at its deepest: organ at the start, tool at the start and at its deepest."""
    poses = np.concatenate([scene.start[None], scene.poses])
    deepest = scene.tool_at(poses[choose_step("deepest", poses)])
    view = view_of(scene, np.linalg.norm(scene.tool_positions[:, :2], axis=1).max())
    axes.set(xlim=(-view.half_width, view.half_width), ylim=(-view.half_height, view.half_height))
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(xticks=[], yticks=[], facecolor=palette.BACKGROUND)
    axes.spines[:].set_visible(False)
    none_in_tool = np.zeros(len(scene.organ_facets), bool)
    draw_surface(axes, scene.organ_positions, scene.organ_facets, none_in_tool, view)
    organ = section_path(scene.organ_positions, scene.organ_facets, view)
    axes.add_patch(
        PathPatch(organ, facecolor=palette.ORGAN_SECTION, edgecolor=palette.ORGAN_OUTLINE, zorder=2,
                  linewidth=palette.OUTLINE_WIDTH)
    )  # fmt: skip
    outline(axes, scene.tool_at(scene.start), scene.tool_facets, view, "dashed", 0.12)
    outline(axes, deepest, scene.tool_facets, view, "solid", palette.TOOL_OPACITY)
    axes.plot(*view.project(scene.tips).T, color=palette.INK, linewidth=0.9, marker=".", markersize=3, zorder=6)
    axes.plot(*view.project(scene.entry), "o", color=palette.PENETRATION, markersize=5, zorder=7)
    add_scale(axes, view)


def view_of(scene: Scene, tool_radius: float) -> View:
    """Upright along the tool's axis, cut along its way aside (or any way, where it has none), with the whole way of
    the tip in sight."""
    axis = scene.start[:3, 2]
    aside = across(scene.tips - scene.entry, axis)
    right = principal(aside, axis) if np.abs(aside).max() > tool_radius else scene.tangent
    ways = (scene.tips - scene.entry) @ np.stack([right, axis], axis=1)
    low, high = ways.min(axis=0), ways.max(axis=0)
    middle = (low + high) / 2
    half = max(*(high - low) / 2 + 2.5 * tool_radius)
    return View(scene.entry + middle[0] * right + middle[1] * axis, right, axis, half, half)


def outline(
    axes: Axes, positions: np.ndarray, facets: np.ndarray, view: View, style: str, opacity: float
) -> None:
    path = section_path(positions, facets, view)
    axes.add_patch(PathPatch(path, facecolor=palette.TOOL, edgecolor="none", alpha=opacity, zorder=3))
    axes.add_patch(
        PathPatch(path, facecolor="none", edgecolor=palette.TOOL_OUTLINE, linestyle=style,
                  linewidth=palette.OUTLINE_WIDTH, zorder=5)
    )  # fmt: skip
