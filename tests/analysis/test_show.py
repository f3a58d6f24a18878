"""`show`: figures against ones computed by hand, and what is refused."""

import csv
import io
import math
import os
import unittest
from pathlib import Path

import h5py
from result_file import ProgramTest, write_results


def cases_of(label, speed, depths, **more):
    shared = {"label": label, "speed": float(speed)} | more
    return [shared | {"case_id": f"{label}-{speed}-{i}", "depth_max_d_max": d} for i, d in enumerate(depths)]


class Show(ProgramTest):
    def write(self, *groups):
        write_results(self.file, [case for group in groups for case in group])

    def tidy(self, *arguments):
        return list(csv.DictReader(io.StringIO(self.output_of("show", self.file, "--csv", *arguments))))

    def row_of(self, text, label):
        return next(line for line in text.splitlines() if label in line.split())

    def test_median_and_quartiles(self):
        self.write(cases_of("a", 100, [1.0, 2.0, 3.0, 4.0, 100.0]))
        (row,) = self.tidy("--metric", "depth_max_d_max")
        figures = [float(row[name]) for name in ("median", "q1", "q3", "min", "max")]
        self.assertEqual(figures, [3, 2, 4, 1, 100])
        self.assertEqual((row["cases"], row["failed"], row["nan"], row["units"]), ("5", "0", "0", "mm"))
        self.assertIn("3 (2–4)", self.output_of("show", self.file))

    def test_each_is_one_row_per_case_in_full_precision(self):
        self.write(cases_of("a", 100, [1 / 3, 2.0]), cases_of("b", 20, [0.1], status="failed", reason="it, \"broke\""))
        rows = list(csv.DictReader(io.StringIO(self.output_of("show", self.file, "--each"))))
        self.assertEqual([row["case_id"] for row in rows], ["a-100-0", "a-100-1", "b-20-0"])
        self.assertEqual(float(rows[0]["depth_max_d_max"]), 1 / 3)
        self.assertEqual((rows[2]["status"], rows[2]["reason"]), ("failed", 'it, "broke"'))
        few = self.output_of("show", self.file, "--each", "--only", "speed=20", "--metric", "time_handle_p50")
        (row,) = csv.DictReader(io.StringIO(few))
        self.assertNotIn("depth_max_d_max", row)
        self.assert_refused("show", self.file, "--each", "--by", "label", saying=["--each"])

    def test_rounding_is_shown_as_zero(self):
        self.write(cases_of("a", 100, [8.6e-15, 9.1e-15]), cases_of("b", 100, [2e-11, 2e-11]))
        shown = self.output_of("show", self.file, "--by", "label")
        self.assertIn(" 0", self.row_of(shown, "a"))
        self.assertNotIn("e-15", shown)
        self.assertIn("2e-11", self.row_of(shown, "b"))
        self.assertEqual(float(self.tidy("--by", "label")[0]["median"]), (8.6e-15 + 9.1e-15) / 2)

    def test_failures_are_counted_and_not_averaged(self):
        self.write(
            cases_of("a", 100, [1.0, 2.0]),
            cases_of("a", 200, [50.0], status="diverged"),
            cases_of("b", 100, [7.0]),
            cases_of("b", 200, [math.nan], status="timed_out"),
            cases_of("a", 100, [99.0], status="crashed"),
        )
        rows = self.tidy("--by", "label", "--metric", "depth_max_d_max")
        counts = [(row["label"], row["cases"], row["failed"]) for row in rows]
        self.assertEqual(counts, [("a", "4", "2"), ("b", "2", "1")])
        self.assertEqual([float(row["median"]) for row in rows], [1.5, 7])
        self.assertEqual(rows[1]["failures"], "1 timed_out")
        text = self.output_of("show", self.file)
        self.assertIn("6 cases, 3 complete, 3 failed (1 diverged, 1 timed_out, 1 crashed)", text)
        diverged = next(line for line in text.splitlines() if line.split()[:2] == ["200", "a"])
        self.assertIn("(1 diverged)", diverged)
        self.assertIn("–", diverged)
        self.assertNotIn("50", diverged)

    def test_only_keeps_what_matches_every_key(self):
        self.write(
            cases_of("a", 100, [1.0]), cases_of("a", 20, [2.0]), cases_of("b", 100, [4.0]), cases_of("c", 100, [8.0])
        )
        only = ["--only=speed=100", "--only=label=a", "--only=label=c"]
        rows = self.tidy("--by", "label", "--metric", "depth_max_d_max", *only)
        self.assertEqual([(row["label"], float(row["median"])) for row in rows], [("a", 1), ("c", 8)])
        for wrong, said in (("speed", "key=value"), ("sped=1", "speed"), ("speed=99", "100")):
            self.assert_refused("show", self.file, f"--only={wrong}", saying=[said])

    def test_nan_is_counted_and_not_averaged(self):
        self.write(cases_of("a", 100, [math.nan, 1.0, 3.0, math.nan]), cases_of("b", 100, [math.nan]))
        some, none = self.tidy("--metric", "depth_max_d_max")
        self.assertEqual((some["nan"], float(some["median"])), ("2", 2.0))
        self.assertEqual((none["nan"], none["median"]), ("1", ""))
        text = self.output_of("show", self.file)
        self.assertIn("2 [2 NaN]", self.row_of(text, "a"))
        self.assertIn("– [1 NaN]", self.row_of(text, "b"))

    def test_rows_are_in_the_order_of_speeds_and_of_the_file(self):
        self.write(*(cases_of(label, speed, [1.0]) for speed in (400, 20, 100) for label in ("z", "a")))
        found = [(row["speed"], row["label"]) for row in self.tidy("--metric", "depth_max_d_max")]
        speeds = ("20.0", "100.0", "400.0")
        self.assertEqual(found, [(speed, label) for speed in speeds for label in ("z", "a")])

    def test_conditions_that_differ_are_not_mixed(self):
        self.write(cases_of("a", 100, [1.0], organ="sphere"), cases_of("a", 100, [9.0], organ="liver"))
        rows = self.tidy("--metric", "depth_max_d_max")
        medians = [(row["organ"], float(row["median"])) for row in rows]
        self.assertEqual(medians, [("sphere", 1), ("liver", 9)])

    def test_a_metric_is_all_its_columns_and_csv_has_full_precision(self):
        third = 1 / 3
        self.write(cases_of("a", 100, [third]))
        (row,) = self.tidy("--metric", "depth_max")
        self.assertEqual((row["metric"], float(row["median"])), ("depth_max_d_max", third))

    def test_a_name_of_a_metric_and_of_anothers_column_is_both(self):
        # The mean of order_spread over the steps, and what there is of the metric order_spread_mean.
        figures = {"order_spread_mean": 60.0, "order_spread_max": 80.0, "order_spread_mean_mean": 20.0}
        self.write(cases_of("a", 100, [0.0], **figures))
        names = ("order_spread_mean", "order_spread", "order_spread_mean_mean")
        asked = {name: self.tidy("--metric", name) for name in names}
        medians = {name: {row["metric"]: float(row["median"]) for row in rows} for name, rows in asked.items()}
        mean_mean = {"order_spread_mean_mean": 20}
        self.assertEqual(medians["order_spread_mean"], {"order_spread_mean": 60, **mean_mean})
        self.assertEqual(medians["order_spread"], {"order_spread_mean": 60, "order_spread_max": 80})
        self.assertEqual(medians["order_spread_mean_mean"], mean_mean)

    def test_times_are_shown_in_readable_units(self):
        self.write(cases_of("a", 100, [0.0], time_handle_p50=12345.0))
        text = self.output_of("show", self.file, "--metric", "time_handle")
        self.assertIn("µs", text)
        self.assertIn("12.3", self.row_of(text, "a"))
        self.write(cases_of("a", 100, [0.0], time_handle_p50=12345678.0))
        text = self.output_of("show", self.file, "--metric", "time_handle")
        self.assertIn(" ms\n", text)
        self.assertIn("12.3", self.row_of(text, "a"))

    def test_a_case_without_label_shows_its_strategy(self):
        self.write([{"case_id": "1", "strategy": "tool-facet"}])
        self.assertIn("tool-facet", self.output_of("show", self.file))

    def test_a_part_of_a_sweep_is_called_one(self):
        self.write(cases_of("a", 100, [1.0, 2.0]))
        for whole, said in ((None, False), (2, False), (5, True)):
            if whole:
                with h5py.File(self.file, "r+") as file:
                    file.attrs["sweep_cases"] = whole
            for style in ((), ("--markdown",)):
                self.assertEqual("holds 2 of the sweep's 5 cases" in self.output_of("show", self.file, *style), said)

    def test_markdown(self):
        self.write(cases_of("a|b", 100, [1.0, 2.0, 3.0]))
        lines = self.output_of("show", self.file, "--markdown", "--metric", "depth_max").splitlines()
        self.assertEqual(lines[0], "| speed, mm/s | strategy | cases | failed | depth_max_d_max, mm |")
        self.assertEqual(lines[1], "| ---: | --- | ---: | ---: | ---: |")
        self.assertEqual(lines[2:], [r"| 100 | a\|b | 3 | 0 | 2 (1.5–2.5) |"])

    def test_arguments_in_the_form_that_trocar_passes_them(self):
        self.write(cases_of("a", 100, [1.0]))
        said = self.output_of("show", "--by=label", "--metric=depth_max", "--csv", "--", self.file)
        self.assertIn("\na,1,0,", said)


