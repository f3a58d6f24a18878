"""`trocar.py`, which users import: what it gives of made-up files, worked out here from the cases alone."""

import json
import math
import re
import statistics
import subprocess
import unittest

import h5py
import numpy as np
import pandas as pd
from made_up_strategies import DEPTH, made_up
from result_file import ANALYSIS, ProgramTest, write_results
from trocar_analysis.paired import bootstrap_interval

import trocar

A, B = "fuzzy", "nearest-face"
NAMES = ("speed", "organ", "seed")


class Module(ProgramTest):
    def setUp(self):
        super().setUp()
        self.cases = made_up()

    def load(self):
        write_results(self.file, self.cases)
        return trocar.load(self.file)

    def of(self, label):
        return {tuple(case[name] for name in NAMES): case for case in self.cases if case["label"] == label}

    def refuse(self, words, function, *arguments):
        with self.assertRaises(ValueError) as raised:
            function(*arguments)
        self.assertIn(words, str(raised.exception))

    # load

    def test_a_row_per_case_with_units_and_words(self):
        write_results(self.file, self.cases)
        with h5py.File(self.file, "a") as file:
            file["cases"][DEPTH].attrs["long_name"] = "how deep"
        cases = trocar.load(self.file)
        self.assertEqual([*cases["case_id"]], [case["case_id"] for case in self.cases])
        self.assertEqual([*cases[DEPTH]], [case[DEPTH] for case in self.cases])
        self.assertEqual((cases.attrs["units"][DEPTH], cases.attrs["units"]["label"]), ("mm", ""))
        self.assertEqual(cases.attrs["long_names"][DEPTH], "how deep")

    def test_a_case_without_a_label_has_its_strategys_name(self):
        for case in self.cases:
            case.update(strategy=case["label"], label="")
        self.assertEqual({*self.load()["label"]}, {case["strategy"] for case in self.cases})

    def test_files_that_are_no_results(self):
        self.refuse("no such file", trocar.load, self.folder / "none.h5")
        self.file.write_text("nothing")
        self.refuse("cannot be read as an HDF5 file", trocar.load, self.file)
        write_results(self.file, self.cases)
        with h5py.File(self.file, "a") as file:
            file.attrs["schema_version"] = 1
        self.refuse("was written with schema 1", trocar.load, self.file)
        write_results(self.file, [])
        with h5py.File(self.file, "a") as file:
            for name in ("case_id", "strategy", "status"):
                file["cases"].create_dataset(name, shape=(0,), dtype=h5py.string_dtype())
        self.refuse("has no cases", trocar.load, self.file)

    # pairs

    def test_pairs_are_of_equal_conditions(self):
        pairs = trocar.pairs(self.load(), A, B, DEPTH)
        left, right = self.of(A), self.of(B)
        self.assertEqual(len(pairs), len(left))
        for _, row in pairs.iterrows():
            key = tuple(row[name] for name in NAMES)
            self.assertEqual((row["case_a"], row["case_b"]), (left[key]["case_id"], right[key]["case_id"]))
            self.assertEqual((row["a"], row["b"]), (left[key][DEPTH], right[key][DEPTH]))
            self.assertEqual(row["difference"], right[key][DEPTH] - left[key][DEPTH])
        self.assertEqual((pairs.attrs["metric"], pairs.attrs["unit"]), (DEPTH, "mm"))

    def test_what_has_no_pair_is_counted(self):
        whole = len(self.of(A))
        of_a, of_b = ([case for case in self.cases if case["label"] == name] for name in (A, B))
        for case in self.cases:
            case.update(status="complete", reason="")
        of_a[0].update(status="diverged", **{DEPTH: math.nan})
        of_b[1].update(status="crashed", **{DEPTH: math.nan})
        of_b[2][DEPTH] = math.nan
        self.cases.remove(of_b[3])
        self.cases.remove(of_b[4])
        self.cases.remove(of_a[5])
        pairs = trocar.pairs(self.load(), A, B, DEPTH)
        self.assertEqual(
            pairs.attrs["counts"],
            {"pairs": whole - 6, "unpaired_a": 2, "unpaired_b": 1, "failed_a": 1, "failed_b": 1, "no_value_a": 0,
             "no_value_b": 1},
        )  # fmt: skip
        self.assertEqual(len(pairs), whole - 6)

    def test_some_rows_of_the_cases(self):
        cases = self.load()
        pairs = trocar.pairs(cases[cases["speed"] == 20], A, B, DEPTH)
        self.assertEqual({*pairs["speed"]}, {20.0})
        self.assertEqual(len(pairs), len(self.of(A)) / 2)

    def test_a_quotient_is_in_percent(self):
        for case in self.cases:
            case["tool_volume_at_rest_max"] = 4.0
        pairs = trocar.pairs(self.load(), A, B, "tool_volume_inside_d_max/tool_volume_at_rest_max")
        row = pairs.iloc[0]
        self.assertAlmostEqual(row["a"], 25 * self.of(A)[tuple(row[name] for name in NAMES)]["tool_volume_inside_d_max"])
        self.assertEqual(pairs.attrs["unit"], "%")

    def test_what_pairs_refuses(self):
        cases = self.load()
        self.refuse("did you mean 'nearest-face'?", trocar.pairs, cases, A, "nearest-fac", DEPTH)
        self.refuse(f"did you mean '{DEPTH}'?", trocar.pairs, cases, A, B, "depth_max_d_ma")
        self.refuse("organ holds text", trocar.pairs, cases, A, B, "organ")
        self.refuse("give what trocar.load returned", trocar.pairs, pd.DataFrame({"label": [A]}), A, B, DEPTH)
        self.refuse("lost its units", trocar.pairs, cases.merge(
            cases[["case_id"]], on="case_id"), A, B, DEPTH)  # fmt: skip

    def test_two_cases_under_one_condition(self):
        twice = next(case for case in self.cases if case["label"] == B)
        self.cases.append(twice | {"case_id": "again"})
        self.refuse(f"nearest-face: cases {twice['case_id']} and again", trocar.pairs, self.load(), A, B, DEPTH)

    # median_interval

    def test_the_interval_is_that_of_the_commands(self):
        pairs = trocar.pairs(self.load(), A, B, DEPTH)
        change = trocar.median_interval(pairs, "difference")
        self.assertAlmostEqual(change.median, statistics.median(pairs["difference"]))
        columns = (pairs[name].to_numpy() for name in ("difference", "organ", "seed"))
        self.assertEqual((change.low, change.high), bootstrap_interval(*columns))
        self.assertEqual(change.cases, len(pairs))

    def test_too_few_seeds_for_an_interval(self):
        cases = self.load()
        few = trocar.median_interval(cases[cases["seed"] < 2], DEPTH)
        self.assertTrue(math.isnan(few.low) and not math.isnan(few.median))

    # series

    def write_series(self):
        write_results(self.file, self.cases)
        with h5py.File(self.file, "a") as file:
            group = file.create_group(f"series/{self.cases[3]['case_id']}")
            group["time"], group["drag"] = np.array([0.5, 1.0, 1.5]), np.array([math.nan, 2.0, math.nan])
            group["drag"].attrs.update(units="mm", long_name="how far", missing=json.dumps({"no vertex": [[0, 0], [2, 2]]}))

    def test_a_series_has_times_units_and_reasons(self):
        self.write_series()
        steps = trocar.series(self.file, self.cases[3]["case_id"])
        self.assertEqual((steps.index.name, [*steps.index]), ("time", [0.5, 1.0, 1.5]))
        np.testing.assert_array_equal(steps["drag"], [math.nan, 2.0, math.nan])
        self.assertEqual(steps.attrs["units"]["drag"], "mm")
        self.assertEqual(steps.attrs["long_names"]["drag"], "how far")
        self.assertEqual(steps.attrs["missing"], {"drag": {"no vertex": [(0, 0), (2, 2)]}})

    def test_cases_that_there_are_not(self):
        self.write_series()
        self.refuse("no case 'zzz'", trocar.series, self.file, "zzz")
        self.refuse("has no series of case 40", trocar.series, self.file, "40")

    # where it is

    def test_ten_lines_of_its_docstring(self):
        code = re.search(r":\n\n(.*?)\n\n", trocar.__doc__, re.DOTALL)[1]
        lines = [line.strip() for line in code.splitlines()]
        self.assertLessEqual(len(lines), 10)
        for case in self.cases:
            case["label"] = {A: "fuzzy-per-vertex"}.get(case["label"], case["label"])
        write_results(self.file, self.cases)
        program = "\n".join(["import matplotlib; matplotlib.use('Agg')", *lines]).replace('"analysis"', repr(str(ANALYSIS)))
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", program], cwd=self.folder, capture_output=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertGreater((self.folder / "pairs.png").stat().st_size, 1000)
        self.assertIn(b"Estimate", done.stdout)

    def test_it_is_installed_beside_the_analysis(self):
        rules = (ANALYSIS / "CMakeLists.txt").read_text()
        folders = re.findall(r"install\((?:DIRECTORY trocar_analysis|FILES trocar.py)\s+DESTINATION (\S+?)\)?\s", rules)
        self.assertEqual(len(folders), 2)
        self.assertEqual(len({*folders}), 1)


if __name__ == "__main__":
    unittest.main()
