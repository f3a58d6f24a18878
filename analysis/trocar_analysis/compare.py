"""`compare`: what changed from one result file to another, pair by pair, and whether a gate lets it pass."""

from __future__ import annotations

from dataclasses import dataclass, field

import pandas as pd

from .change_table import lay_out, legend, missing_lines
from .changes import compare_groups
from .errors import InputError
from .gate import OUTCOMES, Judgement, judge, read_conditions
from .pairing import Pairing, outcome_lines, pair_files
from .subject import CASES
from .summary import choose_figures, choose_keys
from .table import aligned, markdown

# What is compared when nothing is asked for: what is left inside, side effects, how far vertices go, time.
USUAL = (
    "depth_max_d_max", "tool_volume_inside_d_max", "facets_crossing_d_mean", "self_crossings_d_mean",
    "displacement_mean_mean", "time_handle_p50",
)  # fmt: skip


@dataclass(frozen=True)
class Comparison:
    """What a user asks of `compare`."""

    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    by: list[str] | None = None  # columns or options to group by
    metrics: list[str] | None = None  # columns or metrics to compare
    fail_on: list[str] = field(default_factory=list)  # conditions (see gate)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"; others are not judged
    style: str = "text"  # or "markdown" or "csv"


def compare(path_a: str, path_b: str, asked: Comparison) -> tuple[str, Judgement]:
    """The table, and what the conditions say to it."""
    conditions = read_conditions(asked.fail_on)
    pairing = pair_files(path_a, path_b, asked.only)
    figures, named = choose(pairing, asked.metrics, [condition.figure for condition in conditions])
    keys = choose_keys(pairing.inputs, asked.by or ["label"], pairing.keys)
    summary = compare_groups(pairing, keys, figures, asked.better)
    judgement = judge(conditions, named, pairing, summary, keys)
    if asked.style == "csv":
        return summary.to_csv(index=False), judgement
    columns = lay_out(summary, keys)
    notes = [*outcome_lines(pairing), *missing_lines(pairing, figures), *legend(pairing, summary)]
    if asked.style == "markdown":
        return markdown(columns) + "\n" + "".join(f"- {note}\n" for note in notes), judgement
    heading = f"A: {path_a}, B: {path_b}, {len(pairing.a)} cases in both"
    return "\n".join([heading, "", *aligned(columns, with_quartiles=True), "", *notes, ""]), judgement


def choose(
    pairing: Pairing, asked: list[str] | None, in_conditions: list[str]
) -> tuple[list[str], dict[str, list[str]]]:
    """The columns to compare, and those of them that each name in a condition stands for. A column that only one file
    has is compared too: none of its pairs has both values."""
    new = [name for name in pairing.b if name not in pairing.a]
    columns = pd.concat([pairing.a, pairing.b[new]], axis=1)
    named = {name: choose_figures(columns, [name], CASES) for name in in_conditions if name != OUTCOMES}
    usual = [name for name in USUAL if name in columns]
    figures = choose_figures(columns, asked, CASES) if asked else usual
    figures = list(dict.fromkeys([*figures, *(column for found in named.values() for column in found)]))
    if not figures:
        raise InputError("the files have none of the usual figures; name one with --metric")
    return figures, named
