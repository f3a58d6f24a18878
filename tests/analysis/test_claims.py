"""Verdicts on claims: results of which it is known, because they were made that way, what holds."""

import math
import unittest

from made_up_claims import ORGANS, RELEASES, SEEDS, ClaimsTest, answers, claim, runs, worked

LESS = 'figure = "depth_max_d_max"\nof = { label = "a" }\nis = "<"\nthan = { label = "b" }'
MORE = LESS.replace('"<"', '">"')


def limit(relation, value, label="a", more=""):
    where = f'where = {{ label = "{label}" }}\n'
    return f'figure = "depth_max_d_max"\nis = "{relation}"\nlimit = {value}\n{where}{more}'


class Limits(ClaimsTest):
    def test_each_relation_below_at_and_above_the_limit(self):
        for value in (1.0, 2.0, 3.0):
            for relation, holds in (("<", value < 2), ("<=", value <= 2), (">", value > 2), (">=", value >= 2)):
                found = self.conditions(claim(limit(relation, 2)), runs("a", value))
                self.assertEqual((found[0]["holds"], found[0]["n"]), (holds, 12), (value, relation))
                self.assertEqual([found[0][name] for name in ("low", "median", "high")], [value - 2] * 3)
                self.assertEqual((found[0]["median_of"], found[0]["p"]), (value, None))

    def test_all_of_the_interval_has_to_be_on_the_side(self):
        # 7 of 12 below: so is the median, but as it happens.
        few = runs("a", lambda organ, seed: 1.0 if (ORGANS.index(organ) * 4 + seed) % 12 < 7 else 3.0)
        (found,) = self.conditions(claim(limit("<", 2)), few)
        self.assertEqual((found["median"], found["high"], found["holds"], found["singly"]), (-1, 1, False, 7))

    def test_it_is_the_median_and_not_the_mean(self):
        cases = runs("a", lambda organ, seed: 1e6 if (organ, seed) == ("tube@4mm", 4) else 1.0)
        self.assertEqual(self.verdict(claim(limit("<", 2)), cases), "reproduced")

    def test_a_figure_divided_case_by_case(self):
        cases = runs("a", 6.0)
        for k, case in enumerate(cases):
            case["depth_max_d_max"], case["weight_max"] = 3.0 * (1 + k), 1.0 + k
        condition = 'per = "weight_max"\n'
        (found,) = self.conditions(claim(limit("<=", 3, more=condition)), cases)
        self.assertEqual((found["median_of"], found["low"], found["high"], found["holds"]), (3, 0, 0, True))
        for case in cases[:2]:
            case["weight_max"] = 0.0  # nothing to divide by: no value
        cases += runs("a", 3, seeds=(9,), weight_max=1.0)
        (found,) = self.conditions(claim(limit("<=", 3, more=condition)), cases)
        self.assertEqual((found["n"], found["lacking"], found["holds"]), (13, 2, True))

    def test_a_list_of_figures_is_their_sum(self):
        cases = runs("a", 2.0, flipped_facets_mean=3.0)
        condition = 'figure = ["depth_max_d_max", "flipped_facets_mean"]\nis = "{}"\nlimit = 5'
        self.assertEqual(self.verdict(claim(condition.format(">=")), cases), "reproduced")
        self.assertEqual(self.verdict(claim(condition.format("<")), cases), "not reproduced")


