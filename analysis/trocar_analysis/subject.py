"""What a table can be about: cases, or the states of the same-state comparison."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

import pandas as pd

from .store import INPUTS, OUTCOME, RUN_OWN

# <metric>[_<moment>]_<figure>: as columns of /cases are named.
CASE_COLUMN = re.compile(r"(?P<series>(?P<metric>.+?)(?:_[hd])?)_(mean|max|final|p50|p95|p99|over_\w+)")


@dataclass(frozen=True)
class Name:
    """What the name of a figure's column says."""

    metric: str  # "depth_max"
    series: str  # with the moment, where the metric has several: "depth_max_d"


@dataclass(frozen=True)
class Subject:
    """What the rows of a table's data are."""

    usable: str  # what the rows that figures are taken over are called
    usual: tuple[str, ...]  # columns or metrics to show when none are asked for
    keys: tuple[str, ...]  # columns by which rows are chosen and grouped
    no_figures: tuple[str, ...]  # columns of numbers that are none
    name_of: Callable[[str], Name | None]  # of a column
    # The rows of a group that figures are taken over, and what the group is counted by.
    count: Callable[[pd.DataFrame], tuple[pd.DataFrame, dict[str, object]]]


def name_in_cases(column: str) -> Name | None:
    match = CASE_COLUMN.fullmatch(column)
    return Name(match["metric"], match["series"]) if match else None


def name_in_states(column: str) -> Name:
    """Every value there is one step's, after handling."""
    return Name(column.removesuffix("_h"), column)


def count_cases(group: pd.DataFrame) -> tuple[pd.DataFrame, dict[str, object]]:
    is_complete = group["status"] == "complete"
    failures = group.loc[~is_complete, "status"]
    counts = {"cases": len(group), "failed": len(failures), "failures": tally(failures.value_counts().to_dict())}
    return group[is_complete], counts


def count_states(group: pd.DataFrame) -> tuple[pd.DataFrame, dict[str, object]]:
    return group, {"states": number_of_states(group), "answers": len(group)}


def number_of_states(answers: pd.DataFrame) -> int:
    return len(answers[["case_id", "step"]].drop_duplicates())


def tally(counts: dict[str, int]) -> str:
    """Such as "2 diverged, 1 crashed"."""
    return ", ".join(f"{count} {what}" for what, count in counts.items())


CASES = Subject(
    usable="complete cases",
    usual=(
        "depth_max_d_max", "vertices_inside_d_max", "facets_crossing_d_mean", "displacement_mean_mean",
        "flipped_facets_mean", "fallbacks_mean", "time_handle_p50", "time_cycle_p50",
    ),
    keys=(*INPUTS, *OUTCOME),
    no_figures=(*INPUTS, "sweep_number", "provenance_row"),
    name_of=name_in_cases,
    count=count_cases,
)  # fmt: skip

STATES = Subject(
    usable="answers",
    usual=(
        "depth_max", "vertices_inside", "facets_crossing", "displacement_mean", "displacement_crossings",
        "flipped_facets", "fallbacks",
    ),
    keys=(*INPUTS, *(f"run_{name}" for name in RUN_OWN), "step"),
    no_figures=(*INPUTS, "state", "step"),
    name_of=name_in_states,
    count=count_states,
)  # fmt: skip
