"""`export`: which files it leaves, what is in them, and what it leaves alone. tests/export/ has VTK read them."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py
import numpy as np

from result_file import ANALYSIS, ProgramTest, box, dent, sheet, write_results


class Export(ProgramTest):
    def setUp(self) -> None:
        super().setUp()
        cases = [{"case_id": "a1", "label": "clears"}, {"case_id": "a2"}, {"case_id": "b1"}]
        write_results(self.file, cases, {"a1": dent(True), "b1": dent(False)})
        self.case = self.folder / "case"

    def names(self) -> list[str]:
        return sorted(path.name for path in self.case.iterdir())

    def export(self, *more: object) -> str:
        return self.output_of("export", self.file, "--case", "a1", "-o", self.case, *more)

    def test_every_step_in_every_format(self) -> None:
        said = self.export()
        endings = ("obj", "ply", "vtp")
        steps = [f"{name}_{k:04}.{ending}" for name in ("organ_deformed", "tool") for k in range(5) for ending in endings]
        self.assertEqual(self.names(), sorted([*steps, "case.json", "deformed.pvd"]))
        self.assertIn("5 of 5 steps of clears (a1)", said)

    def test_only_what_is_asked_for(self) -> None:
        self.export("--format", "obj", "--moment", "found", "--moment", "handled", "--steps", "2:4")
        self.assertEqual(
            self.names(),
            ["case.json", *(f"{name}_000{k}.obj" for name in ("organ_found", "organ_handled", "tool") for k in (2, 3))],
        )

    def test_obj_has_the_stored_positions(self) -> None:
        self.export("--format", "obj", "--moment", "found", "--moment", "handled", "--steps", "1:")
        for moment in ("found", "handled"):
            points, facets = read_obj(self.case / f"organ_{moment}_0003.obj")
            np.testing.assert_array_equal(points.astype(np.float32), dent(True)[3][moment].astype(np.float32))
            np.testing.assert_array_equal(facets, sheet()[1])
        points, facets = read_obj(self.case / "tool_0003.obj")
        np.testing.assert_allclose(points, box()[0] + [0, 0, -5], atol=1e-6)
        np.testing.assert_array_equal(facets, box()[1])

    def test_obj_has_nine_digits(self) -> None:
        with h5py.File(self.file, "a") as file:
            file["replay/a1/deformed"][0, 7] = (1 / 3, -2e-7, 123.456)
        self.export("--format", "obj", "--steps", ":1")
        points, _ = read_obj(self.case / "organ_deformed_0000.obj")
        np.testing.assert_array_equal(points[7].astype(np.float32), np.array([1 / 3, -2e-7, 123.456], np.float32))

    def test_ply_is_binary_with_the_stored_bytes(self) -> None:
        self.export("--format", "ply", "--moment", "handled")
        header, _, body = (self.case / "organ_handled_0002.ply").read_bytes().partition(b"end_header\n")
        self.assertTrue(header.startswith(b"ply\nformat binary_little_endian 1.0\n"), header)
        self.assertIn(b"element vertex 441\n", header)
        self.assertIn(b"element face 800\n", header)
        points = np.frombuffer(body[: 441 * 12], "<f4").reshape(-1, 3)
        np.testing.assert_array_equal(points, dent(True)[2]["handled"].astype(np.float32))
        faces = np.frombuffer(body[441 * 12 :], np.dtype([("count", "u1"), ("at", "<i4", 3)]))
        self.assertEqual(set(faces["count"]), {3})
        np.testing.assert_array_equal(faces["at"], sheet()[1])

    def test_pvd_has_the_times_and_both_surfaces(self) -> None:
        self.export("--format", "vtp", "--moment", "handled", "--steps", "1:3")
        sets = xml.etree.ElementTree.parse(self.case / "handled.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual(
            [(float(one.get("timestep")), one.get("part"), one.get("file")) for one in sets],
            [(time, part, f"{name}_000{step}.vtp") for step, time in ((1, 2 / 30), (2, 3 / 30))
             for part, name in (("0", "organ_handled"), ("1", "tool"))],
        )  # fmt: skip

    def test_the_mark_says_what_it_is_of(self) -> None:
        self.export("--steps", "1:2")
        said = json.loads((self.case / "case.json").read_text())
        self.assertEqual((said["case"]["case_id"], said["case"]["speed"], said["result_file"]), ("a1", 100.0, "out.h5"))
        self.assertEqual(said["time_of_step_in_s"], {"1": 2 / 30})

    # What it leaves alone

    def test_an_earlier_export_is_replaced(self) -> None:
        self.export("--format", "obj")
        (self.case / "replay.xdmf").write_text("of the program")
        (self.case / ".unfinished.elsewhere.1").mkdir()
        self.export("--format", "ply", "--steps", ":1")
        self.assertEqual(self.names(), ["case.json", "organ_deformed_0000.ply", "tool_0000.ply"])

    def test_other_things_are_left_alone(self) -> None:
        self.case.mkdir()
        for name in ("notes.txt", "tool_0000.obj"):  # the second is called like an export's, without its mark
            other = self.case / name
            other.write_text("mine")
            self.assert_refused("export", self.file, "--case", "a1", "-o", self.case, saying=[f"holds {name}"])
            self.assertEqual((self.names(), other.read_text()), ([name], "mine"))
            other.unlink()
        self.export("--format", "obj")
        (self.case / "notes.txt").write_text("mine")
        before = self.names()
        self.assert_refused("export", self.file, "--case", "a1", "-o", self.case, saying=["holds notes.txt"])
        self.assertEqual(self.names(), before)

    def test_bad_usage(self) -> None:
        for more, words in (
            (("--case", "a"), ["case 'a' is not unique: a1, a2"]),
            (("--case", "c"), ["no case 'c'"]),
            (("--case", "a2"), ["case a2 has no replay", "--replay"]),
            (("--case", "a1", "--steps", "3"), ["--steps 3: expected A:B"]),
            (("--case", "a1", "--steps", "2:9"), ["--steps 2:9: is out of range", "steps 0 to 4"]),
            (("--case", "a1", "--steps", "2:2"), ["--steps 2:2: is out of range or empty"]),
            (("--case", "a1", "--format", "stl"), ["'stl'", "obj"]),
        ):
            with self.subTest(more):
                self.assert_refused("export", self.file, *more, "-o", self.case, saying=words)
                self.assertFalse(self.case.exists())

    def test_a_file_in_the_way(self) -> None:
        self.case.write_text("mine")
        self.assert_refused("export", self.file, "--case", "a1", "-o", self.case, saying=["case: cannot be written"])
        self.assertEqual(self.case.read_text(), "mine")

    def test_a_damaged_replay_leaves_the_earlier_export(self) -> None:
        self.export("--format", "obj")
        before = {name: (self.case / name).read_bytes() for name in self.names()}
        with h5py.File(self.file, "a") as file:
            del file["replay/a1/handled"]
        self.assert_refused("export", self.file, "--case", "a1", "-o", self.case, saying=["is damaged"])
        self.assertEqual({name: (self.case / name).read_bytes() for name in self.names()}, before)

    def test_a_killed_export_leaves_nothing_that_looks_whole(self) -> None:
        write_results(self.file, [{"case_id": "a1"}], {"a1": dent(True) * 40})
        self.export("--format", "ply", "--steps", ":1")
        before = self.names()
        command = ["/usr/bin/python3", "-B", "-m", "trocar_analysis", "export", self.file, "--case", "a1", "-o", self.case]
        killed = subprocess.Popen(command, env=os.environ | {"PYTHONPATH": str(ANALYSIS)}, cwd=self.folder)
        while killed.poll() is None and len(list(self.case.glob(".unfinished.*/*.vtp"))) < 2:
            pass
        killed.kill()
        self.assertEqual(killed.wait(), -signal.SIGKILL, "it was done too soon to be killed")
        self.assertEqual([name for name in self.names() if not name.startswith(".unfinished.")], before)
        self.export("--format", "ply", "--steps", ":1")
        self.assertEqual(self.names(), before)

    def test_a_full_disk_leaves_the_earlier_export(self) -> None:
        self.case.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", self.case], capture_output=True, text=True)
        if mounted.returncode != 0:
            self.skipTest(f"cannot mount a small disk here ({mounted.stderr.strip()})")
        self.addCleanup(subprocess.run, ["umount", "-l", self.case], check=True)
        self.export("--format", "ply", "--steps", ":2")
        before = {name: (self.case / name).read_bytes() for name in self.names()}
        self.assert_refused("export", self.file, "--case", "a1", "-o", self.case, saying=["cannot be written", "No space left"])
        self.assertEqual({name: (self.case / name).read_bytes() for name in self.names()}, before)


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray]:
    lines = [line.split() for line in path.read_text().splitlines()]
    points = np.array([line[1:] for line in lines if line[0] == "v"], float)
    return points, np.array([line[1:] for line in lines if line[0] == "f"], int) - 1


if __name__ == "__main__":
    unittest.main()
