"""`front` on made-up files: medians and who is on the front are worked out here; names of points in their panel."""

import csv
import io
import math
import statistics
import unittest
import xml.etree.ElementTree

import numpy as np
from made_up_strategies import BETTER, DEPTH, LABELS, RATIO, TIME, StrategiesTest, chosen, made_up
from matplotlib.colors import to_rgba
from result_file import write_results
from trocar_analysis import palette
from trocar_analysis.errors import InputError
from trocar_analysis.front import Wishes, csv_text, markdown_text, notes, plain_text, read_front
from trocar_analysis.front_plot import STEPS, compose, draw_front, front_steps, scale_of
from trocar_analysis.label_places import cost_of_labels, cost_of_marks, covered_length, place_labels

# Depth and time of the strategies, in this order. By hand: c and e are not on the front, since b is deeper in neither and
# quicker than c, and d is as deep as e and quicker.
POINTS = {"a": (1.0, 9e3), "b": (2.0, 5e3), "c": (2.5, 6e3), "d": (4.0, 1e3), "e": (4.0, 2e3)}


def at(points):
    """Cases of strategies of which all have the same figures."""
    cases = made_up(labels=list(points))
    for case in cases:
        case[DEPTH], case[TIME] = points[case["label"]]
    return cases


class Front(StrategiesTest):
    def read(self, metric=DEPTH, against=TIME, provenance=None, **asked):
        write_results(self.file, self.cases, provenance=provenance)
        return read_front(str(self.file), Wishes(metric, against, **({"better": BETTER} | asked)))

    def on_front(self, *arguments, **asked):
        points = self.read(*arguments, **asked).points
        return points[points["on_front"]]["label"].tolist()

    def draw(self, *arguments, **asked):
        """The panel, the marks by their strategy, and the picture's texts by what they say."""
        canvas, panel = compose(self.read(*arguments, **asked)).axes
        marks = {line.get_label(): line for line in panel.lines if not line.get_label().startswith("_")}
        return panel, marks, {text.get_text(): text for text in canvas.texts}

    # What is on the front

    def test_medians_and_intervals_are_those_of_the_cases(self):
        for _, row in self.read().points.iterrows():
            cases = chosen(self.cases, label=row["label"])
            organs, seeds = (np.array([case[name] for case in cases]) for name in ("organ", "seed"))
            for prefix, name in (("", DEPTH), ("against_", TIME)):
                values = np.array([case[name] for case in cases])
                self.assertAlmostEqual(row[f"{prefix}median"], statistics.median(values))
                self.assertEqual((row[f"{prefix}low"], row[f"{prefix}high"]), self.interval(values, organs, seeds))

    def test_who_is_not_beaten_in_both(self):
        self.cases = at(POINTS)
        self.assertEqual(self.on_front(), ["d", "b", "a"])  # the quickest first
        self.assertEqual(self.read().points["label"].tolist(), ["d", "b", "a", "e", "c"])
        self.assertEqual(self.on_front(TIME, DEPTH), ["a", "b", "d"])

    def test_where_high_is_better(self):
        self.cases = at(POINTS)
        for case in self.cases:
            case[RATIO], case["depth_max_h_max"] = -case[DEPTH], -case[TIME]
        self.assertEqual(self.on_front(RATIO, TIME), ["d", "b", "a"])
        self.assertEqual(self.on_front(TIME, RATIO), ["a", "b", "d"])
        worst_first = self.on_front(DEPTH, TIME, better={"depth_max": "high", "time_handle": "high"})
        self.assertEqual(worst_first, ["a", "c", "e"])

    def test_equal_ones_are_both_on_it_and_so_are_those_that_differ_by_rounding(self):
        self.cases = at(POINTS | {"again": (2.0 * (1 + 1e-15), 5e3 * (1 - 1e-15))})
        self.assertEqual(self.on_front(), ["d", "b", "again", "a"])

    def test_a_failed_case_is_the_worst_in_both(self):
        self.cases = at(POINTS)
        for case in chosen(self.cases, label="a")[:12]:
            case["status"] = "crashed"
        self.assertEqual(self.on_front(), ["d", "b"])  # with half of its cases, its median is worse than any
        front = self.read()
        (row,) = [row for _, row in front.points.iterrows() if row["label"] == "a"]
        self.assertEqual((row["failed"], row["median"], row["against_median"]), (12, math.inf, math.inf))
        self.assertIn("12 of 120 cases failed: ×", " ".join(notes(front)))

    def test_the_cases_are_of_the_same_conditions(self):
        # The hard half, which b alone has run, would move its medians; so would what has no time.
        self.cases = at(POINTS)
        self.cases = [case for case in self.cases if case["label"] == "b" or case["speed"] == 20]
        for case in chosen(self.cases, label="b", speed=400.0):
            case[DEPTH] = 100.0
        for case in chosen(self.cases, speed=20.0, seed=1):
            case[DEPTH] = 200.0
        for case in chosen(self.cases, speed=20.0, seed=1, label="a"):
            case[TIME] = math.nan
        front = self.read()
        self.assertEqual({label: median for label, median in zip(front.points["label"], front.points["median"])},
                         {label: depth for label, (depth, _) in POINTS.items()})  # fmt: skip
        self.assertEqual(set(front.points["cases"]), {10})
        self.assertIn("14 of 24 conditions are left out: not run with a (12), c (12), d (12), e (12); no value with a (2).",
                      notes(front))  # fmt: skip

    # How it is told

    def test_the_table(self):
        self.cases = at(POINTS)
        text = markdown_text(self.read())
        head, _, first, *_, last = text.split("\n\n")[0].split("\n")
        self.assertEqual(head, "| strategy | depth_max_d_max, mm | time_handle_p50, µs | failed | on the front |")
        self.assertEqual((first, last), ("| d | 4 (4–4) | 1 (1–1) | 0 | yes |", "| c | 2.5 (2.5–2.5) | 6 (6–6) | 0 | no |"))
        self.assertIn("- A point is a strategy's medians over n = 24 cases (2 organs, 2 speeds, 6 seeds), its bars", text)
        self.assertIn(f"- {DEPTH}: lower is better; {TIME}: lower is better.", text)
        self.assertTrue(all(f"\n{note}\n" in plain_text(self.read()) for note in notes(self.read())))

    def test_the_csv(self):
        self.cases = at(POINTS)
        rows = [*csv.DictReader(io.StringIO(csv_text(self.read(RATIO, f"{DEPTH}/{TIME}"))))]
        self.assertEqual(len(rows), 5)
        for row in rows:
            self.assertEqual((row["metric"], row["better"], row["against"], row["against_units"], row["against_better"]),
                             (RATIO, "high", f"{DEPTH}/{TIME}", "mm/ns", "low"))  # fmt: skip
            depth, time = POINTS[row["label"]]
            self.assertEqual([float(row[f"against_{end}"]) for end in ("median", "low", "high")], [depth / time] * 3)
            self.assertEqual((row["cases"], row["failed"]), ("24", "0"))
            self.assertIn(row["on_front"], ("True", "False"))

    def test_times_of_several_machines_are_warned_of(self):
        for number, case in enumerate(self.cases):
            case["provenance_row"] = number % 2
        machines = [{"cpu": "slow", "host": "h"}, {"cpu": "fast", "host": "h"}]
        self.assertIn("times are not comparable", notes(self.read(provenance=machines))[-1])
        self.assertEqual(self.read(against=RATIO, provenance=machines).cautions, [])

    # The picture

    def test_points_are_where_their_medians_are(self):
        self.cases = at(POINTS)
        panel, marks, texts = self.draw()
        for label, (depth, time) in POINTS.items():
            x, y = marks[label].get_data()
            self.assertEqual((*x, *y), (time / 1000, depth))  # µs
            is_on = label in "abd"
            self.assertEqual(texts[label].get_fontweight(), "bold" if is_on else "normal")
            self.assertEqual(to_rgba(texts[label].get_color()), to_rgba(palette.INK if is_on else palette.FAINT_INK))
            self.assertEqual(to_rgba(marks[label].get_markerfacecolor()) == to_rgba("white"), not is_on)
        self.assertEqual(marks[STEPS].get_xydata().tolist(), [[1, 4], [5, 4], [5, 2], [9, 2], [9, 1]])
        self.assertEqual((panel.get_xscale(), panel.get_yscale()), ("linear", "linear"))
        self.assertIn("mm, largest of the steps, ↓ lower is better", texts)
        self.assertIn("µs, median of the steps, ← lower is better", texts)
        self.assertIn("all cases", texts)

    def test_intervals_are_drawn(self):
        panel, marks, _ = self.draw()
        table = self.read().points
        segments = sorted(part.tolist() for bars in panel.collections for part in bars.get_segments())
        expected = []
        for _, row in table.iterrows():
            x, low, high = (row[f"against_{end}"] / 1000 for end in ("median", "low", "high"))
            expected += [[[low, row["median"]], [high, row["median"]]], [[x, row["low"]], [x, row["high"]]]]
        np.testing.assert_allclose(segments, sorted(expected))
        self.cases = made_up(seeds=2)
        panel, _, _ = self.draw()
        self.assertEqual(len(panel.collections), 0)
        self.assertIn("too few seeds for intervals", " ".join(notes(self.read())))

    def test_steps_turn_where_both_are_the_worse(self):
        on = np.array([True, False, True, True])
        steps = front_steps(np.array([1.0, 0, 2, 3]), np.array([9.0, 0, 5, 4]), on)
        self.assertEqual(steps.tolist(), [[1, 9], [2, 9], [2, 5], [3, 5], [3, 4]])
        # High is better along y: worse is lower.
        steps = front_steps(np.array([1.0, 2]), np.array([4.0, 5]), np.array([True, True]))
        self.assertEqual(steps.tolist(), [[1, 4], [2, 4], [2, 5]])
        self.assertEqual(front_steps(np.array([1.0]), np.array([4.0]), np.array([True])).tolist(), [[1, 4]])

    def test_an_axis_is_logarithmic_where_positive_values_differ_much(self):
        def scale(*medians):
            return scale_of(np.array([[median] * 3 for median in medians]))

        self.assertTrue(scale(1.0, 31.0).is_log)
        self.assertFalse(scale(1.0, 29.0).is_log)
        self.assertFalse(scale(0.0, 100.0).is_log)
        self.assertFalse(scale(-1.0, 100.0).is_log)
        self.assertFalse(scale_of(np.array([[1.0, 0, 2], [100, 90, 110]])).is_log)
        far = scale_of(np.array([[1.0, 1e-12, 2], [100, 90, 110]]))
        self.assertTrue(far.is_log and far.low > 0.01)  # an interval that ends next to 0 takes no twelve decades
        self.assertLess(scale(1.0, 10.0).low, 0)  # 0 is on it
        self.assertGreater(scale(8.0, 10.0).low, 5)
        self.assertGreater(scale(3.0, 3.0).high, 3)
        self.assertLess(scale(-8.0, -10.0).high, -5)
        for edge in (scale(math.inf), scale(math.inf, 3.0), scale(-math.inf, 3.0)):
            self.assertTrue(edge.low < edge.high < math.inf)

    def test_a_median_of_failed_cases_is_at_the_panels_edge(self):
        self.cases = at(POINTS)
        for case in chosen(self.cases, label="b"):
            case["status"] = "crashed"
        chosen(self.cases, label="e")[0]["status"] = "crashed"
        panel, marks, _ = self.draw()
        self.assertEqual((*marks["b"].get_xdata(), *marks["b"].get_ydata()), (panel.get_xlim()[1], panel.get_ylim()[1]))
        crosses = sorted((*line.get_xdata(), *line.get_ydata()) for line in panel.lines if line.get_marker() == "x")
        self.assertEqual(crosses, sorted((*marks[name].get_xdata(), *marks[name].get_ydata()) for name in "be"))

    def test_no_names_meet_and_nothing_is_cut_off(self):
        generator = np.random.default_rng(12)
        for count in (2, 7, 14):
            names = [f"strategy {k}" + " aggregate=last" * (k % 3) for k in range(count)]
            places = generator.uniform(1, 3, (count, 2))
            places[1] = places[0]  # two at one place
            self.cases = at({name: (float(y), float(1000 * x)) for name, (x, y) in zip(names, places)})
            for case in self.cases:
                case["drag_mean"] = math.nan
            figure = compose(self.read(only=["speed=20", "speed=400"]))
            canvas, panel = figure.axes
            page, inside = figure.bbox, panel.get_window_extent()
            boxes = [text.get_window_extent() for text in canvas.texts]
            of_names = [text.get_window_extent() for text in canvas.texts if text.get_text() in names]
            self.assertEqual(len(of_names), count)
            for number, box in enumerate(boxes):
                self.assertTrue(page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1)
                self.assertFalse([other for other in boxes[:number] if box.overlaps(other)])
            for box in of_names:
                self.assertTrue(inside.x0 <= box.x0 and box.x1 <= inside.x1 and inside.y0 <= box.y0 and box.y1 <= inside.y1)
            marks = panel.transData.transform([line.get_xydata()[0] for line in panel.lines if line.get_label() in names])
            self.assertFalse([mark for mark in marks for box in of_names if box.contains(*mark)])

    def test_a_name_stands_by_its_point_or_a_line_leads_to_it(self):
        self.cases = at(POINTS | {f"a once more, {k}": POINTS["a"] for k in range(7)})
        figure = compose(self.read())
        canvas, panel = figure.axes
        marks = {line.get_label(): panel.transData.transform(line.get_xydata()[0]) for line in panel.lines}
        lines = [canvas.transData.transform(line.get_xydata()) for line in canvas.lines]
        led = 0
        for text in canvas.texts:
            if text.get_text() not in marks:
                continue
            box, mark = text.get_window_extent(), marks[text.get_text()]
            beyond = np.maximum([box.x0 - mark[0], box.y0 - mark[1]], [mark[0] - box.x1, mark[1] - box.y1]).clip(0)
            if np.hypot(*beyond) > 0.14 * figure.dpi:
                ends = [line[1] for line in lines if np.allclose(line[0], mark)]
                self.assertTrue([end for end in ends if box.padded(0.06 * figure.dpi).contains(*end)], text.get_text())
                led += 1
        self.assertEqual(led, len(lines))
        self.assertGreater(led, 0)

    def test_names_are_clear_of_intervals(self):
        # Those of one figure are long, and two run close by the first strategy's point.
        for one, other in ((DEPTH, TIME), (TIME, DEPTH)):
            self.cases = made_up()
            for case in self.cases:
                number = LABELS.index(case["label"])
                case |= {one: (0.0, 150.0, -150.0, 3000.0)[number], other: 1000.0 * (case["seed"] + (number % 3 > 0))}
            self.assert_clear(*compose(self.read()).axes)

    def assert_clear(self, canvas, panel):
        bars = [panel.transData.transform(part) for bars in panel.collections for part in bars.get_segments()]
        self.assertEqual(len(bars), 8)
        for text in canvas.texts:
            if text.get_text() in LABELS:
                box = text.get_window_extent()
                middle, size = (box.min + box.max) / 2, box.max - box.min
                self.assertEqual([float(covered_length(middle, size, *bar)) for bar in bars], [0] * 8, text.get_text())

    # What has no front

    def test_mistakes(self):
        for asked, words in (
            ({"metric": "drag_mean"}, "drag_mean: neither way is better"),
            ({"against": "drag_mean"}, "drag_mean: neither way is better"),
            ({"against": "depth_max_d_mx"}, "did you mean 'depth_max_d_max'?"),
            ({"against": DEPTH}, "--metric and --against are both depth_max_d_max"),
            ({"only": ["label=fuzzy"]}, "1 strategy (fuzzy), and it takes 2 or more; run more of them"),
        ):
            with self.subTest(asked), self.assertRaises(InputError) as raised:
                self.read(**asked)
            self.assertIn(words, str(raised.exception))

    def test_the_program(self):
        write_results(self.file, self.cases)
        words = ("front", self.file, "--metric", DEPTH, "--against", "time_handle", "--better", "depth_max=low,time_handle=low")
        pictures = [self.folder / name for name in ("a.svg", "a.png", "b.svg")]
        said = self.output_of(*words, *(word for file in pictures for word in ("-o", file)))
        self.assertIn("on the front", said)
        self.assertEqual(pictures[0].read_bytes(), pictures[2].read_bytes())
        self.assertTrue(pictures[1].read_bytes().startswith(b"\x89PNG"))
        tree = xml.etree.ElementTree.parse(pictures[0])
        texts = ["".join(element.itertext()).strip() for element in tree.iter("{http://www.w3.org/2000/svg}text")]
        for text in (*LABELS, "Pareto front", DEPTH, TIME):
            self.assertIn(text, texts)
        self.assertEqual(len(self.output_of(*words, "--csv", "-o", pictures[0]).splitlines()), 5)
        self.cases = [case | {"provenance_row": int(case["case_id"]) % 2} for case in self.cases]
        write_results(self.file, self.cases, provenance=[{"cpu": "slow", "host": "h"}, {"cpu": "fast", "host": "h"}])
        done = self.run_program(*words, "--csv", "-o", pictures[0])
        self.assertEqual((done.returncode, len(done.stdout.splitlines())), (0, 5))
        self.assertIn("times are not comparable", done.stderr)
        self.assert_refused(*words, "-o", "x.pdf", saying=["x.pdf: a picture's name ends in .png or .svg"])
        self.assert_refused(*words[:-4], "-o", "x.svg", saying=["--against"])
        with self.assertRaisesRegex(InputError, "cannot be written"):
            draw_front(self.read(), [str(self.folder / "none" / "a.png")])


