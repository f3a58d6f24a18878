"""Statistics of pairs against answers worked out by hand, scipy's, and what chance alone gives."""

import math
import unittest

import numpy as np
from scipy.stats import binom, norm, wilcoxon
from trocar_analysis import paired
from trocar_analysis.paired import (
    bootstrap_interval, compare_pairs, draw_seeds, ends, median, paired_differences, relative_change, signed_rank,
    tail_beyond, weighted_medians,
)  # fmt: skip

INF = math.inf


def design(organs, seeds, cases=1):
    """Organ and seed of each of `cases` cases a seed."""
    return np.repeat(np.arange(organs), seeds * cases), np.tile(np.repeat(np.arange(seeds), cases), organs)


class Numbers(unittest.TestCase):
    def test_a_failed_case_is_worse_than_any_value_and_like_another(self):
        a, b = np.array([1, INF, INF, 2, -INF]), np.array([3, INF, 5, INF, -INF])
        self.assertEqual([*paired_differences(a, b)], [2, 0, -INF, INF, 0])

    def test_medians(self):
        for values, middle in (
            ([3, 1, 2], 2), ([4, 1, 2, 3], 2.5), ([1, INF, INF], INF), ([1, 2, INF, INF], INF), ([-INF, INF], 0),
            ([-INF, 1, 3, INF], 2), ([1.7e308, 1.7e308], 1.7e308),
        ):  # fmt: skip
            self.assertEqual(median(np.array(values, float)), middle, values)

    def test_relative_change(self):
        for change, before, percent in ((1, 4, 25), (-1, -4, -25), (0, 0, 0), (2, 0, INF), (-2, 0, -INF), (INF, 3, INF)):
            self.assertEqual(relative_change(change, before), percent)
        self.assertTrue(math.isnan(relative_change(0, INF)))

    def test_the_median_difference_is_not_that_of_the_medians(self):
        a, b = np.array([0.0, 1, 10]), np.array([9.0, 2, 11])
        change = compare_pairs(a, b, *design(1, 3))
        self.assertEqual((change.median_a, change.median_b, change.difference), (1, 9, 1))

    def test_no_pairs(self):
        change = compare_pairs(*np.empty((4, 0)))
        self.assertEqual(change.pairs, 0)
        self.assertTrue(math.isnan(change.difference) and math.isnan(change.p))


class SignedRank(unittest.TestCase):
    def test_against_scipy_and_by_hand(self):
        # Five differences of one sign: 2 of the 2^5 ways to set signs are as extreme.
        self.assertEqual(signed_rank(np.array([1.0, 2, 3, 4, 5])), 2 / 32)
        values = np.random.default_rng(1).normal(0.3, 1, 80)
        self.assertAlmostEqual(signed_rank(values), wilcoxon(values, mode="approx").pvalue, 12)
        with_zeros = np.concatenate([values, np.zeros(9)])
        self.assertAlmostEqual(
            signed_rank(with_zeros), wilcoxon(with_zeros, zero_method="pratt", mode="approx").pvalue, 12
        )

    def test_zeros_and_failed_cases(self):
        self.assertEqual(signed_rank(np.zeros(7)), 1)
        some = np.array([-1.0, 2, -3, 4, 9])
        self.assertEqual(signed_rank(np.where(some == 9, INF, some)), signed_rank(some))


