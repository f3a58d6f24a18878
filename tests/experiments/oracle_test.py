"""Recomputes the metrics of five random cases of paper.toml from their replays and compares them with what was stored.

/usr/bin/python3 oracle_test.py PROGRAM [--allow-missing]

The oracle knows metrics by their definitions alone and shares nothing with the program's judge. A metric that the file
does not hold is an error, as is one in the file that the oracle does not know; --allow-missing lets both pass, for a
program that is yet to learn some.
"""

import os
import pathlib
import sys
import tempfile
import time
import unittest

import h5py
import numpy as np

from oracle.answer import Answers
from oracle.case import read_case
from oracle.compare import NOT_IN_REPLAY, compare_figures, compare_missing, compare_series
from oracle.draw import draw_cases, list_cases, run_case
from oracle.paths import judge_ways
from oracle.region import judge_region, judge_window
from oracle.surfaces import judge_surfaces
from oracle.vertices import judge_vertices
from oracle.volumes import compare_sums, judge_volumes, rays_agree_with_solid_angles

SEED = 2009
SWEEP = pathlib.Path(__file__).parents[2] / "experiments" / "paper.toml"
COUNTS = (
    "collided_vertices", "vertices_inside_h", "vertices_inside_d", "facets_crossing_h", "facets_crossing_d",
    "tunnelled", "tool_crossings", "displacement_crossings", "flipped_facets", "self_crossings_h", "self_crossings_d",
)  # fmt: skip
PROGRAM = ""
ALLOW_MISSING = False


def recompute(case, generator):
    answers = Answers(case.steps)
    for judge in (judge_vertices, judge_surfaces, judge_ways, judge_region, judge_window):
        judge(case, answers)
    judge_volumes(case, answers, generator)
    return answers


def complaints(case, answers):
    """What is wrong with the case's series and figures."""
    wrong, series = [], dict(case.series)
    if "recovery_final" in case.columns:  # taken once, so it has no series
        series["recovery"] = np.append(np.full(case.steps - 1, np.nan), case.columns["recovery_final"])
    for name, answer in answers.items():
        if name in series:
            wrong += compare_series(name, series[name], answer)
            if name.startswith("tool_volume"):
                wrong += compare_sums(name, series[name], answer)
        elif not ALLOW_MISSING:
            wrong.append(f"{name}: not in the file")
    for name, stored in case.series.items():
        if name.startswith(NOT_IN_REPLAY) or name == "window":
            continue
        if name not in answers and not ALLOW_MISSING:
            wrong.append(f"{name}: the oracle does not know it")
        wrong += compare_figures(name, stored, case.columns, case.series["window"])
        wrong += compare_missing(name, stored, case.columns, case.series["window"])
    return wrong


def summary(case, answers):
    compared = sum(np.count_nonzero(answer.known) for answer in answers.values())
    counts = [answer for name, answer in answers.items() if name in COUNTS]
    wide = sum(np.count_nonzero(answer.known & (answer.low < answer.high)) for answer in counts)
    return f"{compared} values of {case.steps} steps compared, rounding leaves {wide} counts open"


class Oracle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.generator = np.random.default_rng(SEED)
        cls.drawn = draw_cases(list_cases(PROGRAM, SWEEP), cls.generator)

    def test_five_random_cases(self):
        for drawn in self.drawn:
            name = ", ".join(value for key, value in drawn.items() if key != "id")
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                started = time.monotonic()
                out = pathlib.Path(folder) / "out.h5"
                run_case(PROGRAM, SWEEP, drawn, out)
                with h5py.File(out) as file:
                    case = read_case(file, drawn["id"])
                self.assertEqual(case.columns["status"], "complete")
                self.assertTrue(rays_agree_with_solid_angles(case, self.generator))
                answers = recompute(case, self.generator)
                wrong = complaints(case, answers)
                print(f"{name}: {summary(case, answers)}, {time.monotonic() - started:.1f} s")
                self.assertEqual(wrong, [], "\n".join(["", *wrong]))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    if "--allow-missing" in sys.argv:
        sys.argv.remove("--allow-missing")
        ALLOW_MISSING = True
    unittest.main()
