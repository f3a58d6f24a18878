"""Pictures of a rule base: where curves cross, what is written on the pictures, and that they are the same each time."""

import json
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

import matplotlib.image
import numpy as np
from result_file import ProgramTest
from trocar_analysis.curves import apart, crossings, peak
from trocar_analysis.errors import InputError
from trocar_analysis.rule_plot import alike, draw_rules, names_of

EPSILON = 0.7071


def rule_base(folder, threshold=EPSILON):
    """Linear terms that cross at ∓threshold, triangles at 0, ½ and 1 for the weights, two passes."""
    x = np.linspace(-1, 1, 81)
    extraction = np.clip((x - threshold) / (2 - 2 * threshold) + 0.5, 0, 1)
    penetration = extraction[::-1]
    cases = {"penetration": penetration, "sliding": 1 - penetration - extraction, "extraction": extraction}
    weight = np.linspace(0, 1, 21)
    triangles = [(name, np.clip(1 - abs(2 * weight - 2 * peak_at), 0, 1)) for name, peak_at in
                 (("LOW", 0), ("MEDIUM", 0.5), ("HIGH", 1))]  # fmt: skip
    weights = ("I_P", "I_S", "I_E")
    first = dict(zip(weights, cases.values()))
    return {
        "output": str(folder),
        "title": "feedback",
        "inputs": [
            {"name": "I_C", "x": x.tolist(), "terms": [{"name": name, "y": y.tolist()} for name, y in cases.items()]},
            *({"name": f"{name} before", "x": weight.tolist(),
               "terms": [{"name": term, "y": y.tolist()} for term, y in triangles]} for name in weights),
        ],
        "outputs": [
            {"name": name, "terms": [{"name": term, "value": value} for term, value in
                                     (("LOW", 0.0), ("MEDIUM", 0.5), ("HIGH", 1.0))]} for name in weights
        ],
        "response": {
            "x": x.tolist(),
            "passes": [
                {"label": "first facet"} | {name: y.tolist() for name, y in first.items()},
                {"label": "after feedback"} | {name: (y / 2).tolist() for name, y in first.items()},
            ],
        },
    }  # fmt: skip


class Curves(unittest.TestCase):
    def test_straight_lines_cross_where_they_do_between_points(self):
        x = np.array([0.0, 1.0, 2.0])
        ((at, height),) = crossings(x, np.array([[1, 0.6, 0.6], [0, 0.9, 0.9]]))
        self.assertAlmostEqual(at, 1 / 1.3)
        self.assertAlmostEqual(height, 0.9 / 1.3)

    def test_terms_that_only_touch_or_meet_at_nothing_do_not_cross(self):
        x = np.linspace(0, 1, 5)
        apart_terms = np.array([[1, 0.5, 0, 0, 0], [0, 0, 0, 0.5, 1]])
        touching = np.array([[1, 0.5, 0.2, 0.5, 1], [0, 0.1, 0.2, 0.1, 0]])
        for curves in (apart_terms, touching):
            self.assertEqual(crossings(x, curves), [])

    def test_a_crossing_below_a_third_term_is_none_of_neighbours(self):
        x = np.linspace(0, 1, 3)
        low, high, middle = [1, 0.3, 0], [0, 0.3, 1], [0, 0.8, 0]
        self.assertEqual([round(at, 6) for at, _ in crossings(x, np.array([low, high]))], [0.5])
        places = [at for at, _ in crossings(x, np.array([low, high, middle]))]
        np.testing.assert_allclose(places, [1 / 3, 2 / 3])

    def test_the_middle_of_where_terms_agree(self):
        x = np.linspace(0, 4, 5)
        self.assertEqual(crossings(x, np.array([[1, 0.5, 0.5, 0.5, 0], [0, 0.5, 0.5, 0.5, 1]])), [(2.0, 0.5)])

    def test_a_jump_is_in_the_middle_of_its_interval(self):
        x = np.array([-1.0, -0.71, -0.70, 1.0])
        self.assertAlmostEqual(crossings(x, np.array([[1.0, 1, 0, 0], [0, 0, 1, 1]]))[0][0], -0.705)

    def test_the_peak_of_a_plateau_is_its_middle(self):
        self.assertEqual(peak(np.array([0.0, 1, 2, 3]), np.array([0.0, 1, 1, 0])), 1.5)

    def test_a_line_on_others_has_no_place_of_its_own(self):
        line = np.linspace(0, 1, 41)
        high = np.where(np.arange(41) == 20, 2.0, line)
        self.assertEqual(apart(np.array([line, line, high])), [None, None, 20])


