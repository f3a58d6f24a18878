"""`rank` on made-up files: ranks, medians and what is left out are worked out here, from the cases alone."""

import csv
import io
import math
import statistics
import unittest
import xml.etree.ElementTree

import numpy as np
from made_up_strategies import BETTER, DEPTH, LABELS, RATIO, TIME, StrategiesTest, chosen, made_up
from result_file import write_results
from trocar_analysis.critical_difference import compose
from trocar_analysis.errors import InputError
from trocar_analysis.rank import Wishes, csv_text, draw_ranking, markdown_text, notes, plain_text, read_ranking
from trocar_analysis.ranks import critical_difference, friedman


def ranks_by_hand(values):
    """Of a dict by strategy: 1 for the least; the strategies that share a value share the mean of their places."""
    ordered = sorted(values.values())
    places = {value: [k + 1 for k, other in enumerate(ordered) if other == value] for value in ordered}
    return {name: statistics.mean(places[value]) for name, value in values.items()}


class Rank(StrategiesTest):
    def read(self, metric=DEPTH, provenance=None, **asked):
        write_results(self.file, self.cases, provenance=provenance)
        return read_ranking(str(self.file), Wishes(metric, **({"better": BETTER} | asked)))

    def refuse(self, words, **asked):
        with self.assertRaises(InputError) as raised:
            self.read(**asked)
        self.assertIn(words, str(raised.exception))
        self.assertNotIn("\n", str(raised.exception))

    def mean_ranks(self, metric=DEPTH, sign=1, cases=None):
        """By strategy, case by case: ranks under a condition, their means on a seed of an organ, the ranks of these."""
        cases = cases or self.cases
        of_blocks = {label: [] for label in LABELS}
        for organ, seed in sorted({(case["organ"], case["seed"]) for case in cases}):
            here = chosen(cases, organ=organ, seed=seed)
            means = {label: 0.0 for label in LABELS}
            for speed in {case["speed"] for case in here}:
                of_condition = ranks_by_hand(
                    {case["label"]: math.inf if case["status"] != "complete" else sign * case[metric]
                     for case in chosen([{"status": "complete"} | case for case in here], speed=speed)}
                )  # fmt: skip
                means = {label: means[label] + of_condition[label] for label in LABELS}
            for label, rank in ranks_by_hand(means).items():
                of_blocks[label].append(rank)
        return {label: statistics.mean(ranks) for label, ranks in of_blocks.items()}

    def assert_mean_ranks(self, ranking, expected):
        found = dict(zip(ranking.table["label"], ranking.table["mean_rank"]))
        self.assertEqual(found.keys(), expected.keys())
        for label, mean in expected.items():
            self.assertAlmostEqual(found[label], mean, 12)

    # What is ranked

    def test_ranks_within_conditions_then_within_seeds_of_organs(self):
        ranking = self.read()
        self.assertEqual(len(ranking.ranks.blocks), 12)
        self.assert_mean_ranks(ranking, self.mean_ranks())
        self.assertEqual(ranking.table["mean_rank"].tolist(), sorted(ranking.table["mean_rank"]))
        self.assertIn("A block is a seed on an organ (2 organs, 6 seeds), of 2 conditions (2 speeds): strategies are ranked "
                      "by the mean of their ranks under these.", notes(ranking))  # fmt: skip

    def test_where_high_is_better(self):
        self.assert_mean_ranks(self.read(RATIO), self.mean_ranks(RATIO, -1))

    def test_a_filter_leaves_one_condition(self):
        ranking = self.read(only=["speed=20"])
        self.assert_mean_ranks(ranking, self.mean_ranks(cases=chosen(self.cases, speed=20.0)))
        self.assertIn("A block is a seed on an organ (2 organs, 6 seeds), of one condition.", notes(ranking))

    def test_strategies_may_be_chosen_by_their_options(self):
        for case in self.cases:
            case["options"] = '{"order": "ring"}' if case["label"] != "fuzzy" else '{"order": "none"}'
        self.assertEqual(sorted(self.read(only=["order=ring"]).table["label"]), sorted(LABELS[1:]))

    def test_medians_and_intervals_are_those_of_the_cases(self):
        for _, row in self.read().table.iterrows():
            cases = chosen(self.cases, label=row["label"])
            values, organs, seeds = (np.array([case[name] for case in cases]) for name in (DEPTH, "organ", "seed"))
            self.assertEqual(row["cases"], 24)
            self.assertAlmostEqual(row["median"], statistics.median(values))
            self.assertEqual((row["low"], row["high"]), self.interval(values, organs, seeds))

    def test_a_failed_case_is_the_worst_and_is_counted(self):
        for case in chosen(self.cases, label="fuzzy")[:5]:
            case |= {"status": "crashed", DEPTH: 0.0, RATIO: 9.0}
        for metric, sign in ((DEPTH, 1), (RATIO, -1)):
            ranking = self.read(metric)
            self.assert_mean_ranks(ranking, self.mean_ranks(metric, sign))
            failed = dict(zip(ranking.table["label"], ranking.table["failed"]))
            self.assertEqual(failed, dict.fromkeys(LABELS, 0) | {"fuzzy": 5})
            self.assertEqual(ranking.ranks.failed.sum(), 5)

    def test_conditions_that_a_strategy_lacks_are_left_out_of_ranks_and_medians(self):
        def is_lost(case):
            return case["organ"] == "o0" and (case["seed"], case["speed"]) in {(0, 20.0), (1, 20.0), (1, 400.0)}

        common = [case for case in self.cases if not is_lost(case)]
        lost = [case for case in self.cases if is_lost(case)]
        self.cases = common + [case for case in lost if case["label"] != "fuzzy" or case["seed"] == 1]
        for case in chosen(self.cases, label="joint-vertex", organ="o0", seed=1):
            case |= {DEPTH: math.nan, "missing": '{"depth_max_d": "no organ"}'}
        chosen(lost, label="cylinder-axis", seed=1)[0]["status"] = "failed"
        ranking = self.read()
        self.assert_mean_ranks(ranking, self.mean_ranks(cases=common))
        self.assertEqual((len(ranking.ranks.blocks), ranking.ranks.left_out), (11, 1))
        (fuzzy,) = [row for _, row in ranking.table.iterrows() if row["label"] == "cylinder-axis"]
        values = [case[DEPTH] for case in chosen(common, label="cylinder-axis")]
        self.assertEqual((fuzzy["cases"], fuzzy["failed"]), (21, 0))
        self.assertAlmostEqual(fuzzy["median"], statistics.median(values))
        said = notes(ranking)
        self.assertIn("3 of 24 conditions are left out: not run with fuzzy (1); no value with joint-vertex (2). Failed "
                      "among them: 1.", said)  # fmt: skip
        self.assertIn(f"{DEPTH}: no value in 2 of 94 complete cases (no organ).", said)
        self.assertIn("over 11 blocks; 1 left out, where one has no value.", said[0])
        self.assertIn("of 1 to 2 conditions", " ".join(said))

    def test_a_condition_without_any_value_is_not_told_strategy_by_strategy(self):
        for case in chosen(self.cases, speed=20.0, organ="o0"):
            case[DEPTH] = math.nan
        self.assertIn("6 of 24 conditions are left out: no value with any strategy (6).", notes(self.read()))

    def test_what_differs_by_rounding_is_a_tie(self):
        for one, other in zip(chosen(self.cases, label="fuzzy"), chosen(self.cases, label="nearest-face")):
            one[DEPTH] = other[DEPTH] * (1 + 1e-15)
        means = dict(zip(self.read().table["label"], self.read().table["mean_rank"]))
        self.assertEqual(means["fuzzy"], means["nearest-face"])

    def test_quotients_and_metrics_of_one_column(self):
        name = f"tool_volume_inside_d_max/{RATIO}"
        for case in self.cases:
            case["q"] = case["tool_volume_inside_d_max"] / case[RATIO]
        expected = self.mean_ranks("q")
        for case in self.cases:
            del case["q"]
        self.assert_mean_ranks(self.read(name), expected)
        self.assertEqual(self.read("time_handle").figure.name, TIME)

    # The tests

    def test_tests_are_told(self):
        ranking = self.read()
        test, difference = friedman(ranking.ranks.of_block), critical_difference(4, 12)
        said = notes(ranking)
        self.assertLess(test.p_f, 1e-4)
        self.assertEqual(said[0], "That all rank alike: p < 0.0001 (Friedman, Iman and Davenport), over 12 blocks.")
        self.assertEqual(said[1], f"Critical difference of mean ranks: {difference:.2f} (Nemenyi, α = 0.05).")
        means = dict(zip(ranking.table["label"], ranking.table["mean_rank"]))
        self.assertEqual([*means], [*LABELS])
        for one, other in zip(LABELS, LABELS[1:]):
            self.assertEqual(f"{one} ≈ {other}" in said[2], means[other] - means[one] < difference)
        self.assertTrue(said[2].startswith("Not told apart: "))

    def test_nothing_and_everything_told_apart(self):
        for case in self.cases:
            case[DEPTH] = 3.0
        said = notes(self.read())
        self.assertIn("p = 1.0000", said[0])
        self.assertEqual(said[2], "None is told apart from another.")
        self.cases = made_up(seeds=40)
        for case in self.cases:
            case[DEPTH] = float(LABELS.index(case["label"]))
        self.assertEqual(notes(self.read())[2], "All are told apart.")

    # How it is told

    def test_the_table(self):
        ranking = self.read()
        best = ranking.table.iloc[0]
        cells = f"{best['median']:.3g} ({best['low']:.3g}–{best['high']:.3g})"
        text = markdown_text(ranking)
        self.assertEqual(text.split("\n")[0], "| strategy | mean rank | depth_max_d_max, mm | failed |")
        self.assertEqual(text.split("\n")[2], f"| fuzzy | {best['mean_rank']:.2f} | {cells} | 0 |")
        self.assertTrue(all(f"- {note}\n" in text for note in notes(ranking)))
        text = plain_text(ranking)
        self.assertIn("mean rank", text.split("\n")[0])
        self.assertTrue(all(f"\n{note}\n" in text for note in notes(ranking)))
        self.assertIn("| time_handle_p50, µs |", markdown_text(self.read(TIME)))

    def test_the_csv(self):
        ranking = self.read(TIME)
        rows = [*csv.DictReader(io.StringIO(csv_text(ranking)))]
        self.assertEqual([row["label"] for row in rows], ranking.table["label"].tolist())
        for row in rows:
            times = [case[TIME] for case in chosen(self.cases, label=row["label"])]
            self.assertEqual(float(row["median"]), statistics.median(times))  # in ns
            self.assertEqual((row["metric"], row["units"], row["better"]), (TIME, "ns", "low"))
            self.assertEqual((row["cases"], row["failed"], row["blocks"]), ("24", "0", "12"))
            self.assertEqual(float(row["p"]), friedman(ranking.ranks.of_block).p_f)
            self.assertEqual(float(row["critical_difference"]), critical_difference(4, 12))

    def test_too_few_seeds_for_intervals(self):
        self.cases = made_up(seeds=2)
        self.assertIn("too few seeds for intervals", " ".join(notes(self.read())))

    def test_organs_of_one_shape_are_told(self):
        self.cases = made_up(organs=3)
        self.assertNotIn("of one shape", " ".join(notes(self.read())))
        for case in self.cases:
            case["organ"] = {"o0": "sheet@2mm", "o1": "tube@2mm", "o2": "sheet@4mm"}[case["organ"]]
        self.assertIn("\nsheet@2mm and sheet@4mm: of one shape, where a seed may be the same place;", plain_text(self.read()))
        self.assertNotIn("of one shape", plain_text(self.read(only=["organ=sheet@2mm", "organ=tube@2mm"])))

    def test_times_of_several_machines_are_warned_of(self):
        for number, case in enumerate(self.cases):
            case["provenance_row"] = number % 2
        machines = [{"cpu": "slow", "host": "h"}, {"cpu": "fast", "host": "h"}]
        for metric, count in ((TIME, 1), (f"{DEPTH}/{TIME}", 1), (DEPTH, 0)):
            ranking = self.read(metric, provenance=machines)
            self.assertEqual(len(ranking.cautions), count, metric)
            self.assertEqual("times are not comparable" in markdown_text(ranking), count == 1)

    # What cannot be ranked

    def test_mistakes(self):
        for metric, words in (
            ("depth_mx", "did you mean 'depth_max'?"),
            ("drag_mean", "drag_mean: neither way is better, so no strategy is; take a figure of a metric of which `trocar "
                          "list metrics` says low or high"),
            ("speed", "no metric 'speed'"),
            (f"{DEPTH}/tool_volume", "no metric 'tool_volume'"),
        ):  # fmt: skip
            with self.subTest(metric):
                self.refuse(words, metric=metric)
        self.refuse("did you mean 'speed'?", only=["sped=20"])
        for case in self.cases:
            case["depth_max_h_max"] = 1.0
        self.refuse("depth_max has several columns; say which: depth_max_d_max, depth_max_h_max", metric="depth_max")

    def test_too_little_to_rank(self):
        self.refuse("2 strategies (fuzzy, nearest-face), and it takes 3 or more",
                    only=["label=fuzzy", "label=nearest-face"])  # fmt: skip
        self.refuse("one seed on one organ only, and it takes 2 or more", only=["seed=1", "organ=o0"])
        for case in self.cases:
            case[DEPTH] = case[DEPTH] if case["organ"] == "o0" and case["seed"] == 1 else math.nan
        self.refuse("run more seeds (22 of 24 conditions are left out: no value with any strategy (22))")
        self.cases = made_up()
        self.cases = [case for case in self.cases if (case["label"] == "fuzzy") == (case["speed"] == 20)]
        self.refuse("of 24 conditions none has a value of each of the 4 strategies; not run with fuzzy (12), nearest-face "
                    "(12), cylinder-axis (12), joint-vertex (12); choose")  # fmt: skip

    def test_two_cases_of_a_strategy_under_one_condition(self):
        for number in (3, 4):
            again = self.cases[number] | {"case_id": f"other-{number}"}
            self.cases.append(again)
        self.refuse("cases 3 and other-3 are both of fuzzy under the same conditions; rank cases of one sweep")
        self.cases[-2]["options"] = '{"order": "none"}'
        self.refuse("choose with --only order=…")

    # The program

    def test_the_program(self):
        self.cases[0]["status"] = "crashed"
        write_results(self.file, self.cases)
        words = ("rank", self.file, "--metric", DEPTH, "--better", "depth_max=low", "--only", "speed=20")
        pictures = [self.folder / name for name in ("a.svg", "a.png", "b.svg")]
        said = self.output_of(*words, *(word for file in pictures for word in ("-o", file)))
        self.assertIn("Critical difference of mean ranks: 1.35", said)
        self.assertEqual(pictures[0].read_bytes(), pictures[2].read_bytes())
        self.assertTrue(pictures[1].read_bytes().startswith(b"\x89PNG"))
        tree = xml.etree.ElementTree.parse(pictures[0])
        texts = ["".join(element.itertext()).strip() for element in tree.iter("{http://www.w3.org/2000/svg}text")]
        for text in (DEPTH, "speed=20 · lower is better", "CD = 1.35", "A block is a seed on an organ (2 organs, 6 seeds), of "
                     "one condition."):  # fmt: skip
            self.assertIn(text, texts)
        self.assertEqual(sum(text.startswith(LABELS) for text in texts), 4)
        self.assertTrue([text for text in texts if text.startswith("fuzzy") and text.endswith(", 1 failed")])
        self.assertEqual(len(self.output_of(*words, "--csv", "-o", pictures[0]).splitlines()), 5)
        self.assert_refused(*words, "-o", "x.pdf", saying=["x.pdf: a picture's name ends in .png or .svg"])
        self.assert_refused(*words, saying=["-o/--output"])
        self.assert_refused("rank", self.file, "-o", "x.svg", saying=["--metric"])

    def test_nothing_is_cut_off(self):
        self.cases = made_up(labels=[f"{label} aggregate=last, feedback=false" for label in LABELS])
        for case in chosen(self.cases, speed=20.0, organ="o0"):
            case[DEPTH] = math.nan
        ranking = self.read()
        figure = compose(ranking.ranks, ranking.figure.title, "all cases", [*ranking.about] * 3)
        page, boxes = figure.bbox, [text.get_window_extent() for text in figure.axes[0].texts]
        for number, box in enumerate(boxes):
            self.assertTrue(page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1)
            self.assertFalse([other for other in boxes[:number] if box.overlaps(other)])

    def test_a_title_in_words_has_the_figure_beside_it(self):
        svg = self.folder / "a.svg"
        for case in self.cases:
            case["facets_crossing_d_mean"] = case[DEPTH]
        draw_ranking(self.read("facets_crossing_d_mean", better={"facets_crossing": "low"}), [str(svg)])
        self.assertIn(">Organ facets that cross the tool's surface<", svg.read_text())
        self.assertIn(">facets_crossing_d_mean · all cases · lower is better<", svg.read_text())

    def test_a_picture_that_cannot_be_written(self):
        with self.assertRaisesRegex(InputError, "cannot be written"):
            draw_ranking(self.read(), [str(self.folder / "none" / "a.svg")])


if __name__ == "__main__":
    unittest.main()
