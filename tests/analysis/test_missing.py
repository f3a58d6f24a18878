"""What `show` says of figures that do not exist, and what a result file says of steps without a value."""

import csv
import io
import math
import unittest

import h5py
from result_file import ProgramTest, write_results
from trocar_analysis.errors import InputError
from trocar_analysis.store import ResultFile

NO_VERTEX = '{"drag":{"no vertex collided":12},"strain":{"empty region":1}}'
AGAIN = '{"drag":{"no vertex collided":1}}'
TWO_REASONS = '{"drag":{"no vertex collided":2,"motion along the normal":7}}'


def case(number, drag, missing="", **more):
    return {"case_id": f"c{number}", "drag_mean": drag, "metrics": "all", "missing": missing} | more


class Missing(ProgramTest):
    def tidy(self, *arguments):
        return list(csv.DictReader(io.StringIO(self.output_of("show", self.file, "--csv", *arguments))))

    def test_how_many_cases_lack_a_figure_and_why(self):
        cases = [case(i, 1.0) for i in range(17)] + [case(i, math.nan, NO_VERTEX) for i in range(17, 20)]
        cases.append(case(20, math.nan, NO_VERTEX, status="diverged"))
        write_results(self.file, cases)
        said = "drag: no value in 3 of 20 complete cases (no vertex collided)"
        text = self.output_of("show", self.file, "--metric", "drag", "--metric", "depth_max")
        self.assertIn("1 [3 NaN]", text)
        self.assertEqual(text.splitlines()[-1], said)
        self.assertEqual(text.count("no value in"), 1)
        lines = self.output_of("show", self.file, "--metric", "drag", "--markdown").splitlines()
        self.assertEqual([line[0] for line in lines if line], ["|", "|", "|", "-", "-"])
        self.assertEqual(lines[-1], f"- {said}")
        (row,) = self.tidy("--metric", "drag")
        self.assertEqual((row["nan"], row["why"]), ("3", "3 no vertex collided"))

    def test_reasons_are_counted_over_all_groups_and_in_each(self):
        write_results(
            self.file,
            [
                case(1, math.nan, NO_VERTEX), case(2, math.nan, TWO_REASONS), case(3, math.nan, AGAIN),
                case(4, math.nan, NO_VERTEX, label="b"), case(5, math.nan, "", label="b"), case(6, 3.0, label="b"),
            ],
        )  # fmt: skip
        text = self.output_of("show", self.file, "--metric", "drag")
        expected = "3 no vertex collided, 1 motion along the normal and no vertex collided, 1 no reason recorded"
        self.assertIn(f"drag: no value in 5 of 6 complete cases ({expected})", text)
        one, other = self.tidy("--metric", "drag")
        self.assertEqual(one["why"], "2 no vertex collided, 1 motion along the normal and no vertex collided")
        self.assertEqual(other["why"], "1 no vertex collided, 1 no reason recorded")

    def test_figures_of_a_series_share_a_line_where_they_lack_the_same_cases(self):
        drag_max = {"drag_max": math.nan, "drag_final": math.nan}
        with_values = {"drag_max": 2.0, "drag_final": math.nan}
        write_results(self.file, [case(1, math.nan, NO_VERTEX, **drag_max), case(2, 1.0, NO_VERTEX, **with_values)])
        text = self.output_of("show", self.file, "--metric", "drag_mean", "--metric", "drag_max")
        self.assertIn("\ndrag: no value in 1 of 2 complete cases (no vertex collided)", text)
        text = self.output_of("show", self.file, "--metric", "drag")
        self.assertIn("\ndrag_max, drag_mean: no value in 1 of 2", text)
        self.assertIn("\ndrag_final: no value in 2 of 2", text)

    def test_a_metric_that_was_off(self):
        write_results(self.file, [case(1, math.nan, metrics="depth_max,drag_along"), case(2, 1.0, metrics="drag")])
        text = self.output_of("show", self.file, "--metric", "drag")
        self.assertIn("drag: no value in 1 of 2 complete cases (the metric was off)", text)

    def test_a_run_without_a_step_in_the_window(self):
        write_results(self.file, [case(1, 1.0, window_steps=7), case(2, math.nan, window_steps=0)])
        said = "drag: no value in 1 of 2 complete cases (the tool meets the organ at rest in no step)"
        self.assertIn(said, self.output_of("show", self.file, "--metric", "drag"))

    def test_nothing_is_said_where_nothing_is_missing(self):
        write_results(self.file, [case(1, 1.0, NO_VERTEX)])
        self.assertNotIn("NaN", self.output_of("show", self.file, "--metric", "drag"))

    def test_what_was_asked_for_is_no_figure_unless_it_is_named(self):
        asked = {"judged_rate": 100.0, "same_state": 5, "window_steps": 40}
        write_results(self.file, [case(1, 1.0, **asked), case(2, 1.0, **asked | {"same_state": 0})])
        text = self.output_of("show", self.file)
        for name in (*asked, "metrics", "missing"):
            self.assertNotIn(name, text)
        (row,) = self.tidy("--metric", "window_steps")
        self.assertEqual(float(row["median"]), 40)
        rows = self.tidy("--by", "same_state", "--metric", "drag")
        self.assertEqual([row["same_state"] for row in rows], ["0", "5"])
        for name in ("metrics", "missing", "same_state"):
            self.assert_refused("show", self.file, "--metric", name, saying=[f"no metric '{name}'"])

    def test_a_column_missing_that_is_not_understood(self):
        for wrong in ("no vertex", "[1]", '{"drag": 3}'):
            write_results(self.file, [case(1, math.nan, wrong)])
            self.assert_refused("show", self.file, "--metric", "drag", saying=["out.h5: is damaged"])

    def test_steps_without_a_value(self):
        write_results(self.file, [case(1, 1.0)])
        with h5py.File(self.file, "a") as file:
            for name in ("drag", "depth_max_d", "broken"):
                file[f"series/c1/{name}"] = [math.nan, 1.0, math.nan, math.nan]
            file["series/c1/drag"].attrs["missing"] = '{"no vertex collided":[[0,0],[2,3]]}'
            file["series/c1/broken"].attrs["missing"] = "[["
        with ResultFile(self.file) as results:
            self.assertEqual(results.missing_steps("c1", "drag"), {"no vertex collided": [(0, 0), (2, 3)]})
            self.assertEqual(results.missing_steps("c1", "depth_max_d"), {})
            for name in ("broken", "none"):
                with self.assertRaisesRegex(InputError, "is damaged"):
                    results.missing_steps("c1", name)


if __name__ == "__main__":
    unittest.main()
