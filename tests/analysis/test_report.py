"""The report of a result file: what it holds, that it is what the file says, its size, and files that it refuses."""

from __future__ import annotations

import contextlib
import csv
import io
import sys
import unittest
from unittest import mock

import h5py
import numpy as np
from report_sweep import BETTER, LEFT, PROVENANCE, SEEDS, ReportTest, fail, sweep
from result_file import write_results

from trocar_analysis.__main__ import main
from trocar_analysis.rank import Wishes, csv_text, read_ranking

CLAIM = """
[[claim]]
id = "C1"
place = "Fig. 1"
says = "careful leaves less than hasty."
data = "runs"
[[claim.condition]]
figure = "depth_max_d_max"
of = { label = "careful" }
is = "<"
than = { label = "hasty" }
"""
LACKING = CLAIM.replace("C1", "C2").replace("depth_max_d_max", "strain_max")


class Contents(ReportTest):
    def test_it_says_what_the_file_is(self):
        self.write(sweep())
        with h5py.File(self.file, "a") as file:
            file.attrs.update(sweep_toml='name = "made up"\n', created_utc="2026-01-01", sweep_cases=200)
        report = self.report()
        self.assertEqual(
            [report[name] for name in ("title", "file", "cases", "planned", "createdUtc", "generator", "schema")],
            ["made up", "out.h5", 84, 200, "2026-01-01", "test", 2],
        )
        self.assertEqual(report["labels"], [*LEFT])
        self.assertIn("84 of the sweep's 200 cases", report["notes"][0])

    def test_one_page_of_one_file_with_program_and_style(self):
        self.report(sweep())
        text = self.output.read_text()
        for part in ("/* the page's program */", "/* the page's style */", "default-src 'none'"):
            self.assertIn(part, text)
        self.assertEqual((self.made.size, [*self.folder.glob("*.tmp*")]), (self.output.stat().st_size, []))

    def test_ways_that_cases_were_run_stand_once(self):
        cases = sweep()
        for number, case in enumerate(cases):
            case["provenance_row"] = number % 3
        other = PROVENANCE | {"host": "other"}
        later = PROVENANCE | {"start": "2026-01-02T00:00:00Z", "end": "2026-01-02T00:01:00Z", "load": 3.0}
        write_results(self.file, cases, provenance=[PROVENANCE, other, later])
        report = self.report()
        self.assertEqual([way["host"] for way in report["provenance"]], ["h", "other"])
        self.assertEqual([way["cases"] for way in report["provenance"]], [56, 28])
        self.assertEqual(report["provenance"][0]["last_end"], later["end"])
        self.assertIn("different machines", report["overview"]["cautions"][0])

    def test_glossary(self):
        (depth,) = [one for one in self.report(sweep())["glossary"] if one["metric"] == "depth_max"]
        self.assertEqual((depth["unit"], depth["better"], depth["columns"]), ("mm", "low", ["depth_max_d_max"]))


