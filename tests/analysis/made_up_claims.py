"""Claims and results whose verdicts are known because they were made that way, and the claims judged on them."""

from __future__ import annotations

import json
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

from result_file import write_results
from trocar_analysis.claims.reproduce import reproduce

ORGANS = ("sphere@4mm", "liver@4mm", "tube@4mm")
SEEDS = (1, 2, 3, 4)  # on three organs: as many as an interval needs
RELEASES = ("contact", "step")
BETTER = {"depth_max": "low", "edge_ratio_mean": "high", "drag": "low", "flipped_facets": "low"}

CLAIM = """
[[claim]]
id = "{id}"
place = "Fig. 1"
says = "something"
data = "{data}"
"""


def claim(*conditions: str, name: str = "C1", data: str = "runs", more: str = "") -> str:
    return CLAIM.format(id=name, data=data) + more + "".join(f"[[claim.condition]]\n{one}\n" for one in conditions)


def place_of(organ: str, seed: int) -> float:
    """What has nothing to do with strategies, and differs from place to place by far more than they do."""
    return 1000.0 * (1 + ORGANS.index(organ) if organ in ORGANS else 9) + 37.0 * seed**2


def runs(
    label: str, value: float | Callable[[str, int], float], organs: tuple = ORGANS, seeds: tuple = SEEDS,
    releases: tuple = ("contact",), figure: str = "depth_max_d_max", **more: object,
) -> list[dict]:  # fmt: skip
    """A case for each organ, seed and release, with this value of the figure or what it gives of organ and seed."""
    cases = []
    for organ in organs:
        for seed in seeds:
            for release in releases:
                case = {"label": label, "organ": organ, "seed": seed, "release": release, "fractions": 1} | more
                case["case_id"] = " ".join(map(str, case.values()))
                case[figure] = float(value(organ, seed) if callable(value) else value)
                cases.append(case)
    return cases


def worked(value: float) -> Callable[[str, int], float]:
    """A figure that is `value` more than what the place alone makes."""
    return lambda organ, seed: place_of(organ, seed) + value


def answers(cases: list[dict], label: str, *steps: dict) -> list[dict]:
    """What `label` answered to the states of these runs: a row of figures for each step."""
    own = {"strategy": label, "options": "{}", "label": label, "reason": ""}
    return [own | {"case_id": case["case_id"], "step": k} | row for case in cases for k, row in enumerate(steps)]


class ClaimsTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file, self.claims = self.folder / "out.h5", self.folder / "claims.toml"

    def write(self, claims: str, cases: list[dict], states: list[dict] | None = None) -> None:
        self.claims.write_text(claims, encoding="utf-8")
        columns = {name for case in cases for name in case}
        nothing = dict.fromkeys(columns - {"status"}, 0.0)
        write_results(self.file, [nothing | case for case in cases], states=states)

    def told(self, style: str = "text", better: dict | None = None, turns: str | None = None) -> str:
        return reproduce(str(self.claims), str(self.file), turns, None, BETTER if better is None else better, style)

    def judged(
        self, claims: str, cases: list[dict], states: list[dict] | None = None, release: str = "contact",
        organs: str = "verdicts", **more: object,
    ) -> dict[str, dict]:  # fmt: skip
        """The verdict of each claim under one release, as --json has it."""
        self.write(claims, cases, states)
        return {one["id"]: one[organs][release] for one in json.loads(self.told("json", **more))}

    def verdict(self, claims: str, cases: list[dict], states: list[dict] | None = None, **more: object) -> str:
        """That of the only claim."""
        (found,) = self.judged(claims, cases, states, **more).values()
        return found["verdict"]

    def conditions(
        self, claims: str, cases: list[dict], states: list[dict] | None = None, **more: object
    ) -> list[dict]:
        (found,) = self.judged(claims, cases, states, **more).values()
        return found["conditions"]
