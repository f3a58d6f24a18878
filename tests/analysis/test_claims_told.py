"""What is told of claims, as text, Markdown and JSON, and of mistakes in their file; turns; Holm's correction."""

import json
import math
import re
import unittest

from made_up_claims import BETTER, ClaimsTest, claim, runs, worked
from result_file import ProgramTest
from trocar_analysis.claims.claim_file import read_claims
from trocar_analysis.errors import InputError

LIMIT = 'figure = "depth_max_d_max"\nis = "<"\nlimit = 2'
LESS = 'figure = "depth_max_d_max"\nof = { label = "a" }\nis = "<"\nthan = { label = "b" }'


class Told(ClaimsTest):
    def test_turns_have_a_table_of_their_own(self):
        turns = self.folder / "turns.csv"
        rows = [(label, seed, turn) for seed in range(12) for label, turn in (("a", 50 + seed), ("b", 5))]
        turns.write_text("label,seed,largest_turn\n" + "".join(f"{a},{seed},{turn}\n" for a, seed, turn in rows))
        condition = 'figure = "largest_turn"\nwhere = {{ label = "{}" }}\nis = "{}"\nlimit = {}'
        text = claim(condition.format("a", ">=", 40), condition.format("b", "<=", 10), data="turns")
        found = self.judged(text, runs("a", 1.0), turns=str(turns))["C1"]
        self.assertEqual((found["verdict"], [one["n"] for one in found["conditions"]]), ("reproduced", [12, 12]))
        text = claim(condition.format("b", ">=", 40), condition.format("a", "<=", 10), data="turns")
        self.assertEqual(self.verdict(text, runs("a", 1.0), turns=str(turns)), "not reproduced")
        # They have no organs, so that there is nothing to confirm them on, and need no result file.
        koala = runs("a", 1.0, ("koala s100",))
        self.assertEqual(self.verdict(text, koala, turns=str(turns), organs="confirmation"), "not run")
        self.file.unlink()
        said = self.told(turns=str(turns))
        self.assertIn("largest_turn (b) ≥ 40 degree", said)
        self.assertNotIn("confirmation", said)
        with self.assertRaisesRegex(InputError, "none.csv"):
            self.told(turns=str(self.folder / "none.csv"))

    def test_p_is_corrected_within_a_claim(self):
        # All twelve differences of one sign: 2 of 2^12 ways to set signs are as extreme.
        b = runs("b", lambda organ, seed: worked(2)(organ, seed) + seed / 7 + len(organ) / 97)
        cases = runs("a", worked(1)) + b
        alone, twice = claim(LESS), claim(LESS, LESS, LIMIT, name="C2")
        found = self.judged(alone + twice, cases)
        self.assertAlmostEqual(found["C1"]["conditions"][0]["p"], 2 / 2**12, 12)
        self.assertEqual([one["p"] for one in found["C2"]["conditions"]], [4 / 2**12, 4 / 2**12, None])

    def test_json_says_of_what_each_number_is(self):
        condition = LESS + '\ntimes = 2\neach = { scene = ["in"], speed = [20] }'
        cases = [case for label, value in (("a", 3.0), ("b", 2.0)) for case in runs(label, value, scene="in", speed=20.0)]
        (found,) = self.conditions(claim(condition), cases)
        self.assertEqual((found["figure"], found["is"], found["times"], found["each"]),
                         (["depth_max_d_max"], "<", 2, {"scene": "in", "speed": 20}))  # fmt: skip
        self.assertEqual((found["of"]["label"], found["than"]["label"]), (["a"], ["b"]))
        self.assertEqual((found["median_of"], found["median_than"], found["median"]), (3, 2, -1))

    def test_json_is_valid_where_a_number_is_infinite_or_none(self):
        cases = runs("a", math.nan)
        for case in cases:
            case["status"] = "crashed"
        self.write(claim(LIMIT, 'figure = "nothing_max"'), cases + runs("b", math.nan, nothing_max=math.nan))
        text = self.told("json")
        self.assertNotRegex(text, r"\b(NaN|Infinity)\b")
        self.assertEqual(json.loads(text)[0]["verdicts"]["contact"]["conditions"][0]["median_of"], "inf")

    def test_text_says_what_is_compared_under_what(self):
        text = 'where = { speed = 400, scene = "in" }\n'
        sides = [runs(label, value, scene="in", speed=400.0) for label, value in (("a", 1.5), ("b", 2.0))]
        self.write(claim(LESS + "\ntimes = 3", more=text) + claim(LIMIT, name="C2"), sides[0] + sides[1])
        said = self.told()
        self.assertIn("depth_max_d_max (a) < 3 × (b), 400 mm/s", said)
        self.assertRegex(said, r"C1 +Fig. 1 +reproduced +not run +something")
        self.assertRegex(said, r"contact +mm +1.5 +2 +−4.5 \[−4.5, −4.5\] +12 +12 +12 +yes +0.000532 +−1\n")

    def test_markdown_is_a_table_whatever_texts_hold(self):
        text = claim(LESS.replace('"a"', '"a|1"'), LIMIT).replace('"something"', '"""one|two\nthree"""')
        self.write(text, runs("a|1", 1.0) + runs("b", 3.0))
        said = self.told("markdown")
        tables = re.split(r"\n\s*\n", said)
        tables = [lines for lines in (table.splitlines() for table in tables) if lines[0].startswith("|")]
        self.assertEqual(len(tables), 2)
        for lines in tables:
            columns = {len(re.findall(r"(?<!\\)\|", line)) for line in lines}
            self.assertEqual(len(columns), 1, lines)
            self.assertRegex(lines[1], r"^\|( -+:? \|)+$")
        self.assertIn("one\\|two three", said)
        self.assertIn("(a\\|1)", said)
        self.assertNotIn("\n|", said.split("\n- ")[-1])


