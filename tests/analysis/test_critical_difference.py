"""The critical-difference diagram: what is written on it, and where its lines are."""

import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

import matplotlib.image
import numpy as np
from trocar_analysis import palette
from trocar_analysis.critical_difference import AXIS, BAR_OVERHANG, BAR_WIDTH, LENGTH, compose, draw_critical_difference
from trocar_analysis.errors import InputError
from trocar_analysis.ranks import Ranks, critical_difference

NAMES = ["fuzzy", "nearest-face", "cylinder-axis", "joint-vertex"]


def made_up(means, blocks=14, names=NAMES, failed=None, left_out=0):
    """Ranks of these means: half of the blocks as much above as the others below."""
    spread = np.where(np.arange(blocks) % 2, 0.5, -0.5)[:, None] * np.array([1, -1, 0, 0])
    return Ranks(list(names), np.array(means) + spread, np.array(failed or [0] * len(means)), left_out,
                 [*range(blocks)])  # fmt: skip


def place(rank, strategies=4):
    return LENGTH * (strategies - rank) / (strategies - 1)


class Diagram(unittest.TestCase):
    def draw(self, ranks):
        """Its texts, each with its position, and its lines, each with its width, x and y."""
        (axes,) = compose(ranks, "depth").axes
        texts = {text.get_text(): text.get_position() for text in axes.texts}
        lines = [(line.get_linewidth(), np.array(line.get_xdata(), float), np.array(line.get_ydata(), float))
                 for line in axes.lines]  # fmt: skip
        return texts, lines

    def bars(self, lines):
        return [(x[0] + BAR_OVERHANG, x[1] - BAR_OVERHANG, y[0]) for width, x, y in lines if width == BAR_WIDTH]

    def test_each_strategy_has_a_line_from_its_rank_to_its_name(self):
        means = [1.2, 3.9, 2.1, 2.8]
        texts, lines = self.draw(made_up(means))
        for name, mean in zip(NAMES, means):
            x, y = texts[f"{name}  {mean:.2f}"]
            (line,) = [(xs, ys) for width, xs, ys in lines if len(xs) == 3 and abs(xs[0] - place(mean)) < 1e-9]
            self.assertEqual((line[0][2], line[1][0]), (x, AXIS))
            self.assertTrue(0 < line[1][2] - y < 0.1)  # just above its line
            self.assertEqual(x > LENGTH, mean < 2.5)  # the better half on the right
        heights = {name: texts[f"{name}  {mean:.2f}"][1] for name, mean in zip(NAMES, means)}
        self.assertEqual(heights["fuzzy"], heights["nearest-face"])  # the outermost on top
        self.assertLess(heights["fuzzy"], heights["cylinder-axis"])

    def test_the_axis_has_the_best_on_the_right(self):
        texts, _ = self.draw(made_up([1.2, 3.9, 2.1, 2.8]))
        self.assertEqual([texts[str(rank)][0] for rank in (1, 4)], [LENGTH, 0])

    def test_bars_join_what_is_not_told_apart(self):
        self.assertAlmostEqual(critical_difference(4, 14), 1.2536, 4)
        _, lines = self.draw(made_up([1.2, 3.9, 2.1, 2.8]))
        bars = sorted(self.bars(lines), reverse=True)
        np.testing.assert_allclose([bar[:2] for bar in bars],
                                   [(place(2.1), place(1.2)), (place(2.8), place(2.1)), (place(3.9), place(2.8))])
        heights = [bar[2] for bar in bars]
        self.assertNotEqual(heights[0], heights[1])  # they would touch
        self.assertEqual(heights[0], heights[2])

    def test_nothing_joined(self):
        _, lines = self.draw(made_up([1.0, 4, 2, 3], blocks=1000))
        self.assertEqual(self.bars(lines), [])

    def test_the_difference_is_as_long_as_it_is(self):
        texts, lines = self.draw(made_up([1.2, 3.9, 2.1, 2.8]))
        self.assertIn("CD = 1.25", texts)
        lengths = [x[1] - x[0] for _, x, y in lines if len(x) == 2 and y[0] == y[1] < AXIS]
        np.testing.assert_allclose(lengths, [critical_difference(4, 14) / 3 * LENGTH])
        texts, lines = self.draw(made_up([1.2, 3.9, 2.1, 2.8], blocks=2))
        self.assertIn("CD = 3.32, more than ranks can differ", texts)
        self.assertFalse([x for _, x, y in lines if y[0] < AXIS and x[0] != x[1] and y[1] < AXIS])

    def test_what_failed_and_what_is_left_out_is_said(self):
        texts, _ = self.draw(made_up([1.2, 3.9, 2.1, 2.8], failed=[0, 3, 0, 0], left_out=2))
        self.assertIn("nearest-face  3.90, 3 failed", texts)
        said = " ".join(texts)
        self.assertIn("14 blocks; 2 left out, where one has no value. That all rank alike: p < 0.0001", said)
        self.assertIn("Bars join what differs by less than CD (Nemenyi, α = 0.05).", said)
        texts, _ = self.draw(made_up([2.4, 2.6, 2.5, 2.5], blocks=14))
        self.assertTrue([text for text in texts if "p = " in text])

    def test_nothing_is_cut_off_and_no_names_meet(self):
        for longest in ("tool-facet", "fuzzy-per-vertex aggregate=last, feedback=false"):
            figure = compose(made_up([1.2, 3.9, 2.1, 2.8], names=[*NAMES[:3], longest], failed=[0, 0, 0, 12]), "depth")
            page = figure.bbox
            boxes = [text.get_window_extent() for text in figure.axes[0].texts]
            for number, box in enumerate(boxes):
                self.assertTrue(page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1)
                self.assertFalse([other for other in boxes[:number] if box.overlaps(other)])
            axis = figure.axes[0].transData.transform([(0, AXIS), (LENGTH, AXIS)])[:, 0]
            for text, box in zip(figure.axes[0].texts, boxes):
                if text.get_text().split("  ")[0] in (*NAMES, longest):
                    self.assertTrue(box.x1 < axis[0] or box.x0 > axis[1], text.get_text())

    def test_it_is_readable_in_grey(self):
        (axes,) = compose(made_up([1.2, 3.9, 2.1, 2.8]), "depth").axes
        colors = {mark.get_color() for mark in (*axes.lines, *axes.texts)}
        self.assertLessEqual(colors, {palette.INK, palette.FAINT_INK, "black"})

    def test_too_little_to_rank(self):
        with self.assertRaisesRegex(InputError, "depth: 1 blocks in which each of 4 strategies has a value"):
            compose(made_up([1.2, 3.9, 2.1, 2.8], blocks=1), "depth")
        with self.assertRaisesRegex(InputError, "3 strategies or more"):
            compose(Ranks(["a", "b"], np.array([[1.0, 2]] * 5), np.array([0, 0]), 0, [*range(5)]), "depth")


class Files(unittest.TestCase):
    def test_both_formats_the_same_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            svg, png = Path(folder) / "cd.svg", Path(folder) / "cd.png"
            drawn = []
            for _ in range(2):
                draw_critical_difference(made_up([1.2, 3.9, 2.1, 2.8]), "depth", [str(svg), str(png)])
                drawn.append(svg.read_bytes())
            self.assertEqual(*drawn)
            tree = xml.etree.ElementTree.parse(svg)
            words = {"".join(element.itertext()).strip() for element in tree.iter() if element.tag.endswith("}text")}
            self.assertLessEqual({"depth", "fuzzy  1.20", "CD = 1.25", "mean rank, best: 1"}, words)
            pixels = matplotlib.image.imread(png)
            self.assertEqual(pixels.shape[1], 1400)
            self.assertGreater(pixels.std(), 0.05)
            with self.assertRaisesRegex(InputError, "cannot be written"):
                draw_critical_difference(made_up([1.2, 3.9, 2.1, 2.8]), "depth", [str(Path(folder) / "no" / "cd.svg")])


if __name__ == "__main__":
    unittest.main()
