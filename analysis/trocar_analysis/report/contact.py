"""Where an organ and the tool are in each other, for drawing. Floating point: the figures that are printed as numbers come from
the result file, whose metrics are decided exactly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry import distances, facets_in_tool, inside

ON_SURFACE = 1e-3  # mm: a vertex that is no deeper is on the tool's surface; handling puts vertices there


@dataclass(frozen=True)
class Contact:
    """Of one moment."""

    facets: np.ndarray  # numbers of those that cross the tool's surface or lie inside it
    vertices: np.ndarray  # numbers of those inside the tool
    depths: np.ndarray  # of these: to the tool's surface, mm


def contact(positions: np.ndarray, facets: np.ndarray, tool: np.ndarray, tool_facets: np.ndarray) -> Contact:
    low, high = tool.min(axis=0), tool.max(axis=0)
    near = np.flatnonzero(((positions >= low) & (positions <= high)).all(axis=1))
    vertices = near[inside(positions[near], tool, tool_facets)]
    depths = distances(positions[vertices], tool[tool_facets])
    deep = depths > ON_SURFACE
    crossing = np.flatnonzero(facets_in_tool(positions, facets, tool, tool_facets))
    return Contact(crossing, vertices[deep], depths[deep])
