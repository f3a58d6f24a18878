"""A case as it was recorded for replay: a step of it, or all of them. Lengths in mm, world coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Step:
    """One step of a case."""

    positions: dict[str, np.ndarray]  # per moment: organ vertices, mm, [vertices, 3]
    rest_positions: np.ndarray  # organ vertices at rest, mm, [vertices, 3]
    facets: np.ndarray  # of the organ, [facets, 3]
    tool_positions: np.ndarray  # tool vertices at this step, in world coordinates, mm, [vertices, 3]
    tool_facets: np.ndarray  # [facets, 3]
    tool_tip: np.ndarray  # the origin of the tool's frame, mm, [3]
    tool_way: np.ndarray  # of the tool's tip in this step, mm, [3]; zero in the first step
    moved: np.ndarray  # numbers of the vertices that the strategy displaced
    values: dict[str, float]  # the step's value of every series of the case; "time" in s


@dataclass(frozen=True)
class Recording:
    """All steps of a case."""

    positions: dict[str, np.ndarray]  # per moment: organ vertices, [steps, vertices, 3]
    rest_positions: np.ndarray  # [vertices, 3]
    facets: np.ndarray  # of the organ, [facets, 3]
    tool_positions: np.ndarray  # in the tool's frame, [vertices, 3]
    tool_facets: np.ndarray  # [facets, 3]
    tool_poses: np.ndarray  # tool frame to world at the end of each step, [steps, 4, 4]
    moved: list[np.ndarray]  # per step: numbers of the vertices that the strategy displaced
    moved_by: list[np.ndarray]  # per step: where to, from where they were found, [moved, 3]
    series: dict[str, np.ndarray]  # per series: one value a step, NaN where there is none

    @property
    def steps(self) -> int:
        return len(self.tool_poses)

    def tool_at(self, step: int) -> np.ndarray:
        """The tool's vertices in the world."""
        pose = self.tool_poses[step]
        return self.tool_positions @ pose[:3, :3].T + pose[:3, 3]
