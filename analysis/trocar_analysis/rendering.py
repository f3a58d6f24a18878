"""An organ, lit, with a tool of glass in it, as the pixels of a picture: nearer things hide others, wherever the two
pass through each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.colors import to_rgb

from . import palette
from .camera import Camera, fragments
from .geometry import facet_normals

LAMP = np.array([0.35, 0.75, 0.55])  # direction towards it: right, up, towards the eye
LINE = 0.9  # width of an organ's edge, pixels of the finished picture
FINER = 3  # pixels are made so many times finer, and averaged
FRONT_GLASS, BACK_GLASS = 0.30, 0.16  # opacity of the tool's near and far sides
NOWHERE = -1e9  # depth where nothing is


@dataclass(frozen=True)
class Surface:
    """A mesh in the world."""

    positions: np.ndarray
    facets: np.ndarray


def render(
    camera: Camera, organ: Surface, tool: Surface, marked: np.ndarray, cut: bool, mark: str = palette.FACET_IN_TOOL
) -> tuple[np.ndarray, np.ndarray]:
    """The picture's colours, [rows, columns, 3], and the depth of what hides the tool at each of its finer pixels.

    `marked` are numbers of the organ's facets, which get the colour `mark`. Where `cut`, the part of the organ with y below that of the picture's
    centre is left out, and the section is filled. The eye has to be on that side."""
    colours, depth = draw_organ(camera, organ, marked, cut, mark)
    colours = draw_glass(camera, tool, colours, depth)
    rows, columns = (size // FINER for size in camera.shape)
    blocks = colours[: rows * FINER, : columns * FINER].reshape(rows, FINER, columns, FINER, 3)
    return blocks.mean(axis=(1, 3)), depth


def brightness(normals: np.ndarray) -> np.ndarray:
    """Lambert's law and some ambient light, of surfaces with these normals."""
    return 0.66 + 0.42 * np.clip(normals @ (LAMP / np.linalg.norm(LAMP)), 0, 1)


def draw_organ(
    camera: Camera, organ: Surface, marked: np.ndarray, cut: bool, mark: str
) -> tuple[np.ndarray, np.ndarray]:
    depth = np.full(camera.shape, NOWHERE)
    from_within = np.zeros(camera.shape, bool)
    colours = np.empty((*camera.shape, 3))
    colours[:] = to_rgb(palette.BACKGROUND)
    seen = camera.see(organ.positions)
    normals = facet_normals(seen, organ.facets)
    outside = normals[:, 2] >= 0
    facet_colours = np.where(outside[:, None], to_rgb(palette.ORGAN), to_rgb(palette.ORGAN_INSIDE))
    facet_colours[marked] = to_rgb(mark)
    facet_colours *= brightness(np.where(outside[:, None], normals, -normals))[:, None]
    plane = section_depth(camera) if cut else np.full(camera.shape, np.inf)
    line = np.array(to_rgb(palette.ORGAN_OUTLINE))
    for fragment in fragments(camera, seen, organ.facets):
        near = fragment.covered & (fragment.depth > depth[fragment.window])
        near &= fragment.depth <= plane[fragment.window]
        depth[fragment.window][near] = fragment.depth[near]
        from_within[fragment.window][near] = not outside[fragment.facet]
        share = np.clip(0.5 * LINE - fragment.to_edge / camera.pixel / FINER + 0.5, 0, 1)[near, None] * 0.55
        colours[fragment.window][near] = (1 - share) * facet_colours[fragment.facet] + share * line
    if cut:
        colours[from_within] = to_rgb(palette.ORGAN_SECTION)
        depth[from_within] = plane[from_within]
    return np.clip(colours, 0, 1), depth


def section_depth(camera: Camera) -> np.ndarray:
    """Of the plane of the section at each pixel: what is nearer to the eye is left out."""
    rows, columns = camera.shape
    across, upwards, towards = camera.basis[1]  # y in the picture's coordinates
    right = (np.arange(columns) + 0.5) * camera.pixel - camera.half_width
    up = camera.half_height - (np.arange(rows) + 0.5) * camera.pixel
    return -(right * across + up[:, None] * upwards) / towards


def draw_glass(camera: Camera, tool: Surface, colours: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """The tool over what is there, but for what of it is behind the organ."""
    seen = camera.see(tool.positions)
    normals = facet_normals(seen, tool.facets)
    towards = np.where(normals[:, 2:] >= 0, normals, -normals)
    own = np.array(to_rgb(palette.TOOL)) * (0.55 + 0.75 * brightness(towards))[:, None]
    opacity = np.where(normals[:, 2] >= 0, FRONT_GLASS, BACK_GLASS)
    through = np.ones(camera.shape)
    glass, weight = np.zeros(colours.shape), np.full(camera.shape, 1e-12)
    for fragment in fragments(camera, seen, tool.facets):
        near = fragment.covered & (fragment.depth > depth[fragment.window])
        share = opacity[fragment.facet]
        through[fragment.window][near] *= 1 - share
        glass[fragment.window][near] += share * own[fragment.facet]
        weight[fragment.window][near] += share
    return np.clip(colours * through[..., None] + glass / weight[..., None] * (1 - through[..., None]), 0, 1)


def sharp_edges(surface: Surface) -> np.ndarray:
    """The ends of the edges at which the surface bends by more than 10°, [edges, 2, 3]."""
    normals = facet_normals(surface.positions, surface.facets)
    first, edges = {}, []
    for facet, corners in enumerate(surface.facets):
        for edge in zip(corners, np.roll(corners, -1)):
            other = first.setdefault(frozenset(edge), facet)
            if other != facet and normals[facet] @ normals[other] < np.cos(np.radians(10)):
                edges.append(surface.positions[list(edge)])
    return np.array(edges)


def split_by_sight(
    camera: Camera, edges: np.ndarray, depth: np.ndarray
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """The parts of edges that are seen and those that the organ hides, each as points of the picture."""
    parts = ([], [])
    for start, end in edges:
        line = camera.see(start + np.linspace(0, 1, 300)[:, None] * (end - start))
        hidden = line[:, 2] < depth[camera.pixel_of(line)] - 2 * camera.pixel
        breaks = np.flatnonzero(np.diff(hidden)) + 1
        for run in np.split(np.arange(len(line)), breaks):
            parts[int(hidden[run[0]])].append(line[run, :2])
    return parts
