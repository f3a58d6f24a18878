"""Replays in the report: that they say what the file does, within 0.02 mm, in the budget, and what is left out."""

import base64
import gzip
import re
import unittest

import h5py
import numpy as np
from result_file import ProgramTest, box, dent, sheet, write_results
from trocar_analysis.geometry import distances
from trocar_analysis.report.blocks import KINDS, Blocks
from trocar_analysis.report.contact import contact
from trocar_analysis.report.frames import LEAST, kept_steps
from trocar_analysis.report.lattice import MOST_ERROR
from trocar_analysis.report.replays import pack_replays
from trocar_analysis.store import MOMENTS, ResultFile

ERROR = 0.02  # mm: what the page promises


def read(blocks: Blocks, block: dict) -> np.ndarray:
    """What the page reads."""
    packed = re.search(f'id="{block["block"]}">([^<]*)<', blocks.tags())[1]
    planes = np.frombuffer(gzip.decompress(base64.b64decode(packed)), np.uint8)
    kind = np.dtype(KINDS[block["kind"]])
    return planes.reshape(kind.itemsize, -1).T.copy().view(kind).reshape(block["shape"])


def positions(blocks: Blocks, replay: dict) -> np.ndarray:
    """Three moments a frame, [frames, 3, vertices, 3]."""
    unsigned = read(blocks, replay["positions"]).astype(np.int64)
    numbers = np.cumsum((unsigned >> 1) ^ -(unsigned & 1), axis=0) + read(blocks, replay["organ"]["rest"])
    placed = np.array(replay["organ"]["origin"]) + replay["organ"]["spacing"] * numbers
    return placed.reshape(-1, 3, *placed.shape[1:])


def lists(blocks: Blocks, packed: dict) -> list[np.ndarray]:
    return np.split(read(blocks, packed["values"]), read(blocks, packed["offsets"])[1:-1])


def long_dent(steps: int) -> list[dict]:
    """The dent, and then noise that packs badly, of vertices that fall a little further every step."""
    noise = np.random.default_rng(1)
    result = dent(True)
    while len(result) < steps:
        step = dict(result[-1])
        step |= {moment: step[moment] + noise.normal(0, 0.5, step[moment].shape) for moment in MOMENTS}
        result.append(step | {"moved": np.empty(0, int)})
    return result


