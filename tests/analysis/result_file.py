"""Result files for the tests, in the layout of results/README.md, and the program run on them."""

from __future__ import annotations

import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import IO

import h5py
import numpy as np

ANALYSIS = Path(__file__).resolve().parents[2] / "analysis"

UNITS = {
    "speed": "mm/s", "rate": "Hz", "depth_max_d_max": "mm", "drag_mean": "mm", "time_handle_p50": "ns", "time_handle_p99": "ns",
    "depth_max_h": "mm", "drag": "mm", "displacement_mean": "mm",
    "tool_volume_inside_d_max": "mm³", "tool_volume_at_rest_max": "mm³", "time_cycle_p50": "ns",
}  # fmt: skip

CASE = {
    "build_id": "b1", "strategy": "nearest-face", "options": "{}", "label": "", "organ": "sphere",
    "tool": "prism-4", "scene": "penetration", "speed": 100.0, "rate": 30.0, "release": "contact", "seed": 1,
    "status": "complete", "reason": "", "depth_max_d_max": 0.0, "time_handle_p50": 1000.0,
}  # fmt: skip


def write_results(
    path: Path, cases: list[dict], replays: dict[str, list[dict]] | None = None, states: list[dict] | None = None,
    provenance: list[dict] | None = None,
) -> None:  # fmt: skip
    """Cases are CASE with the given values over it; replays are steps per case id (see dent()); states and provenance
    are rows of these tables. All cases have the columns of the first, and so have all rows of the others."""
    with h5py.File(path, "w") as file:
        file.attrs.update(schema_version=2, complete=1, generator="test")
        for name in ("cases", "series", "states", "replay", "provenance"):
            file.create_group(name)
        write_table(file["cases"], [CASE | case for case in cases])
        write_table(file["states"], [{"state": row} | state for row, state in enumerate(states or [])])
        write_table(file["provenance"], provenance or [])
        for case_id, steps in (replays or {}).items():
            write_replay(file, case_id, steps)


def write_table(group: h5py.Group, rows: list[dict]) -> None:
    for name in rows[0] if rows else ():
        values = [row[name] for row in rows]
        is_text = isinstance(values[0], str)
        column = group.create_dataset(name, data=values, dtype=h5py.string_dtype() if is_text else None)
        column.attrs["units"] = UNITS.get(name, "" if is_text else "1")


def write_replay(file: h5py.File, case_id: str, steps: list[dict]) -> None:
    organ, facets = sheet()
    tool, tool_facets = box()
    group = file.create_group(f"replay/{case_id}")
    for moment in ("found", "handled", "deformed"):
        group[moment] = np.array([step[moment] for step in steps], np.float32)
    group["facets"], group["rest_positions"] = facets, organ.astype(np.float32)
    group["tool_facets"], group["tool_positions"] = tool_facets, tool.astype(np.float32)
    group["tool_pose"] = np.array([step["pose"] for step in steps], np.float32)
    group["moved"] = np.concatenate([step["moved"] for step in steps]).astype(np.int32)
    group["moved_by"] = np.concatenate([(step["handled"] - step["found"])[step["moved"]] for step in steps])
    group["moved_offsets"] = np.cumsum([0, *(len(step["moved"]) for step in steps)])
    file[f"series/{case_id}/time"] = np.arange(1, len(steps) + 1) / 30
    file[f"series/{case_id}/collided_vertices"] = np.array([float(len(step["moved"])) for step in steps])


def sheet() -> tuple[np.ndarray, np.ndarray]:
    """A flat square of 40 mm, vertices 2 mm apart, normals along +z."""
    side = 21
    x, y = np.meshgrid(np.linspace(-20, 20, side), np.linspace(-20, 20, side), indexing="ij")
    first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).reshape(-1)
    halves = [(first, first + side, first + side + 1), (first, first + side + 1, first + 1)]
    facets = np.concatenate([np.stack(half, axis=1) for half in halves])
    return np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1), facets


def box() -> tuple[np.ndarray, np.ndarray]:
    """A closed box, 6 × 6 mm wide and 40 mm long, the tip's middle at the origin."""
    corners = np.array([(x, y, z) for x in (-3.0, 3.0) for y in (-3.0, 3.0) for z in (0.0, 40.0)])
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))])


def dent(clears: bool) -> list[dict]:
    """Five steps: the tool's tip is 1, 3, 5 and 5 mm deep, then 4 mm clear. Vertices inside the tool go to its
    tip when the strategy `clears`, else nowhere."""
    steps = []
    positions, _ = sheet()
    for tip in (-1.0, -3.0, -5.0, -5.0, 4.0):
        pose = np.eye(4)
        pose[2, 3] = tip
        inside = (np.abs(positions[:, :2]) < 3).all(axis=1) & (positions[:, 2] > tip)
        handled = positions.copy()
        if clears:
            handled[inside, 2] = tip - 0.01
        moved = np.flatnonzero(inside) if clears else np.array([], int)
        moments = {"found": positions, "handled": handled, "deformed": handled}
        steps.append(moments | {"pose": pose, "moved": moved})
        positions = handled
    return steps


class ProgramTest(unittest.TestCase):
    """Runs the program in a folder of its own, as users do."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file = self.folder / "out.h5"

    def run_program(
        self, *arguments: object, path_first: Path | None = None, stdout: int | IO[str] = subprocess.PIPE
    ) -> subprocess.CompletedProcess[str]:
        path = os.pathsep.join(map(str, [*([path_first] if path_first else []), ANALYSIS]))
        return subprocess.run(
            ["/usr/bin/python3", "-B", "-m", "trocar_analysis", *map(str, arguments)],
            env=os.environ | {"PYTHONPATH": path, "PYTHONIOENCODING": "utf-8"},
            cwd=self.folder, stdout=stdout, stderr=subprocess.PIPE, encoding="utf-8", check=False,
        )  # fmt: skip

    def output_of(self, *arguments: object) -> str:
        done = self.run_program(*arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def assert_refused(self, *arguments: object, saying: list[str], path_first: Path | None = None) -> None:
        done = self.run_program(*arguments, path_first=path_first)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for words in saying:
            self.assertIn(words, done.stderr)
