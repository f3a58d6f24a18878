"""`show`: which rows of a result file a table is of, and what is said above and below it."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field

import pandas as pd

from .errors import InputError
from .failures import failures_text
from .missing import notes
from .options import option_columns
from .provenance import is_time, origins, provenance_text, warning
from .store import CONDITIONS, INPUTS, OUTCOME, ResultFile
from .subject import CASES, STATES, Subject, number_of_states, tally
from .summary import choose_figures, choose_keys, only_rows, summarise
from .table import INCOMPARABLE, number, render


@dataclass(frozen=True)
class Wishes:
    """What a user asks of a table."""

    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    by: list[str] | None = None  # columns or options to group by
    metrics: list[str] | None = None  # columns or metrics to show
    style: str = "text"  # or "markdown" or "csv"
    width: int | None = None  # the terminal's (see render)


@dataclass(frozen=True)
class Contents:
    """What a table of cases is made from."""

    cases: pd.DataFrame
    origin: pd.DataFrame  # how each of them was run (see provenance.origins)
    units: dict[str, str]
    part: list[str]  # a line that says so where the file holds only a part of its sweep


def read_cases(path: str) -> Contents:
    with ResultFile(path) as results:
        cases, provenance, units = results.cases_table(), results.provenance_table(), results.units()
        whole = results.sweep_cases()
    if cases.empty:
        raise InputError(f"{path}: has no cases")
    is_part = whole is not None and len(cases) < whole
    part = [f"the file holds {len(cases)} of the sweep's {whole} cases; trocar run runs the others"] if is_part else []
    return Contents(cases, origins(cases, provenance, path), units, part)


def show_cases(path: str, wishes: Wishes) -> str:
    """The table of a result file's cases."""
    contents = read_cases(path)
    return show(path, contents.cases, contents.units, CASES, wishes, contents.origin, contents.part)


def show_states(path: str, wishes: Wishes) -> str:
    """The table of a result file's same-state comparison: what each strategy made of equal states."""
    with ResultFile(path) as results:
        states, units = results.states_table(), results.units()
    if states.empty:
        raise InputError(f"{path}: has no states; run a sweep with [compare] same_state = 5")
    return show(path, states, units, STATES, wishes)


def show_failures(path: str, wishes: Wishes) -> str:
    """The cases that did not complete."""
    contents = read_cases(path)
    cases, _ = chosen_rows(path, contents.cases, CASES, wishes)
    return failures_text(path, cases, contents.units, wishes.style)


def show_each(path: str, wishes: Wishes) -> str:
    """One row per case: what it was run with, how it ended, and its figures (all, or those asked for) in full
    precision and the stored units, as CSV."""
    contents = read_cases(path)
    cases, _ = chosen_rows(path, contents.cases, CASES, wishes)
    numbers = [name for name in contents.cases if name not in (*INPUTS, *OUTCOME)]
    figures = choose_figures(contents.cases, wishes.metrics, CASES) if wishes.metrics else numbers
    known = [name for name in (*INPUTS, "status", "reason") if name in cases]
    return cases[[*known, *figures]].to_csv(index=False)


def show_provenance(path: str, wishes: Wishes) -> str:
    """Which programs on which machines the cases come from."""
    contents = read_cases(path)
    cases, _ = chosen_rows(path, contents.cases, CASES, wishes)
    return provenance_text(path, contents.origin.loc[cases.index], wishes.style)


def chosen_rows(
    path: str, rows: pd.DataFrame, subject: Subject, wishes: Wishes
) -> tuple[pd.DataFrame, list[str]]:
    """The rows that are asked for, with the options of their strategies as columns, and by what one may ask."""
    options = option_columns(rows, path)
    known = [*(name for name in subject.keys if name in rows), *options]
    return only_rows(rows.join(options), wishes.only, known), known


def show(
    path: str, rows: pd.DataFrame, units: dict[str, str], subject: Subject, wishes: Wishes,
    origin: pd.DataFrame | None = None, part: list[str] | None = None,
) -> str:  # fmt: skip
    figures = choose_figures(rows, wishes.metrics, subject)
    rows, known = chosen_rows(path, rows, subject, wishes)
    keys = choose_keys(rows, wishes.by, known)
    if not figures:
        raise InputError(f"{path}: has none of the usual figures; name one with --metric")
    summary = summarise(rows, keys, figures, units, subject)
    has_times = origin is not None and any(map(is_time, figures))
    times = "times" if wishes.style == "csv" else f"times ({INCOMPARABLE})"
    caution = warning(origin.loc[rows.index], times) if has_times else []
    to_say = [*(part or []), *caution]
    summary["comparable"] = [not (caution and is_time(name)) for name in summary["metric"]]
    if wishes.style == "csv":
        print(*to_say, sep="\n", end="\n" if to_say else "", file=sys.stderr)
        return summary.to_csv(index=False)
    what = count_of_cases(rows) if subject is CASES else count_of_states(rows)
    heading = [f"{path}: {what}", *shared_conditions(rows, keys, units), *to_say]
    below = notes(subject.count(rows)[0], figures, subject)
    if wishes.style == "markdown":
        below = [*to_say, *below]
    return render(summary, keys, figures, units, subject, heading, below, wishes.style, wishes.width)


def count_of_cases(cases: pd.DataFrame) -> str:
    """How many there are, and how they ended."""
    failed = cases.loc[cases["status"] != "complete", "status"]
    how = f", {len(failed)} failed ({tally(failed.value_counts().to_dict())})" if len(failed) else ""
    return f"{len(cases)} cases, {len(cases) - len(failed)} complete{how}"


def count_of_states(answers: pd.DataFrame) -> str:
    """How many there are, where they come from and how many strategies they were handed to."""
    states, strategies = number_of_states(answers), answers["label"].nunique()
    counts = f"{states} states found in {answers['case_id'].nunique()} runs, {len(answers)} answers"
    return f"{counts} of {strategies} strategies"


def shared_conditions(rows: pd.DataFrame, keys: list[str], units: dict[str, str]) -> list[str]:
    """A line on the conditions that all rows share and that are no keys, when there are any."""
    known = [name for name in CONDITIONS if name in rows and name not in keys]
    shared = [name for name in known if rows[name].nunique() == 1]
    facts = [f"{name} {number(rows[name].iloc[0])} {units.get(name, '')}".strip() for name in shared]
    return [", ".join(facts)] if facts else []
