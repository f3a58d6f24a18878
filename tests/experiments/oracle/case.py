"""One case as its replay tells of it, in float64, and what the file says that the judge found.

For the oracle alone; it shares nothing with the program's judge.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from . import geometry


@dataclass
class Case:
    columns: dict  # of /cases: text and numbers
    series: dict  # of /series: one value a step
    found: np.ndarray  # [steps, vertices, 3]; so are handled and deformed
    handled: np.ndarray
    deformed: np.ndarray
    rest: np.ndarray  # [vertices, 3]
    facets: np.ndarray  # [facets, 3]
    moved: list  # vertices that the strategy displaced, a step
    tool_positions: np.ndarray  # in the tool's frame
    tool_facets: np.ndarray
    start: np.ndarray  # pose before the first step, [4, 4]
    poses: np.ndarray  # [steps, 4, 4]

    @property
    def steps(self):
        return len(self.poses)

    @cached_property
    def tool(self):
        """Corners of the tool's facets in its frame."""
        return self.tool_positions[self.tool_facets]

    @cached_property
    def radius(self):
        """Of the tool: the largest distance of its vertices from the axis through its tip."""
        return np.linalg.norm(self.tool_positions[:, :2], axis=1).max()

    @cached_property
    def edges(self):
        sides = np.sort(self.facets[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        return np.unique(sides, axis=0)

    @cached_property
    def boundary(self):
        """Directed sides of facets without a facet beyond."""
        sides = self.facets[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        known = set(map(tuple, sides))
        return np.array([side for side in known if side[::-1] not in known], int).reshape(-1, 2)

    @property
    def closed(self):
        return len(self.boundary) == 0

    @property
    def heightfield(self):
        """Whether the organ is a sheet by formula, whose inside is what lies beneath it."""
        return self.columns["organ"].split("@")[0] in ("sheet", "rough-sheet")

    def pose_before(self, step):
        return self.poses[step - 1] if step else self.start


def to_tool(pose, points):
    """From the world into the frame of a tool at `pose`."""
    return (points - pose[:3, 3]) @ pose[:3, :3]


def closed_beneath(case, positions):
    """Corners of the organ; a sheet is closed by walls that go down from its boundary to a floor beneath all tools."""
    corners = positions[case.facets]
    if case.closed:
        return corners
    depth = np.array([0, 0, 100.0])
    a, b = positions[case.boundary[:, 0]], positions[case.boundary[:, 1]]
    below_a, below_b = case.rest[case.boundary[:, 0]] - depth, case.rest[case.boundary[:, 1]] - depth
    middle = np.broadcast_to(below_a.mean(axis=0), a.shape)
    walls = [(b, a, below_a), (b, below_a, below_b), (below_b, below_a, middle)]
    return np.concatenate([corners, *(np.stack(wall, axis=1) for wall in walls)])


def read_case(file, identifier):
    """Reads the case of this id from an open result file that holds its replay."""
    row = list(file["cases/case_id"].asstr()[:]).index(identifier)
    columns = {}
    for name, data in file["cases"].items():
        columns[name] = data.asstr()[row] if data.dtype == object else data[row]
    replay = file["replay"][identifier]
    numbers = {name: data[:] for name, data in replay.items()}
    return Case(
        columns=columns,
        series={name: data[:] for name, data in file["series"][identifier].items()},
        found=numbers["found"].astype(float),
        handled=numbers["handled"].astype(float),
        deformed=numbers["deformed"].astype(float),
        rest=numbers["rest_positions"].astype(float),
        facets=numbers["facets"],
        moved=np.split(numbers["moved"], numbers["moved_offsets"][1:-1]),
        tool_positions=numbers["tool_positions"].astype(float),
        tool_facets=numbers["tool_facets"],
        start=numbers["tool_start"].astype(float),
        poses=numbers["tool_pose"].astype(float),
    )


def mean_normals(case):
    """Of each vertex at rest: the mean of its facets' normals by their areas."""
    corners = case.rest[case.facets]
    normals = np.zeros_like(case.rest)
    np.add.at(normals, case.facets.ravel(), np.repeat(geometry.area_vectors(corners), 3, axis=0))
    return normals / np.linalg.norm(normals, axis=1)[:, None]
