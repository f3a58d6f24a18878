"""The organ and the tool of a step as surfaces, with what is known at their vertices and facets."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..geometry import facets_in_tool, inside
from ..store import Step


@dataclass(frozen=True)
class Surface:
    """Triangles. Positions are float32, as they are stored: every format holds them to the last bit."""

    name: str  # such as "organ_deformed" and "tool"
    words: str  # what it is, in one line
    time: float  # s
    positions: np.ndarray  # [vertices, 3], mm
    facets: np.ndarray  # [facets, 3], counter-clockwise seen from outside
    at_vertices: dict[str, np.ndarray] = field(default_factory=dict)  # [vertices] or [vertices, 3]
    at_facets: dict[str, np.ndarray] = field(default_factory=dict)  # [facets]


def organ_of(step: Step, moment: str, words: str, time: float) -> Surface:
    """`displacement` is what the strategy did, mm, whatever the moment; `from_rest`, `inside_tool` and `in_tool` (facets
    that lie in the tool or cross it) are of the moment. The last two are found in floating point, for looking at."""
    positions = step.positions[moment]
    moved = np.zeros(len(positions), np.uint8)
    moved[step.moved] = 1
    tool = (step.tool_positions, step.tool_facets)
    at_vertices = {
        "displacement": step.positions["handled"] - step.positions["found"],
        "from_rest": positions - step.rest_positions,
        "moved": moved,
        "inside_tool": inside(positions, *tool).astype(np.uint8),
    }
    at_facets = {"in_tool": facets_in_tool(positions, step.facets, *tool).astype(np.uint8)}
    name, words = f"organ_{moment}", f"organ {moment}, {words}"
    return Surface(name, words, time, positions.astype(np.float32), step.facets, at_vertices, at_facets)


def tool_of(step: Step, words: str, time: float) -> Surface:
    return Surface("tool", f"tool, {words}", time, step.tool_positions.astype(np.float32), step.tool_facets)
