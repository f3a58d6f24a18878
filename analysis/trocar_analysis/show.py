"""`show`: which rows of a result file a table is of, and what is said above and below it."""

from __future__ import annotations

from dataclasses import dataclass, field

import pandas as pd

from .errors import InputError
from .missing import notes
from .options import option_columns
from .store import CONDITIONS, ResultFile
from .subject import CASES, STATES, Subject, number_of_states, tally
from .summary import choose_figures, choose_keys, only_rows, summarise
from .table import number, render


@dataclass(frozen=True)
class Wishes:
    """What a user asks of a table."""

    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    by: list[str] | None = None  # columns or options to group by
    metrics: list[str] | None = None  # columns or metrics to show
    style: str = "text"  # or "markdown" or "csv"
    width: int | None = None  # the terminal's (see render)


def show_cases(path: str, wishes: Wishes) -> str:
    """The table of a result file's cases."""
    with ResultFile(path) as results:
        cases, units = results.cases_table(), results.units()
    if cases.empty:
        raise InputError(f"{path}: has no cases")
    return show(path, cases, units, CASES, wishes)


def show_states(path: str, wishes: Wishes) -> str:
    """The table of a result file's same-state comparison: what each strategy made of equal states."""
    with ResultFile(path) as results:
        states, units = results.states_table(), results.units()
    if states.empty:
        raise InputError(f"{path}: has no states; run a sweep with [compare] same_state = 5")
    return show(path, states, units, STATES, wishes)


def show(path: str, rows: pd.DataFrame, units: dict[str, str], subject: Subject, wishes: Wishes) -> str:
    figures = choose_figures(rows, wishes.metrics, subject)
    options = option_columns(rows, path)
    known = [*(name for name in subject.keys if name in rows), *options]
    rows = only_rows(rows.join(options), wishes.only, known)
    keys = choose_keys(rows, wishes.by, known)
    if not figures:
        raise InputError(f"{path}: has none of the usual figures; name one with --metric")
    summary = summarise(rows, keys, figures, units, subject)
    if wishes.style == "csv":
        return summary.to_csv(index=False)
    what = count_of_cases(rows) if subject is CASES else count_of_states(rows)
    heading = [f"{path}: {what}", *shared_conditions(rows, keys, units)]
    below = notes(subject.count(rows)[0], figures, subject)
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
