"""Ranks, Friedman's test and Nemenyi's difference against Demšar's worked example (2006) and others published; ranks of
blocks by hand, and how often chance alone is taken for a difference."""

import math
import unittest

import numpy as np
from trocar_analysis.ranks import (
    critical_difference, friedman, not_told_apart, order_of, rank_blocks, rank_strategies,
)  # fmt: skip

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


def rank_cube(values, **options):
    """Of values [blocks, conditions, strategies]; the strategies are a, b, c …"""
    numbers = np.indices(np.shape(values)).reshape(3, -1).tolist()
    names = [chr(ord("a") + k) for k in numbers[2]]
    return rank_blocks(np.ravel(values), names, numbers[1], numbers[0], **options)


class OrderOf(unittest.TestCase):
    def test_what_differs_by_rounding_is_equal(self):
        values = np.array([3.0, 1, 1 + 1e-12, INF, INF, -INF, 2])
        self.assertEqual(order_of(values).tolist(), [3, 1, 1, 4, 4, 0, 2])
        self.assertEqual(order_of(np.array([[0, 1e-13, INF], [INF, 1e300, 5], [1, 1.001, -2]])).tolist(),
                         [[0, 0, 1], [2, 1, 0], [1, 2, 0]])  # fmt: skip
        self.assertEqual(order_of(np.array([[0.1 + 0.2], [0.3]]).T).tolist(), [[0, 0]])

    def test_ranks_take_it_for_equal(self):
        self.assertEqual(rank_table([[0.3, 0.1 + 0.2, 5], [7.0, 7, 7 + 1e-6]]).of_block.tolist(),
                         [[1.5, 1.5, 3], [1.5, 1.5, 3]])  # fmt: skip
        high = rank_table([[0.3, 0.1 + 0.2, 5]], low_is_better=False)
        self.assertEqual(high.of_block.tolist(), [[2.5, 2.5, 1]])


class RankBlocks(unittest.TestCase):
    def test_by_hand(self):
        # Ranks 1 2 3, 1 3 2 and 3 1 2 are 5/3, 2 and 7/3 in the mean; 1 2 3, 2 1 3 and 3 2 1 are 2, 5/3 and 7/3.
        ranks = rank_cube([[[1, 2, 3], [10, 30, 20], [0.3, 0.1, 0.2]], [[4, 5, 6], [5, 4, 6], [9, 8, 7]]])
        self.assertEqual((ranks.of_block.tolist(), ranks.blocks), ([[1, 2, 3], [2, 1, 3]], [0, 1]))
        np.testing.assert_allclose(ranks.mean, [1.5, 1.5, 3])

    def test_means_that_are_equal_share_a_rank(self):
        # 1.5 1.5 3 and 3 1 2 and 1 3 2: 11/6, 11/6, 7/3, whatever the order of the sums.
        for order in ([0, 1, 2], [2, 1, 0], [1, 0, 2]):
            block = np.array([[1, 1, 2], [3, 1, 2], [1, 3, 2]])[order]
            self.assertEqual(rank_cube([block]).of_block.tolist(), [[1.5, 1.5, 3]])

    def test_one_condition_is_a_block_by_itself(self):
        table = np.random.default_rng(6).normal(size=(20, 4))
        for low in (True, False):
            one, other = rank_cube(table[:, None], low_is_better=low), rank_table(table, low_is_better=low)
            self.assertEqual(one.of_block.tolist(), other.of_block.tolist())

    def test_a_condition_with_large_values_weighs_as_much_as_another(self):
        values = np.random.default_rng(7).uniform(1, 2, (10, 3, 4))
        expected = rank_cube(values).of_block.tolist()
        self.assertEqual(rank_cube(values * [[1], [1000], [1e-3]]).of_block.tolist(), expected)
        self.assertNotEqual(rank_table((values * [[1], [1000], [1e-3]]).mean(axis=1)).of_block.tolist(), expected)

    def test_a_failed_case_is_last_under_its_condition_only(self):
        ranks = rank_cube([[[INF, 2, 3], [1, 2, 3], [1, 3, 2]]])  # 3 1 2, 1 2 3, 1 3 2
        self.assertEqual((ranks.of_block.tolist(), ranks.failed.tolist()), ([[1, 2, 3]], [1, 0, 0]))

    def test_conditions_that_lack_a_value_are_left_out(self):
        values = [[[9, 1, 2], [1, 2, 3]], [[NAN, 1, 2], [3, 2, 1]], [[1, NAN, INF], [1, 2, NAN]]]
        ranks = rank_cube(values)
        self.assertEqual((ranks.blocks, ranks.left_out), ([0, 1], 1))
        self.assertEqual(ranks.of_block.tolist(), [[2, 1, 3], [3, 2, 1]])  # 3 1 2 and 1 2 3: 2, 1.5, 2.5
        self.assertEqual(ranks.failed.tolist(), [0, 0, 0])
        nothing = rank_cube([[[NAN, 1, 2]]])
        self.assertEqual((nothing.blocks, nothing.left_out, nothing.of_block.shape), ([], 1, (0, 3)))

    def test_a_strategy_twice_under_a_condition(self):
        with self.assertRaisesRegex(ValueError, "two cases of b"):
            rank_blocks(np.arange(3.0), ["a", "b", "b"], ["slow"] * 3, [("liver", 1)] * 3)

    def test_chance_alone(self):
        # Strategies are alike; those of a seed do the same under each of its conditions (all alike) or not (apart).
        generator, blocks, conditions = np.random.default_rng(8), 12, 6
        found = {f"{how} {common}": 0 for how in ("blocks", "conditions", "means") for common in ("alike", "apart")}
        for _ in range(300):
            of_seed = generator.normal(size=(blocks, 1, 4))
            noise = generator.normal(size=(blocks, conditions, 4))
            for common, values in (("alike", of_seed + 0.3 * noise), ("apart", noise)):
                within = rank_table(values.reshape(-1, 4)).of_block
                means = within.reshape(blocks, conditions, 4).mean(axis=1)
                for how, ranks in (("blocks", rank_cube(values).of_block), ("conditions", within), ("means", means)):
                    is_told_apart = np.ptp(ranks.mean(axis=0)) >= critical_difference(4, len(ranks))
                    found[f"{how} {common}"] += is_told_apart
        for common in ("alike", "apart"):  # 15 expected, and 3.8 is the standard deviation
            self.assertTrue(3 <= found[f"blocks {common}"] <= 27, found)
        self.assertGreater(found["conditions alike"], 90, found)  # each condition a block: it finds what is not there
        self.assertLess(found["means apart"], 3, found)  # means that are not ranked again: it misses what is


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
