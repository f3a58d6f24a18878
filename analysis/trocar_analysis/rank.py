"""`rank`: which strategies do better by one figure, and which the file does not tell apart: mean ranks, tests and medians
as a table; critical_difference.py draws them.

A block of the tests is a seed on an organ, and all conditions under which every strategy has a value there (see
ranks.rank_blocks)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from .case_figures import Cases, Figure, judged_figure, plural, pooled_words, read_cases
from .critical_difference import draw_critical_difference, p_words
from .equal_conditions import conditions_in, equal_conditions
from .errors import InputError
from .ranks import ALPHA, Ranks, critical_difference, friedman, not_told_apart, rank_blocks
from .sensitivity_table import cell, shown_unit
from .table import Column, aligned, markdown

FEWEST_STRATEGIES, FEWEST_BLOCKS = 3, 2
BETTER = {"low": "lower is better", "high": "higher is better"}


@dataclass(frozen=True)
class Wishes:
    """What a user asks of `rank`."""

    metric: str  # a column, or a quotient "a/b" of two
    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"


@dataclass(frozen=True)
class Ranking:
    """What is drawn and tabulated."""

    figure: Figure
    ranks: Ranks
    table: pd.DataFrame  # one row per strategy, the best first: see EqualConditions.medians; `mean_rank`
    only: list[str]  # what the cases were chosen by
    about: list[str]  # what was ranked and what was left out
    cautions: list[str]  # what to say of times


def read_ranking(path: str, asked: Wishes) -> Ranking:
    """The strategies of a result file by a figure. InputError for a figure of which neither way is better, and where
    there is too little to rank."""
    return ranking_of(read_cases(path, asked.only), asked)


def ranking_of(cases: Cases, asked: Wishes) -> Ranking:
    """As read_ranking, of cases that have been read, by `asked.only`."""
    figure = judged_figure(asked.metric, cases, asked.better)
    equal = equal_conditions(cases, [figure], FEWEST_STRATEGIES)
    every = cases.table
    blocks = [*zip(every["organ"], every["seed"])]
    ranks = rank_blocks(figure.values.to_numpy(), [*every["label"]], [*equal.condition], blocks, figure.better == "low")
    if len(ranks.blocks) < FEWEST_BLOCKS:
        raise InputError(
            f"{cases.path}: all strategies have a value with one seed on one organ only, and it takes {FEWEST_BLOCKS} or more "
            "to tell them apart; run more seeds" + "".join(f" ({note.rstrip('.')})" for note in equal.notes[:1])
        )
    table = equal.medians(figure)
    table["mean_rank"] = table["label"].map(dict(zip(ranks.strategies, ranks.mean)))
    table = table.sort_values("mean_rank", kind="stable", ignore_index=True)
    cautions = cases.cautions([figure], equal.used.index)
    about = [blocks_words(equal.used, ranks), *shapes_words(equal.used), *equal.notes]
    return Ranking(figure, ranks, table, asked.only, about, cautions)


def blocks_words(used: pd.DataFrame, ranks: Ranks) -> str:
    """What a block is, and of how many conditions."""
    counts = used.groupby(["organ", "seed"]).size() // len(ranks.strategies)
    n = f"{counts.min()}" if counts.min() == counts.max() else f"{counts.min()} to {counts.max()}"
    pooled = pooled_words(used, [name for name in conditions_in(used) if name not in ("organ", "seed")])
    organs, seeds = used["organ"].nunique(), used["seed"].nunique()
    said = f"A block is a seed on an organ ({counted(organs, 'organ')}, {counted(seeds, 'seed')})"
    if counts.max() == 1:
        return f"{said}, of one condition."
    return f"{said}, of {n} conditions ({pooled}): strategies are ranked by the mean of their ranks under these."


def shapes_words(used: pd.DataFrame) -> list[str]:
    """A line where several organs are one shape with edges of different length."""
    organs = pd.Series(used["organ"].unique())
    shapes = organs.groupby(organs.str.partition("@")[0], sort=False).agg(list)
    several = [" and ".join(same) for same in shapes if len(same) > 1]
    if not several:
        return []
    return [
        f"{', '.join(several)}: of one shape, where a seed may be the same place; their blocks may not be independent, and "
        "differences seem surer than they are. --only organ=… chooses one."
    ]


def counted(number: int, name: str) -> str:
    return f"{number} {name if number == 1 else plural(name)}"


def draw_ranking(ranking: Ranking, files: list[str]) -> None:
    """The critical-difference diagram, into each of the files."""
    figure = ranking.figure
    said = f"{', '.join(ranking.only) or 'all cases'} · {BETTER[figure.better]}"
    if figure.title != figure.name:
        said = f"{figure.name} · {said}"
    draw_critical_difference(ranking.ranks, figure.title, files, said, [*ranking.about, *ranking.cautions])


def notes(ranking: Ranking) -> list[str]:
    """What is said below the table."""
    ranks, table = ranking.ranks, ranking.table
    test, difference = friedman(ranks.of_block), critical_difference(len(ranks.strategies), len(ranks.blocks))
    cases = table["cases"].iloc[0]
    medians = f"Medians over {cases} cases each, {BETTER[ranking.figure.better]}; "
    medians += (
        "too few seeds for intervals" if table["low"].isna().all()
        else "in brackets the 95 % bootstrap interval, seeds drawn within organs"
    )  # fmt: skip
    lost = f"; {ranks.left_out} left out, where one has no value" if ranks.left_out else ""
    return [
        f"That all rank alike: {p_words(test)} (Friedman, Iman and Davenport), over {len(ranks.blocks)} blocks{lost}.",
        f"Critical difference of mean ranks: {difference:.2f} (Nemenyi, α = {ALPHA:g}).",
        groups_words(ranks, difference),
        f"{medians}; a failed case counts as the worst value there is.",
        *ranking.about,
        *ranking.cautions,
    ]


def groups_words(ranks: Ranks, difference: float) -> str:
    groups = not_told_apart(ranks.mean, difference)
    if not groups:
        return "All are told apart."
    if len(groups[0]) == len(ranks.strategies):
        return "None is told apart from another."
    return "Not told apart: " + "; ".join(" ≈ ".join(ranks.strategies[k] for k in group) for group in groups) + "."


def csv_text(ranking: Ranking) -> str:
    """One row per strategy, in full precision and the stored unit, quotients in percent; the test is the same in all."""
    ranks, figure, table = ranking.ranks, ranking.figure, ranking.table
    whole = {"p": friedman(ranks.of_block).p_f, "critical_difference": critical_difference(*ranks.of_block.shape[::-1])}
    figure_of_all = {"metric": figure.name, "units": figure.unit, "better": figure.better}
    columns = ["label", "mean_rank", *figure_of_all, "median", "low", "high", "cases", "failed", "blocks", *whole]
    return table.assign(**figure_of_all, blocks=len(ranks.blocks), **whole)[columns].to_csv(index=False)


def markdown_text(ranking: Ranking) -> str:
    return markdown(columns_of(ranking)) + "\n" + "".join(f"- {note}\n" for note in notes(ranking))


def plain_text(ranking: Ranking) -> str:
    return "\n".join([*aligned(columns_of(ranking), with_quartiles=True), "", *notes(ranking), ""])


def columns_of(ranking: Ranking) -> list[Column]:
    table = ranking.table
    return [
        Column(("strategy", ""), "", True, plain(table["label"])),
        Column(("mean rank", ""), "", False, plain(f"{mean:.2f}" for mean in table["mean_rank"])),
        median_column(ranking.figure, table),
        Column(("failed", ""), "", False, plain(table["failed"])),
    ]


def median_column(figure: Figure, table: pd.DataFrame) -> Column:
    unit, factor = shown_unit(figure.unit, table)
    numbers = (table[["median", "low", "high"]] * factor).to_numpy(float)
    return Column((figure.name, ""), unit, False, [cell(*np.squeeze(row)) for row in numbers])


def plain(values: Iterable[object]) -> list[tuple[str, str]]:
    return [(str(value), "") for value in values]
