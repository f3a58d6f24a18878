"""The cases of two result files, paired by what they were run with."""

from __future__ import annotations

from dataclasses import dataclass

import pandas as pd
from pandas.api.types import is_numeric_dtype

from .errors import InputError
from .options import option_columns
from .provenance import origins, why_not_comparable
from .store import INPUTS, ResultFile
from .subject import tally
from .summary import only_rows

MOST_LISTED = 10  # cases in a line


@dataclass(frozen=True)
class Pairing:
    """Cases of A and B. All tables have case_id as index. A pair is a case that both have."""

    inputs: pd.DataFrame  # of the cases of either file: columns of INPUTS, and options of strategies; A's where both are
    a: pd.DataFrame  # the columns of the pairs' cases in A
    b: pd.DataFrame  # … and in B, in the same order
    only_a: pd.Index  # cases that B does not have
    only_b: pd.Index
    units: dict[str, str]
    keys: list[str]  # columns of `inputs` by which one may choose and group
    times: str  # why times of A and B cannot be compared; "" when they can


def pair_files(path_a: str, path_b: str, only: list[str]) -> Pairing:
    """Pairs the cases that match the filters `only` (see only_rows)."""
    a, origin_a, units_a = read_side(path_a)
    b, origin_b, units_b = read_side(path_b)
    for name in a.columns.intersection(b.columns):
        if is_numeric_dtype(a[name]) != is_numeric_dtype(b[name]):
            raise InputError(f"{path_b}: its column {name} is not of the kind that it is in {path_a}")
    every = pd.concat([a, b.loc[b.index.difference(a.index, sort=False)]])
    inputs = every[[name for name in INPUTS if name in every]]
    options = option_columns(inputs, f"{path_a} or {path_b}")
    keys = [*inputs.columns, *options]
    inputs = only_rows(inputs.join(options), only, keys)
    a, b = a.loc[a.index.isin(inputs.index)], b.loc[b.index.isin(inputs.index)]
    both = a.index.intersection(b.index, sort=False)
    if both.empty:
        raise InputError(
            f"{path_a} and {path_b}: none of the {len(a)} cases of the one is among the {len(b)} of the other: cases "
            "pair when all that they were run with is the same, options and settings too; run the same sweep for both"
        )
    return Pairing(
        inputs, a.loc[both], b.loc[both], a.index.difference(both, sort=False), b.index.difference(both, sort=False),
        units_b | units_a, keys, why_not_comparable(origin_a.loc[both], origin_b.loc[both]),
    )  # fmt: skip


def read_side(path: str) -> tuple[pd.DataFrame, pd.DataFrame, dict[str, str]]:
    """The cases of a file, how each was run, and units."""
    with ResultFile(path) as results:
        cases, provenance, units = results.cases_table(), results.provenance_table(), results.units()
    if cases.empty:
        raise InputError(f"{path}: has no cases")
    if missing := {"organ", "seed"} - {*cases}:
        raise InputError(f"{path}: is damaged: /cases has no column {', '.join(sorted(missing))}")
    cases = cases.set_index("case_id", drop=False).rename_axis(None)
    if twice := [*cases.index[cases.index.duplicated()]]:
        raise InputError(f"{path}: is damaged: /cases has case {twice[0]} twice")
    return cases, origins(cases, provenance, path), units


@dataclass(frozen=True)
class Outcomes:
    """How pairs ended."""

    changed: dict[str, list[str]]  # "complete → failed": the cases
    worse: int  # pairs that completed in A and not in B


def outcomes(pairing: Pairing) -> Outcomes:
    """Which pairs ended in another status. To get worse is not to complete any more; ways to fail have no order."""
    before, after = pairing.a["status"], pairing.b["status"]
    differ = before != after
    changes = before[differ] + " → " + after[differ]
    changed = {how: [*cases.index] for how, cases in changes.groupby(changes, sort=False)}
    return Outcomes(changed, int(((before == "complete") & (after != "complete")).sum()))


def outcome_lines(pairing: Pairing) -> list[str]:
    """What to say of statuses that changed and of cases that only one file has."""
    found = outcomes(pairing)
    lines = [f"{how}: {listed(cases)}" for how, cases in found.changed.items()]
    if not lines:
        statuses = tally(pairing.a["status"].value_counts().to_dict())
        lines.append(f"Every pair ended alike ({statuses}).")
    for here, there, cases in (("A", "B", pairing.only_a), ("B", "A", pairing.only_b)):
        if len(cases):
            lines.append(f"in {here}, missing in {there}: {listed([*cases])}")
    return lines


def listed(cases: list[str]) -> str:
    """How many, and the first of them."""
    more = ", …" if len(cases) > MOST_LISTED else ""
    return f"{len(cases)} case{'s' if len(cases) > 1 else ''} ({', '.join(cases[:MOST_LISTED])}{more})"
