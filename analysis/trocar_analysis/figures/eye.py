"""Where the panels of a figure are seen from: by rule, from the tool and the organ at rest."""

from __future__ import annotations

import numpy as np

from ..camera import Camera
from ..view import View
from .figure_file import ViewRule


def place_camera(view: View, tip: np.ndarray, rule: ViewRule, pixels: int) -> Camera:
    """Looks at the tool from `view`'s front, turned about its axis and raised; the tool stands upright."""
    turn, elevation = np.radians(rule.turn), np.radians(rule.elevation)
    level = np.cos(turn) * view.front + np.sin(turn) * view.right
    towards = np.cos(elevation) * level + np.sin(elevation) * view.axis
    right = np.cross(view.axis, towards)
    right /= np.linalg.norm(right)
    basis = np.stack([right, np.cross(towards, right), towards], axis=1)
    return Camera(basis, tip + rule.rise * view.axis, rule.width / 2, rule.height / 2, pixels)
