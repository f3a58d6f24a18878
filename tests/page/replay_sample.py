"""A result file with replays for the tests of the replay: replay_sample.py OUT.h5. Made by formula, as those of tests/analysis."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "analysis"))

from result_file import dent, write_results  # noqa: E402

CASES = [
    {"case_id": "aa11", "label": "clears"},
    {"case_id": "aa22", "label": "leaves"},
    {"case_id": "bb33", "label": "clears", "seed": 2},
]

if __name__ == "__main__":
    write_results(Path(sys.argv[1]), CASES, {"aa11": dent(True), "aa22": dent(False), "bb33": dent(True)})
