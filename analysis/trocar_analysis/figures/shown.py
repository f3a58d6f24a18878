"""What a panel shows: the case and the step that its description means, and what is said of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..errors import InputError
from ..store import ResultFile, Step
from ..subject import CASES
from ..summary import only_rows
from ..view import View, choose_view
from .figure_file import Panel
from .steps import choose_step


@dataclass(frozen=True)
class Shown:
    """A panel, and the step that it shows."""

    panel: Panel
    case: pd.Series
    number: int
    step: Step
    way: np.ndarray  # the tip's in this step, mm; in the first step, of which no way is stored, that of the next
    view: View  # `snapshot`'s of this step


def find_step(results: ResultFile, cases: pd.DataFrame, panel: Panel) -> Shown:
    filters = [f"{key}={value}" for key, value in panel.where.items()]
    found = only_rows(cases, filters, [name for name in CASES.keys if name in cases])
    if len(found) > 1:
        differ = [name for name in CASES.keys if name in found and found[name].nunique() > 1 and name != "case_id"]
        raise InputError(f"{len(found)} cases match its `where`; they differ in {', '.join(differ)}")
    case = found.iloc[0]
    number = choose_step(results, case["case_id"], panel.step)
    step = results.step(case["case_id"], number)
    for name in panel.facts:
        results.series(case["case_id"], name)
    poses = results.tool_poses(case["case_id"])
    way = np.diff(poses[:, :3, 3], axis=0)[max(number - 1, 0)] if len(poses) > 1 else step.tool_way
    return Shown(panel, case, number, step, way, choose_view(step.rest_positions, step.tool_positions, poses, number))


def check_same_state(description: str, one: Shown, other: Shown) -> None:
    """That both strategies were asked about the same: the organ as it was found, to the last bit, and the tool."""
    for what, mine, its in (
        ("organ", one.step.positions["found"], other.step.positions["found"]),
        ("tool", one.step.tool_positions, other.step.tool_positions),
    ):
        if not np.array_equal(mine, its):
            raise InputError(
                f"{description}: panel {one.panel.letter} (step {one.number}) does not show the state of panel "
                f"{other.panel.letter} (step {other.number}): the {what} is somewhere else"
            )


def differing(shown: list[Shown]) -> list[str]:
    """The conditions that have to be said of each panel."""
    return [name for name in ("organ", "speed") if len({one.case[name] for one in shown}) > 1]


def conditions(case: pd.Series, names: list[str]) -> list[str]:
    """Such as "prism-12", "20 mm/s" and "seed 1"."""
    words = {"speed": "{:g} mm/s", "release": "release {}", "seed": "seed {}"}
    return [words.get(name, "{}").format(case[name]) for name in names if name in case]


def facts(one: Shown) -> list[str]:
    """The panel's words, with each series' value in this step in them. What does not exist is a dash."""
    values = {name: one.step.values[name] for name in one.panel.facts}
    return [words.replace("{}", f"{values[name]:.3g}" if np.isfinite(values[name]) else "–")
            for name, words in one.panel.facts.items()]  # fmt: skip
