"""Writes the result files that the tests of the page are about: sample_results.py FOLDER. Whole, half-failed, failed."""

from __future__ import annotations

import sys
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "analysis"))
from report_sweep import PROVENANCE, fail, sweep  # noqa: E402
from result_file import write_results  # noqa: E402

SWEEP = 'name = "made up"\nstrategies = ["careful", "middling", "hasty"]\nspeeds = [20, 100]\nseeds = 7\n'


def write(path: Path, cases: list[dict]) -> None:
    write_results(path, cases, provenance=[PROVENANCE])
    with h5py.File(path, "a") as file:
        file.attrs.update(sweep_toml=SWEEP, created_utc="2026-01-01T00:00:00Z", sweep_cases=len(cases))
        for number, case in enumerate(cases):
            steps = np.arange(1, 31)
            for name, values in {"time": steps / 30, "drag": np.sin(steps / 5 + number)}.items():
                series = file.create_dataset(f"series/{case['case_id']}/{name}", data=values)
                series.attrs["units"] = {"time": "s", "drag": "mm"}[name]


def main() -> None:
    folder = Path(sys.argv[1])
    write(folder / "whole.h5", sweep())
    half = sweep()
    fail(half, [*range(0, len(half), 2)])
    write(folder / "half.h5", half)
    failed = sweep()
    fail(failed, [*range(len(failed))])
    write(folder / "failed.h5", failed)
    write(folder / "single.h5", sweep(("hasty",), (1,)))


if __name__ == "__main__":
    main()