class Refused(ProgramTest):
    def test_missing_file(self):
        self.assert_refused("show", "none.h5", saying=["none.h5: no such file"])

    def test_text_file(self):
        self.file.write_text("organ")
        self.assert_refused("show", self.file, saying=["cannot be read as an HDF5 file"])

    def test_foreign_hdf5_file(self):
        with h5py.File(self.file, "w") as file:
            file["cases"] = [1, 2]
        self.assert_refused("show", self.file, saying=["is no Trocar result"])

    def test_other_schema(self):
        write_results(self.file, [{"case_id": "1"}])
        with h5py.File(self.file, "a") as file:
            file.attrs["schema_version"] = 7
        self.assert_refused("show", self.file, saying=["schema 7", "reads schema 2"])

    def test_unfinished_file(self):
        write_results(self.file, [{"case_id": "1"}])
        with h5py.File(self.file, "a") as file:
            del file.attrs["complete"]
        self.assert_refused("show", self.file, saying=["is not whole"])

    def test_columns_of_different_length(self):
        write_results(self.file, [{"case_id": "1"}])
        with h5py.File(self.file, "a") as file:
            file["cases/extra"] = [1.0, 2.0]
        self.assert_refused("show", self.file, saying=["is damaged", "differ in length"])

    def test_unknown_names_with_the_nearest_right_one(self):
        write_results(self.file, [{"case_id": "1"}])
        self.assert_refused("show", self.file, "--by", "sped", saying=["no column or option 'sped'", "'speed'"])
        self.assert_refused("show", self.file, "--metric", "depth_mux", saying=["'depth_mux'", "'depth_max'"])

    def test_bad_usage(self):
        self.assert_refused("show", saying=["file"])
        self.assert_refused("shout", "x.h5", saying=["shout"])

    def test_missing_package_is_named(self):
        (self.folder / "h5py.py").write_text('raise ModuleNotFoundError("no h5py", name="h5py")\n')
        self.assert_refused("show", "x.h5", saying=["python3-h5py"], path_first=self.folder)

    def test_a_full_disk_is_no_bug(self):
        write_results(self.file, [{"case_id": "1"}])
        with Path("/dev/full").open("w") as full:
            done = self.run_program("show", self.file, stdout=full)
        self.assertEqual((done.returncode, done.stderr), (2, "trocar: No space left on device\n"))

    def test_a_reader_that_has_seen_enough(self):
        write_results(self.file, [{"case_id": "1"}])
        reading, writing = os.pipe()
        os.close(reading)
        with os.fdopen(writing, "w") as nobody:
            done = self.run_program("show", self.file, stdout=nobody)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_nobody_has_foreseen_is_no_verdict(self):
        for odd in ('KeyError("odd")', 'OSError("odd")', 'ModuleNotFoundError("odd", name="odd")'):
            (self.folder / "h5py.py").write_text(f"raise {odd}\n")
            done = self.run_program("show", "x.h5", path_first=self.folder)
            self.assertEqual((done.returncode, done.stdout), (3, ""), odd)
            self.assertIn("Traceback", done.stderr)
            *_, what, last = done.stderr.splitlines()
            self.assertIn("odd", what)
            self.assertIn("trocar: this is a bug", last)


if __name__ == "__main__":
    unittest.main()