class Pairs(ClaimsTest):
    def test_pairs_differ_by_far_less_than_places_do(self):
        cases = runs("a", worked(1)) + runs("b", worked(2))
        (found,) = self.conditions(claim(LESS), cases)
        self.assertEqual((found["n"], found["low"], found["median"], found["high"]), (12, -1, -1, -1))
        self.assertTrue(found["holds"])
        self.assertFalse(self.conditions(claim(MORE), cases)[0]["holds"])

    def test_a_pair_agrees_in_all_that_it_was_run_with(self):
        for column, values in {"tool": ("x", "y"), "scene": ("in", "out"), "speed": (20.0, 400.0), "rate": (30.0, 60.0),
                               "fractions": (1, 2)}.items():  # fmt: skip
            cases = []
            for k, value in enumerate(values):
                cases += runs("a", worked(1 + 500 * k), **{column: value})
                cases += runs("b", worked(2 + 500 * k), **{column: value})
            (found,) = self.conditions(claim(LESS), cases)
            self.assertEqual((found["n"], found["low"], found["high"]), (24, -1, -1), column)

    def test_times_as_much(self):
        cases = runs("a", lambda organ, seed: 2.5 * worked(0)(organ, seed)) + runs("b", worked(0))
        for times, word in ((2, "reproduced"), (3, "not reproduced")):
            self.assertEqual(self.verdict(claim(MORE + f"\ntimes = {times}"), cases), word)

    def test_what_tells_the_sides_apart_may_be_any_column(self):
        slow, rapid = runs("a", worked(1), speed=20.0), runs("a", worked(9), speed=400.0)
        by_speed = MORE.replace('label = "a"', "speed = 400").replace('label = "b"', "speed = 20")
        self.assertEqual(self.verdict(claim(by_speed), slow + rapid), "reproduced")
        # The same place on two organs. A seed is then drawn with both.
        seeds = tuple(range(1, 13))
        organs = runs("a", lambda _, seed: seed**3, ("sheet@4mm",), seeds)
        organs += runs("a", lambda _, seed: seed**3 + 1, ("rough@4mm",), seeds)
        by_organ = MORE.replace('label = "a"', 'organ = "rough@4mm"').replace('label = "b"', 'organ = "sheet@4mm"')
        (found,) = self.conditions(claim(by_organ), organs)
        self.assertEqual((found["n"], found["low"], found["high"], found["holds"]), (12, 1, 1, True))

    def test_a_case_without_its_other_is_in_no_pair(self):
        cases = runs("a", worked(1)) + runs("b", worked(2), seeds=(1, 2, 3, 4, 5))
        self.assertEqual(self.conditions(claim(LESS), cases)[0]["n"], 12)


