"""claims_columns.py FILE.h5 CLAIMS.toml: takes from a result file the figures that no condition of a claim names. What a
case was run with and how it ended stays. The space is free only after h5repack."""

import sys
import tomllib

import h5py

# Doubles that are no figure but a condition of the run, which whoever reads the file goes by.
CONDITIONS = {"speed", "rate", "edge_stiffness", "rest_stiffness", "judged_rate"}


def named(claims):
    """The columns that conditions name, of cases and of states."""
    conditions = [one for claim in claims["claim"] for one in claim.get("condition", [])]
    entries = [one[key] for one in conditions for key in ("figure", "per") if key in one]
    return {name for entry in entries for name in ([entry] if isinstance(entry, str) else entry)}


def main():
    path, claims = sys.argv[1:]
    with open(claims, "rb") as file:
        kept = named(tomllib.load(file)) | CONDITIONS
    with h5py.File(path, "r+") as file:
        for group in (file["cases"], file["states"]):
            for name in [name for name, column in group.items() if column.dtype.kind == "f" and name not in kept]:
                del group[name]


if __name__ == "__main__":
    main()
