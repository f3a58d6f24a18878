"""Pictures of metrics: what hides what, by the pixels."""

import unittest

import numpy as np
from matplotlib.colors import to_rgb
from trocar_analysis import palette
from trocar_analysis.camera import camera_from, fragments
from trocar_analysis.rendering import FINER, Surface, render, sharp_edges, split_by_sight

NOTHING = np.array([], int)
FRONT = np.array([0.0, -1, 0])  # the eye: x is right, z is up
SQUARE = np.array([[0, 1, 2], [0, 2, 3]])


def wall(y, half=4.0):
    """A square in the plane of that y, its outer side towards the eye."""
    return np.array([[-half, y, -half], [half, y, -half], [half, y, half], [-half, y, half]])


def cube(half, middle=(0, 0, 0)):
    corners = [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    sides = [(0, 3, 2, 1), (4, 5, 6, 7)] + [(k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4) for k in range(4)]
    facets = [facet for a, b, c, d in sides for facet in ((a, b, c), (a, c, d))]
    return Surface(half * np.array(corners, float) + middle, np.array(facets))


class Rendering(unittest.TestCase):
    def setUp(self):
        self.camera = camera_from(FRONT, np.zeros(3), 10, 10, 60 * FINER)
        self.background = np.array(to_rgb(palette.BACKGROUND))

    def colours(self, organ, tool, marked=NOTHING, cut=False):
        pixels, depth = render(self.camera, organ, tool, marked, cut)
        self.assertEqual(pixels.shape, (60, 60, 3))
        return pixels, depth

    def assert_hue(self, colour, expected):
        """The same but for how bright it is."""
        ratio = colour / np.array(to_rgb(expected))
        self.assertLess(np.ptp(ratio), 0.02)

    def test_a_projection_keeps_lengths(self):
        seen = self.camera.see(np.array([[1.0, 2, 3]]))
        np.testing.assert_allclose(seen, [[1, 3, -2]], atol=1e-12)

    def test_a_triangle_covers_its_area(self):
        corners = np.array([[-4.0, 0, -4], [4, 0, -4], [4, 0, 4]])
        (fragment,) = fragments(self.camera, self.camera.see(corners), np.array([[0, 1, 2]]))
        self.assertAlmostEqual(fragment.covered.sum() * self.camera.pixel**2, 32, delta=1)
        self.assertAlmostEqual(fragment.to_edge[fragment.covered].max(), 8 / (2 + np.sqrt(2)), delta=0.1)

    def test_outer_inner_and_marked_facets_differ(self):
        far_tool = cube(0.1, (0, 0, 100))
        for facets, marked, expected in ((SQUARE, NOTHING, palette.ORGAN), (SQUARE[:, ::-1], NOTHING, palette.ORGAN_INSIDE),
                                         (SQUARE, np.array([0, 1]), palette.FACET_IN_TOOL)):  # fmt: skip
            pixels, _ = self.colours(Surface(wall(0), facets), far_tool, marked)
            self.assert_hue(pixels[35, 20], expected)
            np.testing.assert_allclose(pixels[1, 1], self.background, atol=1e-6)

    def test_glass_shows_before_the_organ_and_not_behind_it(self):
        alone, _ = self.colours(Surface(wall(0), SQUARE), cube(1, (0, 0, 100)))
        before, _ = self.colours(Surface(wall(0), SQUARE), cube(2, (0, -5, 0)))
        behind, _ = self.colours(Surface(wall(0), SQUARE), cube(2, (0, 5, 0)))
        half_in, _ = self.colours(Surface(wall(0), SQUARE), cube(2))
        np.testing.assert_allclose(behind[30, 25], alone[30, 25], atol=1e-6)
        tints = [np.abs(pixels[30, 25] - alone[30, 25]).max() for pixels in (half_in, before)]
        self.assertGreater(tints[0], 0.05)
        self.assertGreater(tints[1], tints[0])

    def test_a_cut_organ_shows_its_section_with_the_tool_in_it(self):
        pixels, depth = self.colours(cube(4), cube(1, (0, 0, 100)), cut=True)
        np.testing.assert_allclose(pixels[30, 25], to_rgb(palette.ORGAN_SECTION), atol=1e-6)
        self.assertAlmostEqual(depth[90, 75], 0, places=6)
        with_tool, _ = self.colours(cube(4), cube(1), cut=True)
        self.assertGreater(np.abs(with_tool[30, 29] - pixels[30, 29]).max(), 0.05)

    def test_beside_its_section_a_cut_organ_shows_its_outside(self):
        self.camera = camera_from(np.array([1.0, -1, 0]), np.zeros(3), 14, 10, 60 * FINER)
        # The section is left of the edge at (3, 0), the side x = 3 right of it up to (3, 3).
        columns = [round(30 + at / np.sqrt(2) * 60 / 14) for at in (1.5, 4.5)]
        for order in (1, -1):  # in which facets are drawn
            organ = Surface(cube(3).positions, cube(3).facets[::order])
            pixels, _ = render(self.camera, organ, cube(1, (0, 0, 100)), NOTHING, True)
            np.testing.assert_allclose(pixels[21, columns[0]], to_rgb(palette.ORGAN_SECTION), atol=1e-6)
            self.assert_hue(pixels[24, columns[1]], palette.ORGAN)

    def test_edges_are_split_where_the_organ_hides_them(self):
        self.assertEqual(len(sharp_edges(cube(1))), 12)
        _, depth = self.colours(Surface(wall(0), SQUARE), cube(1))
        edge = np.array([[[-0.5, -2.0, -1], [0.5, 2, 1]]])  # through the wall in its middle
        seen, hidden = split_by_sight(self.camera, edge, depth)
        self.assertEqual((len(seen), len(hidden)), (1, 1))
        np.testing.assert_allclose(seen[0][-1], [0, 0], atol=0.1)


if __name__ == "__main__":
    unittest.main()
