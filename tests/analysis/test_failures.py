"""`show --failures` and `show --provenance`, and the warning above times that cannot be compared."""

import csv
import io
import unittest

from result_file import ProgramTest, write_results
from trocar_analysis.errors import InputError
from trocar_analysis.show import Wishes, show_cases, show_failures, show_provenance

WORDS = "case_id", "git_commit", "git_dirty", "compiler", "flags", "build_type", "libraries", "cpu", "host"


def row(**more):
    """Of /provenance."""
    return dict.fromkeys(WORDS, "x") | {"git_dirty": 0, "argv": "trocar run", "start": "1", "end": "2"} | more


def case(number, **more):
    return {"case_id": f"c{number}", "label": "a", "provenance_row": 0, "wall_s": 1.0} | more


class Failures(ProgramTest):
    def write(self):
        write_results(
            self.file,
            [
                case(1), case(2, status="failed", reason="no place\nto start", label="b"),
                case(3, status="crashed", reason="signal 11\x1b[31m", seed=2),
                case(4, status="crashed", reason="signal 6", seed=1),
                case(5, status="crashed", reason="signal 6", label="b", organ="liver"),
            ],
        )  # fmt: skip

    def test_one_line_a_case_sorted_and_counted(self):
        self.write()
        lines = show_failures(self.file, Wishes()).splitlines()
        self.assertEqual(lines[:3], [f"{self.file}: 5 cases, 4 failed", "3 crashed: 2 a, 1 b", "1 failed: 1 b"])
        cases = [next(word for word in line.split() if word in ("c2", "c3", "c4", "c5")) for line in lines[7:] if line]
        self.assertEqual(cases, ["c4", "c3", "c5", "c2"])
        self.assertTrue(lines[-1].endswith("no place to start"), lines[-1])
        self.assertNotIn("\x1b", "".join(lines))

    def test_filters_and_csv(self):
        self.write()
        text = self.output_of("show", self.file, "--failures", "--csv", "--only", "label=b")
        rows = list(csv.DictReader(io.StringIO(text)))
        self.assertEqual([(row["case_id"], row["status"]) for row in rows], [("c5", "crashed"), ("c2", "failed")])
        self.assertEqual(rows[1]["reason"], "no place\nto start")
        text = show_failures(self.file, Wishes(["status=complete"]))
        self.assertIn("1 cases, no failures", text)

    def test_no_failures(self):
        write_results(self.file, [case(1)])
        self.assertEqual(self.output_of("show", self.file, "--failures"), f"{self.file}: 1 cases, no failures\n")
        self.assertEqual(len(show_failures(self.file, Wishes(style="csv")).splitlines()), 1)
        self.assert_refused("show", self.file, "--failures", "--by", "label", saying=["no --by"])


class Provenance(ProgramTest):
    def write(self, *rows):
        write_results(self.file, [case(k, provenance_row=k) for k in range(len(rows))], provenance=list(rows))

    def test_equal_rows_are_one_group(self):
        self.write(
            row(case_id="c0", start="3", end="4"), row(case_id="c1", start="1", end="9"),
            row(case_id="c2", host="y", start="0", end="1"),
        )  # fmt: skip
        text = show_provenance(self.file, Wishes(style="csv"))
        rows = [(r["cases"], r["host"], r["first_start"], r["last_end"]) for r in csv.DictReader(io.StringIO(text))]
        self.assertEqual(rows, [("1", "y", "0", "1"), ("2", "x", "1", "9")])
        text = self.output_of("show", self.file, "--provenance")
        self.assertIn("3 cases, 1 program, 2 machines", text)
        self.assertIn("different machines (host)", text)

    def test_what_makes_times_incomparable(self):
        for name in ("compiler", "flags", "build_type", "libraries", "host", "cpu", "case_id"):
            with self.subTest(name):
                self.write(row(), row(**{name: "y"}))
                text = show_cases(self.file, Wishes(metrics=["time_handle"]))
                self.assertEqual("not comparable" in text.split("─")[0], name != "case_id")
        # A commit is a name. Two may make the same program, and one, with changes that are in none, two programs.
        for builds, commits, comparable in ((("b", "b"), ("x", "y"), True), (("b", "c"), ("x", "x"), False)):
            write_results(
                self.file, [case(k, provenance_row=k, build_id=build) for k, build in enumerate(builds)],
                provenance=[row(git_commit=commit) for commit in commits],
            )  # fmt: skip
            text = show_cases(self.file, Wishes(metrics=["time_handle"]))
            self.assertEqual("not comparable" not in text.split("─")[0], comparable)
            programs = "1 program," if comparable else "2 programs,"
            self.assertIn(programs, self.output_of("show", self.file, "--provenance"))
        self.write(row(), row(host="y"))
        self.assertNotIn("Warning", show_cases(self.file, Wishes(metrics=["depth_max"])))
        markdown = show_cases(self.file, Wishes(metrics=["time_handle"], style="markdown"))
        self.assertIn("\n- Warning: cases come from different machines (host)", markdown)
        done = self.run_program("show", self.file, "--metric", "time_handle", "--csv")
        self.assertIn("not comparable", done.stderr)
        self.assertNotIn("not comparable", done.stdout)

    def test_times_that_cannot_be_compared_are_marked(self):
        metrics = ["time_handle", "wall_s", "depth_max"]
        marked = {}
        for name, origins in {"one": [row(), row()], "two": [row(), row(host="y")]}.items():
            self.write(*origins)
            text, table = (show_cases(self.file, Wishes(metrics=metrics, style=s)) for s in ("text", "markdown"))
            asked = [f"--metric={metric}" for metric in metrics]
            rows = csv.DictReader(io.StringIO(self.run_program("show", self.file, *asked, "--csv").stdout))
            comparable = {r["metric"]: r["comparable"] for r in rows}
            marked[name] = text.count("†"), table.splitlines()[0].split(" | ")[4:], comparable
            self.assertEqual("_p50†" in text.split("─")[0], name == "two")
        times = "time_handle_p50", "wall_s"
        names = ["time_handle_p50, µs", "wall_s", "depth_max_d_max, mm |"]
        self.assertEqual(marked["one"], (0, names, dict.fromkeys([*times, "depth_max_d_max"], "True")))
        names = ["time_handle_p50†, µs", "wall_s†", "depth_max_d_max, mm |"]
        self.assertEqual(marked["two"], (3, names, dict.fromkeys(times, "False") | {"depth_max_d_max": "True"}))

    def test_only_the_shown_cases_count(self):
        rows = [row(), row(host="y")]
        write_results(self.file, [case(k, seed=k, provenance_row=k) for k in (0, 1)], provenance=rows)
        self.assertNotIn("Warning", show_cases(self.file, Wishes(["seed=1"], metrics=["time_handle"])))

    def test_files_that_do_not_say(self):
        write_results(self.file, [case(1)])
        with self.assertRaisesRegex(InputError, "does not say how its cases were run"):
            show_provenance(self.file, Wishes())
        write_results(self.file, [case(1, provenance_row=3)], provenance=[row()])
        with self.assertRaisesRegex(InputError, "is damaged: provenance_row"):
            show_cases(self.file, Wishes())


if __name__ == "__main__":
    unittest.main()
