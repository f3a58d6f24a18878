"""`snapshot`: that the picture shows what it should, by its pixels, and what is refused."""

import unittest
import xml.etree.ElementTree

import h5py
import matplotlib.image
import numpy as np
from result_file import ProgramTest, dent, write_results
from trocar_analysis.snapshot import choose_step


class Snapshot(ProgramTest):
    def setUp(self):
        super().setUp()
        cases = [
            {"case_id": "aa11", "label": "clears"},
            {"case_id": "aa22", "label": "leaves"},
            {"case_id": "bb33", "label": "leaves", "seed": 2},
            {"case_id": "cc44", "label": "unrecorded"},
            {"case_id": "dd55", "label": "other speed", "speed": 20.0},
        ]
        replays = {"aa11": dent(True), "aa22": dent(False), "bb33": dent(True), "dd55": dent(True)}
        write_results(self.file, cases, replays)

    def picture(self, *arguments):
        """What was printed, and the picture's pixels, [rows, columns, RGB]."""
        target = self.folder / "x.png"
        said = self.output_of("snapshot", self.file, "-o", target, *arguments)
        return said, matplotlib.image.imread(target)[:, :, :3]

    @staticmethod
    def red_share(pixels):
        """Share of the panel's pixels in the red of the organ's section inside the tool."""
        return float((np.abs(pixels - [0.863, 0.122, 0.165]).max(axis=2) < 0.01).mean())

    def test_siblings_with_a_replay_stand_side_by_side(self):
        said, pixels = self.picture("--case", "aa11")
        self.assertIn("step 2 of clears, leaves; 1 more", said)
        height, width, _ = pixels.shape
        self.assertEqual(width, round((2 * 3.6 + 3 * 0.08) * 200))
        self.assertGreater(pixels.std(), 0.1)

    def test_what_is_inside_the_tool_is_red(self):
        _, pixels = self.picture("--case", "aa22")
        body = pixels[: int(0.9 * len(pixels))]  # without the legend
        half = body.shape[1] // 2
        self.assertLess(self.red_share(body[:, :half]), 0.2 * self.red_share(body[:, half:]))
        self.assertGreater(self.red_share(body[:, half:]), 0.01)

    def test_alone(self):
        said, pixels = self.picture("--case", "aa22", "--alone")
        self.assertIn("of leaves\n", said)
        self.assertEqual(pixels.shape[1], round((7.0 + 2 * 0.08) * 200))

    def test_without_a_case_several_conditions_are_listed(self):
        done = self.run_program("snapshot", self.file, "-o", self.folder / "x.png")
        self.assertEqual(done.returncode, 2)
        said = done.stderr
        for expected in ("--case", "aa11", "bb33", "dd55", "other speed"):
            self.assertIn(expected, said)
        self.assertNotIn("cc44", said)

    def test_without_a_case_the_only_conditions_are_taken(self):
        cases = [{"case_id": "aa11", "label": "clears"}, {"case_id": "aa22", "label": "leaves"}]
        write_results(self.file, cases, {"aa11": dent(True), "aa22": dent(False)})
        said, _ = self.picture()
        self.assertIn("step 2 of clears, leaves", said)

    def test_the_moment_matters(self):
        _, found = self.picture("--case", "bb33", "--alone", "--moment", "found")
        _, handled = self.picture("--case", "bb33", "--alone", "--moment", "handled")
        self.assertGreater(self.red_share(found), 2 * self.red_share(handled))

    def test_steps(self):
        for asked, number in (("deepest", 2), ("0", 0), ("-1", 4), ("4", 4)):
            said, _ = self.picture("--case", "bb", "--step", asked)
            self.assertIn(f"step {number} of", said)

    def test_deepest_of_a_slide_is_its_end(self):
        poses = np.tile(np.eye(4), (6, 1, 1))
        poses[:, :3, 3] = [(0, 0, -3), (5, 0, -3), (10, 0, -3), (10, 0, -3), (10, 0, 0), (10, 0, 30)]
        self.assertEqual(choose_step("deepest", poses), 2)

    def test_deepest_of_a_way_out_is_its_start(self):
        poses = np.tile(np.eye(4), (3, 1, 1))
        poses[:, 2, 3] = [-8, -4, 3]
        self.assertEqual(choose_step("deepest", poses), 0)

    def test_svg(self):
        target = self.folder / "x.svg"
        self.output_of("snapshot", self.file, "--case", "bb", "-o", target)
        self.assertTrue(xml.etree.ElementTree.parse(target).getroot().tag.endswith("svg"))

    def test_positions_that_are_no_numbers_are_left_out(self):
        with h5py.File(self.file, "a") as file:
            file["replay/bb33/handled"][2, 200:230] = np.nan
        _, pixels = self.picture("--case", "bb33")
        self.assertGreater(pixels.std(), 0.1)

    def refused(self, *arguments, saying):
        self.assert_refused("snapshot", self.file, *arguments, saying=saying)

    def test_unknown_and_ambiguous_case(self):
        self.refused("--case", "aa113", "-o", "x.png", saying=["no case 'aa113'", "'aa11'"])
        self.refused("--case", "aa", "-o", "x.png", saying=["not unique", "aa11, aa22"])

    def test_case_without_replay(self):
        self.refused("--case", "cc44", "-o", "x.png", saying=["no replay", "trocar run … --replay"])

    def test_step_out_of_range(self):
        for asked in ("5", "-6"):
            self.refused("--case", "bb", "--step", asked, "-o", "x.png", saying=["steps 0 to 4"])
        self.refused("--case", "bb", "--step", "last", "-o", "x.png", saying=["deepest"])

    def test_output(self):
        self.refused("--case", "bb", "-o", "x.pdf", saying=[".png or .svg"])
        self.refused("--case", "bb", "-o", "none/x.png", saying=["none/x.png: cannot be written"])

    def test_damaged_replay(self):
        with h5py.File(self.file, "a") as file:
            del file["replay/bb33/facets"]
        self.refused("--case", "bb", "-o", "x.png", saying=["is damaged", "facets"])


if __name__ == "__main__":
    unittest.main()
