"""Which step of a case a picture shows when nobody says which."""

from __future__ import annotations

import numpy as np


def deepest_step(poses: np.ndarray) -> int:
    """Where the tip is furthest in along the tool's axis, and of several such steps (a slide, a hold) the last in which
    it moved. `poses` are those of all steps, [steps, 4, 4]."""
    tips = poses[:, :3, 3]
    depths = -tips @ poses[0, :3, 2]
    deepest = np.flatnonzero(depths >= depths.max() - 1e-3)
    moved = np.linalg.norm(np.diff(tips, axis=0, prepend=tips[:1]), axis=1)[deepest] > 1e-3
    return int(deepest[moved][-1] if moved.any() else deepest[0])