class Replays(ProgramTest):
    CASES = (
        {"case_id": "aa11", "label": "clears"},
        {"case_id": "aa22", "label": "leaves"},
        {"case_id": "bb33", "label": "clears", "seed": 2},
        {"case_id": "cc44", "label": "unrecorded"},
    )

    def pack(self, replays: dict, budget: int = 10_000_000):
        write_results(self.file, list(self.CASES), replays)
        return self.packed(budget)

    def packed(self, budget: int = 10_000_000):
        blocks = Blocks()
        with ResultFile(self.file) as results:
            packed, notes = pack_replays(results, results.cases_table(), blocks, budget)
        return {replay["caseId"]: replay for replay in packed}, notes, blocks

    def test_positions_come_back_within_the_error(self):
        self.assertLessEqual(MOST_ERROR, ERROR)
        steps = long_dent(20)
        packed, notes, blocks = self.pack({"aa11": steps})
        stored = np.stack([[step[moment] for moment in MOMENTS] for step in steps])
        errors = np.linalg.norm(positions(blocks, packed["aa11"]) - stored, axis=-1)
        self.assertLessEqual(errors.max(), ERROR)
        self.assertGreater(errors.max(), 0)
        self.assertEqual(notes, [])

    def test_a_vertex_that_flies_far_comes_back_too(self):
        steps = dent(True)
        steps[3]["deformed"] = steps[3]["deformed"] + [5000.0, -70_000.0, 0]
        packed, _, blocks = self.pack({"aa11": steps})
        stored = steps[3]["deformed"].astype(np.float32)
        self.assertLessEqual(np.linalg.norm(positions(blocks, packed["aa11"])[3, 2] - stored, axis=-1).max(), ERROR)

    def test_moved_vertices_time_poses_and_series(self):
        steps = dent(True)
        packed, _, blocks = self.pack({"aa11": steps})
        replay = packed["aa11"]
        for step, moved in zip(steps, lists(blocks, replay["moved"])):
            np.testing.assert_array_equal(moved, step["moved"])
        by = np.concatenate([(step["handled"] - step["found"])[step["moved"]] for step in steps])
        np.testing.assert_allclose(read(blocks, replay["movedBy"]), by, atol=1e-5)
        np.testing.assert_allclose(read(blocks, replay["poses"]), [step["pose"] for step in steps])
        np.testing.assert_array_equal(read(blocks, replay["time"]), np.arange(1, 6) / 30)
        self.assertEqual(replay["series"], ["collided_vertices"])
        np.testing.assert_array_equal(read(blocks, replay["values"])[0], [len(step["moved"]) for step in steps])

    def test_what_is_in_the_tool(self):
        packed, _, blocks = self.pack({"aa11": dent(True), "aa22": dent(False)})
        depths = np.split(read(blocks, packed["aa22"]["depths"]), read(blocks, packed["aa22"]["inside"]["offsets"])[1:-1])
        self.assertAlmostEqual(depths[0].max(), 1, places=5)  # found in the first step, under the tip
        self.assertAlmostEqual(depths[8].max(), 3, places=5)  # in the third the tip is 5 mm in, the tool's wall 3 mm away
        self.assertEqual(depths[14].size, 0)  # the tool is out
        inside = lists(blocks, packed["aa11"]["inside"])
        self.assertGreater(inside[0].size, 0)
        self.assertEqual(inside[1].size, 0)  # handled: they lie on the tip

    def test_siblings_stand_together_and_share_organ_and_tool(self):
        packed, _, blocks = self.pack({case: dent(True) for case in ("aa11", "aa22", "bb33")})
        self.assertEqual([replay["set"] for replay in packed.values()], [0, 0, 1])
        self.assertIn("seed 2", packed["bb33"]["conditions"])
        self.assertEqual(packed["aa11"]["organ"], packed["bb33"]["organ"])
        self.assertEqual(blocks.tags().count('id="organ-'), 2)  # its facets and its rest
        self.assertEqual(blocks.tags().count('id="tool-'), 2)
        self.assertEqual((packed["aa11"]["firstContact"], packed["aa11"]["deepest"]), (0, 2))

    def test_frames_are_thinned_to_the_budget_and_it_is_said(self):
        _, _, everything = self.pack({"aa11": long_dent(60), "aa22": long_dent(60)})
        budget = everything.size() // 2
        packed, notes, blocks = self.packed(budget)
        self.assertLessEqual(blocks.size(), budget)
        self.assertGreater(blocks.size(), budget // 2)
        frames = [read(blocks, replay["frames"]).tolist() for replay in packed.values()]
        self.assertEqual(frames[0], frames[1])
        self.assertLessEqual({0, 1, 2, 3, 4, 59}, set(frames[0]))
        self.assertEqual(len(notes), 1)
        self.assertIn(f"{len(frames[0])} of 60 steps", notes[0])
        stored = long_dent(60)[frames[0][-2]]["handled"]
        self.assertLessEqual(np.linalg.norm(positions(blocks, packed["aa11"])[-2, 1] - stored, axis=-1).max(), ERROR)

    def test_whole_sets_are_dropped_last(self):
        _, _, everything = self.pack({case: long_dent(40) for case in ("aa11", "aa22", "bb33")})
        packed, notes, blocks = self.packed(int(everything.size() / 3 * 0.95))
        self.assertEqual(set(packed), {"aa11", "aa22"})
        self.assertEqual({len(read(blocks, replay["frames"])) for replay in packed.values()}, {LEAST})
        self.assertIn("its 1 case is left out", notes[-1])
        self.assertIn("seed 2", notes[-1])
        packed, notes, blocks = self.packed(100)
        self.assertEqual((packed, blocks.size(), len(notes)), ({}, 0, 2))

    def test_steps_that_are_no_places_are_left_out_and_it_is_said(self):
        steps = dent(True)
        steps[4]["deformed"] = np.full_like(steps[4]["deformed"], np.nan)
        packed, notes, blocks = self.pack({"aa11": steps})
        self.assertEqual(read(blocks, packed["aa11"]["frames"]).tolist(), [0, 1, 2, 3])
        self.assertEqual(len(notes), 1)
        self.assertIn("1 of 5 steps are left out, from step 4 on", notes[0])

    def test_a_file_without_replays(self):
        self.assertEqual(self.pack({})[:2], ({}, []))

    def test_a_damaged_replay_is_named(self):
        write_results(self.file, list(self.CASES), {"aa11": dent(True)})
        with h5py.File(self.file, "r+") as file:
            del file["replay/aa11/moved_by"]
        with self.assertRaisesRegex(Exception, "is damaged"):
            self.packed()


class Parts(unittest.TestCase):
    def test_kept_steps(self):
        self.assertEqual(kept_steps(10, [3], 20).tolist(), list(range(10)))
        kept = kept_steps(100, [20, 50], 30)
        self.assertEqual(len(kept), 30)
        self.assertLessEqual({0, 18, 19, 20, 21, 22, 48, 49, 50, 51, 52, 99}, set(kept.tolist()))
        self.assertLessEqual(np.diff(kept).max(), 7)
        self.assertEqual(len(kept_steps(100, [20], 1)), LEAST)

    def test_distances_to_triangles(self):
        corners = np.array([[[0.0, 0, 0], [4, 0, 0], [0, 4, 0]]])
        points = np.array([[1.0, 1, 2], [2, -3, 0], [-3, -4, 0], [4, 4, 0], [1, 1, 0]])
        np.testing.assert_allclose(distances(points, corners), [2, 3, 5, 8**0.5, 0], atol=1e-12)

    def test_a_vertex_on_the_tool_is_not_inside(self):
        positions, facets = sheet()
        tool, tool_facets = box()
        self.assertEqual(contact(positions, facets, tool + [0, 0, -1e-6], tool_facets).vertices.size, 0)
        touching = contact(positions, facets, tool - [0, 0, 1.0], tool_facets)
        self.assertEqual(touching.vertices.size, 9)
        np.testing.assert_allclose(touching.depths, 1)


if __name__ == "__main__":
    unittest.main()
