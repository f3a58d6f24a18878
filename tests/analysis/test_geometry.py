"""Sections and insides against shapes with a known answer."""

import unittest

import numpy as np
from result_file import box, sheet
from trocar_analysis.geometry import behind_plane, facet_normals, facets_in_tool, inside, section


def polygon_area(points):
    """Area enclosed in the plane of the last two coordinates; positive when counter-clockwise."""
    x, y = points[:, 1], points[:, 2]
    return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


class Geometry(unittest.TestCase):
    def test_section_of_a_closed_mesh_is_closed(self):
        positions, facets = box()
        (line,) = section(positions, facets, positions[:, 0] - 0.5)
        np.testing.assert_array_equal(line[0], line[-1])
        np.testing.assert_allclose(line[:, 0], 0.5)
        self.assertAlmostEqual(abs(polygon_area(line[:-1])), 6 * 40)

    def test_section_of_two_boxes_runs_the_same_way_around_both(self):
        positions, facets = box()
        both = np.concatenate([positions, positions + [0, 10, 0]])
        lines = section(both, np.concatenate([facets, facets + 8]), both[:, 0] - 0.5)
        areas = [polygon_area(line[:-1]) for line in lines]
        self.assertEqual(len(areas), 2)
        self.assertAlmostEqual(areas[0], areas[1])

    def test_section_of_a_sheet_is_open(self):
        positions, facets = sheet()
        (line,) = section(positions, facets, positions[:, 0] - 0.5)
        self.assertAlmostEqual(np.ptp(line[:, 1]), 40)

    def test_no_section_beside_the_mesh(self):
        positions, facets = box()
        self.assertEqual(section(positions, facets, positions[:, 0] - 5), [])

    def test_what_is_behind_a_plane_keeps_its_area(self):
        positions, facets = sheet()
        polygons, rows = behind_plane(positions, facets, positions[:, 0] - 0.5)
        fans = [np.cross(p[1:-1] - p[0], p[2:] - p[0]) for p in polygons]
        area = sum(np.linalg.norm(fan, axis=1).sum() / 2 for fan in fans)
        self.assertAlmostEqual(area, 20.5 * 40)
        self.assertEqual(len(polygons), len(rows))
        self.assertLessEqual(max(p[:, 0].max() for p in polygons), 0.5)

    def test_inside(self):
        points = np.array([[0, 0, 1], [2.9, 2.9, 39], [3.1, 0, 1], [0, 0, -1], [0, 0, 41.0]])
        self.assertEqual(inside(points, *box()).tolist(), [True, True, False, False, False])

    def test_normals_point_out_of_the_box(self):
        positions, facets = box()
        middles = positions[facets].mean(axis=1) - [0, 0, 20]
        self.assertTrue(((facet_normals(positions, facets) * middles).sum(axis=1) > 0).all())

    def test_facets_in_tool(self):
        positions, facets = sheet()
        tool, tool_facets = box()
        self.assertFalse(facets_in_tool(positions, facets, tool + [0, 0, 0.1], tool_facets).any())
        flags = facets_in_tool(positions, facets, tool - [0, 0, 1], tool_facets)
        middles = positions[facets].mean(axis=1)
        np.testing.assert_array_equal(flags[(np.abs(middles[:, :2]) < 3).all(axis=1)], True)
        np.testing.assert_array_equal(flags[(np.abs(middles[:, :2]) > 4).any(axis=1)], False)

    def test_a_tool_within_one_facet_crosses_it(self):
        corners = np.array([[-50.0, -50, 0], [50, -50, 0], [0, 80, 0]])
        tool, tool_facets = box()
        self.assertTrue(facets_in_tool(corners, np.array([[0, 1, 2]]), tool - [0, 0, 5], tool_facets).all())


if __name__ == "__main__":
    unittest.main()
