"""Ranks, Friedman's test and Nemenyi's difference against Demšar's worked example (2006) and others published."""

import math
import unittest

import numpy as np
from trocar_analysis.ranks import critical_difference, friedman, not_told_apart, rank_strategies

INF, NAN = math.inf, math.nan
CLASSIFIERS = ("C4.5", "C4.5+m", "C4.5+cf", "C4.5+m+cf")
# Demšar's Table 6: areas under the curve on 14 data sets, high is better. In the 13th the last two are equal as
# printed; by the ranks beside them they are not.
AREAS = np.array([
    [0.763, 0.768, 0.771, 0.798], [0.599, 0.591, 0.590, 0.569], [0.954, 0.971, 0.968, 0.967],
    [0.628, 0.661, 0.654, 0.657], [0.882, 0.888, 0.886, 0.898], [0.936, 0.931, 0.916, 0.931],
    [0.661, 0.668, 0.609, 0.685], [0.583, 0.583, 0.563, 0.625], [0.775, 0.838, 0.866, 0.875],
    [1.000, 1.000, 1.000, 1.000], [0.940, 0.962, 0.965, 0.962], [0.619, 0.666, 0.614, 0.669],
    [0.972, 0.981, 0.9751, 0.975], [0.957, 0.978, 0.946, 0.970],
])  # fmt: skip


def rank_table(table, **options):
    """Of values [blocks, strategies]; the strategies are a, b, c …"""
    blocks, strategies = np.shape(table)
    names = [chr(ord("a") + k) for k in range(strategies)] * blocks
    return rank_strategies(np.ravel(table), names, np.repeat(np.arange(blocks), strategies).tolist(), **options)


class RankStrategies(unittest.TestCase):
    def test_low_is_best_and_equal_ones_share_the_mean(self):
        ranks = rank_table([[3.0, 1, 2], [5, 5, 1], [2, 2, 2]])
        self.assertEqual(ranks.strategies, ["a", "b", "c"])
        self.assertEqual(ranks.of_block.tolist(), [[3, 1, 2], [2.5, 2.5, 1], [2, 2, 2]])
        np.testing.assert_allclose(ranks.mean, [2.5, 5.5 / 3, 5 / 3])
        high = rank_table([[3.0, 1, 2]], low_is_better=False)
        self.assertEqual(high.of_block.tolist(), [[1, 3, 2]])

    def test_a_failed_case_ranks_last_and_like_another(self):
        ranks = rank_table([[INF, 1e300, 2], [INF, INF, 2]])
        self.assertEqual(ranks.of_block.tolist(), [[3, 2, 1], [2.5, 2.5, 1]])
        self.assertEqual(ranks.failed.tolist(), [2, 1, 0])
        self.assertEqual(rank_table([[-INF, 1.0, 2]], low_is_better=False).of_block.tolist(), [[3, 2, 1]])

    def test_blocks_without_a_value_are_left_out_and_counted(self):
        ranks = rank_table([[1.0, 2], [NAN, INF], [2, 1]])
        self.assertEqual((ranks.of_block.tolist(), ranks.left_out), ([[1, 2], [2, 1]], 1))
        self.assertEqual(ranks.failed.tolist(), [0, 0])
        lacking = rank_strategies(np.array([1.0, 2, 5]), ["a", "b", "b"], [("liver", 1), ("liver", 1), ("liver", 2)])
        self.assertEqual((lacking.of_block.tolist(), lacking.left_out), ([[1, 2]], 1))
        nothing = rank_table([[NAN, 1.0]])
        self.assertEqual((len(nothing.of_block), nothing.left_out), (0, 1))
        self.assertTrue(np.isnan(nothing.mean).all())

    def test_cases_come_in_any_order(self):
        table = np.random.default_rng(1).normal(size=(20, 4))
        names, blocks = ["a", "b", "c", "d"] * 20, np.repeat(np.arange(20), 4)
        order = np.random.default_rng(2).permutation(80)
        mixed = rank_strategies(table.ravel()[order], [names[k] for k in order], blocks[order].tolist())
        means = dict(zip(mixed.strategies, mixed.mean))
        np.testing.assert_allclose([means[name] for name in "abcd"], rank_table(table).mean)

    def test_a_block_that_lacks_a_condition(self):
        with self.assertRaisesRegex(ValueError, r"block \('liver',\) has two cases of b"):
            rank_strategies(np.arange(3.0), ["a", "b", "b"], [("liver",)] * 3)


