"""Where a picture is taken from: chosen by the tool and the organ at rest, so that strategies share it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

RISE = 0.55  # how far up the picture a point moves for each mm that it lies behind the section plane


@dataclass(frozen=True)
class View:
    """An oblique projection: the section plane, which holds the tool's axis and `right`, is seen at scale;
    what is behind it shows above it; what is in front is cut away. World coordinates, unit vectors, mm."""

    centre: np.ndarray  # of the picture, on the section plane
    right: np.ndarray
    axis: np.ndarray  # of the tool, from tip to handle; upwards in the picture
    half_width: float  # of the picture
    half_height: float

    @property
    def front(self) -> np.ndarray:
        """Normal of the section plane, towards the eye's side."""
        return np.cross(self.right, self.axis)

    @property
    def towards_eye(self) -> np.ndarray:
        """What lies along this direction meets in one point of the picture."""
        return self.front + RISE * self.axis

    def heights(self, points: np.ndarray) -> np.ndarray:
        """Distance in front of the section plane, mm."""
        return (points - self.centre) @ self.front

    def project(self, points: np.ndarray) -> np.ndarray:
        """Coordinates in the picture, right and up from its middle, mm."""
        return self.project_directions(points - self.centre)

    def project_directions(self, directions: np.ndarray) -> np.ndarray:
        return directions @ np.stack([self.right, self.axis - RISE * self.front], axis=1)


def choose_view(
    rest_positions: np.ndarray, tool_positions: np.ndarray, poses: np.ndarray, number: int
) -> View:
    """The view of step `number`: the tool upright, its tip below the middle, the depth it reaches in sight.
    `poses` are those of all steps, `tool_positions` the tool's vertices at that step, in the world."""
    axis, tip = poses[number, :3, 2], poses[number, :3, 3]
    radius = np.linalg.norm(across(tool_positions - tip, axis), axis=1).max()
    way = poses[:, :3, 3] - tip
    half_height = max(0.6 * np.ptp(way @ axis) + 1.25 * radius, 3.5 * radius)
    half_width = 1.15 * half_height

    near = rest_positions - tip
    near = near[np.linalg.norm(near, axis=1) < 2 * half_width]
    # A tool that moves sideways is cut along its way; any other along the organ's longer side.
    sideways = across(way, axis)
    moves_sideways = np.linalg.norm(sideways, axis=1).max() > radius
    right = principal(sideways if moves_sideways else across(near, axis), axis)
    # Of the two sides, look from the one where the organ rises towards the background.
    if np.cov(near @ np.cross(right, axis), near @ axis)[0, 1] > 0:
        right = -right
    return View(tip + 0.35 * half_height * axis, right, axis, half_width, half_height)


def across(vectors: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """The vectors without their part along the axis."""
    return vectors - np.outer(vectors @ axis, axis)


def principal(vectors: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """The direction across `axis` in which the vectors spread most; any, when there are too few."""
    scatter = np.cov(vectors.T) if len(vectors) > 1 else np.zeros((3, 3))
    side = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    scatter = scatter + 1e-9 * np.outer(side, side) - 1e6 * np.outer(axis, axis)
    return np.linalg.eigh(scatter)[1][:, -1]
