"""The conditions of `compare --fail-on`: which changes their author wants to be stopped at."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from .change_table import amount, percent
from .changes import NO_TIMES
from .errors import InputError
from .pairing import Pairing, outcomes

OUTCOMES = "outcomes"  # the condition on how cases end
COMPARISONS = {">": operator.gt, "<": operator.lt, ">=": operator.ge, "<=": operator.le}
CONDITION = re.compile(
    r"\s*(?P<figure>[A-Za-z]\w*)\s*(?P<sign>[<>]=?)\s*"
    r"(?P<limit>[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?)\s*(?P<percent>%?)\s*",
    re.ASCII | re.IGNORECASE,
)


@dataclass(frozen=True)
class Condition:
    """On the median paired difference B − A of a figure, in each group."""

    said: str
    figure: str  # a column or a metric, or OUTCOMES
    compare: Callable[[float, float], bool] = operator.gt
    limit: float = 0  # in the stored unit, or in % of the median of A
    is_relative: bool = False


@dataclass
class Judgement:
    """One line for each condition and group."""

    violated: list[str] = field(default_factory=list)
    not_evaluated: list[str] = field(default_factory=list)  # and why


def read_conditions(said: list[str]) -> list[Condition]:
    return [read_condition(text) for text in said]


def read_condition(said: str) -> Condition:
    if said.strip() == OUTCOMES:
        return Condition(said.strip(), OUTCOMES)
    match = CONDITION.fullmatch(said)
    if match is None or not np.isfinite(float(match["limit"])):
        raise InputError(
            f"--fail-on \"{said}\": expected {OUTCOMES}, or a figure, one of > < >= <=, and a number with or without %, "
            'such as "depth_max_d_max > +5%"'
        )
    compare = COMPARISONS[match["sign"]]
    return Condition(said.strip(), match["figure"], compare, float(match["limit"]), match["percent"] == "%")


def judge(
    conditions: list[Condition], named: dict[str, list[str]], pairing: Pairing, summary: pd.DataFrame, keys: list[str]
) -> Judgement:
    """`named`: the columns that each figure of a condition stands for; `summary` holds them (see compare_groups)."""
    judgement = Judgement()
    for condition in conditions:
        if condition.figure == OUTCOMES:
            judge_outcomes(pairing, judgement)
            continue
        for _, row in summary[summary["metric"].isin(named[condition.figure])].iterrows():
            # A group that only B has is new: there is nothing that it could have got worse than.
            if row["both"] or row["only_a"]:
                group = ", ".join(f"{key} {row[key]}" for key in keys)
                judge_group(condition, row, f"{condition.said}: {row['metric']}, {group}", pairing.times, judgement)
    return judgement


def judge_outcomes(pairing: Pairing, judgement: Judgement) -> None:
    worse = outcomes(pairing).worse
    if worse:
        judgement.violated.append(f"{OUTCOMES}: {worse} of {len(pairing.a)} cases completed in A and not in B")
    if missing := len(pairing.only_a):
        judgement.violated.append(f"{OUTCOMES}: {missing} of {len(pairing.a) + missing} cases of A are missing in B")


def judge_group(condition: Condition, row: pd.Series, where: str, times: str, judgement: Judgement) -> None:
    change = row["relative"] if condition.is_relative else row["difference"]
    if row["verdict"] == NO_TIMES:
        judgement.not_evaluated.append(f"{where}: times are not comparable ({times})")
    elif row["pairs"] == 0:
        judgement.not_evaluated.append(f"{where}: no pair has a value in A and in B ({row['both']} cases in both)")
    elif np.isnan(change):
        judgement.not_evaluated.append(f"{where}: no % of the median of A: it is that of failed cases")
    elif condition.compare(change, condition.limit):
        unit = f" {row['units']}".rstrip()
        judgement.violated.append(
            f"{where}: {percent(row['relative'])}, B − A {amount(row['difference'], '+')}{unit} "
            f"(median {amount(row['median_a'], '')} → {amount(row['median_b'], '')}{unit}, {row['pairs']} pairs)"
        )
