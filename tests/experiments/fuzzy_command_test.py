"""Drives `trocar fuzzy`, and sweeps with a rule base of the user's own.

/usr/bin/python3 fuzzy_command_test.py PROGRAM
"""

import json
import pathlib
import re
import xml.etree.ElementTree

import h5py
import numpy as np

from program_test import ProgramTest, run_tests

STRATEGIES = pathlib.Path(__file__).resolve().parents[2] / "strategies"

SWEEP = """name = "rules"
strategies = [
    "fuzzy-per-vertex",
    { name = "fuzzy-per-vertex", label = "mine", rules = "mine.fll" },
    { name = "fuzzy-per-vertex", label = "last", aggregate = "last", order = "strongest-first", normals = "reference" },
    "nearest-face",
]
organs = ["gallbladder@6mm"]
tools = ["prism-12"]
scenes = ["penetration"]
speeds = [400]
seeds = 1
"""

RULE = "if C_1 is YES and I_C is sliding then I_P is LOW and I_S is HIGH and I_E is LOW"
CHANGED_RULE = RULE.replace("I_S is HIGH", "I_S is MEDIUM")


class Fuzzy(ProgramTest):
    def setUp(self):
        super().setUp()
        self.rules = self.expect_done("fuzzy", "rules").stdout
        self.assertIn(RULE, self.rules)

    def write_sweep(self, rules):
        self.write("mine.fll", rules)
        return self.write("sweep.toml", SWEEP)

    def run_sweep(self, rules):
        out = self.folder / "out.h5"
        out.unlink(missing_ok=True)
        sweep = self.write_sweep(rules)
        self.expect_done("run", sweep, "-o", out, "--replay", "--metrics", "collided_vertices,displacement_mean")
        return sweep, h5py.File(out)

    # The rule base

    def test_rules_prints_the_file_that_ships(self):
        self.assertEqual(self.rules, (STRATEGIES / "rules" / "feedback.fll").read_text())

    def test_a_changed_rule_changes_the_results(self):
        def displacements(rules):
            _, file = self.run_sweep(rules)
            with file:
                cases = file["cases"]
                return dict(zip(cases["label"].asstr()[:], cases["displacement_mean_mean"][:]))

        same, changed = displacements(self.rules), displacements(self.rules.replace(RULE, CHANGED_RULE))
        self.assertEqual(same["mine"], same["fuzzy-per-vertex"])
        self.assertNotEqual(changed["mine"], same["mine"])
        self.assertEqual(changed["fuzzy-per-vertex"], same["fuzzy-per-vertex"])

    def test_a_result_file_holds_the_rules_it_was_made_with(self):
        mine = self.rules.replace(RULE, CHANGED_RULE)
        _, file = self.run_sweep(mine)
        with file:
            labels = list(file["cases/label"].asstr()[:])
            options = json.loads(file["cases/options"].asstr()[labels.index("mine")])
        self.assertEqual(options["rules"], mine)

    def test_a_malformed_copy_is_2_with_file_line_and_reason(self):
        line = 1 + self.rules[: self.rules.index(RULE)].count("\n")
        for to, reason in (("I_C is very sliding", 'the hedge "very"'), ("I_C is slidin", "slidin")):
            sweep = self.write_sweep(self.rules.replace("I_C is sliding then I_P is LOW and", f"{to} then I_P is LOW and"))
            result = self.run_program("run", sweep, "-o", self.folder / "out.h5")
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, rf"mine\.fll:{line}: .*{reason}")
        self.assertFalse((self.folder / "out.h5").exists())

    def test_a_rule_base_that_is_not_there_is_2(self):
        sweep = self.write_sweep(self.rules)
        (self.folder / "mine.fll").unlink()
        self.expect_refused("sweep.toml:4:58: rules is neither feedback nor a file", "run", sweep, "--dry-run")

    def test_bytes_that_are_no_text_are_2(self):
        self.write_sweep("")
        for junk in (b"", b"\0\xff\xfe: \n", b"Engine" * 10000, b":\n:\n", b"rule: if\n", b"Engine: x\nRuleBlock: \n  rule: \n"):
            (self.folder / "mine.fll").write_bytes(junk)
            self.expect_refused("mine.fll:", "run", self.folder / "sweep.toml", "--dry-run")

    # explain

    def test_explain_agrees_with_the_replay(self):
        sweep, file = self.run_sweep(self.rules.replace(RULE, CHANGED_RULE))
        compared = 0
        with file:
            for case_id, strategy in zip(file["cases/case_id"].asstr()[:], file["cases/strategy"].asstr()[:]):
                if strategy != "fuzzy-per-vertex":
                    continue
                replay = file[f"replay/{case_id}"]
                offsets, moved, by = (replay[name][:] for name in ("moved_offsets", "moved", "moved_by"))
                steps = [step for step in range(len(offsets) - 1) if offsets[step] < offsets[step + 1]]
                for step in (steps[0], steps[len(steps) // 2], steps[-1]):
                    chosen = range(offsets[step], offsets[step + 1])
                    for k in (chosen[0], chosen[-1]):
                        said = self.expect_done("fuzzy", "explain", sweep, "--case", case_id[:10],
                                                "--step", step, "--vertex", moved[k]).stdout  # fmt: skip
                        np.testing.assert_allclose(numbers_behind(said, "displacement = "), by[k], atol=1e-6, rtol=0)
                        self.check_arithmetic(said, by[k])
                        compared += 1
        self.assertEqual(compared, 3 * 3 * 2)

    def check_arithmetic(self, said, displacement):
        """What is told hangs together: the facets' vectors make the direction, and the exit distance the length."""
        if "without a direction" in said:
            return
        added = np.array([as_numbers(found) for found in re.findall(r"I_E v_m = \((.*)\)", said)])
        d = added[-1] if "the last facet's vector" in said else added.sum(axis=0)
        direction = np.array(numbers_behind(said, "direction d / |d| = "))
        np.testing.assert_allclose(direction, d / np.linalg.norm(d), atol=2e-5)
        exit_distance = float(re.search(r"exit distance = ([\d.]+) mm", said)[1])
        np.testing.assert_allclose(exit_distance * direction, displacement, atol=1e-4)

    def test_explain_takes_the_deepest_vertex_unless_told(self):
        sweep = self.write_sweep(self.rules)
        said = self.expect_done("fuzzy", "explain", sweep, "--only", "strategy=mine", "--step", 1).stdout
        self.assertRegex(said, r"vertex \d+ of \d+ that collided")

    def test_explain_says_what_there_is_to_choose_from(self):
        sweep = self.write_sweep(self.rules)
        self.expect_refused("choose by --case or --only among", "fuzzy", "explain", sweep, "--step", 0)
        self.expect_refused("begins with zz", "fuzzy", "explain", sweep, "--case", "zz", "--step", 0)
        self.expect_refused("explain knows this strategy only", "fuzzy", "explain", sweep, "--only",
                            "strategy=nearest-face", "--step", 0)  # fmt: skip
        mine = ("fuzzy", "explain", sweep, "--only", "strategy=mine")
        self.expect_refused("--step must be from 0 to", *mine)
        self.expect_refused("--step must be from 0 to", *mine, "--step", 100000)
        self.expect_refused("collided vertices: ", *mine, "--step", 1, "--vertex", 0)
        self.write("sweep.toml", SWEEP.replace("[400]", "[20]"))
        self.expect_refused("no vertex collided in this step", *mine, "--step", 0)

    def test_explain_shows_the_worked_example_as_its_page_has_it(self):
        page = (STRATEGIES / "worked_example.md").read_text()
        command, told = re.search(r"```console\n\$ trocar (.*)\n((?:.|\n)*?)```", page).groups()
        self.assertEqual(self.expect_done(*command.split()).stdout, told)

    def test_explain_takes_the_options_of_the_strategy(self):
        numbers = ("fuzzy", "explain", "--motion", "0,0,-2", "--normal", "0,0,1", "--normal", "0.6,0,0.8")
        self.assertIn("C_1 is NO", self.expect_done(*numbers).stdout)
        self.assertNotIn("C_1 is NO", self.expect_done(*numbers, "--option", "feedback=false").stdout)
        mine = self.write("mine.fll", self.rules.replace(RULE, CHANGED_RULE))
        said = self.expect_done(*numbers[:4], "--normal", "1,0,0", "--option", f"rules={mine}").stdout
        self.assertIn("I_P 0.000000, I_S 0.500000, I_E 0.000000", said)
        self.expect_refused("unknown option", *numbers, "--option", "feedbak=false")
        self.expect_refused("true or false", *numbers, "--option", "feedback=maybe")
        self.expect_refused("key=value", *numbers, "--option", "feedback")

    def test_explain_refuses_what_is_no_direction(self):
        for motion in ("0,0,0", "1,2", "1,2,3,4", "a,b,c", "1,,2", "nan,0,0", "inf,0,0", ""):
            self.assertEqual(self.run_program("fuzzy", "explain", "--motion", motion, "--normal", "0,0,1").returncode, 2)
        self.expect_refused("--normal", "fuzzy", "explain", "--motion", "0,0,1")
        self.expect_refused("explain needs either", "fuzzy", "explain")

    def test_vectors_that_cancel_name_no_direction(self):
        said = self.expect_done("fuzzy", "explain", "--motion", "1,0,0", "--normal", "0,0,1", "--normal", "0,0,-1",
                                "--option", "feedback=false").stdout  # fmt: skip
        self.assertIn("too short to name a direction", said)

    # plot

    def test_plot_draws_the_rules(self):
        folder = self.folder / "plots" / "mine"
        mine = self.write("mine.fll", self.rules.replace("Engine: feedback", "Engine: my_own_rules"))
        self.expect_done("fuzzy", "plot", mine, "-o", folder)
        self.assertEqual(sorted(path.name for path in folder.iterdir()),
                         ["memberships.png", "memberships.svg", "response.png", "response.svg"])  # fmt: skip
        for name in ("memberships", "response"):
            self.assertEqual((folder / f"{name}.png").read_bytes()[:4], b"\x89PNG")
            text = "".join(xml.etree.ElementTree.parse(folder / f"{name}.svg").getroot().itertext())
            self.assertIn("my_own_rules", text)

    def test_plot_refuses(self):
        self.expect_refused("none.fll", "fuzzy", "plot", self.folder / "none.fll", "-o", self.folder / "plots")
        bad = self.write("bad.fll", "Engine: x\nnonsense\n")
        self.expect_refused("bad.fll:2: ", "fuzzy", "plot", bad, "-o", self.folder / "plots")
        self.expect_refused("cannot be made", "fuzzy", "plot", "-o", bad / "below")
        self.assertFalse((self.folder / "plots").exists())


def as_numbers(text):
    return [float(number) for number in text.split(",")]


def numbers_behind(said, words):
    return as_numbers(re.search(re.escape(words) + r"\(([^)]*)\)", said)[1])


if __name__ == "__main__":
    run_tests()
