"""`figure`: which step a panel shows, what is marked on it, and what is refused."""

import re
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np
from matplotlib.colors import to_rgb
from result_file import ANALYSIS, dent, write_results
from trocar_analysis import palette
from trocar_analysis.errors import InputError
from trocar_analysis.figures.crossing_vectors import crossing_edges
from trocar_analysis.figures.figure import draw_figure
from trocar_analysis.figures.figure_file import read_figure
from trocar_analysis.figures.page import DPI
from trocar_analysis.figures.steps import arrival
from trocar_analysis.figures.wire import trails
from trocar_analysis.snapshot import MARGIN

HEAD = """title = "Dents"
caption = "The tool goes in."
columns = 2
[view]
width = 30
height = 30
elevation = 30
turn = 0
rise = 2
"""
CLEARS = """[[panel]]
letter = "a"
title = "clears"
where = { label = "clears" }
"""
WIRE = CLEARS + 'surface = "wire"\n'
LEAVES = CLEARS.replace('"a"', '"b"').replace("clears", "leaves")


class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file, self.figure, self.picture = (Path(folder.name) / name for name in ("out.h5", "figure.toml", "x.png"))
        cases = [{"case_id": "aa11", "label": "clears"}, {"case_id": "aa22", "label": "leaves"}]
        write_results(self.file, cases, {"aa11": dent(True), "aa22": dent(False)})

    def draw(self, *panels, suffix=".png"):
        self.figure.write_text(HEAD + "".join(panels))
        return draw_figure(str(self.file), str(self.figure), str(self.picture.with_suffix(suffix)))

    def panels(self, *panels):
        """The pixels of the left and of the right panel of a picture."""
        self.draw(*panels)
        pixels = matplotlib.image.imread(self.picture)[:, :, :3]
        pitch = round((pixels.shape[1] - MARGIN * DPI) / 2)
        left, inner = round(MARGIN * DPI), slice(100, 600)
        return pixels[inner, left + 5 : pitch - 5], pixels[inner, pitch + left + 5 : 2 * pitch - 5]

    def refused(self, *panels, saying):
        self.picture.unlink(missing_ok=True)
        with self.assertRaises(InputError) as caught:
            self.draw(*panels)
        for words in (str(self.figure), *saying):
            self.assertIn(words, str(caught.exception))
        self.assertFalse(self.picture.exists())

    @staticmethod
    def share_of(pixels, colour):
        return float((np.abs(pixels - to_rgb(colour)).max(axis=2) < 0.08).mean())

    def test_it_says_what_each_panel_shows(self):
        counted = 'facts = { collided_vertices = "{} collided" }\n'
        said = self.draw(WIRE + counted, LEAVES + 'surface = "wire"\nstep = 4\n')
        self.assertIn("a) clears · step 2 · 9 collided\n", said)
        self.assertTrue(said.endswith("b) leaves · step 4"))

    def test_panels_of_one_scene_share_the_camera(self):
        left, right = self.panels(WIRE, WIRE.replace('"a"', '"b"'))
        # Only the first has a scale, in its lower left corner.
        self.assertLess(np.abs(left - right)[:, 150:].max(), 0.02)
        self.assertGreater(np.abs(left - right)[:, :150].max(), 0.5)

    def test_what_is_in_the_tool_is_marked_once_it_is_handled(self):
        red = palette.FACET_IN_TOOL_DARK
        in_it, out_of_it = self.panels(LEAVES + 'surface = "wire"\n', WIRE + "step = 4\n")
        self.assertGreater(self.share_of(in_it, red), 0.003)
        self.assertEqual(self.share_of(out_of_it, red), 0)
        found, _ = self.panels(LEAVES + 'surface = "wire"\nmoment = "found"\n', WIRE)
        self.assertEqual(self.share_of(found, red), 0)

    def test_a_solid_marks_the_same(self):
        red = palette.FACET_IN_TOOL_DARK
        in_it, out_of_it = self.panels(CLEARS, CLEARS.replace('"a"', '"b"') + "step = 4\n")
        self.assertGreater(self.share_of(in_it, red), 0.001)
        self.assertEqual(self.share_of(out_of_it, red), 0)

    def test_vectors_are_drawn_where_asked_for(self):
        without, along = self.panels(WIRE, WIRE.replace('"a"', '"b"') + 'vectors = "all"\n')
        arrow = palette.DISPLACEMENT
        self.assertGreater(self.share_of(along[:, 150:], arrow), self.share_of(without[:, 150:], arrow) + 0.001)

    def test_an_svg_has_its_lines_as_lines(self):
        self.draw(WIRE, LEAVES, suffix=".svg")
        text = self.picture.with_suffix(".svg").read_text()
        xml.etree.ElementTree.fromstring(text)
        self.assertEqual(text.count("data:image/png"), 1)
        longest = max(re.findall(r' d="([^"]*)"', text), key=len)
        self.assertGreater(len(longest.split()), 800)
        self.assertNotRegex(longest, r"\.\d\d")

    def test_the_same_state_is_checked(self):
        self.draw(WIRE + "step = 0\n", LEAVES + 'surface = "wire"\nstep = 0\nstate_of = "a"\n')
        self.refused_state("step = 2\n", "the organ is somewhere else")
        with h5py.File(self.file, "a") as file:
            file["replay/aa22/tool_pose"][0, 0, 3] = 1
        self.refused_state("step = 0\n", "the tool is somewhere else")

    def refused_state(self, step, why):
        self.refused(CLEARS + step, LEAVES + step + 'state_of = "a"\n', saying=["panel b", "state of panel a", why])

    def test_bad_descriptions(self):
        for panel, saying in (
            (CLEARS.replace("where", "were"), ["panel a", "no key 'were'", "'where'"]),
            (CLEARS.replace("label", "lable"), ["panel a", "no key 'lable'"]),
            (CLEARS.replace('label = "clears"', 'label = "clear"'), ["panel a", "no label 'clear'", "'clears'"]),
            (CLEARS.replace('label = "clears"', ""), ["panel a", "2 cases", "label"]),
            (CLEARS + 'surface = "glass"\n', ["panel a", "'glass'", "solid or wire"]),
            (CLEARS + 'step = "last"\n', ["panel a", '"last"', "arrived"]),
            (CLEARS + "step = 5\n", ["panel a", "steps 0 to 4"]),
            (CLEARS + 'step = "most drag"\n', ["panel a", "no series 'drag'"]),
            (CLEARS + 'facts = { drag = "{} mm" }\n', ["panel a", "no series 'drag'"]),
            (CLEARS + 'state_of = "z"\n', ["panel a", "no panel 'z'"]),
            (CLEARS + CLEARS, ["panel a twice"]),
            ("", ["lacks panel"]),
        ):
            with self.subTest(saying):
                self.refused(panel, saying=saying)
        with self.assertRaisesRegex(InputError, "none.toml: No such file"):
            draw_figure(str(self.file), "none.toml", "x.png")
        with self.assertRaisesRegex(InputError, ".png or .svg"):
            self.draw(CLEARS, suffix=".pdf")

    def test_steps_are_found_by_rule(self):
        self.assertTrue(self.draw(WIRE + 'step = "contact"\n').endswith("step 0"))
        with h5py.File(self.file, "a") as file:
            file["series/aa11/strain"] = np.array([0, 0.1, np.nan, 0.3, 0.2])
            file["series/aa11/collided_vertices"][...] = 0
        self.assertTrue(self.draw(WIRE + 'step = "most strain"\n').endswith("step 3"))
        self.refused(CLEARS + 'step = "contact"\n', saying=["collided_vertices is 0 in every step"])

    def test_the_figures_that_ship_are_sound(self):
        for number in (3, 4, 5, 6):
            described = read_figure(str(ANALYSIS / "figures" / f"fig{number}.toml"))
            sweep = tomllib.loads((ANALYSIS.parent / "experiments" / "figures" / f"fig{number}.toml").read_text())
            labels = {one if isinstance(one, str) else one["label"] for one in sweep["strategies"]}
            self.assertEqual({panel.where["label"] for panel in described.panels}, labels)
            self.assertEqual(sweep["seeds"], [1])