class Interval(unittest.TestCase):
    def test_weighted_medians_are_those_of_repeated_values(self):
        generator = np.random.default_rng(2)
        for cases in (1, 7, 30):
            values, unit = generator.integers(-5, 5, cases).astype(float), generator.integers(0, 4, cases)
            unit[0] = 0
            weights = np.concatenate([np.ones((50, 1)), generator.integers(0, 4, (50, 3))], axis=1)
            for row, low, high in zip(weights, *weighted_medians(values, weights * 1.25, unit)):
                repeated = np.sort(np.repeat(values, row[unit].astype(int)))
                self.assertEqual((low, high), (repeated[(len(repeated) - 1) // 2], repeated[len(repeated) // 2]))

    def test_seeds_are_drawn_within_organs_and_bring_all_their_cases(self):
        organs, seeds = design(3, 5, 2)
        weights, unit = draw_seeds(organs, seeds, 1000)
        self.assertEqual(len({*zip(unit, organs, seeds)}), 15)
        for organ in range(3):
            own = weights[:, np.unique(unit[organs == organ])]
            np.testing.assert_allclose(own.sum(axis=1), 5)
        # Rao and Wu: the variance of a mean is that of the mean itself, not (m - 1) / m of it.
        values = np.random.default_rng(3).normal(size=15)
        within = sum(values[k : k + 5].var(ddof=1) / 5 for k in (0, 5, 10))
        weights, _ = draw_seeds(*design(3, 5), 20_000)
        self.assertAlmostEqual((weights @ values).var() / 25, within, delta=0.05 * within)

    def test_too_few_seeds(self):
        for organs, seeds, enough in ((1, 11, False), (1, 12, True), (20, 1, False), (6, 2, True)):
            low, _ = bootstrap_interval(np.arange(organs * seeds) * 1.0, *design(organs, seeds), resamples=100)
            self.assertEqual(not math.isnan(low), enough)

    def test_the_same_every_time_and_the_data_in_any_order(self):
        values, (organs, seeds) = np.random.default_rng(4).normal(size=30), design(6, 5)
        order = np.random.default_rng(5).permutation(30)
        one = bootstrap_interval(values, organs, seeds)
        self.assertEqual(one, bootstrap_interval(values[order], organs[order], seeds[order]))
        self.assertLess(one[0], np.median(values))
        self.assertGreater(one[1], np.median(values))

    def test_its_width_is_that_of_the_order_statistics(self):
        # Of 101 values, those between the 41st and the 61st hold the median with 95 % (binomial).
        low, high = bootstrap_interval(np.arange(101.0), *design(1, 101))
        self.assertLessEqual(abs(low - 40), 1)
        self.assertLessEqual(abs(high - 60), 1)

    def test_blocks_do_not_change_it(self):
        values, (organs, seeds) = np.random.default_rng(6).normal(size=60), design(6, 5, 2)
        whole = bootstrap_interval(values, organs, seeds)
        block, paired.BLOCK = paired.BLOCK, 1000
        try:
            self.assertEqual(bootstrap_interval(values, organs, seeds), whole)
        finally:
            paired.BLOCK = block

    def test_failed_cases_at_both_ends(self):
        values = np.concatenate([np.full(6, -INF), np.zeros(8), np.full(16, INF)])
        low, high = bootstrap_interval(values, *design(1, 30))
        self.assertEqual(high, INF)
        self.assertFalse(math.isnan(low))

    def test_with_few_seeds_it_reaches_further(self):
        # One organ of n seeds: the tail of the normal distribution beyond Student's t of n - 1 degrees, from tables.
        for seeds, t in ((12, 2.2010), (16, 2.1314), (121, 1.9799)):
            self.assertAlmostEqual(tail_beyond(*design(1, seeds)), norm.sf(t), delta=1e-5)
        self.assertAlmostEqual(tail_beyond(*design(3, 5)), norm.sf(2.1788), delta=1e-5)  # 12 degrees
        alone = np.append(np.zeros(16), [1, 2])  # two organs of one seed each say nothing of how seeds differ
        self.assertEqual(tail_beyond(alone, np.append(np.arange(16), [0, 0])), tail_beyond(*design(1, 16)))
        self.assertAlmostEqual(tail_beyond(*design(30, 1000)), 0.025, 5)

    def test_one_organ_misses_the_median_rarely_for_any_number_of_seeds(self):
        # The interval of n different values goes from the k-th to the k-th from the end; so often it misses (binomial).
        for count in range(12, 41):
            low, high = bootstrap_interval(np.arange(1.0, count + 1), *design(1, count))
            self.assertLessEqual(binom.cdf(low - 1, count, 0.5) + binom.sf(high - 1, count, 0.5), 0.07, count)

    def test_swapped_labels_are_rarely_a_change(self):
        # The null check of the design: 1,000 random swaps of A and B within pairs, at the sizes that sweeps have.
        generator = np.random.default_rng(7)
        for shape, swap_seeds in (((6, 5, 2), False), ((6, 5, 2), True), ((1, 16), False), ((3, 20), False)):
            organs, seeds = design(*shape)
            weights, unit = draw_seeds(organs, seeds, 1000)
            tail = tail_beyond(organs, seeds)
            sizes = np.abs(generator.normal(size=len(organs))) ** 3
            found = tested = 0
            for _ in range(1000):
                signs = generator.choice([-1, 1], len(organs))
                differences = sizes * (signs[unit] if swap_seeds else signs)
                low, high = ends(*weighted_medians(differences, weights, unit), tail)
                found += low > 0 or high < 0
                tested += not swap_seeds and signed_rank(differences) < 0.05
            self.assertLessEqual(found, 70)
            self.assertGreater(found, 5)
            self.assertLessEqual(tested, 70)


if __name__ == "__main__":
    unittest.main()
