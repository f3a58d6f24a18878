"""How the cases were run, each way once: the page shows it of the report and of each case."""

from __future__ import annotations

import numpy as np
import pandas as pd

from ..provenance import MACHINE, PROGRAM, origins, runs
from ..store import ResultFile
from .blocks import Blocks

SAME = (*PROGRAM, *MACHINE, "argv")  # of a way; starts, ends and loads are told as a span


def pack_provenance(table: pd.DataFrame, file: ResultFile, blocks: Blocks) -> tuple[list[dict], dict]:
    """Each way, and the column that says which is a case's. No ways where the file does not say."""
    origin = origins(table, file.provenance_table(), str(file.path))
    same = [name for name in SAME if name in origin]
    number = origin.groupby(same, sort=False, dropna=False).ngroup() if same else pd.Series(0, index=table.index)
    ways = [runs(group).iloc[0].to_dict() for _, group in origin.groupby(number)] if same else []
    column = {
        "name": "provenance_row", "unit": "", "longName": "how the case was run", "role": "outcome", "better": None,
        "values": blocks.add("columns/provenance_row", number.to_numpy(), "u4"),
    }  # fmt: skip
    return [{name: plain(value) for name, value in way.items()} for way in ways], column


def plain(value: object) -> str | int | float:
    """As JSON has it."""
    if isinstance(value, (np.integer, np.bool_, bool)):
        return int(value)
    if isinstance(value, (np.floating, float)):
        return float(value) if np.isfinite(value) else ""
    return value if isinstance(value, int) else str(value)
