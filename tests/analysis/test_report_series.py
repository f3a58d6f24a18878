"""Which series of which cases a report holds, and what it says of the others."""

from __future__ import annotations

import json
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from result_file import dent, write_results
from test_report_columns import unpacked

from trocar_analysis.errors import InputError
from trocar_analysis.report.blocks import Blocks
from trocar_analysis.report.series import pack_series, spread_order
from trocar_analysis.store import ResultFile

PLENTY = 10**9  # bytes
STEPS = 12


def case(number: int, **values: object) -> dict:
    return {"case_id": f"c{number}"} | values


def sweep(speeds: int, seeds: int) -> list[dict]:
    """Each speed and seed with two strategies."""
    keys = [(label, speed, seed) for label in "ab" for speed in range(speeds) for seed in range(seeds)]
    return [
        case(k, strategy=label, label=label, speed=float(speed), seed=seed) for k, (label, speed, seed) in enumerate(keys)
    ]


def series_of(case_id: str) -> dict[str, np.ndarray]:
    drag = np.random.default_rng(int(case_id[1:])).normal(size=STEPS)
    drag[[0, 1, 5]] = np.nan
    return {"drag": drag, "time": np.arange(1, STEPS + 1) / 30, "time_handle": np.full(STEPS, 1e9)}


class Series(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "out.h5"
        self.blocks = Blocks()

    def write(self, cases: list[dict], without: tuple[str, ...] = (), recorded: tuple[str, ...] = ()) -> None:
        write_results(self.path, cases, {case_id: dent(True) for case_id in recorded})
        with h5py.File(self.path, "a") as file:
            for case_id in (one["case_id"] for one in cases):
                if case_id in without or case_id in recorded:
                    continue
                for name, values in series_of(case_id).items():
                    dataset = file.create_dataset(f"series/{case_id}/{name}", data=values)
                    dataset.attrs["units"] = {"drag": "mm", "time": "s", "time_handle": "ns"}[name]
                    dataset.attrs["long_name"] = f"what {name} is"
                file[f"series/{case_id}/drag"].attrs["missing"] = '{"no vertex collided":[[0,1],[5,5]]}'

    def packed(self, budget: int = PLENTY) -> tuple[dict, list[str]]:
        with ResultFile(self.path) as file:
            return pack_series(file, file.cases_table(), self.blocks, budget)

    def test_series_are_those_of_the_file_in_single_precision(self) -> None:
        self.write([case(1), case(2)])
        index, notes = self.packed()
        self.assertEqual(notes, [])
        for case_id in ("c1", "c2"):
            entry = index["cases"][case_id]
            values = unpacked(self.blocks, entry["values"])
            names = [index["series"][which]["name"] for which in index["sets"][entry["set"]]]
            self.assertEqual(names, ["drag", "time", "time_handle"])
            for name, row in zip(names, values):
                np.testing.assert_array_equal(row, series_of(case_id)[name].astype(np.float32))
        self.assertEqual(index["series"][0], {"name": "drag", "unit": "mm", "longName": "what drag is"})

    def test_missing_steps_keep_their_reason(self) -> None:
        self.write([case(1)])
        index, _ = self.packed()
        self.assertEqual(index["cases"]["c1"]["missing"], [[0, [[0, 1], [5, 5]], [0]]])
        self.assertEqual(index["reasons"], ["no vertex collided"])

    def test_a_budget_is_kept_and_said(self) -> None:
        self.write(sweep(10, 2))
        whole, _ = self.packed()
        size = self.blocks.size() + len(json.dumps(whole))
        self.blocks = Blocks()
        index, notes = self.packed(size // 2)
        held = len(index["cases"])
        self.assertLess(self.blocks.size() + len(json.dumps(index["cases"])), size // 2)
        self.assertTrue(10 < held < 30, held)
        self.assertEqual(len(notes), 1)
        self.assertIn(f"{held} of 40 cases", notes[0])

    def test_recorded_cases_come_first_then_failed_ones(self) -> None:
        cases = [case(k, status="diverged" if k == 7 else "complete") for k in range(9)]
        self.write(cases, recorded=("c4",))
        index, _ = self.packed()
        self.assertEqual([*index["cases"]][:2], ["c4", "c7"])
        self.assertEqual(len(index["cases"]), 9)

    def test_the_others_are_spread_over_the_conditions_with_all_strategies(self) -> None:
        cases = sweep(speeds=20, seeds=3)
        self.write(cases)
        with ResultFile(self.path) as file:
            table = file.cases_table()
        first = table.loc[spread_order(table)[:20]]
        self.assertEqual(first["label"].value_counts().to_dict(), {"a": 10, "b": 10})
        self.assertEqual(first["seed"].unique().tolist(), [0])
        speeds = np.sort(first["speed"].unique())
        self.assertEqual(len(speeds), 10)
        self.assertLessEqual(np.diff([-1, *speeds, 20]).max(), 3)
        self.assertEqual(sorted(spread_order(table)), [*table.index])

    def test_cases_without_series_are_counted(self) -> None:
        self.write([case(1), case(2), case(3)], without=("c2",))
        index, notes = self.packed()
        self.assertEqual([*index["cases"]], ["c1", "c3"])
        self.assertEqual(notes, ["1 case has no series in the result file."])

    def test_a_file_of_tables_alone_says_so(self) -> None:
        self.write([case(1)], without=("c1",))
        index, notes = self.packed()
        self.assertEqual((index["cases"], notes), ({}, ["The result file has no series of its cases."]))

    def test_series_that_differ_in_length_are_damage(self) -> None:
        self.write([case(1)])
        with h5py.File(self.path, "a") as file:
            del file["series/c1/time"]
            file["series/c1/time"] = np.zeros(STEPS + 1)
        with self.assertRaisesRegex(InputError, "is damaged .*differ in length"):
            self.packed()


if __name__ == "__main__":
    unittest.main()
