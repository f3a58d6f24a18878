"""Statistics of paired values: what changed from A to B under equal conditions. They know nothing of files and of what
the values mean.

A value may be infinite: the worst there is, which a failed case counts as. Two that are infinite alike do not differ.
NaN is not allowed: who calls counts such pairs and leaves them out."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.stats import norm, rankdata, t, wilcoxon

LEVEL = 0.95  # of the interval
RESAMPLES = 10_000
GENERATOR_SEED = 20090701  # fixed: the same files give the same interval
FEWEST_SEEDS = 12  # that have another one on their organ; with fewer the interval misses 0 too often by chance
BLOCK = 4_000_000  # weights that are held at once


@dataclass(frozen=True)
class Change:
    """From A to B, of one figure over `pairs` pairs. NaN where there is none."""

    pairs: int
    median_a: float
    median_b: float
    difference: float  # median of the paired differences B − A, which need not be that of the medians
    low: float  # of the interval of `difference`
    high: float
    relative: float  # `difference` in percent of median_a (see relative_change)
    zeros: int  # pairs that do not differ
    p: float  # of the signed-rank test


def compare_pairs(a: np.ndarray, b: np.ndarray, organs: np.ndarray, seeds: np.ndarray) -> Change:
    """`a` and `b` hold the values of the pairs, `organs` and `seeds` what each pair was run with, [pairs]."""
    if len(a) == 0:
        nothing = float("nan")
        return Change(0, nothing, nothing, nothing, nothing, nothing, nothing, 0, nothing)
    differences = paired_differences(a, b)
    change, median_a = median(differences), median(a)
    low, high = bootstrap_interval(differences, organs, seeds)
    return Change(
        len(a), median_a, median(b), change, low, high, relative_change(change, median_a),
        int((differences == 0).sum()), signed_rank(differences),
    )  # fmt: skip


def paired_differences(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """B − A, and 0 where both are infinite alike."""
    same = a == b
    return np.where(same, 0.0, np.where(same, 0.0, b) - np.where(same, 0.0, a))


def relative_change(change: float, median_a: float) -> float:
    """`change` in percent of the size of `median_a`. No change is 0 % of everything; from 0 every other change is
    infinite. NaN where A's median is infinite: there is nothing to relate a change to."""
    if np.isinf(median_a):
        return float("nan")
    if change == 0:
        return 0.0
    return 100 * change / abs(median_a) if median_a != 0 else float(np.copysign(np.inf, change))


