"""Which files an export consists of."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ..errors import InputError
from ..store import INPUTS, ResultFile, Step, find_case
from .folder import MARK, OWNER, filled
from .obj import obj_text
from .ply import ply_bytes
from .surface import organ_of, tool_of
from .vtp import pvd_text, vtp_bytes

CONTENT = {"obj": lambda surface: obj_text(surface).encode(), "ply": ply_bytes, "vtp": vtp_bytes}


@dataclass(frozen=True)
class Wishes:
    """What of the file is wanted."""

    case: str  # the beginning of its id
    formats: list[str]
    moments: list[str]
    steps: str | None  # "A:B", either may be missing; None for all


def export_case(path: str, output: str, wishes: Wishes) -> str:
    """Fills the folder `output` and returns a line that says with what."""
    with ResultFile(path) as results:
        case = find_case(results.cases_table(), wishes.case)
        count = len(results.tool_poses(case["case_id"]))
        numbers = chosen_steps(wishes.steps, count)
        with filled(Path(output)) as folder:
            times = [write_step(folder, results.step(case["case_id"], k), k, case, wishes) for k in numbers]
            if "vtp" in wishes.formats:
                for moment in wishes.moments:
                    write_collection(folder, moment, numbers, times)
            write_mark(folder, Path(path).name, case, wishes, dict(zip(map(str, numbers), times)))
            files = sum(1 for _ in folder.iterdir())
    return (
        f"{output}: {len(numbers)} of {count} steps of {case['label']} ({case['case_id']}), organ "
        f"{' and '.join(wishes.moments)}, as {', '.join(wishes.formats)}: {files} files"
    )


def chosen_steps(asked: str | None, count: int) -> range:
    if asked is None:
        return range(count)
    first, colon, end = asked.partition(":")
    if not colon or not all(part.isdecimal() for part in (first, end) if part):
        raise InputError(f"--steps {asked}: expected A:B, two whole numbers from 0 of which either may be left out")
    steps = range(int(first or 0), int(end or count))
    if not steps or steps.stop > count:
        raise InputError(f"--steps {asked}: is out of range or empty; the case has steps 0 to {count - 1}")
    return steps


def write_step(folder: Path, step: Step, number: int, case: pd.Series, wishes: Wishes) -> float:
    """Organ and tool of one step. Returns its time, s."""
    time = step.values.get("time")
    if time is None:
        raise InputError(f"case {case['case_id']} has no series time; run its sweep again")
    words = f"{case['label']} ({case['case_id']}), step {number}, {time:.6g} s, in mm"
    surfaces = [organ_of(step, moment, words, time) for moment in wishes.moments]
    for surface in (*surfaces, tool_of(step, words, time)):
        for ending in wishes.formats:
            (folder / file_name(surface.name, number, ending)).write_bytes(CONTENT[ending](surface))
    return time


def write_collection(folder: Path, moment: str, numbers: range, times: list[float]) -> None:
    files = [[file_name(name, k, "vtp") for name in (f"organ_{moment}", "tool")] for k in numbers]
    (folder / f"{moment}.pvd").write_text(pvd_text(times, files), encoding="utf-8")


def write_mark(folder: Path, source: str, case: pd.Series, wishes: Wishes, times: dict[str, float]) -> None:
    """What the export is of, for people and for the next export into the same folder."""
    inputs = {name: plain(case[name]) for name in INPUTS if name in case}
    said = {
        "generator": OWNER, "result_file": source, "case": inputs, "moments": wishes.moments, "length_unit": "mm",
        "time_of_step_in_s": times,
    }  # fmt: skip
    (folder / MARK).write_text(json.dumps(said, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def plain(value: object) -> object:
    """A number of numpy's as one of Python's."""
    return value.item() if hasattr(value, "item") else value


def file_name(surface: str, number: int, ending: str) -> str:
    return f"{surface}_{number:04}.{ending}"
