"""The strategies side by side by one figure, as the page has them: medians with intervals, ranks and what they tell apart."""

from __future__ import annotations

import numpy as np
import pandas as pd

from ..case_figures import Cases, Figure, judged_figure
from ..critical_difference import p_words
from ..equal_conditions import equal_conditions
from ..errors import InputError
from ..rank import Ranking, Wishes, ranking_of
from ..ranks import critical_difference, friedman, not_told_apart
from ..sensitivity_table import shown_unit
from .main_figures import MainFigure


def compared(main: MainFigure, cases: Cases, better: dict[str, str]) -> dict:
    """@returns `rows` per strategy, the best first, empty where nothing can be said; `why` they are not ranked"""
    said = {"name": main.name, "title": main.title, "short": main.short, "why": ""}
    try:
        ranking = ranking_of(cases, Wishes(main.name, [], better))
    except InputError as error:
        return said | unranked(main, cases, better, str(error))
    notes = [*ranking.about, *ranking.cautions]
    return said | figure_told(ranking.figure, ranking.table, cases) | {"ranks": ranks_told(ranking), "notes": notes}


def unranked(main: MainFigure, cases: Cases, better: dict[str, str], why: str) -> dict:
    """Medians alone, where there are too few strategies or blocks to rank; nothing where these are not comparable."""
    # What follows the semicolon is about the arguments of `rank`.
    said = {"why": why.removeprefix(f"{cases.path}: ").partition("; run more")[0], "ranks": None}
    try:
        figure = judged_figure(main.name, cases, better)
        equal = equal_conditions(cases, [figure], 1)
    except InputError:
        nothing = {"unit": "", "factor": 1, "better": None, "lacking": {}, "rows": []}
        return said | nothing | {"notes": []}
    table = equal.medians(figure).assign(mean_rank=np.nan)
    table = table.sort_values("median", ascending=figure.better == "low", kind="stable", ignore_index=True)
    return said | figure_told(figure, table, cases) | {"notes": [*equal.notes, *cases.cautions([figure], equal.used.index)]}


def figure_told(figure: Figure, table: pd.DataFrame, cases: Cases) -> dict:
    """Numbers are in the stored unit; `factor` makes them those of `unit`."""
    unit, factor = shown_unit(figure.unit, table)
    every = cases.table
    lacks = every.loc[figure.values.isna() & (every["status"] == "complete"), "label"].value_counts()
    rows = [
        {"label": row["label"], "cases": int(row["cases"]), "failed": int(row["failed"])}
        | {name: finite(row[name]) for name in ("median", "low", "high")}
        | {"meanRank": finite(row["mean_rank"])}
        for _, row in table.iterrows()
    ]
    told = {"unit": unit, "factor": factor, "better": figure.better}
    return told | {"lacking": {label: int(count) for label, count in lacks.items()}, "rows": rows}


def ranks_told(ranking: Ranking) -> dict:
    ranks = ranking.ranks
    difference = critical_difference(len(ranks.strategies), len(ranks.blocks))
    groups = not_told_apart(ranks.mean, difference)
    return {
        "blocks": len(ranks.blocks), "leftOut": ranks.left_out, "difference": difference, "p": p_words(friedman(ranks.of_block)),
        "groups": [[ranks.strategies[number] for number in group] for group in groups],
    }  # fmt: skip


def finite(value: float) -> float | str | None:
    """As JSON has it: what is infinite, since cases failed, as a text; null for none."""
    return None if np.isnan(value) else ("inf" if value > 0 else "-inf") if np.isinf(value) else float(value)
