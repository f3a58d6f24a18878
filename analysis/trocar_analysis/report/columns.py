"""The table of cases as the page has it (page/src/report.ts, Column): numbers in full, texts as codes."""

from __future__ import annotations

import numpy as np
import pandas as pd
from pandas.api.types import is_numeric_dtype

from ..changes import metric_of
from ..missing import reason
from ..options import option_columns
from ..provenance import is_time, origins, warning
from ..store import CONDITIONS, INPUTS, OUTCOME, ResultFile
from ..subject import CASES
from ..table import ABSENT
from .blocks import Blocks

# Its reasons stand at the figures that lack values; provenance_rows.py has what the other one points at.
LEFT_OUT = ("missing", "provenance_row")


def pack_columns(table: pd.DataFrame, file: ResultFile, better: dict[str, str], blocks: Blocks) -> list[dict]:
    """The columns of /cases and, of the options of strategies, those in which cases differ that have them.
    @param table of ResultFile.cases_table()
    @param better which way is better of a metric: "low" or "high"; others are not judged"""
    units, words = file.units(), file.long_names()
    caution = warning(origins(table, file.provenance_table(), str(file.path)))
    columns = []
    for name in (name for name in table if name not in LEFT_OUT):
        column = {"name": name, "unit": units.get(name, ""), "longName": words.get(name, ""), "role": role_of(name)}
        column["better"] = better_way(name, better) if column["role"] == "figure" else None
        if name in CONDITIONS:
            column["part"] = "condition"
        if caution and is_time(name):
            column["caution"] = caution[0]
        column |= packed_values(f"columns/{name}", table[name], blocks)
        if column["role"] == "figure" and table[name].isna().any():
            column["why"] = packed_values(f"why/{name}", reasons_of(table, name), blocks)
        columns.append(column)
    options = option_columns(table, str(file.path))
    for name in options:
        if options[name].where(options[name] != ABSENT).nunique() > 1:
            column = {"name": name, "unit": "", "longName": f"option {name} of the strategy", "role": "input"}
            column |= {"better": None, "part": "option"}
            columns.append(column | packed_values(f"columns/{name}", options[name], blocks))
    return columns


def role_of(name: str) -> str:
    if name in INPUTS:
        return "input"
    return "outcome" if name in OUTCOME else "figure"


def better_way(name: str, better: dict[str, str]) -> str | None:
    direction = better.get(metric_of(name))
    return direction if direction in ("low", "high") else None


def packed_values(block: str, values: pd.Series, blocks: Blocks) -> dict:
    """The part of a column that holds its values: numbers, or codes into levels in the order in which they come."""
    if is_numeric_dtype(values):
        return {"values": blocks.add(block, values.to_numpy(dtype=float), "f8")}
    codes, levels = pd.factorize(values.astype(str))
    kind = "u2" if len(levels) <= np.iinfo(np.uint16).max else "u4"
    return {"levels": [*levels], "values": blocks.add(block, codes, kind)}


def reasons_of(table: pd.DataFrame, figure: str) -> pd.Series:
    """Why each case has no value of a figure; "" where it has one. A case that did not complete says so by its status."""
    why = pd.Series("", index=table.index)
    lacking = table.index[table[figure].isna()]
    name = CASES.name_of(figure)
    told = {key: table[key] if key in table else None for key in ("missing", "metrics", "window_steps", "status")}

    def value(key: str, row: object, default: object) -> object:
        return default if told[key] is None else told[key][row]

    for row in lacking:
        status = value("status", row, "complete")
        why[row] = (
            status
            if status != "complete"
            else reason(value("missing", row, ""), value("metrics", row, ""), value("window_steps", row, None), name)
        )
    return why