class Words(ClaimsTest):
    def test_reproduced_partly_not(self):
        cases = runs("a", 1.0, speed=20.0) + runs("a", 3.0, speed=400.0)
        each = "each = { speed = [20, 400] }"
        for value, word in ((5, "reproduced"), (2, "partly"), (0.5, "not reproduced")):
            self.assertEqual(self.verdict(claim(limit("<", value, more=each)), cases), word)
        found = self.conditions(claim(limit("<", 2, more=each)), cases)
        self.assertEqual([(one["each"], one["n"], one["holds"]) for one in found],
                         [({"speed": 20}, 12, True), ({"speed": 400}, 12, False)])  # fmt: skip
        self.assertIn("partly (1 of 2)", self.told())

    def test_each_pair_of_values_of_two_columns(self):
        cases = [case for speed in (20.0, 400.0) for label in "ab" for case in runs(label, speed, speed=speed)]
        condition = limit("<", 100, more='each = { label = ["a", "b"], speed = [20, 400] }')
        found = self.conditions(claim(condition), cases)
        self.assertEqual([(one["each"]["label"], one["each"]["speed"], one["holds"]) for one in found],
                         [("a", 20, True), ("a", 400, False), ("b", 20, True), ("b", 400, False)])  # fmt: skip

    def test_each_release_has_its_own_verdict(self):
        cases = runs("a", 1.0) + runs("a", 3.0, releases=("step",))
        found = [self.verdict(claim(limit("<", 2)), cases, release=release) for release in RELEASES]
        self.assertEqual(found, ["reproduced", "not reproduced"])

    def test_not_run_described_and_not_yet(self):
        cases = runs("a", 1.0)
        self.assertEqual(self.verdict(claim(limit("<", 2)), cases, release="step"), "not run")
        self.assertEqual(self.verdict(claim(limit("<", 2), limit("<", 2, "b")), cases), "not run")
        self.assertEqual(self.verdict(claim(limit("<", 2).replace("_d_max", ""), data="answers"), cases), "not run")
        self.assertEqual(self.verdict(claim(limit("<", 2), data="turns"), cases), "not run")
        described = claim('figure = "depth_max_d_max"')
        self.assertEqual(self.verdict(described, cases), "described")
        self.assertEqual([self.conditions(described, cases)[0][name] for name in ("median", "holds")], [1, None])
        pending = claim(more='pending = "it does not exist"\n')
        self.assertEqual(self.verdict(pending, cases), "not yet")
        self.assertIn("it does not exist", self.told())

    def test_too_few_seeds_are_no_verdict(self):
        cases = runs("a", 1.0)
        eleven = [case for case in cases if (case["organ"], case["seed"]) != ("tube@4mm", 4)]
        self.assertEqual(self.verdict(claim(limit("<", 2)), eleven), "too few seeds")
        self.assertEqual(self.verdict(claim(limit(">", 2)), eleven), "too few seeds")
        (found,) = self.conditions(claim(limit("<", 2)), eleven)
        self.assertEqual((found["holds"], found["low"], found["median"], found["singly"]), (None, None, -1, 11))
        # Twelve organs of one seed each, and one seed under many conditions, are too few as well.
        alone = runs("a", 1.0, tuple(f"organ{k}@4mm" for k in range(12)), (1,))
        many = [case for speed in range(1, 13) for case in runs("a", 1.0, seeds=(1,), speed=float(speed))]
        for few in (alone, many):
            self.assertEqual(self.verdict(claim(limit("<", 2)), few), "too few seeds")

    def test_confirmation_organs_have_no_part_in_the_verdict(self):
        cases = runs("a", 1.0) + runs("a", 9.0, ("koala s100", "heart s100", "cow s100"), seeds=tuple(range(1, 21)))
        self.assertEqual(self.verdict(claim(limit("<", 2)), cases), "reproduced")
        self.assertEqual(self.conditions(claim(limit("<", 2)), cases)[0]["n"], 12)
        self.assertEqual(self.verdict(claim(limit("<", 2)), cases, organs="confirmation"), "not reproduced")
        self.assertEqual(self.conditions(claim(limit("<", 2)), cases, organs="confirmation")[0]["n"], 60)
        self.assertIn("confirmation", self.told())

    def test_cases_of_other_claims_sweeps_have_no_part(self):
        (self.folder / "one.toml").write_text('organs = ["sphere", "liver@4.0mm", "tube@4mm"]\nspeeds = [20]\n')
        (self.folder / "two.toml").write_text('organs = ["cleft@3mm"]\nspeeds = [400]\nscenes = ["penetration"]\n')
        cases = runs("a", 1.0, speed=20.0) + runs("a", 9.0, ("sheet@4mm", "cleft@3mm"), tuple(range(20)), speed=20.0)
        cases += runs("a", 9.0, seeds=tuple(range(20)), speed=400.0)
        both, own = 'sweeps = ["one.toml", "two.toml"]\n', 'sweeps = ["one.toml"]\n'
        notes = "".join(f'[sweep."{name}.toml"]\nmetrics = ["depth_max"]\n' for name in ("one", "two"))
        for sweeps, n in ((both, 12), (own, 12), ("", 12 + 40 + 60)):
            self.assertEqual(self.conditions(notes + claim(limit("<", 2), more=sweeps), cases)[0]["n"], n, sweeps)
        more = runs("a", 1.0, ("cleft@3mm",), SEEDS, speed=400.0) + runs("a", 5.0, ("koala s100",), (1, 2), speed=20.0)
        self.assertEqual(self.conditions(notes + claim(limit("<", 2), more=both), cases + more)[0]["n"], 16)
        found = self.conditions(notes + claim(limit("<", 2), more=both), cases + more, organs="confirmation")
        self.assertEqual(found[0]["n"], 2)