class Parts(unittest.TestCase):
    @staticmethod
    def poses(*heights):
        poses = np.tile(np.eye(4), (len(heights), 1, 1))
        poses[:, 2, 3] = heights
        return poses

    def test_arrival_is_before_the_first_standstill(self):
        self.assertEqual(arrival(self.poses(3, 1, -1, -2, -2, -2, 1, 3, 3)), 3)
        self.assertEqual(arrival(self.poses(3, 3, 1, -1, -1)), 3)
        self.assertEqual(arrival(self.poses(3, 2, 1)), 2)
        turned = self.poses(1, 1, 1)
        turned[1, :2, :2] = [[0, -1], [1, 0]]
        turned[2, :2, :2] = turned[1, :2, :2]
        self.assertEqual(arrival(turned), 1)

    @staticmethod
    def crosses(a, a_end, b, b_end, moved=(0, 1)):
        """Whether the edge of these two counts when its ends go there."""
        found, handled = np.array([a, b, (0, -5, 0)], float), np.array([a_end, b_end, (0, -5, 0)], float)
        return len(crossing_edges(found, handled, np.array([[0, 1, 2]]), np.array(moved))) == 1

    def test_an_edge_that_turns_around_crosses(self):
        places = (0, 0, 0), (0.9, 2, 0), (1, 0, 0), (0.1, 2, 0)
        self.assertTrue(self.crosses(*places))
        self.assertFalse(self.crosses(*places, moved=(0,)))
        self.assertFalse(self.crosses((0, 0, 0), (0, 2, 0), (1, 0, 0), (1, 2, 0)))

    def test_vectors_cross_within_a_tenth_of_the_edge(self):
        # They cross in the plane at (1.5, 0), `gap` above each other; the edge is 1.12 mm long and does not turn.
        for gap, expected in ((0, True), (0.11, True), (0.115, False)):
            self.assertEqual(self.crosses((0, 0, 0), (1.7, 0, 0), (1, -0.5, gap), (2, 0.5, gap)), expected, gap)
        self.assertFalse(self.crosses((0, 0, 0), (1.4, 0, 0), (1, -0.5, 0), (2, 0.5, 0)))  # the one ends before
        self.assertFalse(self.crosses((0, 0, 0), (1.7, 0, 0), (1, 0.2, 0), (2, 1.2, 0)))  # the other starts behind it

    def test_vectors_side_by_side_do_not_cross(self):
        for degrees, expected in ((4, False), (6, True)):
            way = 5.5 * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0])
            start = np.array([1, -0.3, 0])
            self.assertEqual(self.crosses((0, 0, 0), (6, 0, 0), start, start + way), expected, degrees)

    def test_trails_go_along_every_edge_once(self):
        rng = np.random.default_rng(1)
        edges = sorted({tuple(sorted(pair)) for pair in rng.integers(0, 30, (200, 2)).tolist() if pair[0] != pair[1]})
        walks = trails([list(edge) for edge in edges])
        walked = [tuple(sorted(pair)) for walk in walks for pair in zip(walk, walk[1:])]
        self.assertEqual(sorted(walked), edges)
        self.assertLess(len(walks), len(edges) / 4)


if __name__ == "__main__":
    unittest.main()
