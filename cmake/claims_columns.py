"""claims_columns.py FILE.h5 CLAIMS.toml: takes from a result file the figures that no condition of a claim names. What a
case was run with and how it ended stays. The space is free only after h5repack."""

import pathlib
import sys

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "analysis"))

from trocar_analysis.claims.claim_file import read_claims  # noqa: E402
from trocar_analysis.store import INPUTS, OUTCOME  # noqa: E402


def main():
    path, claims = sys.argv[1:]
    conditions = [one for claim in read_claims(claims) for one in claim.conditions]
    named = {name for one in conditions for name in (*one.figure, *one.per)}
    with h5py.File(path, "r+") as file:
        for group in (file["cases"], file["states"]):
            figures = [name for name, column in group.items() if column.dtype.kind == "f"]
            for name in figures:
                if name not in {*named, *INPUTS, *OUTCOME}:
                    del group[name]


if __name__ == "__main__":
    main()