class Demsar(unittest.TestCase):
    def setUp(self):
        self.ranks = rank_table(AREAS, low_is_better=False)

    def test_mean_ranks(self):
        self.assertEqual([round(mean, 3) for mean in self.ranks.mean], [3.143, 2.0, 2.893, 1.964])

    def test_friedman(self):
        # He does not correct for ties: three blocks of two equal ones, one of four.
        correction = 1 - (3 * (2**3 - 2) + (4**3 - 4)) / (14 * (4**3 - 4))
        test = friedman(self.ranks.of_block)
        chi_square = test.chi_square * correction
        self.assertEqual(round(chi_square, 2), 9.28)
        self.assertEqual(round(13 * chi_square / (14 * 3 - chi_square), 2), 3.69)
        self.assertAlmostEqual(test.f, 13 * test.chi_square / (14 * 3 - test.chi_square))

    def test_nemenyi(self):
        # At 0.05 nothing is told apart; at 0.1 C4.5 is from the two with m, and C4.5+cf is in both groups.
        self.assertEqual(round(critical_difference(4, 14), 2), 1.25)
        self.assertEqual(round(critical_difference(4, 14, 0.1), 2), 1.12)
        self.assertEqual(not_told_apart(self.ranks.mean, critical_difference(4, 14)), [[3, 1, 2, 0]])
        groups = not_told_apart(self.ranks.mean, critical_difference(4, 14, 0.1))
        self.assertEqual([[CLASSIFIERS[k] for k in group] for group in groups],
                         [["C4.5+m+cf", "C4.5+m", "C4.5+cf"], ["C4.5+cf", "C4.5"]])  # fmt: skip

    def test_table_of_critical_values(self):
        for alpha, published in (
            (0.05, (1.960, 2.343, 2.569, 2.728, 2.850, 2.949, 3.031, 3.102, 3.164)),
            (0.10, (1.645, 2.052, 2.291, 2.459, 2.589, 2.693, 2.780, 2.855, 2.920)),
        ):
            for strategies, q in enumerate(published, 2):
                ours = critical_difference(strategies, 7, alpha) / math.sqrt(strategies * (strategies + 1) / 42)
                self.assertAlmostEqual(ours, q, delta=1e-3)


class Friedman(unittest.TestCase):
    def test_ties(self):
        # Three ways to round first base (Hollander and Wolfe 1973), which the manual of R's friedman.test works out.
        seconds = np.array([
            [540, 550, 555], [585, 570, 575], [520, 560, 550], [555, 550, 540], [590, 585, 570], [545, 555, 560],
            [540, 540, 535], [545, 550, 535], [525, 515, 500], [585, 580, 570], [525, 520, 510], [565, 555, 545],
            [560, 535, 545], [505, 500, 495], [550, 550, 540], [545, 555, 550], [555, 555, 535], [545, 550, 555],
            [550, 545, 525], [565, 560, 540], [570, 565, 555], [630, 630, 625],
        ])  # fmt: skip
        test = friedman(rank_table(seconds).of_block)
        self.assertAlmostEqual(test.chi_square, 11.1429, 4)
        self.assertAlmostEqual(test.p_chi_square, 0.003805, 6)

    def test_without_ties_by_its_formula(self):
        table = np.random.default_rng(3).normal(size=(9, 5)) + np.arange(5) / 3
        ranks = rank_table(table)
        by_hand = 12 * 9 / (5 * 6) * ((ranks.mean**2).sum() - 5 * 6**2 / 4)
        self.assertAlmostEqual(friedman(ranks.of_block).chi_square, by_hand, 10)

    def test_all_equal_and_all_agreeing(self):
        equal = friedman(rank_table(np.ones((5, 3))).of_block)
        self.assertEqual((equal.chi_square, equal.p_chi_square, equal.f, equal.p_f), (0, 1, 0, 1))
        for blocks in (2, 7, 30):  # with 7, chi-square is not quite what it should be
            agreed = friedman(rank_table(np.tile(np.arange(6.0), (blocks, 1))).of_block)
            self.assertAlmostEqual(agreed.chi_square, 5 * blocks, 9)
            self.assertEqual((agreed.f, agreed.p_f), (INF, 0))

    def test_chance_alone(self):
        generator = np.random.default_rng(4)
        found = {"chi": 0, "f": 0, "pair": 0}
        difference = critical_difference(5, 30)
        for _ in range(600):
            ranks = rank_table(generator.normal(size=(30, 5)))
            test = friedman(ranks.of_block)
            found["chi"] += test.p_chi_square < 0.05
            found["f"] += test.p_f < 0.05
            found["pair"] += np.ptp(ranks.mean) >= difference
        for count in found.values():  # 30 expected, and 5.3 is the standard deviation
            self.assertTrue(12 <= count <= 48, found)


class NotToldApart(unittest.TestCase):
    def test_groups_are_the_largest_and_may_overlap(self):
        means = np.array([4.0, 1.0, 2.0, 2.5, 6.0])
        self.assertEqual(not_told_apart(means, 1.6), [[1, 2, 3], [3, 0]])
        self.assertEqual(not_told_apart(means, 1.5), [[1, 2], [2, 3]])  # 1.5 apart is told apart
        self.assertEqual(not_told_apart(means, 0.4), [])
        self.assertEqual(not_told_apart(means, 9), [[1, 2, 3, 0, 4]])
        self.assertEqual(not_told_apart(np.array([2.0, 2.0]), 0.1), [[0, 1]])

    def test_two_share_a_group_if_they_differ_by_less(self):
        generator = np.random.default_rng(5)
        for _ in range(50):
            means, difference = generator.uniform(1, 8, 8), generator.uniform(0, 4)
            groups = not_told_apart(means, difference)
            for one in range(8):
                for other in range(one):
                    shared = any(one in group and other in group for group in groups)
                    self.assertEqual(shared, abs(means[one] - means[other]) < difference)
            for group in groups:
                self.assertFalse(any(set(group) < set(larger) for larger in groups))


if __name__ == "__main__":
    unittest.main()
