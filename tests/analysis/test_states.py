"""`show --states`: the same-state comparison, against figures computed by hand, and what is refused."""

import csv
import io
import math
import unittest

import h5py
from result_file import ProgramTest, write_results

RUNS = [
    {"case_id": "r1", "label": "a", "speed": 20.0},
    {"case_id": "r2", "label": "b", "speed": 20.0},
    {"case_id": "r3", "label": "a", "speed": 100.0},
]


def answer(run, step, label, depth, **more):
    """What the strategy `label` made of the state at a step of a run."""
    return {"case_id": run, "step": step, "strategy": f"{label}-strategy", "label": label, "depth_max_h": depth} | more


def both(run, step, depth_of_a, depth_of_b, **more):
    return [answer(run, step, "a", depth_of_a, **more), answer(run, step, "b", depth_of_b, **more)]


class ShowStates(ProgramTest):
    def write(self, *states, runs=RUNS):
        write_results(self.file, runs, states=[row for rows in states for row in rows])

    def write_three_runs(self):
        self.write(both("r1", 3, 1.0, 5.0), both("r1", 7, 2.0, 6.0), both("r2", 3, 4.0, 9.0), both("r3", 1, 0.5, 7.0))

    def tidy(self, *arguments):
        said = self.output_of("show", "--states", self.file, "--csv", *arguments)
        return list(csv.DictReader(io.StringIO(said)))

    def medians(self, *arguments, keys=("speed", "label")):
        return {tuple(row[key] for key in keys): float(row["median"]) for row in self.tidy(*arguments)}

    def test_answers_are_grouped_by_the_runs_conditions_and_by_who_answered(self):
        self.write_three_runs()
        rows = self.tidy()
        found = [(row["speed"], row["label"], row["states"], float(row["median"])) for row in rows]
        slow = [("20.0", "a", "3", 2.0), ("20.0", "b", "3", 6.0)]
        self.assertEqual(found, [*slow, ("100.0", "a", "1", 0.5), ("100.0", "b", "1", 7.0)])
        self.assertEqual((float(rows[0]["q1"]), float(rows[0]["q3"]), rows[0]["units"]), (1.5, 3.0, "mm"))

    def test_text(self):
        self.write_three_runs()
        text = self.output_of("show", "--states", self.file)
        lines = text.splitlines()
        self.assertEqual(lines[0], f"{self.file}: 4 states found in 3 runs, 8 answers of 2 strategies")
        self.assertIn("organ sphere, tool prism-4", lines[1])
        self.assertIn("Median (lower–upper quartile) over the answers.", text)
        self.assertIn(["20", "a", "3", "2", "(1.5–3)"], [line.split() for line in lines])

    def test_conditions_that_differ_are_not_mixed(self):
        runs = [RUNS[0], RUNS[1] | {"organ": "liver"}]
        self.write(both("r1", 3, 1.0, 5.0), both("r2", 3, 4.0, 9.0), runs=runs)
        medians = self.medians(keys=("organ", "label"))
        self.assertEqual(medians, {("sphere", "a"): 1, ("sphere", "b"): 5, ("liver", "a"): 4, ("liver", "b"): 9})

    def test_filters_on_the_answer_and_on_the_run(self):
        self.write_three_runs()
        self.assertEqual(self.medians("--only=label=b"), {("20.0", "b"): 6, ("100.0", "b"): 7})
        self.assertEqual(self.medians("--only=strategy=b-strategy"), {("20.0", "b"): 6, ("100.0", "b"): 7})
        self.assertEqual(self.medians("--only=run_label=b"), {("20.0", "a"): 4, ("20.0", "b"): 9})
        self.assertEqual(self.medians("--only=run_label=a", "--only=speed=20", "--only=label=a"), {("20.0", "a"): 1.5})
        self.assert_refused("show", "--states", self.file, "--only=run_lable=a", saying=["'run_label'"])
        self.assert_refused("show", "--states", self.file, "--only=speed=50", saying=["no speed '50'"])
        saying = ["label=a", "nothing matches"]
        self.write(both("r1", 3, 1.0, 5.0)[1:], both("r3", 3, 4.0, 9.0))
        self.assert_refused("show", "--states", self.file, "--only=speed=20", "--only=label=a", saying=saying)

    def test_grouping_by_who_ran(self):
        self.write_three_runs()
        medians = self.medians("--by", "run_label,label", "--only=speed=20", keys=("run_label", "label"))
        self.assertEqual(medians, {("a", "a"): 1.5, ("a", "b"): 5.5, ("b", "a"): 4, ("b", "b"): 9})

    def test_states_are_counted_once_however_many_answer(self):
        self.write_three_runs()
        (row,) = self.tidy("--by", "organ")
        self.assertEqual((row["states"], row["answers"], float(row["median"])), ("4", "8", 4.5))

    def test_a_metric_goes_by_its_name_without_the_moment(self):
        more = {"displacement_mean": 0.25, "odd_metric": 8.0}
        self.write(both("r1", 3, 1.0, 5.0, **more))
        for name, column in (("depth_max", "depth_max_h"), ("depth_max_h",) * 2, ("odd_metric",) * 2):
            self.assertEqual({row["metric"] for row in self.tidy("--metric", name)}, {column})
        self.assertEqual({row["metric"] for row in self.tidy()}, {"depth_max_h", "displacement_mean"})
        for name in ("step", "state", "speed", "depth_max_d_max"):
            self.assert_refused("show", "--states", self.file, "--metric", name, saying=[f"no metric '{name}'"])

    def test_markdown_and_why_values_are_missing(self):
        why = {"missing": '{"drag":"no vertex collided"}'}
        self.write(both("r1", 3, 1.0, 5.0, drag=math.nan, **why), both("r1", 7, 2.0, 6.0, drag=0.5, missing=""))
        lines = self.output_of("show", "--states", self.file, "--markdown", "--metric", "drag").splitlines()
        self.assertEqual(lines[0], "| speed, mm/s | strategy | states | drag, mm |")
        self.assertEqual(lines[2], "| 20 | a | 2 | 0.5 [1 NaN] |")
        self.assertEqual(lines[-1], "- drag: no value in 2 of 4 answers (no vertex collided)")
        found = [(row["nan"], row["why"]) for row in self.tidy("--metric=drag")]
        self.assertEqual(found, [("1", "1 no vertex collided")] * 2)

    def test_an_answer_without_label_shows_its_strategy(self):
        self.write([answer("r1", 3, "", 1.0, strategy="tool-facet")])
        self.assertIn("tool-facet", self.output_of("show", "--states", self.file))

    def test_a_file_without_states(self):
        self.write()
        self.assert_refused("show", "--states", self.file, saying=["has no states", "[compare] same_state = 5"])

    def test_damaged_states(self):
        self.write([answer("r9", 3, "a", 1.0)])
        self.assert_refused("show", "--states", self.file, saying=["is damaged", "names a case"])
        for damage, said in (("states/step", "no column step"), ("states", "is damaged")):
            self.write_three_runs()
            with h5py.File(self.file, "a") as file:
                del file[damage]
            self.assert_refused("show", "--states", self.file, saying=[said])


if __name__ == "__main__":
    unittest.main()
