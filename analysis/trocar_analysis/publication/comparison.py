"""What a table and the captions say of one figure: its medians, and which strategies are told apart. All of it is worked out
by what `rank`, `sensitivity`, `compare` and `claims` use."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
import pandas as pd

from ..case_figures import Cases, Figure
from ..conditions import condition_interval
from ..effects import holm
from ..equal_conditions import EqualConditions, equal_conditions
from ..errors import InputError
from ..paired import median, paired_differences, signed_rank
from ..rank import FEWEST_BLOCKS, Ranking, Wishes, ranking_of
from ..ranks import order_of
from ..sensitivity import points_of
from .chosen import words_of

FEWEST_STRATEGIES = 2
NOT_COMPARED = "Strategies are not compared: under no condition has each of them one value, and these medians are of different ones."
CHANGE = ["difference", "difference_low", "difference_high", "p"]


@dataclass(frozen=True)
class Compared:
    """One figure of the cases."""

    figure: Figure
    words: str  # what it is
    used: pd.DataFrame  # the cases that it is of: of equal conditions where `is_fair`, else all
    labels: list[str]  # of all strategies, in the order of the file
    is_fair: bool  # the strategies are compared under the same conditions
    notes: list[str]  # what is left out, or why they are not
    table: pd.DataFrame  # a row per strategy, the best first where one is: see strategies_of
    ranking: Ranking | None
    no_ranking: str  # why there is none
    blocks: int  # that the p of `table` are over; 0: there are none
    cautions: list[str]  # what to say of times


def compare_strategies(cases: Cases, figure: Figure, only: list[str], better: dict[str, str]) -> Compared:
    """The strategies by a figure, under equal conditions where there are such."""
    labels = list(dict.fromkeys(cases.table["label"]))
    equal, notes, why = None, [], "one strategy, so none is better"
    if len(labels) >= FEWEST_STRATEGIES:
        try:
            equal = equal_conditions(cases, [figure], FEWEST_STRATEGIES)
            notes = equal.notes
        except InputError as error:
            why, notes = reason(error, cases), [NOT_COMPARED]
    used = equal.used if equal else cases.table
    ranking, no_ranking = None, why
    if equal:
        try:
            ranking, no_ranking = ranking_of(cases, Wishes(figure.name, only, better)), ""
        except InputError as error:
            no_ranking = reason(error, cases)
    table, blocks = strategies_of(figure, used, equal, ranking)
    return Compared(
        figure, words_of(figure, cases), used, labels, equal is not None, notes, table, ranking, no_ranking, blocks,
        cases.cautions([figure], used.index),
    )  # fmt: skip


def reason(error: InputError, cases: Cases) -> str:
    """What is wrong and what to do, without the file's name and what is between these two."""
    parts = str(error).removeprefix(f"{cases.path}: ").split("; ")
    return "; ".join(dict.fromkeys([parts[0], parts[-1]]))


def strategies_of(
    figure: Figure, used: pd.DataFrame, equal: EqualConditions | None, ranking: Ranking | None
) -> tuple[pd.DataFrame, int]:
    """A row per strategy of sensitivity.points_of; `mean_rank`; CHANGE from the first row's strategy, the best one: the
    median of the paired differences, its interval, and p. NaN for what there is not. Besides, how many blocks p is over."""
    table = points_of(used, ["label"], [figure])
    table["mean_rank"] = np.nan
    if ranking:
        table["mean_rank"] = table["label"].map(ranking.table.set_index("label")["mean_rank"])
        table = table.sort_values("mean_rank", kind="stable", ignore_index=True)
    elif equal and figure.better in ("low", "high"):
        table = table.sort_values("median", ascending=figure.better == "low", kind="stable", ignore_index=True)
    table = table.assign(**{name: np.nan for name in CHANGE})
    if equal is None or figure.better not in ("low", "high"):
        return table, 0
    values = pd.DataFrame({"condition": equal.condition.loc[used.index], "label": used["label"],
                           "value": figure.values.loc[used.index]})  # fmt: skip
    by_label = values.pivot(index="condition", columns="label", values="value")
    where = used.assign(condition=values["condition"]).groupby("condition")[["organ", "seed"]].first()
    changes, blocks = changes_of(by_label[[*table["label"]]], where)
    table[CHANGE] = changes
    return table, blocks


def changes_of(values: pd.DataFrame, where: pd.DataFrame) -> tuple[np.ndarray, int]:
    """CHANGE of each column of `values` [conditions, strategies] from the first one, [strategies, 4], and how many blocks
    there are. `where`: organ and seed of the conditions.

    Cases of one seed on an organ are not independent, and the signed-rank test takes its values as such: so p is over the
    medians of the differences in these blocks, as ranks are in `rank`. It is adjusted for all pairs of strategies, since the
    first was chosen by its values."""
    organs, seeds = where["organ"].to_numpy(), where["seed"].to_numpy()
    block = where.groupby(["organ", "seed"], sort=False).ngroup().to_numpy()
    blocks = int(block.max()) + 1
    table = values.to_numpy(float)
    pairs = [*combinations(range(table.shape[1]), 2)]
    differences = [differences_of(table[:, a], table[:, b]) for a, b in pairs]
    tested = [signed_rank(np.array([median(d[block == k]) for k in range(blocks)])) for d in differences]
    adjusted = holm(np.array(tested))
    changes = np.full((table.shape[1], len(CHANGE)), np.nan)
    for (first, second), difference, p in zip(pairs, differences, adjusted):
        if first == 0:
            change = condition_interval(difference, organs, seeds)
            changes[second] = change.median, change.low, change.high, p if blocks >= FEWEST_BLOCKS else np.nan
    return changes, blocks if blocks >= FEWEST_BLOCKS else 0


def differences_of(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """B − A; 0 where they differ by rounding alone."""
    order = order_of(np.stack([a, b], axis=1))
    return np.where(order[:, 0] == order[:, 1], 0.0, paired_differences(a, b))
