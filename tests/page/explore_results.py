"""Writes a result file by formula for explore.mjs, and prints its cases as JSON, as they are read back from the file.

Two strategies and a third one; three organs, two speeds, two scenes, three seeds. Of the figures depth_max_d_max lacks a
value where the organ is a sheet and the seed 1, and one case diverged. Cases of seed 1 have series."""

from __future__ import annotations

import math
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "analysis"), str(Path(__file__).resolve().parents[2] / "analysis")]

import h5py  # noqa: E402
import numpy as np  # noqa: E402
from result_file import write_results  # noqa: E402

from trocar_analysis.store import ResultFile  # noqa: E402

LABELS = {"nearest-face": "", "fuzzy-per-vertex": "fuzzy, always penetration", "cylinder-axis": ""}
STEPS = 30


def cases() -> list[dict]:
    keys = [
        (strategy, organ, scene, speed, seed)
        for strategy in LABELS for organ in ("sphere", "sheet", "liver") for scene in ("penetration", "sliding")
        for speed in (20.0, 400.0) for seed in (1, 2, 3)
    ]  # fmt: skip
    return [case(number, *key) for number, key in enumerate(keys)]


def case(number: int, strategy: str, organ: str, scene: str, speed: float, seed: int) -> dict:
    depth = math.sqrt(number + 1) / 3 + math.log(speed)
    one = {
        "case_id": f"{number * 7919 + 1:032x}", "strategy": strategy, "label": LABELS[strategy], "organ": organ, "scene": scene,
        "speed": speed, "seed": seed, "missing": "", "depth_max_d_max": depth, "time_handle_p50": 1000.0 * (number + 1) + 0.5,
    }  # fmt: skip
    if organ == "sheet" and seed == 1:
        one |= {"depth_max_d_max": math.nan, "missing": '{"depth_max_d":{"no vertex inside":9}}'}
    if number == 5:
        one |= {"status": "diverged", "reason": "a vertex left the world", "depth_max_d_max": math.nan}
    return one


def add_series(file: h5py.File, case_id: str) -> None:
    time = np.arange(1, STEPS + 1) / 30
    drag = np.sin(time * 9) + int(case_id, 16) % 5
    drag[[0, 1, 2, 10]] = np.nan
    for name, unit, values in (("time", "s", time), ("drag", "mm", drag), ("time_handle", "ns", 1000 + 100 * time)):
        series = file.create_dataset(f"series/{case_id}/{name}", data=values)
        series.attrs["units"] = unit
        series.attrs["long_name"] = f"{name} of a test"
    file[f"series/{case_id}/drag"].attrs["missing"] = '{"no vertex collided":[[0,2],[10,10]]}'


def main(path: Path) -> None:
    made_up = cases()
    write_results(path, made_up)
    with h5py.File(path, "a") as file:
        for one in made_up:
            if one["seed"] == 1:
                add_series(file, one["case_id"])
    with ResultFile(path) as results:
        print(results.cases_table().to_json(orient="records", double_precision=15))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
