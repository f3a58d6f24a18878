"""The options of strategies as columns to choose and to group by."""

from __future__ import annotations

import json

import pandas as pd

from .errors import InputError
from .table import ABSENT

# Columns of options, and what stands before the names of the options in them.
HOLDERS = {"options": "", "run_options": "run_"}


def option_columns(rows: pd.DataFrame, path: str) -> pd.DataFrame:
    """A column per option that any of the rows has. Flags are the words of a sweep file, "true" and "false"; where a
    strategy has no such option, the cell is ABSENT, or NaN in a column of numbers. Options that are called as a column
    of `rows` are left out."""
    columns: dict[str, pd.Series] = {}
    for holder, prefix in HOLDERS.items():
        given = rows[holder].map(lambda said: read_options(said, path)) if holder in rows else []
        for name in dict.fromkeys(option for options in given for option in options):
            if prefix + name not in rows:
                columns[prefix + name] = column_of(name, given)
    return pd.DataFrame(columns, index=rows.index)


def column_of(name: str, given: pd.Series) -> pd.Series:
    values = given.map(lambda options: options.get(name))
    numbers = values.dropna().map(lambda value: isinstance(value, (int, float)) and not isinstance(value, bool))
    return values.astype(float) if numbers.all() else values.map(option_text)


def option_text(value: object) -> str:
    """As a sweep file has it, but for quotes. Of the contents of a file, the first line that is no comment."""
    if value is None:
        return ABSENT
    if not isinstance(value, str):
        return json.dumps(value)
    lines = (line for line in value.split("\n") if line and not line.startswith("#"))
    return next(lines, value) if "\n" in value else value


def read_options(said: str, path: str) -> dict[str, object]:
    """The options that a cell of the column `options` holds."""
    try:
        options = json.loads(said) if said else {}
    except json.JSONDecodeError:
        options = None
    if not isinstance(options, dict):
        raise InputError(f"{path}: is damaged: the column options holds no JSON object but {said!r}")
    return options