class Mistakes(ClaimsTest):
    def assert_refused(self, text, *words):
        self.claims.write_text(text)
        with self.assertRaises(InputError) as refused:
            read_claims(str(self.claims))
        for word in (str(self.claims), *words):
            self.assertIn(word, str(refused.exception))
        self.assertNotIn("\n", str(refused.exception))

    def test_of_a_condition(self):
        for condition, *words in (
            (LIMIT + '\nthan = { label = "b" }', "C1", "either limit or than"),
            ('figure = "x"\nis = "<"', "C1", "either limit or than"),
            (LIMIT.replace('"<"', '"=="'), "C1", "==", "< > <= >="),
            ("limt = 2\n" + LIMIT, "C1", "limt", "did you mean 'limit'"),
            (LIMIT + '\ndata = "run"', "C1", '"run"', "runs or answers or turns"),
            ('is = "<"\nlimit = 2', "C1", "no figure"),
            ('figure = "x"\nlimit = 2', "C1", "limit", "no `is`"),
            (LIMIT + "\ntimes = 2", "C1", "times", "no than"),
            (LIMIT.replace("2", '"2"'), "C1", "limit is '2'", "a number"),
            (LIMIT + '\nwhere = "a"', "C1", "where is 'a'", "a table"),
            (LIMIT + "\neach = { speed = 20 }", "C1", "each.speed is 20", "a list"),
            (LIMIT + "\neach = { speed = [] }", "C1", "each.speed", "a list"),
            (LIMIT.replace("depth_max_d_max", "depth"), "C1", "depth", "no figure of a case"),
        ):
            self.assert_refused(claim(condition), *words)

    def test_of_a_claim(self):
        self.assert_refused(claim(LIMIT) + claim(LIMIT, name="C2") + claim(LIMIT), "C1 twice")
        self.assert_refused(claim(LIMIT, more='plase = "x"\n'), "plase", "did you mean 'place'")
        self.assert_refused(claim(), "C1", "neither conditions nor")
        self.assert_refused(claim(LIMIT).replace('id = "C1"', ""), "without id")
        self.assert_refused(claim(LIMIT).replace('says = "something"', "says = 3"), "C1", "says")
        self.assert_refused(claim(LIMIT, more='sweeps = ["none.toml"]\n'), "none.toml", "No such file")

    def test_a_figure_that_its_sweep_is_not_measured_by(self):
        (self.folder / "one.toml").write_text('organs = ["sphere@4mm"]\n')
        text = claim(LIMIT, more='sweeps = ["one.toml"]\n')
        self.assert_refused('[sweep."one.toml"]\nmetrics = ["drag"]\n' + text, "C1: depth_max_d_max is of no metric", "one.toml")
        self.claims.write_text('[sweep."one.toml"]\nmetrics = ["depth_max"]\n' + text)
        read_claims(str(self.claims))

    def test_of_the_file(self):
        self.assert_refused("", "no [[claim]]")
        self.assert_refused("claim = 3", "no [[claim]]")
        self.assert_refused("claim = [3]", "expected a table")
        self.assert_refused("[[claim]\n", "no TOML file", "line 1")
        with self.assertRaisesRegex(InputError, "none.toml: No such file"):
            read_claims(str(self.folder / "none.toml"))

    def test_what_the_results_do_not_hold_is_named(self):
        for condition, word in ((LIMIT.replace("depth", "width"), "width_max_d_max"),
                                (LIMIT + '\nwhere = { colour = "red" }', "colour")):  # fmt: skip
            self.write(claim(condition), runs("a", 1.0))
            with self.assertRaisesRegex(InputError, word):
                self.told()

    def test_a_side_of_several_cases_has_no_pairs(self):
        self.write(claim(LESS.replace('"a"', '["a", "c"]')), [case for label in "abc" for case in runs(label, 1.0)])
        with self.assertRaisesRegex(InputError, "depth_max_d_max: several cases of one side agree"):
            self.told()


class CommandLine(ProgramTest):
    def test_the_command(self):
        made = ClaimsTest()
        made.folder, made.file, made.claims = self.folder, self.file, self.folder / "claims.toml"
        made.write(claim(LIMIT) + claim(LIMIT.replace("2", "1"), name="C2"), runs("a", 1.0))
        better = "--better=" + ",".join(f"{name}={end}" for name, end in BETTER.items())
        words = {one["id"]: one["verdicts"]["contact"]["verdict"]
                 for one in json.loads(self.output_of("claims", made.claims, self.file, better, "--json"))}  # fmt: skip
        self.assertEqual(words, {"C1": "reproduced", "C2": "not reproduced"})
        only = self.output_of("claims", made.claims, self.file, "--only", "C2", "--markdown")
        self.assertIn("## C2", only)
        self.assertNotIn("C1", only)
        self.assert_refused("claims", made.claims, self.file, "--only", "C22", saying=["no claim 'C22'", "'C2'"])
        self.assert_refused("claims", self.folder / "no.toml", self.file, saying=["no.toml", "No such file"])
        self.assert_refused("claims", made.claims, self.folder / "no.h5", saying=["no.h5", "no such file"])


if __name__ == "__main__":
    unittest.main()