def median(values: np.ndarray) -> float:
    """The middle value, or what lies midway between the two middle ones."""
    ordered = np.sort(values)
    return float(midway(ordered[(len(ordered) - 1) // 2], ordered[len(ordered) // 2]))


def midway(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Between −∞ and ∞: 0, as for any value and its opposite."""
    opposite = np.isinf(low) & np.isinf(high) & (low != high)
    # Halves first: the sum of two large numbers may be too large.
    return np.where(opposite, 0.0, np.where(opposite, 0.0, low) / 2 + np.where(opposite, 0.0, high) / 2)


def bootstrap_interval(
    differences: np.ndarray, organs: np.ndarray, seeds: np.ndarray, resamples: int = RESAMPLES
) -> tuple[float, float]:
    """Percentile bootstrap interval (Efron 1979) of the median of `differences`, [cases]. What is drawn are seeds, within
    each organ: a seed brings all its cases there, since cases of one seed share the place and are not independent.
    Organs are not drawn: they were chosen. Of an organ's m seeds m - 1 are drawn, with replacement, and count m / (m - 1)
    times (Rao and Wu 1988): m of m give intervals too short by the factor sqrt((m - 1) / m). Where a resample has two
    middle values the lower one counts for the low end and the upper one for the high end. NaN, NaN where fewer than
    FEWEST_SEEDS seeds can be drawn.

    Any values will do, one a case, not differences alone; see conditions.py."""
    weights, seed_of_case = draw_seeds(organs, seeds, resamples)
    if len(weights) == 0:
        return float("nan"), float("nan")
    return ends(*weighted_medians(differences, weights, seed_of_case), tail_beyond(organs, seeds))


def ends(lower: np.ndarray, upper: np.ndarray, tail: float) -> tuple[float, float]:
    """The low and the high end beyond which the part `tail` of the resamples lies, of their lower and upper medians."""
    place = int(tail * (len(lower) - 1))
    return float(np.sort(lower)[place]), float(np.sort(upper)[-1 - place])


def tail_beyond(organs: np.ndarray, seeds: np.ndarray) -> float:
    """The part of the resamples beyond either end of the interval: (1 - LEVEL) / 2 where seeds are many, less where
    they are few, since their spread is itself a guess. That is the expanded percentile interval (Hesterberg 2015): as
    far out among the resamples as Student's t is on a normal distribution. The degrees of freedom are the seeds less
    the organs; a seed that is alone on its organ adds none. The factor sqrt(m / (m - 1)) of that method is already in
    the weights."""
    units, _ = seeds_on_organs(organs, seeds)
    _, seeds_of_organ = np.unique(units[0], return_counts=True)
    return float(norm.sf(t.isf((1 - LEVEL) / 2, (seeds_of_organ - 1).sum())))


def seeds_on_organs(organs: np.ndarray, seeds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What can be drawn, numbers of organ and seed [2, seeds of all organs], and which of them each case belongs to,
    [cases]."""
    _, organ_of_case = np.unique(organs, return_inverse=True)
    _, seed = np.unique(seeds, return_inverse=True)
    units, seed_of_case = np.unique(np.stack([organ_of_case, seed]), axis=1, return_inverse=True)
    return units, np.ravel(seed_of_case)


def draw_seeds(organs: np.ndarray, seeds: np.ndarray, resamples: int) -> tuple[np.ndarray, np.ndarray]:
    """How much each seed of each organ counts in each resample, [resamples, seeds of all organs], and which of them each
    case belongs to, [cases]. A seed that is alone on its organ always counts once. No resamples where there are fewer
    than FEWEST_SEEDS others."""
    units, seed_of_case = seeds_on_organs(organs, seeds)
    _, seeds_of_organ = np.unique(units[0], return_counts=True)
    return weights_of(tuple(seeds_of_organ.tolist()), resamples), seed_of_case


@lru_cache(maxsize=32)
def weights_of(seeds_of_organ: tuple[int, ...], resamples: int) -> np.ndarray:
    """draw_seeds' weights. They depend on nothing else, and a file has many groups of cases with as many seeds."""
    generator = np.random.default_rng(GENERATOR_SEED)
    weights = np.ones((resamples, sum(seeds_of_organ)))
    drawn = start = 0
    for count in seeds_of_organ:
        if count > 1:
            times = generator.multinomial(count - 1, np.full(count, 1 / count), size=resamples)
            weights[:, start : start + count] = times * (count / (count - 1))
            drawn += count
        start += count
    weights = weights if drawn >= FEWEST_SEEDS else weights[:0].copy()
    weights.flags.writeable = False
    return weights


def weighted_medians(
    values: np.ndarray, weights: np.ndarray, unit_of_value: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The median of `values` in each resample when a value counts as often as its unit does: the lower and the upper one
    of the two middle values, [resamples] each, which are the same value where there is one in the middle."""
    order = np.argsort(values, kind="stable")
    ordered, units = values[order], unit_of_value[order]
    lower, upper = np.full((2, len(weights)), ordered[0])
    if ordered[0] == ordered[-1]:
        return lower, upper
    rows = max(1, BLOCK // len(values))
    for start in range(0, len(weights), rows):
        block = slice(start, start + rows)
        up_to = np.cumsum(weights[block][:, units], axis=1)
        half = up_to[:, -1:] / 2
        # Weights are no whole numbers: half of all is met within rounding.
        lower[block] = ordered[(up_to >= half * (1 - 1e-9)).argmax(axis=1)]
        upper[block] = ordered[(up_to > half * (1 + 1e-9)).argmax(axis=1)]
    return lower, upper


def signed_rank(differences: np.ndarray) -> float:
    """Two-sided p of Wilcoxon's signed-rank test (1945): that the differences are symmetric about 0. Zeros are ranked
    and then left out (Pratt 1959); nothing but zeros gives 1. Exact up to 50 differences without zeros and ties,
    else by the normal approximation. It takes the pairs as independent, which cases of one seed are not: with several
    cases a seed, trust the interval."""
    sizes = np.abs(differences)
    if not sizes.any():
        return 1.0
    is_exact = len(np.unique(sizes)) == len(sizes) <= 50 and sizes.all()
    # The test looks at ranks only; as ranks, infinite differences are no special case.
    ranks = np.sign(differences) * rankdata(sizes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that there are few of them: tables say how many
        test = wilcoxon(ranks, zero_method="pratt", mode="exact" if is_exact else "approx")
    return float(test.pvalue)
