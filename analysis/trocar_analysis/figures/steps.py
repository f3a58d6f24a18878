"""Which step of a case a panel shows."""

from __future__ import annotations

import numpy as np

from ..errors import InputError
from ..store import ResultFile

MOTION = 1e-6  # mm: a tool that moves less, in every entry of its pose, stands still


def choose_step(results: ResultFile, case_id: str, rule: str | int) -> int:
    """The number of the step, from 0. `rule` is one, or
    "arrived": the last step of the tool's way, before it first stands still;
    "contact": the first step in which vertices collide;
    "most NAME": the first of those in which the series of that name is largest."""
    poses = results.tool_poses(case_id)
    if isinstance(rule, int):
        if not 0 <= rule < len(poses):
            raise InputError(f"step {rule}: the case has steps 0 to {len(poses) - 1}")
        return rule
    if rule == "arrived":
        return arrival(poses)
    name = "collided_vertices" if rule == "contact" else rule.removeprefix("most ")
    if rule != "contact" and not rule.startswith("most "):
        raise InputError(f"step \"{rule}\": expected \"arrived\", \"contact\", \"most NAME\" of a series, or a number")
    values = np.nan_to_num(results.series(case_id, name))
    if not values.any():
        raise InputError(f"step \"{rule}\": {name} is 0 in every step of case {case_id}")
    return int(np.flatnonzero(values > 0)[0] if rule == "contact" else values.argmax())


def arrival(poses: np.ndarray) -> int:
    """The last step before the one in which the tool first stands still; the last of all where it never does. The
    steps in which it has not set out yet do not count."""
    moves = np.abs(np.diff(poses, axis=0)).max(axis=(1, 2)) > MOTION  # from step k to step k + 1
    if not moves.any():
        raise InputError("step \"arrived\": the tool never moves")
    start = int(moves.argmax())
    stands = np.flatnonzero(~moves[start:])
    return start + int(stands[0]) if len(stands) else len(poses) - 1
