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
COMPLETE = "complete"


def pack_columns(table: pd.DataFrame, file: ResultFile, better: dict[str, str], blocks: Blocks) -> list[dict]:
    """The columns of /cases and, of the options of strategies, those in which cases differ that have them.
    @param table of ResultFile.cases_table()
    @param better which way is better of a metric: "low" or "high"; others are not judged"""
    units, words = file.units(), file.long_names()
    caution = warning(origins(table, file.provenance_table(), str(file.path)))
    columns = []
    for name in (name for name in table if name not in LEFT_OUT):
        column = {"name": name, "unit": units.get(name, ""), "longName": words.get(name, ""), "role": role_of(table[name])}
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


def role_of(column: pd.Series) -> str:
    if column.name in INPUTS:
        return "input"
    return "figure" if is_numeric_dtype(column) and column.name not in OUTCOME else "outcome"


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
    lacking = table[table[figure].isna()]
    name = CASES.name_of(figure)
    told = [
        lacking[column] if column in lacking else [default] * len(lacking)
        for column, default in (("missing", ""), ("metrics", ""), ("window_steps", None), ("status", COMPLETE))
    ]
    known: dict[tuple, str] = {}
    why = pd.Series("", index=table.index)
    said = []
    for key in zip(*told):
        *of_figure, status = key
        if key not in known:
            known[key] = status if status != COMPLETE else reason(*of_figure, name)
        said.append(known[key])
    why[lacking.index] = said
    return why