class FailedAndMissing(ClaimsTest):
    def failing(self, cases, count, status="diverged"):
        """The first `count` failed; what they still say of themselves is of no account."""
        for case in cases[:count]:
            case["status"] = status
        return cases

    def test_a_failed_case_is_the_worst_there_is(self):
        below, above = claim(limit("<", 2)), claim(limit(">", 2))
        for count, holds, other in ((0, True, False), (12, False, True)):
            cases = self.failing(runs("a", 1.0), count)
            self.assertEqual(self.conditions(below, cases)[0]["holds"], holds)
            self.assertEqual(self.conditions(above, cases)[0]["holds"], other)
        (found,) = self.conditions(below, self.failing(runs("a", 1.0), 7))
        self.assertEqual((found["n"], found["failed"], found["median"], found["holds"]), (12, 7, "inf", False))
        (found,) = self.conditions(below, self.failing(runs("a", math.nan), 12))
        self.assertEqual((found["n"], found["lacking"], found["median"]), (12, 0, "inf"))

    def test_where_high_is_better_the_worst_is_low(self):
        condition = limit(">", 2).replace("depth_max_d_max", "edge_ratio_mean_h_mean")
        cases = self.failing(runs("a", 9.0, figure="edge_ratio_mean_h_mean"), 12)
        (found,) = self.conditions(claim(condition), cases)
        self.assertEqual((found["median"], found["holds"]), ("-inf", False))

    def test_a_figure_without_a_better_end_counts_against_the_condition(self):
        for relation in ("<", ">"):
            condition = limit(relation, 2).replace("depth", "width")
            cases = self.failing(runs("a", 1.0 if relation == "<" else 3.0, figure="width_max_d_max"), 12)
            self.assertEqual(self.verdict(claim(condition), cases), "not reproduced")
            than = (LESS if relation == "<" else MORE).replace("depth", "width")
            for failing in "ab":  # on either side of the comparison
                sides = {}
                for label, value in zip("ab", (0, 5) if relation == "<" else (5, 0)):
                    sides[label] = runs(label, worked(value), figure="width_max_d_max")
                cases = sides["a"] + sides["b"]
                self.assertEqual(self.verdict(claim(than), cases), "reproduced")
                self.failing(sides[failing], 12)
                self.assertEqual(self.verdict(claim(than), cases), "not reproduced", (relation, failing))

    def test_pairs_with_a_failed_case(self):
        a, b = runs("a", worked(1)), runs("b", worked(2))
        only_b = self.conditions(claim(LESS), a + self.failing(b, 12))[0]
        self.assertEqual((only_b["median"], only_b["holds"], only_b["failed"]), ("-inf", True, 12))
        both = self.conditions(claim(LESS), self.failing(a, 12) + b)[0]
        self.assertEqual([both[end] for end in ("low", "median", "high")], [0, 0, 0])
        self.assertEqual((both["holds"], both["failed"]), (False, 12))
        only_a = self.conditions(claim(LESS), self.failing(runs("a", worked(1)), 7) + runs("b", worked(2)))[0]
        self.assertEqual((only_a["median"], only_a["holds"], only_a["failed"]), ("inf", False, 7))

    def test_values_that_do_not_exist_are_left_out_and_counted(self):
        cases = runs("a", lambda organ, seed: math.nan if seed == 5 else 1.0, seeds=(1, 2, 3, 4, 5))
        (found,) = self.conditions(claim(limit("<", 2)), cases)
        self.assertEqual((found["n"], found["lacking"], found["failed"], found["holds"]), (12, 3, 0, True))
        pairs = runs("a", worked(1), seeds=(1, 2, 3, 4, 5)) + runs(
            "b", lambda organ, seed: math.nan if seed == 5 else worked(2)(organ, seed), seeds=(1, 2, 3, 4, 5)
        )
        (found,) = self.conditions(claim(LESS), pairs)
        self.assertEqual((found["n"], found["lacking"], found["holds"]), (12, 3, True))
        self.assertIn("12 [3 no value]", self.told())
        self.assertEqual(self.verdict(claim(limit("<", 2)), runs("a", math.nan)), "no value")
        self.assertEqual(self.verdict(claim(limit(">", 2)), runs("a", math.nan)), "no value")


