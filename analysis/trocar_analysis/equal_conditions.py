"""Strategies side by side, as `rank` and `front` have them: the cases of those conditions alone under which each of them
has a value. Otherwise one that ran under easy conditions only, or has no value where it is hard, would look good."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd

from .case_figures import Cases, Figure
from .conditions import condition_interval
from .errors import InputError
from .options import option_columns
from .store import CONDITIONS


@dataclass(frozen=True)
class EqualConditions:
    """A condition is all that a case is run with but for its strategy; its seed, too."""

    strategies: list[str]  # their labels, in the order of the file
    condition: pd.Series  # the number of each case's condition, of those left out, too
    used: pd.DataFrame  # the cases of the others, the same number for each strategy
    conditions: int  # … which is how many these are
    notes: list[str]  # what is left out, and why

    def medians(self, figure: Figure) -> pd.DataFrame:
        """One row per strategy: its `label`, its `number` in the file, `cases`, how many of them `failed`, and of the
        figure `median`, and `low` and `high` of its interval (see condition_interval). A failed case is the worst value
        there is."""
        rows = []
        for number, label in enumerate(self.strategies):
            own = self.used[self.used["label"] == label]
            values = figure.values.loc[own.index].to_numpy()
            estimate = condition_interval(values, own["organ"].to_numpy(), own["seed"].to_numpy())
            rows.append(
                {"label": label, "number": number, "cases": len(own), "failed": int((own["status"] != "complete").sum()),
                 "median": estimate.median, "low": estimate.low, "high": estimate.high}
            )  # fmt: skip
        return pd.DataFrame(rows)


def equal_conditions(cases: Cases, figures: list[Figure], fewest: int) -> EqualConditions:
    """Of the strategies among the cases, `fewest` or more, with respect to these figures. InputError where they are
    fewer, where a strategy has two cases under one condition, and where nothing is left."""
    table = cases.table
    names = list(dict.fromkeys(table["label"]))
    if len(names) < fewest:
        raise InputError(
            f"{cases.path}: {len(names)} {'strategy' if len(names) == 1 else 'strategies'} ({', '.join(names)}), and it "
            f"takes {fewest} or more; run more of them, or choose more with --only label=…"
        )
    condition = table.groupby(conditions_in(table), sort=False, dropna=False).ngroup()
    refuse_twice(cases, condition)
    cells = (condition.to_numpy(), table["label"].map({name: k for k, name in enumerate(names)}).to_numpy())
    was_run, has_value = np.zeros((2, condition.max() + 1, len(names)), bool)
    was_run[cells] = True
    has_value[cells] = np.all([figure.values.notna() for figure in figures], axis=0)
    is_whole = has_value.all(axis=1)
    lacking = lacking_words(names, was_run, has_value)
    why = [figure.lacking for figure in figures if figure.lacking]
    if not is_whole.any():
        raise InputError(
            f"{cases.path}: of {len(is_whole)} conditions none has a value of each of the {len(names)} strategies; "
            + "; ".join([lacking, *why, "choose strategies and conditions that have one, with --only"])
        )
    is_used = pd.Series(is_whole[condition], index=table.index)
    notes = []
    if not is_whole.all():
        failed = int((table.loc[~is_used, "status"] != "complete").sum())
        notes.append(
            f"{(~is_whole).sum()} of {len(is_whole)} conditions are left out: {lacking}."
            + (f" Failed among them: {failed}." if failed else "")
        )
    notes += [f"{said}." for said in why]
    return EqualConditions(names, condition, table[is_used.to_numpy()], int(is_whole.sum()), notes)


def conditions_in(table: pd.DataFrame) -> list[str]:
    return [name for name in CONDITIONS if name in table]


def refuse_twice(cases: Cases, condition: pd.Series) -> None:
    table = cases.table
    again = pd.DataFrame({"condition": condition, "label": table["label"]}).duplicated()
    if not again.any():
        return
    second = table[again].iloc[0]
    same = (condition == condition[again.idxmax()]) & (table["label"] == second["label"])
    first, options = table[same].iloc[0], option_columns(table[same], cases.path)
    differ = [name for name in options if options[name].nunique() > 1]
    raise InputError(
        f"{cases.path}: cases {first['case_id']} and {second['case_id']} are both of {second['label']} under the same "
        "conditions; "
        + (f"choose with --only {differ[0]}=…" if differ else "rank cases of one sweep, or give the strategies labels")
    )


def lacking_words(names: list[str], was_run: np.ndarray, has_value: np.ndarray) -> str:
    """In how many conditions a strategy was not run or has no value, [conditions, strategies]. A condition may lack
    several."""
    has_any = has_value.any(axis=1)
    said = [f"no value with any strategy ({(~has_any).sum()})"] if not has_any.all() else []
    lacks_value = was_run & ~has_value & has_any[:, None]
    for why, lacks in (("not run with", ~was_run), ("no value with", lacks_value)):
        counts = sorted(zip(names, lacks.sum(axis=0).tolist()), key=lambda item: -item[1])
        if lacks.any():
            said.append(f"{why} " + ", ".join(f"{name} ({count})" for name, count in counts if count))
    return "; ".join(said)
