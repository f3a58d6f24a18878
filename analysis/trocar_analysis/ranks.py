"""Ranks of several strategies under equal conditions, and which of them the ranks tell apart (Demšar 2006). They know
nothing of files and of what the values mean.

A block is one set of conditions under which every strategy ran: organ, tool, scene, speed, seed, release, or what the
caller takes for one. The tests take blocks as independent, which those of one seed are not: they share the place. Where
the tests matter, let a block be a seed on an organ, and the value a strategy's mean rank over its cases there.

A value may be infinite: the worst there is, which a failed case counts as."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import f, friedmanchisquare, rankdata, studentized_range

ALPHA = 0.05


@dataclass(frozen=True)
class Ranks:
    """1 is best; strategies that are equal share the mean of their ranks."""

    strategies: list[str]  # in the order of their first case
    of_block: np.ndarray  # [blocks, strategies]
    failed: np.ndarray  # how many of a strategy's values are infinite, [strategies]
    left_out: int  # blocks that lack a strategy's value

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
    complete = table[~np.isnan(table).any(axis=1)]
    ranks = rankdata(complete if low_is_better else -complete, axis=1) if len(complete) else complete
    return Ranks(names, ranks, np.isinf(complete).sum(axis=0), len(table) - len(complete))


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
