"""The reference results of the paper's claims, results/reference/claims/: cases of them run again give the same figures,
and the verdicts there are what the results say, by two ways.

/usr/bin/python3 reference_test.py PROGRAM
"""

import json
import lzma
import math
import pathlib
import random
import subprocess
import sys
import tomllib

import h5py

from program_test import ProgramTest, run_tests

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STORED = ROOT / "results" / "reference" / "claims"
PACKED, TURNS, VERDICTS = STORED / "claims.h5.xz", STORED / "claims.turns.csv", STORED / "claims.json"
SAMPLE = 12  # cases that are run again
FEWEST = 60  # of their figures that have to be numbers
CLOSE = 1e-9  # relative: the same bits on a machine like the one that wrote them

# What differs from run to run, from build to build, or by which claims were asked for.
VARYING = ("wall_s", "attempts", "provenance_row", "build_id", "sweep_number", "metrics", "missing", "same_state")


def text(values):
    return [value.decode() if isinstance(value, bytes) else value for value in values]


def read_cases(path, ids=None):
    """Row by case_id: column → value."""
    with h5py.File(path) as file:
        columns = {name: text(data[()]) for name, data in file["cases"].items()}
    rows = [dict(zip(columns, row)) for row in zip(*columns.values())]
    return {row["case_id"]: row for row in rows if ids is None or row["case_id"] in ids}


def sweep_with(case):
    """The first sweep of the claims that has the case."""
    for name in tomllib.loads((ROOT / "experiments" / "claims.toml").read_text(encoding="utf-8"))["sweep"]:
        path = ROOT / "experiments" / name
        sweep = tomllib.loads(path.read_text(encoding="utf-8"))
        labels = [one["label"] if isinstance(one, dict) else one for one in sweep["strategies"]]
        if (
            case["organ"] in sweep["organs"] and case["tool"] in sweep["tools"] and case["scene"] in sweep["scenes"]
            and case["speed"] in sweep["speeds"] and case["label"] in labels and case["seed"] <= sweep["seeds"]
        ):  # fmt: skip
            return path
    return None


class Reference(ProgramTest):
    def setUp(self):
        super().setUp()
        self.results = self.folder / "claims.h5"
        self.results.write_bytes(lzma.decompress(PACKED.read_bytes()))

    def test_cases_run_again_give_the_stored_figures(self):
        stored = read_cases(self.results)
        known = sorted(name for name, case in stored.items() if sweep_with(case))
        self.assertGreater(len(known), 1000)
        compared = 0
        for case_id in random.Random(2009).sample(known, SAMPLE):
            case, out = stored[case_id], self.folder / f"{case_id}.h5"
            only = [f"--only={key}={case[key]}" for key in ("organ", "tool", "seed", "release")]
            only.append(f"--only=speed={case['speed']:g}")
            self.expect_done("run", sweep_with(case), "-o", out, *only, f"--metrics={case['metrics']}", "-j", "1")
            (again,) = read_cases(out, {case_id}).values()
            for name, value in again.items():
                if name in case and name not in VARYING and not name.startswith("time_"):
                    self.assert_same(value, case[name], (case_id, name))
                    compared += isinstance(value, float) and math.isfinite(value)
        self.assertGreater(compared, FEWEST)

    def assert_same(self, value, stored, what):
        if isinstance(value, float):
            if not (math.isnan(value) and math.isnan(stored)):
                self.assertTrue(math.isclose(value, stored, rel_tol=CLOSE, abs_tol=1e-12), (what, value, stored))
        else:
            self.assertEqual(value, stored, what)

    def test_the_stored_verdicts_are_what_the_results_say(self):
        done = subprocess.run(
            [sys.executable, "-B", HERE / "claims_again.py", self.results, "--turns", TURNS, "--against", VERDICTS],
            capture_output=True, text=True, timeout=500,
        )  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count(": the same"), 2 * 13, done.stdout)
        words = {one["verdict"] for claim in json.loads(VERDICTS.read_text()) for one in claim["verdicts"].values()}
        self.assertLessEqual(words, {"reproduced", "partly", "not reproduced", "described", "not yet"})


if __name__ == "__main__":
    run_tests()
