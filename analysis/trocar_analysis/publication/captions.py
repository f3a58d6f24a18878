"""What stands below a picture or a table: what it shows, of how many cases, how many failed and lack a value, and which test
was used. As plain sentences; latex.py makes LaTeX of them."""

from __future__ import annotations

import pandas as pd

from ..case_figures import Figure, pooled_words
from ..critical_difference import p_words
from ..front import Front
from ..rank import BETTER, groups_words
from ..ranks import ALPHA, critical_difference, friedman
from ..sensitivity_table import notes
from ..store import CONDITIONS
from .comparison import Compared
from .panels import Panels

INTERVAL = "95 % bootstrap interval, seeds drawn within organs"


def subject(compared: Compared, defined: bool = False) -> str:
    """The figure, and what it is where its name has no title, or where it is to be `defined`."""
    figure = compared.figure
    has_title = figure.title != figure.name
    name = f"{figure.title} ({figure.name})" if has_title else figure.name
    return f"{name}: {compared.words}" if compared.words and (defined or not has_title) else name


def way(figure: Figure) -> str:
    return f"{BETTER[figure.better].capitalize()}." if figure.better in BETTER else "Neither way is better."


def caption_over(compared: Compared, panels: Panels, only: list[str]) -> list[str]:
    """Of a picture of panels.py."""
    sweep = panels.sweep
    by = [name for name, keys in (("row", panels.rows), ("column", panels.columns)) if keys[0]]
    told = [f"a {which} per {name}" for which, name in zip(by, sweep.panels)]
    return tidy([
        f"{subject(compared)}, over {sweep.over_words}" + (f", {' and '.join(told)}" if told else "") + ".",
        way(compared.figure), *chosen(only), *notes(sweep), *compared.notes, tests(compared),
    ])  # fmt: skip


def caption_ranks(compared: Compared, only: list[str]) -> list[str]:
    """Of a critical-difference diagram."""
    return tidy([
        f"Strategies ranked by {subject(compared)}; 1 is the best.", way(compared.figure), *chosen(only), tests(compared),
        "Bars join strategies whose mean ranks differ by less than the critical difference.", *counts(compared),
        *compared.ranking.about, *compared.cautions,
    ])  # fmt: skip


def caption_front(front: Front) -> list[str]:
    ways = "; ".join(f"{figure.name}: {BETTER[figure.better]}" for figure in (front.figure, front.against))
    return tidy([
        f"Pareto front of {front.figure.name} and {front.against.name} ({ways}).", *chosen(front.only), *front.notes,
        *front.cautions,
    ])  # fmt: skip


def caption_table(compared: Compared, unit: str, only: list[str]) -> list[str]:
    """Of a table of latex_table.py."""
    has_intervals = compared.table["low"].notna().any()
    said = [
        subject(compared, True) + (f", in {unit}." if unit else "."), way(compared.figure), *chosen(only),
        "Median" + (f" and, in brackets, its {INTERVAL}" if has_intervals else "; too few seeds for intervals") + ".",
    ]
    if has_intervals and compared.is_fair and compared.figure.better in BETTER:
        said.append("Bold: the best of its column, where its interval overlaps with no other one's.")
    return tidy([*said, *counts(compared)])


def notes_of_table(compared: Compared) -> list[str]:
    """What stands below a table: the tests, and what was left out."""
    said = [tests(compared)]
    if compared.ranking:
        ranks = compared.ranking.ranks
        said.append(groups_words(ranks, critical_difference(len(ranks.strategies), len(ranks.blocks))))
    if compared.blocks:
        strategies = len(compared.table)
        pairs = strategies * (strategies - 1) // 2
        said.append(
            f"Difference: median of the paired differences from {compared.table['label'].iloc[0]}; p: Wilcoxon's signed-rank "
            f"test of their medians in {compared.blocks} blocks"
            + (f", by Holm's correction for all {pairs} pairs of strategies." if pairs > 1 else ".")
        )
    if compared.ranking:
        said += compared.ranking.about
    return tidy([*said, *compared.notes, *compared.cautions])


def chosen(only: list[str]) -> list[str]:
    return [f"Cases of {', '.join(only)}."] if only else []


def counts(compared: Compared) -> list[str]:
    """How many cases, how many of them failed, and how many lack a value."""
    used, figure = compared.used, compared.figure
    of_strategy = used["label"].value_counts()
    n = f"{of_strategy.min()}" if of_strategy.min() == of_strategy.max() else f"{of_strategy.min()} to {of_strategy.max()}"
    pooled = pooled_words(used, [name for name in CONDITIONS if name in used])
    failed = int((used["status"] != "complete").sum())
    worst = "counts as the worst value there is" if figure.better in BETTER else "is left out"
    no_value = missing_of(used, figure)
    return [
        f"n = {n} cases of each strategy" + (f" ({pooled})" if pooled else "") + ".",
        f"{failed} of {len(used)} cases failed; a failed case {worst}." if failed else f"None of the {len(used)} cases failed.",
        f"{no_value} cases have no value." if no_value else "None lacks a value.",
    ]  # fmt: skip


def missing_of(used: pd.DataFrame, figure: Figure) -> int:
    return int((figure.values.loc[used.index].isna() & (used["status"] == "complete")).sum())


def tests(compared: Compared) -> str:
    """That of all strategies, or why there is none."""
    if compared.ranking is None:
        return f"No test of ranks: {compared.no_ranking.rstrip('.')}." if compared.is_fair else ""
    ranks = compared.ranking.ranks
    difference = critical_difference(len(ranks.strategies), len(ranks.blocks))
    return (
        f"That all strategies rank alike: {p_words(friedman(ranks.of_block))} (Friedman's test as Iman and Davenport have it, "
        f"{len(ranks.blocks)} blocks); critical difference of mean ranks {difference:.2f} (Nemenyi, α = {ALPHA:g})."
    )


def tidy(sentences: list[str]) -> list[str]:
    """Each once, and none that is empty."""
    return list(dict.fromkeys(filter(None, sentences)))
