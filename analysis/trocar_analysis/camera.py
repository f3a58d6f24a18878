"""A parallel projection of a whole scene, and which of its surfaces each pixel of it shows. Lengths in mm."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Camera:
    """Coordinates in the picture are right, up and towards the eye, from the picture's centre."""

    basis: np.ndarray  # [3, 3]: unit vectors of these, as columns
    centre: np.ndarray
    half_width: float  # of the picture
    half_height: float
    pixels: int  # across

    @property
    def pixel(self) -> float:
        """Length of a pixel's side."""
        return 2 * self.half_width / self.pixels

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of pixels."""
        return round(self.pixels * self.half_height / self.half_width), self.pixels

    def see(self, points: np.ndarray) -> np.ndarray:
        return (points - self.centre) @ self.basis

    def pixel_of(self, seen: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Row (from the top) and column of the pixel at each of these coordinates; the nearest where it is
        outside the picture."""
        rows, columns = self.shape
        column = np.floor((seen[:, 0] + self.half_width) / self.pixel).astype(int)
        row = np.floor((self.half_height - seen[:, 1]) / self.pixel).astype(int)
        return row.clip(0, rows - 1), column.clip(0, columns - 1)


def camera_from(
    towards_eye: np.ndarray, centre: np.ndarray, width: float, height: float, pixels: int
) -> Camera:
    """Looks from that direction, with +z upwards."""
    towards = towards_eye / np.linalg.norm(towards_eye)
    right = np.cross([0, 0, 1], towards)
    right /= np.linalg.norm(right)
    return Camera(
        np.stack([right, np.cross(towards, right), towards], axis=1), centre, width / 2, height / 2, pixels
    )


@dataclass(frozen=True)
class Fragment:
    """The pixels that a triangle covers."""

    facet: int  # its number
    window: tuple[slice, slice]  # rows and columns of the pixels around it
    covered: np.ndarray  # which of these it covers
    depth: np.ndarray  # coordinate towards the eye at each of them
    to_edge: np.ndarray  # distance to the nearest edge, as seen, at each of them


def fragments(camera: Camera, seen: np.ndarray, facets: np.ndarray) -> Iterator[Fragment]:
    """One of each facet that covers pixels' middles."""
    rows, columns = camera.shape
    x = (np.arange(columns) + 0.5) * camera.pixel - camera.half_width
    y = camera.half_height - (np.arange(rows) + 0.5) * camera.pixel
    for number, corners in enumerate(seen[facets]):
        low, high = corners.min(axis=0), corners.max(axis=0)
        window = (
            slice(np.searchsorted(-y, -high[1]), np.searchsorted(-y, -low[1], side="right")),
            slice(np.searchsorted(x, low[0]), np.searchsorted(x, high[0], side="right")),
        )
        px, py = np.meshgrid(x[window[1]], y[window[0]])
        (ax, ay, _), (bx, by, _), (cx, cy, _) = corners
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if px.size == 0 or abs(area) < 1e-9:
            continue
        b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / area
        c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / area
        shares = np.stack([1 - b - c, b, c])  # barycentric coordinates
        opposite = (np.roll(corners, -1, axis=0) - np.roll(corners, -2, axis=0))[:, :2]
        heights = abs(area) / np.hypot(*opposite.T)
        yield Fragment(
            number, window, (shares >= 0).all(axis=0), np.tensordot(corners[:, 2], shares, 1),
            (shares * heights[:, None, None]).min(axis=0),
        )  # fmt: skip
