"""Ranks of several strategies under equal conditions, and which of them the ranks tell apart (Demšar 2006). They know
nothing of files and of what the values mean.

A block is one set of conditions under which every strategy ran: organ, tool, scene, speed, seed, release, or what the
caller takes for one. The tests take blocks as independent, which those of one seed are not: they share the place. Where
the tests matter, let a block be a seed on an organ, and the value a strategy's mean rank over its cases there: that is
rank_blocks.

A value may be infinite: the worst there is, which a failed case counts as. Values that differ by rounding alone are
equal: two strategies that do the same thing by other sums would else differ in every block."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import f, friedmanchisquare, rankdata, studentized_range

ALPHA = 0.05
ROUNDING, LEAST = 1e-9, 1e-12  # of the larger value, and of any: what differs by less does by rounding alone


@dataclass(frozen=True)
class Ranks:
    """1 is best; strategies that are equal share the mean of their ranks."""

    strategies: list[str]  # in the order of their first case
    of_block: np.ndarray  # [blocks, strategies]
    failed: np.ndarray  # how many of a strategy's values are infinite, [strategies]
    left_out: int  # blocks that lack a strategy's value
    blocks: list[Hashable]  # what each row of `of_block` is of

    @property
    def mean(self) -> np.ndarray:
        """Of each strategy, [strategies]. NaN where there is no block."""
        blocks = len(self.of_block)
        return self.of_block.sum(axis=0) / blocks if blocks else np.full(len(self.strategies), np.nan)


@dataclass(frozen=True)
class Friedman:
    """That all strategies rank alike, tested. Both have large values where they do not."""

    chi_square: float  # Friedman's, corrected for ties
    p_chi_square: float
    f: float  # Iman and Davenport's of the same ranks; ∞ where all blocks agree
    p_f: float


def rank_strategies(
    values: np.ndarray, strategies: Sequence[str], blocks: Sequence[Hashable], low_is_better: bool = True
) -> Ranks:
    """The value, the strategy and the block of each case, [cases]. NaN: the case has no such value. A block in which a
    strategy has none is left out. ValueError if a strategy has two cases in a block: the block lacks a condition."""
    names = list(dict.fromkeys(strategies))
    column = {name: number for number, name in enumerate(names)}
    row = {block: number for number, block in enumerate(dict.fromkeys(blocks))}
    cells = [(row[block], column[name]) for block, name in zip(blocks, strategies)]
    if len(set(cells)) < len(cells):
        twice = next(number for number, cell in enumerate(cells) if cell in cells[:number])
        raise ValueError(f"block {blocks[twice]} has two cases of {strategies[twice]}")
    table = np.full((len(row), len(names)), np.nan)
    for cell, value in zip(cells, values):
        table[cell] = value
    is_complete = ~np.isnan(table).any(axis=1)
    complete = table[is_complete]
    ranks = rankdata(order_of(complete if low_is_better else -complete), axis=1) if len(complete) else complete
    kept = [block for block, whole in zip(row, is_complete) if whole]
    return Ranks(names, ranks, np.isinf(complete).sum(axis=0), len(table) - len(complete), kept)


def rank_blocks(
    values: np.ndarray, strategies: Sequence[str], conditions: Sequence[Hashable], blocks: Sequence[Hashable],
    low_is_better: bool = True,
) -> Ranks:  # fmt: skip
    """As rank_strategies, where a block is several conditions (speed, scene, …): the value, the strategy, the condition
    and the block of each case, [cases].

    Strategies are ranked under each condition of a block, these ranks averaged over its conditions, and the means ranked
    again, among the strategies of the block. The figure's own values are not averaged: they are larger under one
    condition than under another, and it alone would decide; a rank weighs the same under each, and so does a failed
    case, of which there is no mean. The means are ranked again because the tests know how ranks 1, 2, …, k spread by
    chance; how means of ranks do depends on how much the conditions of a block have in common, which nobody knows: they
    spread less, and the tests would miss differences. Were each condition a block, as if they had nothing in common,
    the tests would find differences that are not there. If the strategies are alike, any order of them in a block is as
    likely as another, whatever its conditions have in common, which is all that the tests ask for. What it costs: a
    block says who is ahead, not under how many of its conditions.

    A condition in which a strategy has no value is left out, and a block without any other. `failed` counts cases of the
    conditions that are not."""
    within = rank_strategies(values, strategies, [*zip(blocks, conditions)], low_is_better)
    of_block: dict[Hashable, list[np.ndarray]] = {}
    for (block, _), ranks in zip(within.blocks, within.of_block):
        of_block.setdefault(block, []).append(ranks)
    # Sums of halves are exact: means that are equal are so to the last bit.
    means = np.array([np.mean(ranks, axis=0) for ranks in of_block.values()]).reshape(-1, len(within.strategies))
    ranks = rankdata(means, axis=1) if len(means) else means
    return Ranks(within.strategies, ranks, within.failed, len({*blocks}) - len(of_block), [*of_block])


def order_of(values: np.ndarray) -> np.ndarray:
    """Numbers from 0, along the last axis, that are in order as the values are, and equal where these differ by rounding
    alone."""
    order = np.argsort(values, axis=-1, kind="stable")
    ordered = np.take_along_axis(values, order, axis=-1)
    below, above = ordered[..., :-1], ordered[..., 1:]
    with np.errstate(invalid="ignore"):  # ∞ − ∞
        larger = np.maximum(np.abs(below), np.abs(above))
        is_near = (above - below <= np.maximum(ROUNDING * larger, LEAST)) & np.isfinite(larger)
    numbers = np.zeros(values.shape, int)
    steps = np.cumsum(~(is_near | (above == below)), axis=-1)
    np.put_along_axis(numbers, order[..., 1:], steps, axis=-1)
    return numbers


def friedman(of_block: np.ndarray) -> Friedman:
    """Of ranks [blocks, strategies], of at least three strategies (of two, see paired.signed_rank) and two blocks.
    Friedman's test (1937), whose p is too large where strategies and blocks are few, and Iman and Davenport's (1980)
    of the same ranks, which Demšar advises. All ranks equal: nothing speaks against it, p is 1."""
    blocks, strategies = of_block.shape
    if np.ptp(of_block) == 0:
        return Friedman(0.0, 1.0, 0.0, 1.0)
    test = friedmanchisquare(*of_block.T)
    most = blocks * (strategies - 1)  # chi-square where all blocks agree
    left = most - test.statistic
    # Within rounding: what is left of a sum that comes to 0.
    ratio = (blocks - 1) * test.statistic / left if left > 1e-9 * most else np.inf
    freedom = (strategies - 1, (strategies - 1) * (blocks - 1))
    return Friedman(float(test.statistic), float(test.pvalue), float(ratio), float(f.sf(ratio, *freedom)))


def critical_difference(strategies: int, blocks: int, alpha: float = ALPHA) -> float:
    """Nemenyi's (1963): mean ranks over `blocks` blocks that differ by as much are told apart; with probability
    1 − alpha no two are that in truth rank alike. q sqrt(k (k + 1) / (6 N)), q being the studentized range of k, with
    infinite degrees of freedom, over sqrt(2) (Demšar 2006)."""
    q = studentized_range.isf(alpha, strategies, np.inf) / np.sqrt(2)
    return float(q * np.sqrt(strategies * (strategies + 1) / (6 * blocks)))


def not_told_apart(mean_ranks: np.ndarray, difference: float) -> list[list[int]]:
    """The largest groups of strategies, by number and best first, of which no two differ by `difference` or more;
    groups overlap, a strategy alone is none."""
    order = np.argsort(mean_ranks, kind="stable")
    groups: list[list[int]] = []
    end = 0  # of the group before
    for start in range(len(order)):
        stop = start + int((mean_ranks[order[start:]] - mean_ranks[order[start]] < difference).sum())
        if stop - start > 1 and stop > end:
            groups.append(order[start:stop].tolist())
            end = stop
    return groups
