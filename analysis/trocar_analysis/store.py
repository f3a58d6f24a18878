"""Access to a result file. The only place that knows how the file is laid out (results/README.md)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np
import pandas as pd

from .errors import InputError, unknown

SCHEMA_VERSION = 1

# Columns of /cases that say what was run and how it ended; every other column is a figure.
INPUTS = (
    "case_id", "build_id", "strategy", "options", "label", "organ", "organ_facets", "tool", "scene",
    "speed", "rate", "release", "fractions", "seed",
)  # fmt: skip
OUTCOME = ("status", "reason", "attempts", "wall_s", "provenance_row")

# What two cases must have in common to differ in nothing but the strategy.
CONDITIONS = ("scene", "organ", "tool", "speed", "rate", "release", "fractions", "seed")

MOMENTS = ("found", "handled", "deformed")

MOST_LISTED = 20  # cases in a message


@dataclass(frozen=True)
class Step:
    """One step of a case, as it was recorded for replay."""

    positions: dict[str, np.ndarray]  # per moment: organ vertices, mm, [vertices, 3]
    rest_positions: np.ndarray  # organ vertices at rest, mm, [vertices, 3]
    facets: np.ndarray  # of the organ, [facets, 3]
    tool_positions: np.ndarray  # tool vertices at this step, in world coordinates, mm, [vertices, 3]
    tool_facets: np.ndarray  # [facets, 3]
    tool_way: np.ndarray  # of the tool's tip in this step, mm, [3]; zero in the first step
    moved: np.ndarray  # numbers of the vertices that the strategy displaced
    values: dict[str, float]  # the step's value of every series of the case; "time" in s


class ResultFile:
    """An open result file. Use it in a `with` statement. Raises InputError for what is no Trocar result."""

    def __init__(self, path: str | Path):
        self.path = Path(path)
        if not self.path.exists():
            raise InputError(f"{self.path}: no such file")
        if self.path.is_dir():
            raise InputError(f"{self.path}: is a folder; give the result file (.h5) in it")
        try:
            self._file = h5py.File(self.path, "r")
        except OSError as error:
            raise InputError(f"{self.path}: cannot be read as an HDF5 file ({one_line(error)})") from error
        try:
            self._check()
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> ResultFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def _check(self) -> None:
        version = self._file.attrs.get("schema_version")
        if version is None or not isinstance(self._file.get("cases"), h5py.Group):
            raise InputError(f"{self.path}: is no Trocar result (it has no schema_version or no /cases)")
        if int(version) != SCHEMA_VERSION:
            raise InputError(
                f"{self.path}: was written with schema {int(version)}, this program reads schema "
                f"{SCHEMA_VERSION}; use the trocar that wrote it, or run the sweep again"
            )
        if self._file.attrs.get("complete") != 1:
            raise InputError(f"{self.path}: is not whole; remove it and run its sweep again")
        missing = {"case_id", "strategy", "status"} - set(self._file["cases"])
        if missing:
            raise InputError(f"{self.path}: is damaged: /cases has no column {', '.join(sorted(missing))}")

    def cases_table(self) -> pd.DataFrame:
        """/cases, one row per case. A case without a label has its strategy's name as label."""
        with self._reading():
            columns = {name: read_column(dataset) for name, dataset in self._file["cases"].items()}
        lengths = {len(values) for values in columns.values()}
        if len(lengths) != 1:
            raise InputError(f"{self.path}: is damaged: the columns of /cases differ in length")
        cases = pd.DataFrame(columns)
        label = cases.get("label", pd.Series("", index=cases.index))
        cases["label"] = label.where(label != "", cases["strategy"])
        return cases

    def units(self) -> dict[str, str]:
        """The unit of each column of /cases; "" for text and plain numbers."""
        units = {name: text(dataset.attrs.get("units", "")) for name, dataset in self._file["cases"].items()}
        return {name: "" if unit == "1" else unit for name, unit in units.items()}

    def has_replay(self, case_id: str) -> bool:
        return f"replay/{case_id}" in self._file

    def tool_poses(self, case_id: str) -> np.ndarray:
        """Tool frame to world at the end of each step, [steps, 4, 4], mm."""
        with self._reading():
            return self._replay(case_id)["tool_pose"][...].astype(float)

    def step(self, case_id: str, number: int) -> Step:
        """Step `number` (from 0) of a case that has a replay."""
        with self._reading():
            return self._read_step(case_id, number)

    def _read_step(self, case_id: str, number: int) -> Step:
        replay = self._replay(case_id)
        pose, before = (replay["tool_pose"][k].astype(float) for k in (number, max(number - 1, 0)))
        offsets = replay["moved_offsets"]
        return Step(
            positions={moment: replay[moment][number].astype(float) for moment in MOMENTS},
            rest_positions=replay["rest_positions"][...].astype(float),
            facets=replay["facets"][...],
            tool_positions=replay["tool_positions"][...] @ pose[:3, :3].T + pose[:3, 3],
            tool_facets=replay["tool_facets"][...],
            tool_way=pose[:3, 3] - before[:3, 3],
            moved=replay["moved"][int(offsets[number]) : int(offsets[number + 1])],
            values={
                name: float(series[number])
                for name, series in self._file.get(f"series/{case_id}", {}).items()
                if number < len(series)
            },
        )

    @contextmanager
    def _reading(self) -> Iterator[None]:
        """Turns what h5py raises for a damaged file into an InputError."""
        try:
            yield
        except (OSError, KeyError, ValueError, IndexError, RuntimeError) as error:
            raise InputError(f"{self.path}: is damaged ({one_line(error)}); run its sweep again") from error

    def _replay(self, case_id: str) -> h5py.Group:
        if not self.has_replay(case_id):
            raise InputError(
                f"{self.path}: case {case_id} has no replay; record one with `trocar run … --replay`"
            )
        return self._file["replay"][case_id]