class Comparisons(ReportTest):
    def test_numbers_are_those_of_rank(self):
        report = self.report(sweep())
        for comparison in report["overview"]["comparisons"]:
            table = csv_text(read_ranking(str(self.file), Wishes(comparison["name"], [], BETTER)))
            rows = [*csv.DictReader(io.StringIO(table))]
            self.assertEqual([row["label"] for row in comparison["rows"]], [row["label"] for row in rows])
            for ours, theirs in zip(comparison["rows"], rows):
                for name, column in (("meanRank", "mean_rank"), ("median", "median"), ("low", "low"), ("high", "high")):
                    self.assertEqual(ours[name], float(theirs[column]), (comparison["name"], name))
            self.assertEqual(comparison["ranks"]["difference"], float(rows[0]["critical_difference"]))

    def test_medians_are_those_of_the_cases(self):
        cases = sweep()
        comparison = self.report(cases)["overview"]["comparisons"][0]
        for row in comparison["rows"]:
            values = [case["depth_max_d_max"] for case in cases if case["label"] == row["label"]]
            self.assertEqual(row["median"], np.median(values))
        self.assertEqual((comparison["unit"], comparison["better"]), ("mm", "low"))

    def test_times_are_told_in_a_unit_that_people_read(self):
        time = self.report(sweep())["overview"]["comparisons"][-1]
        self.assertEqual((time["name"], time["unit"], time["factor"]), ("time_handle_p99", "µs", 1e-3))
        self.assertEqual(time["rows"][0]["label"], "hasty")

    def test_the_front_is_of_what_is_left_against_time(self):
        front = self.report(sweep())["overview"]["front"]
        self.assertEqual([(one["label"], one["onFront"]) for one in front["points"]],
                         [("hasty", True), ("middling", True), ("careful", True)])  # fmt: skip
        self.assertEqual((front["y"]["name"], front["x"]["name"]), ("depth_max_d_max", "time_handle_p99"))

    def test_how_cases_ended_and_what_lacks_a_value(self):
        cases = sweep()
        fail(cases, [0, 1, 2])
        fail(cases, [28], "timed_out", "after 60 s")
        cases[30]["depth_max_d_max"] = np.nan
        overview = self.report(cases)["overview"]
        careful, middling, hasty = overview["counts"]
        self.assertEqual(careful, {"label": "careful", "cases": 28, "complete": 25, "failed": {"diverged": 3}})
        self.assertEqual((middling["failed"], hasty["failed"]), ({"timed_out": 1}, {}))
        depth = overview["comparisons"][0]
        self.assertEqual(depth["lacking"], {"middling": 1})
        self.assertIn("1 of 28 conditions are left out", "".join(depth["notes"]))
        self.assertEqual([(kind["status"], kind["cases"], kind["example"]) for kind in overview["failures"]["kinds"]],
                         [("diverged", 3, cases[0]["case_id"]), ("timed_out", 1, cases[28]["case_id"])])  # fmt: skip

    def test_more_than_half_failed_is_infinitely_bad_and_said(self):
        cases = sweep()
        fail(cases, [*range(20)])
        overview = self.report(cases)["overview"]
        (careful,) = [row for row in overview["comparisons"][0]["rows"] if row["label"] == "careful"]
        self.assertEqual((careful["median"], careful["failed"]), ("inf", 20))
        self.assertIn("20 of 84 cases failed", overview["answer"][-1])

    def test_all_failed(self):
        cases = sweep()
        fail(cases, [*range(len(cases))])
        overview = self.report(cases)["overview"]
        self.assertIn("No case completed", overview["answer"][0])
        self.assertEqual(overview["failures"]["kinds"][0]["cases"], 84)

    def test_one_strategy_is_not_ranked(self):
        overview = self.report(sweep(("hasty",)))["overview"]
        self.assertIn("only strategy", overview["answer"][0])
        self.assertEqual(len(overview["comparisons"][0]["rows"]), 1)
        self.assertIn("takes 3 or more", overview["comparisons"][0]["why"])
        self.assertIn("takes 2 or more", overview["front"]["why"])

    def test_too_few_seeds_for_intervals(self):
        depth = self.report(sweep(seeds=SEEDS[:2]))["overview"]["comparisons"][0]
        self.assertEqual({row["low"] for row in depth["rows"]}, {None})


class Claims(ReportTest):
    def told(self, text: str, cases: list[dict]) -> dict:
        path = self.folder / "claims.toml"
        path.write_text(text)
        return self.report(cases, claims=str(path))["overview"]["claims"]

    def test_none_given(self):
        told = self.report(sweep())["overview"]["claims"]
        self.assertEqual(told["claims"], [])
        self.assertIn("No file of claims was given", told["about"][0])

    def test_a_claim_is_judged_on_the_cases_of_the_file(self):
        told = self.told(CLAIM, [case for case in sweep() if case["speed"] == 20])
        (claim,) = told["claims"]
        words = {one["release"]: one["word"] for one in claim["verdicts"]}
        self.assertEqual(words, {"contact": "reproduced", "step": "not run"})
        self.assertIn("of 1 claims 1 reproduced", told["about"][0])
        table = [dict(zip((one["title"] for one in claim["table"]["columns"]), row)) for row in claim["table"]["rows"]]
        self.assertEqual((table[0]["release"], table[0]["n"], table[0]["holds"]), ("contact", "14", "yes"))

    def test_a_figure_that_the_file_lacks_leaves_the_other_claims(self):
        told = self.told(CLAIM + LACKING, sweep())
        first, second = told["claims"]
        self.assertEqual(first["verdicts"][0]["word"], "reproduced")
        self.assertEqual(second["verdicts"][0]["word"], "cannot be judged")
        self.assertIn("lacks the figure strain_max", second["notes"][0])
        self.assertIn("1 of 2 claims cannot be judged", "".join(told["about"]))