class Rules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def draw(self, described):
        file = self.folder / "rules.json"
        file.write_text(json.dumps(described), encoding="utf-8")
        return draw_rules(str(file))

    def words(self, picture):
        """What a reader can search in it. A subscript is a word of its own."""
        tree = xml.etree.ElementTree.parse(picture)
        return {"".join(element.itertext()).strip() for element in tree.iter() if element.tag.endswith("}text")}

    def test_both_pictures_in_both_formats_and_what_is_written_on_them(self):
        out = self.folder / "new" / "pictures"
        said = self.draw(rule_base(out))
        self.assertEqual(said.splitlines(), [str(out / name) for name in
                         ("memberships.svg", "memberships.png", "response.svg", "response.png")])  # fmt: skip
        for name in ("memberships", "response"):
            pixels = matplotlib.image.imread(out / f"{name}.png")
            self.assertEqual(pixels.shape[1], 1400)
            self.assertGreater(pixels.std(), 0.05)
        words = self.words(out / "memberships.svg")
        expected = {"feedback: membership functions", "penetration", "sliding", "extraction", "LOW", "MEDIUM", "HIGH"}
        self.assertLessEqual(expected | {"−ε", "ε", "−0.7071", "0.7071", "180°", "135°", "90°", "45°", "0°"}, words)
        words = self.words(out / "response.svg")
        self.assertLessEqual({"feedback: weights inferred", "1  first facet", "2  after feedback", "1", "2"}, words)

    def test_the_threshold_is_that_of_the_data(self):
        self.draw(rule_base(self.folder, threshold=0.6))
        words = self.words(self.folder / "memberships.svg")
        self.assertLessEqual({"−0.6", "0.6", "ε"}, words)
        self.assertNotIn("0.7071", words)

    def test_terms_that_cross_elsewhere_on_either_side_have_no_epsilon(self):
        described = rule_base(self.folder)
        x = np.array(described["inputs"][0]["x"])
        terms = {"towards": np.clip(0.5 - 2 * (x + 0.5), 0, 1)}
        terms["away"] = 1 - terms["towards"]
        described["inputs"][0]["terms"] = [{"name": name, "y": y.tolist()} for name, y in terms.items()]
        self.draw(described)
        words = self.words(self.folder / "memberships.svg")
        self.assertIn("−0.5", words)
        self.assertNotIn("ε", words)

    def test_variables_with_the_same_terms_share_a_panel(self):
        groups = alike(rule_base(self.folder)["inputs"])
        self.assertEqual([len(group) for group in groups], [1, 3])
        self.assertEqual(names_of(groups[1]), "$I_{P}$, $I_{S}$, $I_{E}$ before")
        described = rule_base(self.folder)
        described["inputs"][2]["terms"][0]["name"] = "NONE"
        self.assertEqual([[one["name"] for one in group] for group in alike(described["inputs"])],
                         [["I_C"], ["I_P before", "I_E before"], ["I_S before"]])  # fmt: skip

    def test_the_same_rule_base_gives_the_same_bytes(self):
        drawn = []
        for _ in range(2):
            self.draw(rule_base(self.folder))
            drawn.append([(self.folder / f"{name}.svg").read_text() for name in ("memberships", "response")])
        self.assertEqual(*drawn)
        self.assertNotIn("<dc:date>", "".join(drawn[0]))

    def test_a_folder_that_cannot_be_made(self):
        (self.folder / "taken").write_text("a file")
        with self.assertRaisesRegex(InputError, "taken: cannot be made a folder"):
            self.draw(rule_base(self.folder / "taken"))


class RulesCommand(ProgramTest):
    def test_a_missing_package_is_named(self):
        (self.folder / "matplotlib.py").write_text('raise ModuleNotFoundError("none", name="matplotlib")\n')
        self.assert_refused("rules", "x.json", saying=["python3-matplotlib"], path_first=self.folder)


if __name__ == "__main__":
    unittest.main()