def find_case(cases: pd.DataFrame, prefix: str) -> pd.Series:
    """The one case whose id starts with `prefix`."""
    matches = cases[cases["case_id"].str.startswith(prefix)]
    if len(matches) == 1:
        return matches.iloc[0]
    exact = cases[cases["case_id"] == prefix]
    if len(exact) == 1:
        return exact.iloc[0]
    if matches.empty:
        raise unknown("case", prefix, cases["case_id"])
    several = ", ".join(matches["case_id"].head(5))
    raise InputError(f"case '{prefix}' is not unique: {several}; give more of the id")


def only_case(cases: pd.DataFrame) -> pd.Series:
    """The first of `cases` when they are all under the same conditions; else a message that lists them."""
    if len(cases) == len(siblings(cases, cases.iloc[0])):
        return cases.iloc[0]
    shown = [name for name in ("label", *CONDITIONS) if name in cases and cases[name].nunique() > 1]
    lines = [f"  {row['case_id']}  {', '.join(str(row[name]) for name in shown)}" for _, row in cases.iterrows()]
    more = f"\n  … and {len(lines) - MOST_LISTED} more" if len(lines) > MOST_LISTED else ""
    raise InputError("which case? give --case with one of\n" + "\n".join(lines[:MOST_LISTED]) + more)


def siblings(cases: pd.DataFrame, case: pd.Series) -> pd.DataFrame:
    """The cases that differ from `case` in nothing but the strategy and its options, itself included."""
    shared = [name for name in CONDITIONS if name in cases]
    same = (cases[shared] == case[shared]).all(axis=1) & (cases["label"] != case["label"])
    return cases[same | (cases["case_id"] == case["case_id"])]


def read_column(dataset: h5py.Dataset) -> np.ndarray:
    """The values of a column, text as str."""
    if h5py.check_string_dtype(dataset.dtype) is None:
        return dataset[...]
    return np.array([text(value) for value in dataset[...]], dtype=object)


def text(value: object) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def one_line(error: BaseException) -> str:
    return " ".join(str(error).split())