class Budget(ReportTest):
    def test_too_small_for_the_table_of_cases(self):
        self.write(sweep())
        said = self.refused("--budget is 0.001", budget=0.001)
        enough = float(said.split("give --budget ")[1].split()[0])
        self.report(budget=enough)
        self.assertLessEqual(self.output.stat().st_size, enough * 1e6)

    def test_series_fill_what_is_left_and_not_more(self):
        self.write(sweep())
        random = np.random.default_rng(1)
        with h5py.File(self.file, "a") as file:
            for case in sweep():
                file[f"series/{case['case_id']}/drag"] = random.normal(size=4000)
        small = self.report(budget=0.3)
        self.assertLessEqual(self.output.stat().st_size, 300_000)
        self.assertGreater(self.output.stat().st_size, 250_000)
        self.assertIn("of 84 cases are in this report", small["notes"][0])
        whole = self.report(budget=15)
        self.assertEqual((len(whole["series"]["cases"]), whole["notes"]), (84, []))

    def test_no_budget(self):
        self.write(sweep())
        self.refused("expected MB, more than 0", budget=0)


class Refused(ReportTest):
    def test_no_such_file(self):
        self.refused("no such file")

    def test_not_a_result_file(self):
        self.file.write_text("hello")
        self.refused("cannot be read as an HDF5 file")

    def test_another_schema(self):
        self.write(sweep())
        with h5py.File(self.file, "a") as file:
            file.attrs["schema_version"] = 1
        self.refused("was written with schema 1, this program reads schema 2")

    def test_no_cases(self):
        self.write(sweep())
        with h5py.File(self.file, "a") as file:
            for name, column in {**file["cases"]}.items():
                empty = column[:0]
                del file["cases"][name]
                file["cases"][name] = empty
        self.refused("has no cases")

    def test_a_damaged_column(self):
        self.write(sweep())
        with h5py.File(self.file, "a") as file:
            del file["cases/seed"]
        self.refused("has no column seed")

    def test_the_result_file_is_not_written_over(self):
        self.write(sweep())
        before = self.file.read_bytes()
        self.output = self.file
        self.refused("is the result file")
        self.assertEqual(self.file.read_bytes(), before)

    def test_a_report_that_is_there_stays_when_the_next_is_refused(self):
        self.report(sweep())
        before = self.output.read_bytes()
        self.refused("give --budget", budget=0.001)
        self.assertEqual(self.output.read_bytes(), before)

    def test_the_page_was_not_built(self):
        (self.folder / "page" / "page.js").unlink()
        self.write(sweep())
        self.refused("make page")

    def test_a_folder_that_is_not_there(self):
        self.write(sweep())
        self.output = self.folder / "none" / "report.html"
        self.refused("there is no folder")


class Command(ReportTest):
    def run_main(self, *arguments: object) -> tuple[int, str, str]:
        out, err = io.TextIOWrapper(io.BytesIO()), io.StringIO()
        words = ["trocar", "report", *map(str, arguments)]
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main()
        out.flush()
        return code, out.buffer.getvalue().decode(), err.getvalue()

    def test_it_prints_the_path_and_the_size(self):
        self.write(sweep())
        code, out, _ = self.run_main(self.file, "-o", self.output, "--better", "depth_max=low")
        self.assertEqual(code, 0)
        self.assertTrue(out.startswith(f"{self.output} (0.0 MB)"), out)

    def test_bad_input_is_code_2_and_one_line(self):
        code, out, err = self.run_main(self.file, "-o", self.output)
        self.assertEqual((code, out, len(err.splitlines())), (2, "", 1))


if __name__ == "__main__":
    unittest.main()
