"""`sensitivity` on made-up files: the medians that are drawn are worked out here, from the cases alone."""

import csv
import io
import math
import statistics
import unittest
import xml.etree.ElementTree
from functools import partial
from unittest import mock

import numpy as np
import pandas as pd
from matplotlib.colors import to_rgba
from result_file import ProgramTest, write_results
from trocar_analysis.errors import InputError
from trocar_analysis.paired import bootstrap_interval
from trocar_analysis.sensitivity import Wishes, read_sweep
from trocar_analysis.sensitivity_panel import Scale, log_ticks, scale_of, tick_texts
from trocar_analysis.sensitivity_plot import compose, draw_sweep, keep_apart
from trocar_analysis.sensitivity_table import csv_text, markdown_text, notes

LOW = {"depth_max": "low", "tool_volume_inside": "low", "time_cycle": "low", "edge_ratio_min": "high"}
LABELS, SPEEDS, RELEASES = ("fuzzy", "nearest-face"), (400.0, 20.0, 100.0), ("contact", "step")
DEPTH = "depth_max_d_max"


def made_up(organs=3, seeds=5, releases=("contact",), **fixed):
    """Cases at every speed, of which no two values are alike."""
    generator = np.random.default_rng(7)
    rows = []
    for label in LABELS:
        for organ in range(organs):
            for seed in range(seeds):
                for speed in SPEEDS:
                    for release in releases:
                        depth = float(generator.uniform(1, 5))
                        rows.append(
                            {"case_id": str(len(rows)), "label": label, "organ": f"o{organ}", "seed": seed,
                             "speed": speed, "release": release, DEPTH: depth, "drag_mean": depth,
                             "edge_ratio_min_h_mean": depth, "tool_volume_inside_d_max": depth,
                             "tool_volume_at_rest_max": 5 + float(generator.uniform(0, 10)),
                             "rest_stiffness": 100.0, "rate": 30.0, "missing": "", "metrics": "all"} | fixed
                        )  # fmt: skip
    return rows


def chosen(cases, **keys):
    return [case for case in cases if all(case[name] == value for name, value in keys.items())]


