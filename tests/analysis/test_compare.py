"""`compare` on made-up files of which the change is known."""

import csv
import io
import math
import unittest

import h5py
import numpy as np
from result_file import ProgramTest, write_results
from trocar_analysis.compare import Comparison, compare
from trocar_analysis.errors import InputError
from trocar_analysis.gate import read_condition

LOW = {"depth_max": "low", "time_handle": "low", "drag": "neither", "edge_ratio_min": "high"}
RUN = {
    "git_commit": "c", "git_dirty": 0, "compiler": "g", "flags": "-O2", "build_type": "Release", "libraries": "l",
    "cpu": "fast", "host": "h",
}  # fmt: skip


def cases(labels=("a", "b"), organs=3, seeds=5):
    """Two speeds a seed; depths that spread widely between cases."""
    generator = np.random.default_rng(1)
    rows = []
    for label in labels:
        for organ in range(organs):
            for seed in range(seeds):
                for speed in (20.0, 100.0):
                    depth = float(np.exp(generator.normal(0, 1)))
                    rows.append(
                        {"case_id": f"{label}{organ}{seed}{speed:g}", "label": label, "organ": f"o{organ}",
                         "seed": seed, "speed": speed, "depth_max_d_max": depth, "drag_mean": depth,
                         "edge_ratio_min_h_mean": depth, "time_handle_p50": 1000 * depth, "provenance_row": 0}
                    )  # fmt: skip
    return rows


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.a, self.b = cases(), cases()
        self.paths = [self.folder / "a.h5", self.folder / "b.h5"]
        self.written = ""

    def write(self, run_b=None):
        """Both files, if anything has changed since."""
        before, self.written = self.written, repr((self.a, self.b, run_b))
        if self.written == before:
            return
        write_results(self.paths[0], self.a, provenance=[RUN])
        write_results(self.paths[1], self.b, provenance=[RUN | (run_b or {})])

    def compare(self, run_b=None, **asked):
        self.write(run_b)
        return compare(*self.paths, Comparison(**({"better": LOW} | asked)))

    def tidy(self, run_b=None, **asked):
        """The rows of the table by figure and label."""
        text, _ = self.compare(run_b, style="csv", **asked)
        return {(row["metric"], row["label"]): row for row in csv.DictReader(io.StringIO(text))}

    def judged(self, *conditions, **asked):
        """Exit code as the command line would have it, and what was said."""
        _, judgement = self.compare(fail_on=[*conditions], **asked)
        code = 2 if judgement.not_evaluated else 1 if judgement.violated else 0
        return code, [*judgement.violated, *judgement.not_evaluated]

    def scale(self, name, factor, label="b"):
        for case in self.b:
            if case["label"] == label:
                case[name] *= factor

    # What changed

    def test_a_shift_is_found_in_its_group_and_direction(self):
        for name in ("depth_max_d_max", "drag_mean", "edge_ratio_min_h_mean"):
            self.scale(name, 1.1)
        rows = self.tidy(metrics=["depth_max", "drag", "edge_ratio_min"])
        words = {key: row["verdict"] for key, row in rows.items()}
        self.assertEqual(
            [words[name, "b"] for name in ("depth_max_d_max", "drag_mean", "edge_ratio_min_h_mean")],
            ["worse", "more", "better"],
        )
        self.assertEqual({words[name, "a"] for name, _ in rows}, {"equal"})
        row = rows["depth_max_d_max", "b"]
        depths = np.array([case["depth_max_d_max"] for case in self.a if case["label"] == "b"])
        self.assertAlmostEqual(float(row["median_a"]), np.median(depths), 12)
        self.assertAlmostEqual(float(row["difference"]), 0.1 * np.median(depths), 12)
        self.assertAlmostEqual(float(row["relative"]), 10, 9)
        self.assertLess(float(row["p"]), 1e-4)
        self.assertLess(float(row["low"]), float(row["difference"]))
        self.assertLess(float(row["difference"]), float(row["high"]))
        self.assertEqual((row["pairs"], row["both"], row["zeros"]), ("30", "30", "0"))

    def test_noise_is_no_clear_change(self):
        generator = np.random.default_rng(2)
        for case in self.b:
            case["depth_max_d_max"] += generator.normal(0, 0.1)
        rows = self.tidy(metrics=["depth_max"])
        self.assertEqual({row["verdict"] for row in rows.values()}, {"no clear change"})
        self.scale("depth_max_d_max", 0.5)
        self.assertEqual(self.tidy(metrics=["depth_max"])["depth_max_d_max", "b"]["verdict"], "better")

    def test_pairs_are_by_case_id_not_by_row(self):
        self.b.reverse()
        self.assertEqual(self.tidy(metrics=["depth_max"])["depth_max_d_max", "a"]["verdict"], "equal")

    def test_an_unknown_direction_is_not_judged(self):
        self.scale("depth_max_d_max", 1.1)
        self.assertEqual(self.tidy(better={})["depth_max_d_max", "b"]["verdict"], "more")

    def test_few_seeds_have_no_interval_and_no_word(self):
        self.a, self.b = cases(seeds=3), cases(seeds=3)
        self.scale("depth_max_d_max", 1.5)
        row = self.tidy()["depth_max_d_max", "b"]
        self.assertEqual((row["verdict"], row["low"]), ("too few seeds", ""))
        self.assertEqual(self.judged("depth_max_d_max > 5%")[0], 1)

    # What is missing

    def test_failed_cases_are_the_worst_values(self):
        for case in self.b[:20]:
            case |= {"status": "crashed", "depth_max_d_max": 0.0}
        self.a[0] |= {"status": "failed", "depth_max_d_max": math.nan}
        rows = self.tidy(metrics=["depth_max", "drag", "edge_ratio_min"])
        row = rows["depth_max_d_max", "a"]
        self.assertEqual((row["pairs"], row["failed_a"], row["failed_b"], row["zeros"]), ("30", "1", "20", "11"))
        self.assertEqual((row["median_b"], row["difference"], row["verdict"]), ("inf", "inf", "worse"))
        row = rows["edge_ratio_min_h_mean", "a"]
        self.assertEqual((row["median_b"], row["difference"], row["verdict"]), ("-inf", "-inf", "worse"))
        row = rows["drag_mean", "a"]  # neither way is worse: nothing to count a failed case as
        self.assertEqual((row["pairs"], row["failed_b"], row["verdict"]), ("10", "20", "equal"))
        text, _ = self.compare(metrics=["depth_max"])
        self.assertIn("complete → crashed: 19 cases (a0", text)
        self.assertIn("failed → crashed: 1 case (a0020)", text)
        self.assertIn("∞", text)
        self.assertIn("[1→20 failed]", text)

    def test_values_and_cases_on_one_side_only_are_counted_and_listed(self):
        self.a[0]["depth_max_d_max"] = self.b[0]["depth_max_d_max"] = math.nan
        for case in self.b[1:13]:
            case["depth_max_d_max"] = math.nan
        self.a[13]["depth_max_d_max"] = math.nan
        del self.a[-1], self.b[-3:-1]
        row = self.tidy(metrics=["depth_max"])["depth_max_d_max", "a"]
        counts = [row[name] for name in ("no_value_a", "no_value_b", "no_value", "pairs")]
        self.assertEqual(counts, ["1", "12", "1", "16"])
        text, _ = self.compare(metrics=["depth_max"])
        self.assertIn("depth_max_d_max: a value in A only: 12 cases (a00100, a0120,", text)
        self.assertIn(", …)", text)
        self.assertIn("depth_max_d_max: a value in B only: 1 case (a11100)", text)
        self.assertIn("[14 no value]", text)
        self.assertIn("in A, missing in B: 2 cases (b23100, b2420)", text)
        self.assertIn("in B, missing in A: 1 case (b24100)", text)
        row = self.tidy(metrics=["depth_max"])["depth_max_d_max", "b"]
        self.assertEqual([row[name] for name in ("only_a", "only_b", "both")], ["2", "1", "27"])

    def test_a_figure_of_one_file_only(self):
        for case in self.b:
            del case["drag_mean"]
        row = self.tidy(metrics=["drag"])["drag_mean", "a"]
        self.assertEqual((row["pairs"], row["no_value_b"], row["verdict"]), ("0", "30", "no pairs"))

    # Times

    def test_times_of_different_machines_or_flags_are_not_judged(self):
        self.scale("time_handle_p50", 2)
        self.assertEqual(self.tidy({"git_commit": "d"})["time_handle_p50", "b"]["verdict"], "worse")
        for fact in ("cpu", "host", "build_type", "flags"):
            row = self.tidy({fact: "other"})["time_handle_p50", "b"]
            self.assertEqual(row["verdict"], "not comparable", fact)
        text, _ = self.compare({"cpu": "slow"})
        self.assertIn("Times are not comparable (cpu: fast in A, slow in B)", text)
        self.assertIn("\n† Times are not", text)
        self.assertIn("time_handle_p50†, µs", text)
        self.assertNotIn("depth_max_d_max†", text)
        self.assertNotIn("†", self.compare()[0])
        rows = self.tidy({"cpu": "slow"})
        self.assertEqual({name for (name, _), row in rows.items() if row["comparable"] == "False"}, {"time_handle_p50"})
        self.assertEqual({row["comparable"] for row in self.tidy().values()}, {"True"})
        code, said = self.judged("time_handle_p50 > +500%", run_b={"cpu": "slow"})
        self.assertEqual(code, 2)
        self.assertIn("cpu: fast in A, slow in B", said[0])
        self.assertEqual(self.judged("depth_max_d_max > +5%", run_b={"cpu": "slow"})[0], 0)
        self.write()
        with h5py.File(self.paths[1], "a") as file:
            del file["provenance/cpu"]
        self.assertIn("B does not say its cpu", compare(*self.paths, Comparison())[0])

    # The gate

    def test_conditions(self):
        self.scale("depth_max_d_max", 1.1)
        half = 0.1 * np.median([case["depth_max_d_max"] for case in self.a if case["label"] == "b"]) / 2
        for condition, code in (
            ("depth_max_d_max > +5%", 1), ("depth_max_d_max>5%", 1), ("depth_max > 5 %", 1),
            ("depth_max_d_max > 11%", 0), ("depth_max_d_max < -5%", 0), ("depth_max_d_max <= 0", 1),
            (f"depth_max_d_max > {half}", 1), (f"depth_max_d_max > {3 * half}", 0), ("drag_mean >= 0", 1),
            ("drag_mean > 0%", 0), ("outcomes", 0),
        ):  # fmt: skip
            self.assertEqual(self.judged(condition)[0], code, condition)
        code, said = self.judged("depth_max_d_max > +5%", "drag_mean > 1%")
        self.assertEqual(len(said), 1)
        self.assertIn("label b: +10 %", said[0])
        self.assertIn("30 pairs", said[0])
        self.assertEqual(self.judged("depth_max_d_max > +5%", only=["label=a"])[0], 0)

    def test_a_condition_that_measures_nothing_does_not_pass(self):
        for case in self.b:
            case["drag_mean"] = math.nan if case["label"] == "b" else case["drag_mean"]
        code, said = self.judged("drag_mean > 5%")
        self.assertEqual((code, len(said)), (2, 1))
        self.assertIn("label b: no pair has a value", said[0])
        with self.assertRaisesRegex(InputError, "no metric 'depth_mix'.*'depth_max'"):
            self.judged("depth_mix > 5%")
        for case in self.a:
            case["status"] = "failed"
        code, said = self.judged("depth_max_d_max > 5%")
        self.assertEqual(code, 2)
        self.assertIn("failed cases", said[0])

    def test_from_zero_every_change_is_too_much(self):
        for a, b in zip(self.a, self.b):
            a["depth_max_d_max"], b["depth_max_d_max"] = 0.0, 0.001 if b["label"] == "b" else 0.0
        code, said = self.judged("depth_max_d_max > 500%")
        self.assertEqual((code, len(said)), (1, 1))
        self.assertIn("+∞", said[0])

    def test_groups_that_only_one_file_has(self):
        self.b = [case | {"case_id": "n" + case["case_id"], "label": "new"} for case in self.b[:30]] + self.b
        self.assertEqual(self.judged("depth_max_d_max > 5%", "outcomes"), (0, []))
        self.a, self.b = self.b, self.a
        code, said = self.judged("depth_max_d_max > 5%", "outcomes")
        self.assertEqual(code, 2)
        self.assertIn("30 of 90 cases of A are missing in B", said[0])
        self.assertIn("label new: no pair", said[1])

    def test_outcomes(self):
        self.a[3]["status"] = self.b[3]["status"] = "failed"
        self.a[4]["status"] = "diverged"
        self.assertEqual(self.judged("outcomes")[0], 0)
        self.b[5]["status"] = "timed_out"
        self.assertEqual(self.judged("outcomes"), (1, ["outcomes: 1 of 60 cases completed in A and not in B"]))
        self.b[5]["status"] = "complete"
        del self.b[7]
        self.assertEqual(self.judged("outcomes")[0], 1)

    def test_conditions_that_are_none(self):
        for wrong in (
            "", "depth_max", "depth_max > ", "depth_max > 5 mm", "> 5%", "depth_max = 5", "depth > 1e999", "a > nan",
            "depth_max > 5%%", "outcome s", "depth_max >> 5",
        ):  # fmt: skip
            with self.assertRaisesRegex(InputError, "expected outcomes, or a figure"):
                read_condition(wrong)

    # The command line

    def test_exit_codes_and_streams(self):
        self.scale("depth_max_d_max", 1.1)
        self.write()
        words = ("compare", "--better=depth_max=low", "--metric=depth_max", "--fail-on=depth_max_d_max > +5%")
        done = self.run_program(*words, "--csv", "--", *self.paths)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stdout.splitlines()), 3)
        self.assertIn("trocar: fails on depth_max_d_max > +5%: depth_max_d_max, label b: +10 %", done.stderr)
        self.assertEqual(self.run_program(*words, "--only=label=a", "--", *self.paths).returncode, 0)

    def test_files_that_cannot_be_compared(self):
        self.write()
        foreign = self.folder / "foreign.h5"
        foreign.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
        self.assert_refused("compare", self.paths[0], foreign, saying=["foreign.h5: cannot be read"])
        strange = {"organ": None, "status": [1] * 60, "depth_max_d_max": ["deep"] * 60, "speed": [[1.0]] * 60}
        for name, values in strange.items():
            with self.subTest(name), h5py.File(self.paths[1], "a") as file:
                kept = file["cases"][name][()]
                del file["cases"][name]
                if values:
                    file["cases"][name] = values
                file.flush()
                with self.assertRaisesRegex(InputError, f"b.h5: .*{name}"):
                    compare(*self.paths, Comparison())
                if values:
                    del file["cases"][name]
                file["cases"].create_dataset(name, data=kept)
        for case in self.b:
            case["case_id"] = "x" + case["case_id"]
        with self.assertRaisesRegex(InputError, "none of the 60 cases"):
            self.compare()
        self.b = [case | {"case_id": "same"} for case in self.b]
        with self.assertRaisesRegex(InputError, "b.h5: is damaged: /cases has case same twice"):
            self.compare()

    def test_groups_and_markdown(self):
        text, _ = self.compare(by=["speed", "label"], style="markdown", metrics=["depth_max"])
        lines = text.splitlines()
        self.assertTrue(lines[0].startswith("| figure | speed | strategy | pairs | median A |"))
        self.assertEqual(sum(line.startswith("| depth_max_d_max, mm |") for line in lines), 4)
        self.assertIn("- Every pair ended alike (60 complete).", lines)
        with self.assertRaisesRegex(InputError, "did you mean 'speed'"):
            self.compare(by=["sped"])


if __name__ == "__main__":
    unittest.main()