class LabelPlaces(unittest.TestCase):
    def test_the_length_of_a_line_in_a_box(self):
        middle, size = np.array([2.0, 1]), np.array([2.0, 1])  # from 1, 0.5 to 3, 1.5
        for start, end, length in (
            ((0, 1), (4, 1), 2), ((2, 1), (9, 1), 1), ((2, 0), (2, 9), 1), ((0, 2), (4, 2), 0), ((4, 0), (4, 2), 0),
            ((1.5, 0.75), (2, 0.75), 0.5), ((5, 1), (9, 1), 0), ((0, 0), (4, 2), math.hypot(2, 1)), ((2, 1), (2, 1), 0),
        ):  # fmt: skip
            self.assertAlmostEqual(float(covered_length(middle, size, np.array(start), np.array(end))), length)
        lengths = covered_length(np.array([[2.0, 1], [9, 9]]), size, np.array([0, 1]), np.array([4, 1]))
        self.assertEqual(lengths.tolist(), [2, 0])

    def test_a_lone_label_is_next_to_its_point(self):
        (place,) = place_labels(np.array([[2.0, 2]]), np.array([[1.0, 0.2]]), (4, 4), np.empty((0, 2, 2)), 0.05)
        beyond = np.maximum(np.abs(place - 2) - [0.5, 0.1], 0)
        self.assertLess(np.hypot(*beyond), 0.15)

    def test_labels_in_a_crowd_are_clear_of_each_other_of_marks_and_in_the_panel(self):
        generator = np.random.default_rng(13)
        for spread in (0.02, 0.5, 2):
            for _ in range(5):
                points = 2 + spread * generator.uniform(-1, 1, (10, 2))
                sizes = np.stack([generator.uniform(0.3, 1.2, 10), np.full(10, 0.15)], axis=1)
                places = place_labels(points, sizes, (4, 4), np.empty((0, 2, 2)), 0.05)
                self.assertTrue(((places - sizes / 2 >= -1e-9) & (places + sizes / 2 <= 4 + 1e-9)).all())
                for k in range(10):
                    self.assertFalse((np.abs(points - places[k]) < sizes[k] / 2).all(axis=1).any())
                    for m in range(k):
                        apart = np.abs(places[k] - places[m]) >= (sizes[k] + sizes[m]) / 2 - 1e-9
                        self.assertTrue(apart.any())

    def test_a_label_rather_does_not_lie_on_a_bar(self):
        point, size = np.array([[2.0, 2]]), np.array([[1.0, 0.2]])
        bars = np.array([[[1.0, 2], [3, 2]], [[2, 1], [2, 3]]])
        (place,) = place_labels(point, size, (4, 4), bars, 0.05)
        self.assertEqual([float(covered_length(place, size[0], *bar)) for bar in bars], [0, 0])

    def test_what_a_place_costs(self):
        points, size = np.array([[2.0, 2], [3, 2]]), np.array([1.0, 0.2])
        middles = np.array([[2.0, 2], [2.5, 2], [2.6, 2], [3.6, 2.1], [2.5, 2.3]])
        marks = cost_of_marks(middles, size, points, 0.05)
        self.assertEqual((marks / marks[0]).tolist(), [1, 2, 1, 0, 0])
        # Of a label at 3, 3, whose point is 3, 2: to cover it, its line or a line of one's own across it.
        middles = np.array([[2.2, 3.1], [3, 2.5], [4.8, 3.5], [2, 2.3]])
        covers, under, across, clear = cost_of_labels(
            np.array([2.0, 2.6]), middles, size, points[1:], np.array([[3.0, 3]]), size[None]
        )
        self.assertTrue(covers > across == under > clear == 0)

    def test_a_label_that_is_larger_than_its_panel(self):
        (place,) = place_labels(np.array([[1.0, 1]]), np.array([[9.0, 0.2]]), (4, 4), np.empty((0, 2, 2)), 0.05)
        self.assertTrue(np.isfinite(place).all())


if __name__ == "__main__":
    unittest.main()
