"""Which cases a claim is judged on: those of its sweeps. A result file holds those of other claims as well."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from ..toml_file import read_toml

# Keys of a sweep file and the column of what they list.
LISTS = {"organs": "organ", "tools": "tool", "scenes": "scene", "speeds": "speed"}
FORMULA = "@"  # in the name of an organ that is made by formula; those from files are the confirmation set

# Of a sweep: column → its values. A column of which the file says more than names is not there.
Sweep = dict[str, tuple]


def read_sweeps(folder: Path, names: list[str]) -> tuple[Sweep, ...]:
    return tuple(read_sweep(folder / name) for name in names)


def read_sweep(path: Path) -> Sweep:
    content = read_toml(path, "a sweep that a claim names")
    sweep = {}
    for key, column in LISTS.items():
        if key not in content:
            continue
        entries = content[key]
        names = [organ_name(one) if column == "organ" else one for one in entries if not isinstance(one, dict)]
        if column == "organ" or len(names) == len(entries):
            sweep[column] = tuple(names)
    return sweep


def organ_name(formula: str) -> str:
    """As result files spell it: "sphere" and "sphere@4.0mm" are sphere@4mm."""
    shape, _, edge = formula.partition(FORMULA)
    try:
        return f"{shape}{FORMULA}{float(edge.removesuffix('mm') or 4):g}mm"
    except ValueError:
        return formula


def rows_of(sweeps: tuple[Sweep, ...], table: pd.DataFrame) -> pd.Series:
    """Which rows are of one of the sweeps. Organs from files are those of the confirmation set, which belong to no
    sweep file. A claim that names no sweep is judged on all."""
    if not sweeps:
        return pd.Series(True, index=table.index)
    from_file = ~table["organ"].str.contains(FORMULA, regex=False)
    chosen = pd.Series(False, index=table.index)
    for sweep in sweeps:
        of_sweep = pd.Series(True, index=table.index)
        for column, values in sweep.items():
            of_sweep &= table[column].isin(values) | (from_file if column == "organ" else False)
        chosen |= of_sweep
    return chosen
