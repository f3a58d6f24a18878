"""Cases of several strategies under the same conditions, for the tests of `rank` and `front`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from unittest import mock

import numpy as np
from result_file import ProgramTest
from trocar_analysis.paired import bootstrap_interval

LABELS, SPEEDS = ("fuzzy", "nearest-face", "cylinder-axis", "joint-vertex"), (20.0, 400.0)
BETTER = {"depth_max": "low", "time_handle": "low", "edge_ratio_min": "high", "tool_volume_inside": "low"}
DEPTH, TIME, RATIO = "depth_max_d_max", "time_handle_p50", "edge_ratio_min_h_mean"


def made_up(organs: int = 2, seeds: int = 6, labels: Sequence[str] = LABELS) -> list[dict]:
    """Under each condition every strategy once; a strategy is deeper than those before it, mostly, and quicker."""
    generator = np.random.default_rng(11)
    rows = []
    for number, label in enumerate(labels):
        for organ in range(organs):
            for seed in range(seeds):
                for speed in SPEEDS:
                    depth, time, ratio = generator.uniform(0, 1, 3)
                    rows.append(
                        {"case_id": str(len(rows)), "label": label, "organ": f"o{organ}", "seed": seed, "speed": speed,
                         DEPTH: float(depth + number / 2), TIME: float(1000 * (1 + time) * (9 - number)),
                         RATIO: float(ratio), "tool_volume_inside_d_max": float(depth), "drag_mean": float(depth),
                         "missing": "", "metrics": "all"}
                    )  # fmt: skip
    return rows


def chosen(cases: list[dict], **keys: object) -> list[dict]:
    return [case for case in cases if all(case[name] == value for name, value in keys.items())]


class StrategiesTest(ProgramTest):
    """Has made-up cases to change."""

    def setUp(self) -> None:
        super().setUp()
        self.cases = made_up()
        # Where an interval ends is known to test_paired.py; here few resamples do.
        self.interval = partial(bootstrap_interval, resamples=300)
        quick = mock.patch("trocar_analysis.conditions.bootstrap_interval", self.interval)
        quick.start()
        self.addCleanup(quick.stop)
