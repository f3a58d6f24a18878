"""A sweep by formula for the tests of the report: three strategies of which it is known who leaves least, and what it costs."""

from __future__ import annotations

import json
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from result_file import write_results

from trocar_analysis.errors import InputError
from trocar_analysis.report import html
from trocar_analysis.report.report import ClaimFiles, make_report

ORGANS, SEEDS, SPEEDS = ("sphere@4mm", "liver@4mm"), (1, 2, 3, 4, 5, 6, 7), (20.0, 100.0)
LEFT = {"careful": 1.0, "middling": 2.0, "hasty": 4.0}  # mm: how deep each leaves the organ in the tool
TIMES = {"careful": 9000.0, "middling": 5000.0, "hasty": 1000.0}  # ns
BETTER = {"depth_max": "low", "time_handle": "low", "drag": "low", "tool_volume_inside": "low"}
BUDGET = 1  # MB
PROVENANCE = {
    "git_commit": "abc", "git_dirty": 0, "compiler": "GNU 12", "host": "h", "cpu": "CPU", "argv": "trocar run made-up.toml",
    "start": "2026-01-01T00:00:00Z", "end": "2026-01-01T00:01:00Z", "load": 0.5, "cases": 1,
}  # fmt: skip


def sweep(strategies: tuple[str, ...] = tuple(LEFT), seeds: tuple[int, ...] = SEEDS) -> list[dict]:
    cases = []
    for label in strategies:
        for organ in ORGANS:
            for seed in seeds:
                for speed in SPEEDS:
                    place = 0.01 * seed + (0.5 if organ == ORGANS[1] else 0) + speed / 1000
                    cases.append({
                        "case_id": f"{label}-{organ[:-4]}-{seed}-{speed:.0f}", "label": label, "strategy": label, "organ": organ,
                        "seed": seed, "speed": speed, "depth_max_d_max": LEFT[label] + place, "drag_mean": 3 - place,
                        "time_handle_p99": TIMES[label] + 10 * seed, "provenance_row": 0,
                    })  # fmt: skip
    return cases


def fail(cases: list[dict], which: list[int], status: str = "diverged", reason: str = "a vertex went to infinity") -> None:
    """A failed case has no figures."""
    for number in which:
        cases[number] |= {"status": status, "reason": reason}
        cases[number] |= {name: np.nan for name in ("depth_max_d_max", "drag_mean", "time_handle_p99")}


def read_report(path: Path) -> dict:
    """What the page of a report reads."""
    found = re.search(r'<script type="application/json" id="report">(.*?)</script>', path.read_text("utf-8"), re.S)
    return json.loads(found[1])


class ReportTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file, self.output = self.folder / "out.h5", self.folder / "report.html"
        page = self.folder / "page"
        page.mkdir()
        (page / "page.js").write_text("/* the page's program */")
        (page / "page.css").write_text("/* the page's style */")
        self.enterContext(mock.patch.object(html, "PAGE", page))

    def write(self, cases: list[dict], **more: object) -> None:
        write_results(self.file, cases, provenance=[PROVENANCE], **more)

    def report(self, cases: list[dict] | None = None, budget: float = BUDGET, claims: str | None = None) -> dict:
        if cases is not None:
            self.write(cases)
        self.made = make_report(str(self.file), str(self.output), budget, BETTER, ClaimFiles(claims))
        return read_report(self.output)

    def refused(self, *saying: str, budget: float = BUDGET) -> str:
        """The report is refused with a message that says this, and nothing is written."""
        before = {*self.folder.iterdir()}
        with self.assertRaises(InputError) as raised:
            self.report(budget=budget)
        for words in saying:
            self.assertIn(words, str(raised.exception))
        self.assertEqual({*self.folder.iterdir()}, before)
        return str(raised.exception)
