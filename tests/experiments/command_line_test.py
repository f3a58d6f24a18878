"""Drives the built program from outside: exit codes, messages, what it writes and what it leaves alone.

/usr/bin/python3 command_line_test.py PROGRAM
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import xml.etree.ElementTree

import h5py
import numpy as np

from program_test import ProgramTest, run_tests
from same_bits import bits

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGES = SOURCE / "experiments" / "metrics" / "pages"
TURNS = SOURCE / "results" / "reference" / "claims" / "claims.turns.csv"

SWEEP = """name = "small"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@10mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [100, 400]
seeds = 2
"""

PANELS = """title = "Two ways"
caption = "Both at once."
columns = 2
view = { width = 30, height = 30, elevation = 30, turn = 0, rise = 2 }
[[panel]]
letter = "a"
title = "one"
where = { label = "nearest-face" }
surface = "wire"
[[panel]]
letter = "b"
title = "other"
where = { label = "fuzzy-per-vertex" }
"""

CUBE_OFF = """OFF
8 12 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 2 3 7
3 2 7 6
3 1 2 6
3 1 6 5
3 0 4 7
3 0 7 3
"""

BROKEN_MESHES = {
    "truncated.off": CUBE_OFF[: len(CUBE_OFF) // 2],
    "quad.obj": "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
    "index.off": CUBE_OFF.replace("3 0 2 1", "3 0 2 8"),
    "nan.off": CUBE_OFF.replace("1 1 0", "1 nan 0"),
    "billions.off": CUBE_OFF.replace("8 12 0", "4000000000 12 0"),
}

# Edits of SWEEP and what the message must hold.
BAD_SWEEPS = {
    "unknown strategy": ('"nearest-face"', '"nearest-fase"', 'sweep.toml:2:15: unknown strategy "nearest-fase"'),
    "speed 0": ("[100, 400]", "[0]", "sweep.toml:6:11: "),
    "negative speed": ("[100, 400]", "[-20]", "sweep.toml:6:11: "),
    "no seeds": ("seeds = 2", "seeds = 0", "sweep.toml:7:9: "),
    "syntax": ("seeds = 2", "seeds = = 2", "sweep.toml:7:9: "),
    "unknown key": ("speeds", "speds", 'sweep.toml:6:1: unknown key "speds"; did you mean "speeds"?'),
    "missing mesh": ('"sphere@10mm"', '{ file = "none.off" }', "none.off"),
}


class CommandLine(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        self.out = self.folder / "out.h5"

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    # Usage

    def test_help_of_each_command_has_an_example(self):
        for command in ([], ["run"], ["merge"], ["list"], ["show"], ["compare"], ["sensitivity"], ["rank"], ["front"], ["snapshot"],
                        ["figure"], ["figures"], ["report"], ["export"], ["reproduce"], ["check"],
                        ["bench"],
                        ["fuzzy"],
                        ["fuzzy", "rules"], ["fuzzy", "explain"], ["fuzzy", "plot"]):  # fmt: skip
            text = self.expect_done(*command, "--help").stdout
            self.assertIn("Example:", text)
            self.assertIn("Exit codes:", text)

    def test_version(self):
        self.assertRegex(self.expect_done("--version").stdout, r"^trocar \d+\.\d+\.\d+ ")

    def test_bad_usage_is_2(self):
        for arguments in ([], ["fly"], ["run"], ["run", self.sweep], ["run", self.sweep, "-o", self.out, "-j", "0"],
                          ["run", self.sweep, "-o", self.out, "--fast"], ["list", "organ"]):  # fmt: skip
            self.assertEqual(self.run_program(*arguments).returncode, 2, arguments)
        self.expect_refused('did you mean "check"?', "chekc")
        self.assertEqual(self.files(), ["sweep.toml"])

    def test_list_names_everything_that_a_sweep_can(self):
        text = self.expect_done("list").stdout
        for name in ("nearest-face", "fuzzy-per-vertex", "sphere", "prism-N", "penetration", "depth_max", "aggregate"):
            self.assertIn(name, text)
        self.assertNotIn("sphere", self.expect_done("list", "strategies").stdout)

    # Bad input

    def test_bad_sweeps_are_2_with_their_place(self):
        self.out.write_text("kept")
        for name, (before, after, message) in BAD_SWEEPS.items():
            with self.subTest(name):
                self.assertIn(before, SWEEP)
                self.sweep.write_text(SWEEP.replace(before, after))
                self.expect_refused(message, "run", self.sweep, "-o", self.out)
                self.assertEqual(self.out.read_text(), "kept")

    def test_a_missing_sweep_is_2(self):
        self.expect_refused("none.toml: No such file", "run", self.folder / "none.toml", "-o", self.out)

    def test_broken_meshes_are_2_for_run_and_check(self):
        for name, text in BROKEN_MESHES.items():
            with self.subTest(name):
                self.write(name, text)
                self.sweep.write_text(SWEEP.replace('"sphere@10mm"', f'{{ file = "{name}", size = 60 }}'))
                self.expect_refused(name, "run", self.sweep, "-o", self.out)
                self.expect_refused(name, "check", self.folder / name)
                self.assertFalse(self.out.exists())

    def test_check(self):
        text = self.expect_done("check", self.write("cube.off", CUBE_OFF), "--size", "50").stdout
        self.assertIn("50 × 50 × 50 mm", text)
        bowtie = "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"
        refused = self.run_program("check", self.write("bowtie.off", bowtie))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("refused", refused.stdout)

    def test_an_output_that_cannot_be_written_is_2_before_anything_runs(self):
        self.expect_refused("cannot be written", "run", self.sweep, "-o", self.folder / "none" / "out.h5")
        self.expect_refused("is no file", "run", self.sweep, "-o", self.folder)
        self.assertEqual(self.files(), ["sweep.toml"])

    def test_a_file_that_is_no_result_is_not_written_over(self):
        self.out.write_text("my notes")
        self.expect_refused("out.h5", "run", self.sweep, "-o", self.out)
        self.assertEqual(self.out.read_text(), "my notes")
        self.assertEqual(self.files(), ["out.h5", "sweep.toml"])

    def test_results_of_another_sweep_are_not_written_over(self):
        self.expect_done("run", self.sweep, "-o", self.out)
        before = self.out.read_bytes()
        self.sweep.write_text(SWEEP.replace("small", "other"))
        self.expect_refused("another sweep", "run", self.sweep, "-o", self.out)
        self.assertEqual(self.out.read_bytes(), before)

    def test_filters_are_checked(self):
        self.expect_refused('did you mean "speed"?', "run", self.sweep, "-o", self.out, "--only", "sped=100")
        self.assertFalse(self.out.exists())

    # Runs

    def test_dry_run_lists_cases_and_writes_nothing(self):
        text = self.expect_done("run", self.sweep, "--dry-run", "--only", "speed=100").stdout
        self.assertIn("4 cases, 4 of them to run", text)
        self.assertEqual(self.files(), ["sweep.toml"])
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1")
        text = self.expect_done("run", self.sweep, "-o", self.out, "--dry-run").stdout
        self.assertIn("8 cases, 4 of them to run", text)

    def test_a_second_run_runs_nothing(self):
        self.assertIn("8 run in", self.expect_done("run", self.sweep, "-o", self.out).stdout)
        before = self.out.read_bytes()
        self.assertIn("8 from an earlier run, 0 run", self.expect_done("run", self.sweep, "-o", self.out).stdout)
        self.assertEqual(self.out.read_bytes(), before)

    def test_metrics_are_chosen_and_a_case_without_one_is_run_again(self):
        one = ("run", self.sweep, "-o", self.out, "--only", "seed=1", "--only", "speed=100")
        self.expect_done(*one, "--metrics", "fast")
        self.assertIn("0 run in", self.expect_done(*one, "--metrics", "drag,depth_max").stdout)
        self.assertIn("2 run in", self.expect_done(*one, "--metrics", "tool_volume_inside").stdout)
        self.assertIn("0 run in", self.expect_done(*one, "--metrics", "fast").stdout)
        self.expect_refused('did you mean "drag"?', *one, "--metrics", "drga")
        self.expect_refused("no metric is named", *one, "--metrics", "")

    def test_list_metrics_says_when_and_in_what_unit(self):
        text = self.expect_done("list", "metrics").stdout
        for words in (r"tool_volume_inside +mm³ +H, D +low", r"recovery +mm +end", r"time_cycle +ns +step +low"):
            self.assertRegex(text, words)

    def test_states_are_compared_where_the_sweep_asks_for_it(self):
        self.sweep.write_text(SWEEP.replace("@10mm", "@5mm") + "[compare]\nsame_state = 2\n")
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1")
        with h5py.File(self.out) as file:
            labels = [label.decode() for label in file["states/label"][()]]
        self.assertGreater(len(labels), 0)
        self.assertEqual(labels.count("nearest-face"), labels.count("fuzzy-per-vertex"))
        text = self.expect_done("show", "--states", self.out, "--metric", "displacement_mean").stdout
        self.assertIn("fuzzy-per-vertex", text)

    def test_a_scene_without_a_place_is_left_out_with_the_reason(self):
        # No point of a sheet 120 mm wide is two radii of this tool from its boundary.
        thick = '["prism-6", { shape = "prism", sides = 6, radius = 40 }]'
        self.sweep.write_text(SWEEP.replace('["prism-6"]', thick).replace("sphere", "sheet"))
        result = self.expect_done("run", self.sweep, "-o", self.out)
        self.assertIn("8 of 8 cases: 8 complete", result.stdout)
        self.assertIn("not run: penetration on sheet@10mm with prism-6 r40 l80 (8 cases)", result.stderr)
        self.assertIn("80 mm from the boundary", result.stderr)
        result = self.run_program("run", self.sweep, "-o", self.out, "--only", "tool=prism-6 r40 l80")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no case is left to run", result.stderr)

    def test_a_case_that_fails_is_3_and_does_not_stop_the_others(self):
        # Two radii of this tool from the boundary there is one square of 1.8 mm in the middle of the sheet: a seed's
        # 10,000 draws mostly hit it.
        thick = '[{ shape = "prism", sides = 6, radius = 29.55 }]'
        sweep = SWEEP.replace('["prism-6"]', thick).replace("sphere", "sheet").replace("seeds = 2", "seeds = 20")
        self.sweep.write_text(sweep.replace("[100, 400]", "[400]"))
        result = self.run_program("run", self.sweep, "-o", self.out)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertRegex(result.stdout, r"40 of 40 cases: [0-9]+ complete, [0-9]+ failed")
        self.assertIn("failed: nearest-face, sheet@10mm, prism-6 r29.55 l80, penetration, 400 mm/s, seed", result.stderr)

    def test_an_interrupted_run_is_130_and_goes_on(self):
        self.sweep.write_text(SWEEP.replace("@10mm", "@2.5mm").replace("seeds = 2", "seeds = 20"))
        process = subprocess.Popen(
            [self.program, "run", self.sweep, "-o", self.out, "-j", "2"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True)  # fmt: skip
        self.assertIn("of 80 cases done", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        text, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("interrupted", text)
        self.assertEqual(self.files(), ["out.h5", "sweep.toml"])
        kept = int(text.split()[0])
        self.assertGreater(kept, 0)
        text = self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1", "--only", "seed=20").stdout
        self.assertIn("8 of 8 cases: 8 complete", text)

    # Pictures of metrics

    def test_snapshot_draws_what_a_metric_counts(self):
        for name, beginning in (("x.png", b"\x89PNG"), ("x.svg", b"<?xml")):
            target = self.folder / name
            said = self.expect_done("snapshot", "--metric", "depth_max", "-o", target).stdout
            self.assertIn("depth_max = 2 mm", said)
            self.assertTrue(target.read_bytes().startswith(beginning))
        self.expect_refused("x.pdf: a picture's name ends in", "snapshot", "--metric", "drag", "-o", self.folder / "x.pdf")

    def test_snapshot_needs_one_thing_to_draw(self):
        target = self.folder / "x.png"
        self.expect_refused('did you mean "depth_max"?', "snapshot", "--metric", "depth_mix", "-o", target)
        self.expect_refused("is no folder", "snapshot", "--metric", "all", "-o", target)
        for arguments in ([], ["--metric", "drag", "--scene", "sliding", "--organ", "sheet"], [self.out, "--metric", "drag"]):
            self.expect_refused("snapshot needs one of", "snapshot", *arguments, "-o", target)
        self.assertFalse(target.exists())

    # Figures

    def test_figure_draws_the_panels_that_a_file_describes(self):
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1", "--only", "speed=400", "--replay")
        panels = self.write("panels.toml", PANELS)
        for name, beginning in (("x.png", b"\x89PNG"), ("x.svg", b"<?xml")):
            said = self.expect_done("figure", self.out, "--panels", panels, "-o", self.folder / name).stdout
            self.assertIn("b) fuzzy-per-vertex · step ", said)
            self.assertTrue((self.folder / name).read_bytes().startswith(beginning))
        wrong = self.write("wrong.toml", PANELS.replace("nearest-face", "farthest-face"))
        self.expect_refused("wrong.toml: panel a: no label", "figure", self.out, "--panels", wrong, "-o", self.folder / "y.png")
        self.assertFalse((self.folder / "y.png").exists())

    # Reports, figures and exports

    def test_report_is_one_page(self):
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1")
        page = self.folder / "report.html"
        self.expect_done("report", self.out, "-o", page, "--budget", "2")
        text = page.read_text()
        self.assertTrue(text.startswith("<!doctype html>"))
        self.assertLessEqual(len(text.encode()), 2_000_000)
        self.expect_refused("--budget", "report", self.out, "-o", page, "--budget", "0")
        self.expect_refused("none.h5", "report", self.folder / "none.h5", "-o", page)
        self.assertEqual(page.read_text(), text)

    def test_report_judges_the_claims_and_reads_the_turns_beside_the_results(self):
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1")
        for turns, word in (("", "not run"), (TURNS.read_text(), "reproduced")):
            if turns:
                self.write("out.turns.csv", turns)
            self.expect_done("report", self.out, "-o", self.folder / "report.html")
            said = re.search(r'id="report">(.*?)</script>', (self.folder / "report.html").read_text(), re.DOTALL)[1]
            claims = {claim["id"]: claim["verdicts"] for claim in json.loads(said)["overview"]["claims"]["claims"]}
            self.assertEqual({verdict["word"] for verdict in claims["C11"]}, {word})

    def test_figures_fill_a_folder(self):
        self.expect_done("run", self.sweep, "-o", self.out)
        folder = self.folder / "figures"
        self.expect_done("figures", self.out, "-o", folder, "--metric", "depth_max_d_max", "--only", "speed=400")
        self.assertLessEqual({".svg", ".pdf", ".tex"}, {path.suffix for path in folder.iterdir()})
        self.expect_refused("none.h5", "figures", self.folder / "none.h5", "-o", folder)

    def test_export_has_meshes_and_the_way_for_paraview(self):
        self.expect_done("run", self.sweep, "-o", self.out, "--only", "seed=1", "--only", "speed=400", "--replay")
        with h5py.File(self.out) as file:
            first, second = file["cases/case_id"].asstr()[:]
        folder = self.folder / "case"
        self.expect_done(
            "export", self.out, "--case", second[:8], "-o", folder, "--format", "obj", "--moment", "handled", "--steps", "1:3"
        )
        names = [f"{name}_000{step}.obj" for name in ("organ_handled", "tool") for step in (1, 2)]
        self.assertEqual(sorted(path.name for path in folder.iterdir()), sorted([*names, "case.json", "replay.xdmf"]))
        grids = xml.etree.ElementTree.parse(folder / "replay.xdmf").findall("Domain/Grid")
        self.assertEqual([grid.get("Name").split()[-1] for grid in grids], [second])
        place = grids[0].find(".//Topology/DataItem").text.split(":")[0]
        self.assertTrue((folder / place).samefile(self.out))
        self.expect_refused("is not unique", "export", self.out, "--case", os.path.commonprefix([first, second]), "-o", folder)
        self.expect_refused("--format", "export", self.out, "--case", first, "-o", folder, "--format", "stl")

    def test_every_metric_has_a_page_with_its_picture(self):
        table = self.expect_done("list", "metrics").stdout
        metrics = re.findall(r"^  (\w+) +\S+ +(?:before|H|D|end|step)\b", table, re.MULTILINE)
        self.assertGreater(len(metrics), 20)
        texts = [page.read_text() for page in sorted(PAGES.glob("*.md"))]
        readme = (PAGES.parent / "README.md").read_text()
        for name in metrics:
            with self.subTest(name):
                own = [text for text in texts if name in text.splitlines()[0][2:].split(", ")]
                self.assertEqual(len(own), 1, "one page has it in its title")
                self.assertIn(f"`{name}`", readme)
                if not name.startswith("time_"):
                    self.assertIn(f"(pictures/{name}.png)", own[0])
                    self.assertTrue((PAGES / "pictures" / f"{name}.png").exists())

    def test_results_do_not_depend_on_the_number_of_jobs(self):
        other = self.folder / "other.h5"
        self.sweep.write_text(SWEEP + "[compare]\nsame_state = 2\n")
        self.expect_done("run", self.sweep, "-o", self.out, "--jobs", "1", "--replay")
        self.expect_done("run", self.sweep, "-o", other, "--jobs", "2", "--replay")
        one, two = bits(self.out), bits(other)
        self.assertGreater(len(one), 50)
        self.assertEqual(one.keys(), two.keys())
        for name in one:
            self.assertEqual(one[name], two[name], name)

    def test_show_passes_on_the_analysis_and_its_exit_code(self):
        self.expect_done("run", self.sweep, "-o", self.out)
        result = self.expect_done("show", self.out, "--by", "label,speed", "--metric", "depth_max_d_max", "--csv")
        self.assertIn("nearest-face", result.stdout)
        self.expect_refused("no_such_metric", "show", self.out, "--metric", "no_such_metric")
        self.expect_refused("none.h5", "show", self.folder / "none.h5")
        self.assertIn("8 cases, no failures", self.expect_done("show", self.out, "--failures").stdout)
        self.assertIn("8 cases, 1 program, 1 machine", self.expect_done("show", self.out, "--provenance").stdout)
        self.expect_refused("excludes", "show", self.out, "--failures", "--by", "label")

    def test_rank_and_front_know_which_way_is_better(self):
        self.sweep.write_text(SWEEP.replace('"fuzzy-per-vertex"]', '"fuzzy-per-vertex", "cylinder-axis"]'))
        self.expect_done("run", self.sweep, "-o", self.out)
        svg = self.folder / "x.svg"
        text = self.expect_done("rank", self.out, "--metric", "facets_crossing_d_mean", "--only", "speed=100", "-o", svg).stdout
        self.assertIn("over 2 blocks", text)
        self.assertIn("critical difference", text.lower())
        figures = ("front", self.out, "--metric", "facets_crossing_d_mean", "--against", "edge_ratio_mean_h_mean")
        self.assertIn("edge_ratio_mean_h_mean: higher is better", self.expect_done(*figures, "-o", svg).stdout)
        self.assertIn("cylinder-axis", svg.read_text())
        self.expect_refused("neither way is better", "rank", self.out, "--metric", "collided_vertices_max", "-o", svg)
        self.expect_refused("excludes", *figures, "-o", svg, "--csv", "--markdown")

    def test_a_bug_of_the_analysis_is_3(self):
        self.write("pandas.py", "raise KeyError('odd')")
        os.environ["PYTHONPATH"] = str(self.folder)
        self.addCleanup(os.environ.pop, "PYTHONPATH")
        for words in (("show", "a.h5"), ("compare", "a.h5", "b.h5")):
            result = self.run_program(*words)
            self.assertEqual(result.returncode, 3, result.stderr)
            self.assertIn("KeyError: 'odd'\ntrocar: this is a bug", result.stderr)

    def test_compare_is_a_gate(self):
        after = self.folder / "after.h5"
        self.expect_done("run", self.sweep, "-o", self.out)
        after.write_bytes(self.out.read_bytes())
        gate = ("compare", self.out, after, "--fail-on", "gap_mean_d_mean > +5%", "--fail-on", "outcomes")
        text = self.expect_done(*gate).stdout
        self.assertIn("8 cases in both", text)
        self.assertIn("equal", text)
        with h5py.File(after, "a") as file:
            file["cases/gap_mean_d_mean"][...] *= 1.1
        result = self.run_program(*gate)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("fails on gap_mean_d_mean > +5%: gap_mean_d_mean, label nearest-face: +10 %", result.stderr)
        with h5py.File(after, "a") as file:
            file["cases/gap_mean_d_mean"][...] = np.nan
        self.expect_refused("cannot evaluate gap_mean_d_mean", *gate)
        self.expect_refused("expected outcomes, or a figure", *gate[:3], "--fail-on", "gap_mean_d_mean")
        self.sweep.write_text("no result")
        self.expect_refused("sweep.toml", "compare", self.out, self.sweep)


if __name__ == "__main__":
    run_tests()