class Sensitivity(ProgramTest):
    def setUp(self):
        super().setUp()
        self.cases = made_up()
        # Where an interval ends is known to test_paired.py; here few resamples do.
        quick = mock.patch("trocar_analysis.conditions.bootstrap_interval", partial(bootstrap_interval, resamples=300))
        quick.start()
        self.addCleanup(quick.stop)

    def read(self, over="speed", metrics=(DEPTH,), **asked):
        write_results(self.file, self.cases)
        return read_sweep(str(self.file), Wishes(over, list(metrics), **({"better": LOW} | asked)))

    def draw(self, *arguments, **asked):
        """The panels, row by row and in a row by release, and the picture's texts."""
        canvas, *panels = compose(self.read(*arguments, **asked)).axes
        texts = [text.get_text() for text in canvas.texts]
        releases = [text.removeprefix("release: ") for text in texts if text.startswith("release: ")] or [""]
        rows = [panels[k : k + len(releases)] for k in range(0, len(panels), len(releases))]
        return [dict(zip(releases, row)) for row in rows], texts

    def marks(self, panel, name):
        (line,) = [line for line in panel.lines if line.get_label() == name]
        return line

    def tidy(self, *arguments, **asked):
        return list(csv.DictReader(io.StringIO(csv_text(self.read(*arguments, **asked)))))

    # What is drawn

    def test_medians_are_those_of_the_cases(self):
        self.cases = made_up(releases=RELEASES)
        (row,), _ = self.draw()
        self.assertEqual([*row], ["step", "contact"])
        for release, panel in row.items():
            for label in LABELS:
                x, y = self.marks(panel, label).get_data()
                self.assertEqual([*x], sorted(SPEEDS))
                for speed, median in zip(x, y):
                    cases = chosen(self.cases, release=release, label=label, speed=speed)
                    self.assertEqual(len(cases), 15)
                    self.assertAlmostEqual(median, statistics.median(case[DEPTH] for case in cases))

    def test_intervals_are_drawn_and_hold_their_median(self):
        (row,), _ = self.draw()
        table = {(point["release"], point["label"], float(point["speed"])): point for point in self.tidy()}
        for release, panel in row.items():
            for label, bars in zip(LABELS, panel.collections):
                for (x, low), (_, high) in bars.get_segments():
                    point = table[release, label, x]
                    self.assertEqual((low, high), (float(point["low"]), float(point["high"])))
                    self.assertTrue(low < float(point["median"]) < high)

    def test_the_interval_of_equal_values_is_that_value(self):
        for case in self.cases:
            case[DEPTH] = 3.0
        self.assertEqual({(p["median"], p["low"], p["high"]) for p in self.tidy()}, {("3.0", "3.0", "3.0")})

    def test_too_few_seeds_for_an_interval(self):
        self.cases = made_up(seeds=3)
        (row,), texts = self.draw()
        self.assertEqual(sum(len(bars.get_segments()) for panel in row.values() for bars in panel.collections), 0)
        self.assertIn("too few seeds for intervals", " ".join(texts))

    def test_numbers_are_along_a_logarithmic_axis(self):
        (row,), texts = self.draw()
        panel = row["contact"]
        self.assertEqual(panel.get_xscale(), "log")
        self.assertEqual([tick.get_text() for tick in panel.get_xticklabels()], ["20", "100", "400"])
        self.assertIn("speed, mm/s, log scale", texts)
        self.assertEqual(panel.lines[0].get_alpha(), 1)

    def test_panels_of_a_row_share_their_scale(self):
        self.cases = made_up(releases=RELEASES)
        for case in chosen(self.cases, release="step"):
            case[DEPTH] *= 3
        (row,), _ = self.draw()
        self.assertEqual(row["contact"].get_ylim(), row["step"].get_ylim())
        self.assertEqual({tick.get_text() for tick in row["contact"].get_yticklabels()}, {""})
        self.assertEqual(row["step"].get_ylabel(), "mm")

    def test_categories_stand_in_the_order_of_the_file(self):
        tools = ["prism-4", "needle", "grasper"]
        for case in self.cases:
            case["tool"] = tools[SPEEDS.index(case["speed"])]
            case["speed"] = 100.0
        (row,), texts = self.draw("tool")
        panel = row["contact"]
        self.assertEqual([tick.get_text() for tick in panel.get_xticklabels()], tools)
        x, y = self.marks(panel, "fuzzy").get_data()
        self.assertEqual([*x], [0, 1, 2])
        needles = chosen(self.cases, tool="needle", release="contact", label="fuzzy")
        self.assertAlmostEqual(y[1], statistics.median(case[DEPTH] for case in needles))
        self.assertLess(panel.lines[0].get_alpha(), 0.5)
        self.assertIn("tool", texts)

    def test_speeds_are_lines_of_their_own_where_something_else_is_along_x(self):
        self.cases = made_up() + made_up(rate=1000.0)
        for number, case in enumerate(self.cases):
            case["case_id"] = str(number)
        (row,), texts = self.draw("rate")
        slow, fast, other = (self.marks(row["contact"], name) for name in
                             ("fuzzy, 20 mm/s", "fuzzy, 400 mm/s", "nearest-face, 20 mm/s"))  # fmt: skip
        cases = chosen(self.cases, label="fuzzy", speed=400.0, rate=30.0)
        self.assertAlmostEqual(fast.get_ydata()[0], statistics.median(case[DEPTH] for case in cases))
        self.assertEqual(slow.get_color(), fast.get_color())
        self.assertEqual(slow.get_marker(), fast.get_marker())
        self.assertNotEqual(slow.get_color(), other.get_color())
        self.assertNotEqual(slow.get_marker(), other.get_marker())
        # In grey and where dashes are short, filled marks tell speeds apart.
        middle = self.marks(row["contact"], "fuzzy, 100 mm/s")
        self.assertEqual(to_rgba(middle.get_markerfacecolor()), to_rgba("white"))
        self.assertNotEqual(to_rgba(slow.get_markerfacecolor()), to_rgba("white"))
        self.assertEqual(sum(name in texts for name in ("fuzzy, 20 mm/s", "nearest-face, 400 mm/s")), 2)

    def test_a_release_along_x_needs_no_panels(self):
        self.cases = made_up(releases=RELEASES)
        (row,), texts = self.draw("release", only=["speed=20"])
        self.assertEqual([*row], [""])
        self.assertEqual([tick.get_text() for tick in row[""].get_xticklabels()], ["contact", "step"])

    def test_which_way_is_better_is_said(self):
        rows, texts = self.draw(metrics=[DEPTH, "edge_ratio_min", "drag_mean"])
        self.assertEqual(len(rows), 3)
        said = [text for text in texts if " of the steps" in text]
        self.assertEqual(said, ["largest of the steps, ↓ lower is better", "mean of the steps, ↑ higher is better",
                                "mean of the steps"])  # fmt: skip

    # Cases that failed, and values that do not exist

    def test_a_failed_case_counts_as_the_worst_and_marks_its_point(self):
        here = chosen(self.cases, label="fuzzy", speed=20.0, release="contact")
        here[0] |= {"status": "diverged", DEPTH: 0.0, "edge_ratio_min_h_mean": 9.0}
        rest = sorted(case[DEPTH] for case in here[1:])
        rows, texts = self.draw(metrics=[DEPTH, "edge_ratio_min", "drag_mean"])
        # Of 14 values and a worst one the middle is the eighth; where low is worst, the seventh.
        for row, median in zip(rows, (rest[7], rest[6], statistics.median(rest))):
            panel = row["contact"]
            self.assertAlmostEqual(self.marks(panel, "fuzzy").get_ydata()[0], median)
            crosses = [[*line.get_xdata()] for line in panel.lines if line.get_marker() == "x"]
            self.assertEqual(crosses, [[20.0], []])
        self.assertIn("1 of 90 cases failed", " ".join(texts))
        (left_out,) = [point for point in self.tidy(metrics=["drag_mean"]) if point["failed"] != "0"]
        self.assertEqual((left_out["cases"], left_out["failed"], left_out["no_value"]), ("15", "1", "0"))

    def test_a_median_of_failed_cases_is_at_the_panels_edge(self):
        for case in chosen(self.cases, label="fuzzy", speed=20.0, release="contact")[:8]:
            case["status"] = "crashed"
        rows, _ = self.draw(metrics=[DEPTH, "edge_ratio_min"])
        for row, edge in zip(rows, (1, 0)):
            panel = row["contact"]
            self.assertEqual(self.marks(panel, "fuzzy").get_ydata()[0], panel.get_ylim()[edge])
            self.assertGreater(panel.get_ylim()[1], 1)
        point = self.tidy()[0]
        self.assertEqual((point["label"], point["speed"], point["failed"], point["median"]),
                         ("fuzzy", "20.0", "8", "inf"))  # fmt: skip
        self.assertIn("| 15 | 8 | ∞ (", markdown_text(self.read()))

    def test_values_that_do_not_exist_are_counted_with_their_reason(self):
        here = chosen(self.cases, label="fuzzy", speed=20.0, release="contact")
        for case in here[:3]:
            case |= {"drag_mean": math.nan, "missing": '{"drag": "no vertex collided"}'}
        sweep = self.read(metrics=["drag_mean"])
        (point,) = [row for row in csv.DictReader(io.StringIO(csv_text(sweep))) if row["no_value"] != "0"]
        self.assertEqual((point["cases"], point["no_value"], point["failed"]), ("15", "3", "0"))
        self.assertAlmostEqual(float(point["median"]), statistics.median(case["drag_mean"] for case in here[3:]))
        self.assertIn("drag_mean: no value in 3 of 90 complete cases (no vertex collided).", notes(sweep))

    def test_a_figure_without_any_value(self):
        for case in self.cases:
            case["drag_mean"] = math.nan
        _, texts = self.draw(metrics=["drag_mean"])
        self.assertIn("no value", texts)

    # Quotients

    def test_a_quotient_is_taken_case_by_case(self):
        name = "tool_volume_inside_d_max/tool_volume_at_rest_max"
        here = chosen(self.cases, label="fuzzy", speed=20.0, release="contact")
        here[0]["tool_volume_at_rest_max"] = 0.0
        shares = [100 * case["tool_volume_inside_d_max"] / case["tool_volume_at_rest_max"] for case in here[1:]]
        (row,), texts = self.draw(metrics=[])  # the usual ones, of which the file has this one
        self.assertAlmostEqual(self.marks(row["contact"], "fuzzy").get_ydata()[0], statistics.median(shares))
        self.assertEqual(row["contact"].get_ylabel(), "%")
        self.assertIn("(no tool_volume_at_rest_max to divide by)", " ".join(texts))
        self.assertEqual(self.read(metrics=[f"{DEPTH}/tool_volume_at_rest_max"]).figures[0].unit, "mm/mm³")
        self.assertIn(f"{name}, %", markdown_text(self.read(metrics=[name])))

    # The table and the notes

    def test_the_markdown_has_what_is_drawn(self):
        self.cases = made_up(releases=RELEASES)
        text = markdown_text(self.read())
        head = text.split("\n", 1)[0]
        self.assertEqual(head, "| release | speed, mm/s | strategy | cases | failed | depth_max_d_max, mm |")
        median = statistics.median(case[DEPTH] for case in chosen(self.cases, release="step", label="fuzzy", speed=100))
        self.assertIn(f"| step | 100 | fuzzy | 15 | 0 | {median:.3g} (", text)
        self.assertIn("- A point is the median over n = 15 cases (3 organs, 5 seeds); its bar", text)
        self.assertIn("- None of the 180 cases failed.", text)

    def test_what_changes_along_is_said(self):
        for case in self.cases:
            stiffness = case["speed"]
            case |= {"rest_stiffness": stiffness, "edge_stiffness": 10 * stiffness, "speed": 9.0}
            case["tool"] = f"t{stiffness:g}"
        said = notes(self.read("rest_stiffness"))
        self.assertIn("Along with rest_stiffness goes edge_stiffness: from 200 to 4000.", said)
        self.assertIn("Along with rest_stiffness goes tool: t20, t100, t400.", said)

    def test_times_are_in_a_unit_that_people_read(self):
        for case in self.cases:
            case["time_cycle_p50"] = 2e6
        (row,), _ = self.draw(metrics=["time_cycle"])
        self.assertEqual(row["contact"].get_ylabel(), "ms")
        self.assertEqual(set(self.marks(row["contact"], "fuzzy").get_ydata()), {2.0})
        self.assertEqual(row["contact"].collections[0].get_segments()[0][:, 1].tolist(), [2.0, 2.0])
        self.assertIn("time_cycle_p50, ms |", markdown_text(self.read(metrics=["time_cycle"])))
        self.assertIn("| 15 | 0 | 2 (2–2) |", markdown_text(self.read(metrics=["time_cycle"])))

    def test_times_of_several_programs_are_warned_of(self):
        for number, case in enumerate(self.cases):
            case |= {"provenance_row": number % 2, "time_cycle_p50": 2e6}
        machines = [{"cpu": "slow", "host": "h"}, {"cpu": "fast", "host": "h"}]
        write_results(self.file, self.cases, provenance=machines)
        sweep = read_sweep(str(self.file), Wishes("speed", ["time_cycle"]))
        self.assertIn("times are not comparable", notes(sweep)[-1])
        self.assertEqual(read_sweep(str(self.file), Wishes("speed", [DEPTH])).cautions, [])

    # What cannot be drawn

    def test_mistakes(self):
        for asked, words in (
            ({"over": "sped"}, "did you mean 'speed'?"),
            ({"over": "seed"}, "no column to sweep over 'seed'"),
            ({"over": "rest_stiffness"}, "rest_stiffness is 100 in all cases; these vary: organ, speed"),
            ({"metrics": ["depth_mx"]}, "did you mean 'depth_max'?"),
            ({"metrics": [f"{DEPTH}/tool_volume_at_rest"]}, "'tool_volume_at_rest' in"),
            ({"metrics": [f"{DEPTH}/volume"]}, "no metric 'volume'"),
            ({"only": ["speed=20"]}, "speed is 20 mm/s in all cases"),
        ):
            with self.subTest(asked), self.assertRaises(InputError) as raised:
                self.read(**asked)
            self.assertIn(words, str(raised.exception))

    def test_a_file_without_the_usual_figures(self):
        for case in self.cases:
            del case["tool_volume_at_rest_max"]
        with self.assertRaisesRegex(InputError, "has none of the usual figures; name one with --metric"):
            self.read(metrics=[])

    def test_a_picture_that_cannot_be_written(self):
        sweep = self.read()
        cannot = "cannot be written"
        for name, words in (("a.pdf", "ends in .png or .svg"), ("none/a.png", cannot), ("none/a.svg", cannot)):
            with self.subTest(name), self.assertRaises(InputError) as raised:
                draw_sweep(sweep, [str(self.folder / name)])
            self.assertIn(words, str(raised.exception))
        self.assertEqual([*self.folder.iterdir()], [self.file])

    # The program

    def test_the_program_writes_pictures_with_text(self):
        self.cases = made_up(releases=RELEASES)
        self.cases[0]["status"] = "crashed"
        write_results(self.file, self.cases)
        words = ("sensitivity", self.file, "--over", "speed", "--metric", DEPTH, "--better", "depth_max=low")
        pictures = [self.folder / name for name in ("a.svg", "a.png", "b.svg")]
        said = self.output_of(*words, *(word for file in pictures for word in ("-o", file)))
        self.assertEqual(said.split(), [str(file) for file in pictures])
        self.assertEqual(pictures[0].read_bytes(), pictures[2].read_bytes())
        self.assertTrue(pictures[1].read_bytes().startswith(b"\x89PNG"))
        tree = xml.etree.ElementTree.parse(pictures[0])
        texts = ["".join(element.itertext()).strip() for element in tree.iter("{http://www.w3.org/2000/svg}text")]
        for text in (*LABELS, "mm", "release: contact", "release: step", "speed, mm/s, log scale", DEPTH,
                     "Sensitivity to: speed", "20", "100", "400"):  # fmt: skip
            self.assertIn(text, texts)
        together = " ".join(texts)
        self.assertIn("median over n = 15 cases", together)
        self.assertIn("1 of 180 cases failed", together)


