"""The values that a condition is judged on: one for each case, or one for each pair of cases."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..conditions import excess
from ..errors import InputError
from ..store import CONDITIONS, ResultFile
from ..subject import CASES, STATES
from .claim_file import Condition, Where
from .claim_sweeps import FORMULA, rows_of

# What a case was run with; two cases that agree in all but what a condition tells apart are a pair.
RUN_KEYS = (*CONDITIONS, "label", "run_label")


@dataclass(frozen=True)
class Sources:
    """What the conditions of claims are judged on, one table each."""

    tables: dict[str, pd.DataFrame]  # "runs": of cases; "answers": of a run's states and who answered; "turns"
    units: dict[str, str]
    better: dict[str, str]  # metric → "low" or "high"


@dataclass(frozen=True)
class Values:
    """Of the cases, or pairs, of a condition under one release: what has to be on one side of 0, or of the limit."""

    values: np.ndarray  # infinite for what failed; without those that have none
    of: np.ndarray  # the figure of the first group, and of the second where there is one
    than: np.ndarray
    organs: np.ndarray
    seeds: np.ndarray
    failed: int  # cases, or answers of whole runs, that did not complete
    lacking: int  # that have no value


def read_sources(path: str | None, turns_path: str | None, better: dict[str, str]) -> Sources:
    """`path`: of a result file; None where no claim is judged on one."""
    tables, units = {}, {}
    if path is not None:
        with ResultFile(path) as results:
            tables = {"runs": results.cases_table(), "answers": results.states_table()}
            units = results.units()
    if turns_path:
        try:
            tables["turns"] = pd.read_csv(turns_path)
        except (OSError, ValueError) as error:
            raise InputError(f"{turns_path}: cannot be read as the table of turns ({error})") from error
        units |= {column: "degree" for column in tables["turns"] if column.startswith("largest_turn")}
    return Sources(tables, units, better)


def organs_of(sources: Sources, confirmation: bool) -> set[str]:
    """The organs of the verdicts, or those of the confirmation set."""
    names = set(sources.tables["runs"]["organ"])
    return {name for name in names if (FORMULA not in name) == confirmation}


def runs_without_states(condition: Condition, sources: Sources) -> tuple[int, int]:
    """Of the runs whose states a condition is judged on: in how many there was none to hand out, since nothing was ever
    inside the tool, and how many there are."""
    runs, states = sources.tables.get("runs"), sources.tables.get("answers")
    if condition.data != "answers" or runs is None or states is None:
        return 0, 0
    chosen = rows_of(condition.sweeps, runs)
    for column, values in condition.of.items():
        # In the table of answers `label` is who answered; the runs are everybody's.
        if column in RUN_KEYS and column != "label":
            chosen &= runs[column].isin({*values, *condition.than.get(column, ())})
    asked = set(states["case_id"]) if len(states) else set()
    ids = runs.loc[chosen, "case_id"]
    return int((~ids.isin(asked)).sum()), len(ids)


def values_of(condition: Condition, sources: Sources, release: str, confirmation: bool) -> Values:
    """What the condition is judged on under this release."""
    groups = [figures(condition, condition.of, sources, release, confirmation, condition.asks_for_more)]
    if condition.than:
        groups.append(figures(condition, condition.than, sources, release, confirmation, not condition.asks_for_more))
    told_apart = {
        column for column in {**condition.of, **condition.than} if condition.of.get(column) != condition.than.get(column)
    } if condition.than else set()  # fmt: skip
    keys = [key for key in RUN_KEYS if key in groups[0] and key not in told_apart]
    both = pairs_of(condition, *groups, keys) if condition.than else groups[0]
    of = both["value"].to_numpy(float)
    than = both["value_than"].to_numpy(float) if condition.than else np.full(len(of), np.nan)
    failed = both["failed"] | both["failed_than"] if condition.than else both["failed"]
    values = excess(of, than, condition.times) if condition.than else excess(of, condition.limit)
    known = ~np.isnan(values)
    return Values(
        values[known], of[known], than[known], both["organ"].to_numpy()[known], both["seed"].to_numpy()[known],
        int(failed.sum()), int((~known).sum()),
    )  # fmt: skip


def pairs_of(condition: Condition, of: pd.DataFrame, than: pd.DataFrame, keys: list[str]) -> pd.DataFrame:
    """Side by side what agrees in the keys. A seed has its place on an organ; a condition that compares organs pairs
    the same place on two."""
    for group in (of, than):
        if group.duplicated(keys).any():
            raise InputError(
                f"a condition on {' + '.join(condition.figure)}: several cases of one side agree in all but what tells "
                f"the two sides apart ({', '.join(keys)}); let `where`, `of` and `than` choose one"
            )
    return of.merge(than, on=keys, suffixes=("", "_than"))


def figures(
    condition: Condition, group: Where, sources: Sources, release: str, confirmation: bool, should_be_more: bool
) -> pd.DataFrame:
    """One row per case of the group, or per run and strategy that answered: what it was run with, `value` (infinite, on
    the side that is not better, where it failed; NaN where there is none) and `failed`. `should_be_more`: the condition
    asks for large values of this group."""
    table = sources.tables.get(condition.data)
    if table is None or table.empty:
        return empty()
    if condition.data == "turns":  # on no organ: nothing that could confirm them
        return empty() if confirmation else turned(condition, group, table)
    chosen = table["release"] == release
    chosen &= table["organ"].isin(organs_of(sources, confirmation))
    chosen &= rows_of(condition.sweeps, table)
    for column, values in group.items():
        if column not in table:
            raise InputError(f"the result file has no column {column}, which a claim chooses cases by")
        chosen &= table[column].isin(values)
    rows = table[chosen]
    for column in (*condition.figure, *condition.per):
        if column not in rows:
            raise InputError(f"the result file lacks the figure {column}; run it with that metric")
    worst = worst_of(condition, sources, should_be_more)
    if condition.data == "answers":
        return of_answers(condition, rows, worst)
    value = quotient(condition, rows)
    failed = rows["status"] != "complete"
    keys = [key for key in RUN_KEYS if key in rows]
    return rows[keys].assign(value=value.mask(failed, worst), failed=failed)


def empty() -> pd.DataFrame:
    return pd.DataFrame({"organ": [], "seed": [], "value": [], "failed": pd.Series([], dtype=bool)})


def turned(condition: Condition, group: Where, table: pd.DataFrame) -> pd.DataFrame:
    """The turns know no scene: one row per strategy and seed."""
    rows = table
    for column, values in group.items():
        rows = rows[rows[column].isin(values)]
    return pd.DataFrame({
        "organ": "", "seed": rows["seed"], "label": rows["label"], "value": quotient(condition, rows), "failed": False
    })  # fmt: skip


def quotient(condition: Condition, rows: pd.DataFrame) -> pd.Series:
    value = rows[[*condition.figure]].astype(float).sum(axis=1, skipna=False)
    if not condition.per:
        return value
    divisor = rows[[*condition.per]].astype(float).sum(axis=1, skipna=False)
    return value / divisor.where(divisor != 0)


def of_answers(condition: Condition, rows: pd.DataFrame, worst: float) -> pd.DataFrame:
    """The states of one run are not independent of each other: a run and a strategy that answered make one value, the
    mean over its states; of a quotient the sums' quotient. An answer that failed makes it a failure."""
    keys = [key for key in RUN_KEYS if key in rows]
    failed = rows["reason"] != "" if "reason" in rows else pd.Series(False, index=rows.index)
    columns = [*condition.figure, *condition.per]
    rows = rows[keys].assign(**{name: rows[name].astype(float) for name in columns}, failed=failed)
    known = rows.dropna(subset=[name for name in columns if name in rows])
    means = known.groupby(keys, sort=False)[columns].mean()
    ends = rows.groupby(keys, sort=False)["failed"].any()
    result = ends.to_frame().join(means).reset_index()
    return result[keys].assign(
        value=quotient(condition, result).mask(result["failed"], worst), failed=result["failed"]
    )  # fmt: skip


def worst_of(condition: Condition, sources: Sources, should_be_more: bool) -> float:
    """What a case that failed counts as: the end of the scale that is not better. A figure without a better end counts
    against the condition."""
    direction = {sources.better.get(metric_of(column, condition.data), "") for column in condition.figure}
    if direction == {"low"}:
        return np.inf
    if direction == {"high"}:
        return -np.inf
    return -np.inf if should_be_more else np.inf


def metric_of(column: str, data: str) -> str:
    name = (STATES if data == "answers" else CASES).name_of(column)
    return name.metric if name else column