class Answers(ClaimsTest):
    MORE = 'figure = "displacement_mean"\nof = { label = "a" }\nis = ">"\nthan = { label = "b" }'

    def test_the_same_states_make_the_pair_whoever_ran(self):
        ran = runs("x", 0.0) + runs("y", 0.0)
        states = []
        for k, case in enumerate(ran):  # states differ from run to run by far more than answers do
            states += answers([case], "a", {"displacement_mean": 100.0 * k + 2}, {"displacement_mean": 50.0 * k + 4})
            states += answers([case], "b", {"displacement_mean": 100.0 * k + 1}, {"displacement_mean": 50.0 * k + 3})
        (found,) = self.conditions(claim(self.MORE, data="answers"), ran, states)
        self.assertEqual((found["n"], found["low"], found["median"], found["high"]), (24, 1, 1, 1))
        self.assertTrue(found["holds"])
        less = claim(self.MORE.replace('">"', '"<"'), data="answers")
        self.assertEqual(self.verdict(less, ran, states), "not reproduced")

    def test_a_run_makes_one_value_the_mean_over_its_states_and_of_a_quotient_that_of_the_sums(self):
        ran = runs("x", 0.0)
        states = answers(ran, "a", {"drag": 1.0, "vertices": 1.0}, {"drag": 9.0, "vertices": 3.0})
        condition = 'figure = "drag"\nwhere = { label = "a" }\nis = ">="\nlimit = 0\n'
        (found,) = self.conditions(claim(condition, data="answers"), ran, states)
        self.assertEqual((found["n"], found["median_of"]), (12, 5.0))
        (found,) = self.conditions(claim(condition + 'per = "vertices"', data="answers"), ran, states)
        self.assertEqual(found["median_of"], 2.5)

    def test_the_run_is_chosen_by_its_conditions_and_the_answer_by_its_label(self):
        ran = runs("x", 0.0, speed=20.0) + runs("x", 0.0, speed=400.0)
        states = answers(ran[:12], "a", {"drag": 1.0}) + answers(ran[12:], "a", {"drag": 5.0})
        states += answers(ran, "b", {"drag": 9.0})
        condition = 'figure = "drag"\nwhere = { label = "a" }\nis = "<"\nlimit = 3\neach = { speed = [20, 400] }'
        found = self.conditions(claim(condition, data="answers"), ran, states)
        self.assertEqual([(one["n"], one["median_of"], one["holds"]) for one in found], [(12, 1, True), (12, 5, False)])

    def test_states_without_a_value_are_left_out_and_an_answer_that_failed_is_the_worst(self):
        ran = runs("x", 0.0)
        states = answers(ran, "a", {"drag": 1.0}, {"drag": math.nan}) + answers(ran, "b", {"drag": 2.0}, {"drag": 2.0})
        condition = 'figure = "drag"\nof = { label = "a" }\nis = "<"\nthan = { label = "b" }'
        (found,) = self.conditions(claim(condition, data="answers"), ran, states)
        self.assertEqual((found["n"], found["lacking"], found["median"], found["holds"]), (12, 0, -1, True))
        nothing = [row | {"drag": math.nan} if row["label"] == "a" else row for row in states]
        self.assertEqual(self.verdict(claim(condition, data="answers"), ran, nothing), "no value")
        failed = [row | {"reason": "no direction"} if row["label"] == "a" and row["step"] else row for row in states]
        (found,) = self.conditions(claim(condition, data="answers"), ran, failed)
        self.assertEqual((found["failed"], found["median"], found["holds"]), (12, "inf", False))


if __name__ == "__main__":
    unittest.main()
