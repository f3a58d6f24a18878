"""Access to a result file. With case_series.py the only place that knows how the file is laid out (results/README.md)."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import h5py
import numpy as np
import pandas as pd

from .case_series import CaseSeries, read_case_series
from .errors import InputError, unknown
from .recording import Recording, Step

SCHEMA_VERSION = 2

# Columns of /cases that say what was run and how it ended; every other column is a figure.
INPUTS = (
    "case_id", "build_id", "strategy", "options", "label", "organ", "organ_facets", "tool", "scene",
    "speed", "rate", "release", "edge_stiffness", "rest_stiffness", "fractions", "seed", "metrics", "judged_rate",
    "same_state",
)  # fmt: skip
OUTCOME = (
    "status", "reason", "attempts", "wall_s", "window_steps", "missing", "sweep_number", "provenance_row",
)  # fmt: skip

# Columns that /cases has of a run and /states, or its reader, of the strategy that answered: those of the run
# are called run_… beside the answer's.
RUN_OWN = ("strategy", "options", "label", "status")

TEXTS = ("case_id", "strategy", "options", "label", "organ", "status", "reason")

# What two cases must have in common to differ in nothing but the strategy.
CONDITIONS = (
    "scene", "organ", "tool", "speed", "rate", "release", "edge_stiffness", "rest_stiffness", "fractions", "seed",
)  # fmt: skip

MOMENTS = ("found", "handled", "deformed")

MAX_COMPRESSION = 1032  # of deflate: bytes for each one stored

MOST_LISTED = 20  # cases in a message


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
        if version != SCHEMA_VERSION:
            raise InputError(
                f"{self.path}: was written with schema {one_line(version)}, this program reads schema "
                f"{SCHEMA_VERSION}; use the trocar that wrote it, or run the sweep again"
            )
        if self._file.attrs.get("complete") != 1:
            raise InputError(f"{self.path}: is not whole; remove it and run its sweep again")
        missing = {"case_id", "strategy", "status"} - set(self._file["cases"])
        if missing:
            raise InputError(f"{self.path}: is damaged: /cases has no column {', '.join(sorted(missing))}")

    def cases_table(self) -> pd.DataFrame:
        """/cases, one row per case. A case without a label has its strategy's name as label."""
        return self._labelled("cases")

    def states_table(self) -> pd.DataFrame:
        """/states, one row per state and strategy that answered, and the inputs of the run in which the state was
        found. What both have is called run_… where it is the run's: `label` answered, `run_label` ran. Empty
        when the file has no states."""
        with self._reading():
            names = set(self._file["states"])
        if not names:
            return pd.DataFrame()
        if missing := {"case_id", "step", "strategy"} - names:
            raise InputError(f"{self.path}: is damaged: /states has no column {', '.join(sorted(missing))}")
        states, runs = self._labelled("states"), self.cases_table()
        if not states["case_id"].isin(runs["case_id"]).all():
            raise InputError(f"{self.path}: is damaged: /states names a case that /cases does not have")
        runs = runs[[name for name in (*INPUTS, "status") if name in runs]]
        runs = runs.rename(columns={name: f"run_{name}" for name in RUN_OWN})
        new = [name for name in runs if name == "case_id" or name not in states]
        return states.merge(runs[new], on="case_id", how="left", validate="many_to_one")

    def provenance_table(self) -> pd.DataFrame:
        """/provenance: how cases were run, each distinct way once; their column provenance_row numbers its rows.
        Empty when the file has none."""
        return self._table("provenance")

    def sweep_cases(self) -> int | None:
        """How many cases the whole sweep has, of which the file may hold a part; None where it does not say."""
        count = self._file.attrs.get("sweep_cases")
        return None if count is None else int(count)

    def origin(self) -> dict[str, str]:
        """Of the file: `created_utc`, `generator` and `sweep_toml`; "" for what it does not say."""
        with self._reading():
            return {name: text(self._file.attrs.get(name, "")) for name in ("created_utc", "generator", "sweep_toml")}

    def units(self) -> dict[str, str]:
        """The unit of each column of /cases and /states; "" for text and plain numbers."""
        with self._reading():
            units = {
                name: text(dataset.attrs.get("units", ""))
                for group in ("states", "cases")
                for name, dataset in self._file[group].items()
            }
        return {name: "" if unit == "1" else unit for name, unit in units.items()}

    def long_names(self) -> dict[str, str]:
        """What each column of /cases is, in words; without those of which the file does not say it."""
        with self._reading():
            said = {name: dataset.attrs.get("long_name", "") for name, dataset in self._file["cases"].items()}
        return {name: text(words) for name, words in said.items() if len(words)}

    def missing_steps(self, case_id: str, series: str) -> dict[str, list[tuple[int, int]]]:
        """Why a series of a case has steps without a value: for each reason the ranges of steps, both ends
        included. Empty when every step has one."""
        with self._reading():
            said = self._file[f"series/{case_id}/{series}"].attrs.get("missing", "")
            ranges = json.loads(text(said)) if said else {}
            return {reason: [(int(a), int(b)) for a, b in steps] for reason, steps in ranges.items()}

    def series(self, case_id: str, name: str) -> np.ndarray:
        """A series of a case, one value a step, NaN where there is none; in the stored unit."""
        with self._reading():
            known = list(self._file.get(f"series/{case_id}", {}))
        if name not in known:
            raise unknown("series", name, known)
        with self._reading():
            return self._file[f"series/{case_id}/{name}"][...].astype(float)

    def case_series(self, case_id: str) -> CaseSeries:
        """All series of a case at once, in the order of their names; empty where the file has none of it."""
        with self._reading():
            return read_case_series(self._file["series"], case_id)

    def series_words(self, case_id: str, name: str) -> tuple[str, str]:
        """The unit of a series, "" for plain numbers, and what it is, in words."""
        with self._reading():
            said = self._file[f"series/{case_id}/{name}"].attrs
            unit, words = text(said.get("units", "")), text(said.get("long_name", ""))
        return "" if unit == "1" else unit, words

    def has_replay(self, case_id: str) -> bool:
        return f"replay/{case_id}" in self._file

    def recorded_cases(self) -> set[str]:
        """The ids of the cases that have a replay."""
        with self._reading():
            return set(self._file.get("replay", ()))

    def tool_poses(self, case_id: str) -> np.ndarray:
        """Tool frame to world at the end of each step, [steps, 4, 4], mm."""
        with self._reading():
            return self._replay(case_id)["tool_pose"][...].astype(float)

    def step(self, case_id: str, number: int) -> Step:
        """Step `number` (from 0) of a case that has a replay."""
        with self._reading():
            return self._read_step(case_id, number)

    def replay_size(self, case_id: str) -> tuple[int, int]:
        """Steps and organ vertices of a case that has a replay."""
        with self._reading():
            steps, vertices, _ = self._replay(case_id)["found"].shape
            return steps, vertices

    def recording(self, case_id: str) -> Recording:
        """All steps of a case that has a replay."""
        with self._reading():
            replay = self._replay(case_id)
            offsets = replay["moved_offsets"][1:-1].astype(int)
            return Recording(
                positions={moment: replay[moment][...] for moment in MOMENTS},
                rest_positions=replay["rest_positions"][...].astype(float),
                facets=replay["facets"][...],
                tool_positions=replay["tool_positions"][...].astype(float),
                tool_facets=replay["tool_facets"][...],
                tool_poses=replay["tool_pose"][...].astype(float),
                moved=np.split(replay["moved"][...], offsets),
                moved_by=np.split(replay["moved_by"][...], offsets),
                series={
                    name: values[...].astype(float)
                    for name, values in self._file.get(f"series/{case_id}", {}).items()
                    if len(values)
                },
            )

    def _labelled(self, group: str) -> pd.DataFrame:
        """A table of the file. A row without a label gets its strategy's name as label."""
        table = self._table(group)
        with self._reading():
            for said in set(table.get("missing", ())):
                read_reasons(said)
        label = table.get("label", pd.Series("", index=table.index))
        table["label"] = label.where(label != "", table["strategy"])
        return table

    def _table(self, group: str) -> pd.DataFrame:
        with self._reading():
            columns = {name: read_column(dataset) for name, dataset in self._file[group].items()}
        for name, values in columns.items():
            if values.ndim != 1 or (name in TEXTS and values.dtype != object):
                raise InputError(f"{self.path}: is damaged: /{group}/{name} is no column of its kind")
        if len({len(values) for values in columns.values()}) > 1:
            raise InputError(f"{self.path}: is damaged: the columns of /{group} differ in length")
        return pd.DataFrame(columns)

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
            tool_tip=pose[:3, 3],
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
        except (OSError, KeyError, TypeError, ValueError, AttributeError, IndexError, RuntimeError) as error:
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
    """The values of a column, text as str. ValueError when it claims more rows than the bytes stored for it can hold."""
    if dataset.size * dataset.dtype.itemsize > MAX_COMPRESSION * (dataset.id.get_storage_size() + 1):
        raise ValueError(f"{dataset.name} claims {dataset.size} rows")
    if h5py.check_string_dtype(dataset.dtype) is None:
        return dataset[...]
    return np.array([text(value) for value in dataset[...]], dtype=object)


@cache
def read_reasons(said: str) -> dict[str, tuple[str, ...]]:
    """What the column `missing` says: for each series that lacks values why, the most frequent reason first.
    ValueError when it says something else."""
    series = json.loads(said) if said else {}
    if not isinstance(series, dict):
        raise ValueError("the column missing holds no JSON object")
    reasons = {name: {why: 1} if isinstance(why, str) else dict(why) for name, why in series.items()}
    return {name: tuple(sorted(why, key=why.get, reverse=True)) for name, why in reasons.items()}


def text(value: object) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def one_line(error: object) -> str:
    return " ".join(str(error).split())