class Layout(unittest.TestCase):
    def test_names_are_kept_apart_near_their_lines(self):
        generator = np.random.default_rng(3)
        for _ in range(200):
            wanted = generator.uniform(0, 2, generator.integers(1, 9))
            kept = keep_apart(wanted, 0.2, 0, 2)
            self.assertTrue((np.diff(np.sort(kept)) > 0.2 - 1e-9).all())
            self.assertTrue(((kept > -1e-9) & (kept < 2 + 1e-9)).all())
            self.assertEqual(np.argsort(kept).tolist(), np.argsort(wanted).tolist())
        np.testing.assert_allclose(keep_apart(np.array([1.0, 0.5, 1.0]), 0.2, 0, 2), [0.9, 0.5, 1.1])
        np.testing.assert_allclose(keep_apart(np.array([1.99, 1.98]), 0.2, 0, 2), [2, 1.8])

    def test_ticks_of_a_logarithmic_axis_are_few(self):
        self.assertEqual(log_ticks(Scale(0.9, 30, True)), [1, 2, 5, 10, 20])
        np.testing.assert_allclose(log_ticks(Scale(0.02, 8, True)), [0.03, 0.1, 0.3, 1, 3])
        self.assertEqual(log_ticks(Scale(0.5, 2e5, True)), [1, 10, 100, 1e3, 1e4, 1e5])

    def test_numbers_without_room_have_no_tick_label(self):
        self.assertEqual(tick_texts({600: 600.0, 10000: 1e4, 10001: 10001.0}, False, 3.0), ["600", "10,000", ""])
        self.assertEqual(tick_texts({"pointed-prism-12": 0, "needle": 1}, True, 1.2), ["pointed-\nprism-12", "needle"])

    def test_a_figure_that_spans_much_has_a_logarithmic_axis(self):
        def scale(medians):
            return scale_of(pd.DataFrame({"median": medians, "low": medians, "high": medians}))

        self.assertTrue(scale([1.0, 100.0]).is_log)
        self.assertFalse(scale([0.0, 100.0]).is_log)  # 0 has no place on it
        self.assertFalse(scale([10.0, 100.0]).is_log)
        self.assertLess(scale([10.0, 100.0]).low, 0.01)  # else from 0
        self.assertEqual(scale([math.inf, math.nan]), Scale(0, 1, False))
        self.assertTrue(scale([-3.0, 1.0]).low < -3)


if __name__ == "__main__":
    unittest.main()
