"""Where the tool is between two poses, by halving the motion again and again.

For the oracle alone; it shares nothing with the program's judge.
"""

import numpy as np

from .answer import ROUNDING

CHORD = 1e-3  # mm: how far from their arcs metrics.md lets chords be, the program's and these


def halved(motion):
    """The rigid motion that, done twice, is `motion`: H with R_H² = R and R_H t_H + t_H = t.

    I + R = R_H (R_H⁻¹ + R_H), whose second factor is symmetric and, for turns of less than half a circle, positive:
    R_H is the orthogonal factor of I + R.
    """
    left, _, right = np.linalg.svd(np.eye(3) + motion[:3, :3])
    half = np.eye(4)
    half[:3, :3] = left @ right
    half[:3, 3] = np.linalg.solve(np.eye(3) + half[:3, :3], motion[:3, 3])
    return half


def moved(motion, points):
    return points @ motion[:3, :3].T + motion[:3, 3]


def from_one_to_other(before, after):
    """after = before @ motion."""
    motion = np.eye(4)
    motion[:3, :3] = before[:3, :3].T @ after[:3, :3]
    motion[:3, 3] = before[:3, :3].T @ (after[:3, 3] - before[:3, 3])
    return motion


def turns(before, after):
    return not np.array_equal(before[:3, :3], after[:3, :3])


def screw(before, after, points):
    """Poses along the screw from one pose to the other, both included, and how far off ways along them may be, mm.

    They are so near to one another that points of the tool (in its frame) go along chords within CHORD of their arcs.
    The program may have taken other chords, just as near.
    """
    if not turns(before, after):
        return [before, after], ROUNDING
    motion, count = from_one_to_other(before, after), 1
    while True:
        half = halved(motion)
        bulge = moved(half, points) - (points + moved(motion, points)) / 2
        if np.linalg.norm(bulge, axis=1).max() <= CHORD:
            break
        motion, count = half, 2 * count
    poses = [before]
    for _ in range(count - 1):
        poses.append(poses[-1] @ motion)
    return [*poses, after], ROUNDING + 2 * CHORD


def looks(before, after, points, spacing):
    """Poses between two, the latter included, while the tip goes straight and the tool turns evenly: none of the
    tool's points goes further than `spacing` (mm) from one to the next."""
    motion, count = from_one_to_other(before, after), 1
    while np.linalg.norm(moved(motion, points) - points, axis=1).max() > spacing:
        motion, count = halved(motion), 2 * count
    poses, turned = [], before[:3, :3]
    for part in range(1, count):
        turned = turned @ motion[:3, :3]
        pose = before.copy()
        pose[:3, :3] = turned
        pose[:3, 3] += part / count * (after[:3, 3] - before[:3, 3])
        poses.append(pose)
    return [*poses, after]
