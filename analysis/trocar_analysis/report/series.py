"""Which series of which cases are in the report (page/src/views/series_data.ts): as many cases as the budget allows."""

from __future__ import annotations

import json
from collections.abc import Iterator

import numpy as np
import pandas as pd

from ..store import CONDITIONS, ResultFile
from .blocks import Blocks

GOLDEN = (5**0.5 - 1) / 2  # its multiples, modulo 1, fill 0 to 1 evenly however many are taken
ENTRY = 130  # bytes that a case takes beside its values and entry: its id, twice, and its tag


def pack_series(
    file: ResultFile, table: pd.DataFrame, blocks: Blocks, budget_bytes: int
) -> tuple[dict, list[str]]:
    """The index of what was packed, and what to say of what was not. Cases come whole: all their series or none.
    @param table of ResultFile.cases_table()"""
    index: dict = {"series": [], "sets": [], "reasons": [], "cases": {}}
    numbers: dict[str, int] = {}  # of series in the index
    left, without, full = budget_bytes, 0, False
    for case_id in wanted_order(file, table):
        series = file.case_series(case_id)
        if not series.names or not series.values.size:
            without += 1
            continue
        for name in series.names:
            if name not in numbers:
                numbers[name] = len(numbers)
                unit, words = file.series_words(case_id, name)
                index["series"].append({"name": name, "unit": unit, "longName": words})
        entry = {
            "set": place_of([numbers[name] for name in series.names], index["sets"]),
            "missing": missing_entries(series.missing, index["reasons"]),
        }
        own = Blocks()
        entry["values"] = own.add(f"series/{case_id}", series.values.astype(np.float32), "f4")
        left -= own.size() + len(json.dumps(entry)) + ENTRY
        if left < 0:
            full = True
            break
        blocks.take(own)
        index["cases"][case_id] = entry
    return index, notes(len(index["cases"]), len(table), without, full)


def notes(packed: int, cases: int, without: int, full: bool) -> list[str]:
    said = []
    if full and packed + without < cases:
        said.append(
            f"The series of {packed} of {cases} cases are in this report: recorded and failed cases first, then cases "
            "spread evenly over the conditions, each with all strategies; a larger --budget takes more."
        )
    if without and not packed:
        said.append("The result file has no series of its cases.")
    elif without:
        cases_have = "cases have" if without > 1 else "case has"
        said.append(f"{without} {cases_have} no series in the result file.")
    return said


def wanted_order(file: ResultFile, table: pd.DataFrame) -> Iterator[str]:
    """The ids of cases, the most wanted first: with a replay, failed, then the others."""
    ids, failed = table["case_id"], table["status"] != "complete"
    recorded = file.recorded_cases()
    yield from (case_id for case_id in ids if case_id in recorded)
    yield from (case_id for case_id in ids[failed] if case_id not in recorded)
    order = spread_order(table)
    yield from (case_id for case_id in ids.loc[order[~failed[order]]] if case_id not in recorded)


def spread_order(table: pd.DataFrame) -> pd.Index:
    """The table's index so that what comes first is spread evenly over the conditions: the first seed of all, then the
    second. Strategies under equal conditions stay together: they are looked at side by side."""
    fixed = [name for name in CONDITIONS if name in table and name != "seed"]
    place = numbered(table, fixed)
    seed = table["seed"] if "seed" in table else pd.Series(0, index=table.index)
    round_number = pd.DataFrame({"place": place, "seed": seed}).groupby("place")["seed"].rank(method="dense")
    keys = pd.DataFrame({"round": round_number, "spread": (place * GOLDEN) % 1, "place": place}, index=table.index)
    return keys.sort_values(["round", "spread", "place"], kind="stable").index


def numbered(table: pd.DataFrame, columns: list[str]) -> pd.Series:
    """The number of each row's combination of values, in the order in which they come."""
    if not columns:
        return pd.Series(0, index=table.index)
    return table.groupby(columns, sort=False, dropna=False).ngroup()


def missing_entries(said: list[str], reasons: list[str]) -> list[list]:
    """Each reason with its ranges of steps and the series of the case that lack these: [reason, ranges, series]. Most
    series of a case lack the same steps."""
    found: dict[tuple[int, str], list[int]] = {}
    for number, text in enumerate(said):
        for reason, ranges in (json.loads(text) if text else {}).items():
            found.setdefault((place_of(reason, reasons), json.dumps(ranges)), []).append(number)
    return [[reason, json.loads(ranges), series] for (reason, ranges), series in found.items()]


def place_of(one: object, all_of_them: list) -> int:
    if one not in all_of_them:
        all_of_them.append(one)
    return all_of_them.index(one)
