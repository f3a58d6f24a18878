"""Conditions on figures: what they come to, and that differences say the same as ratios where there are ratios."""

import math
import unittest

import numpy as np
from trocar_analysis.conditions import condition_interval, excess
from trocar_analysis.paired import bootstrap_interval

INF = math.inf


def design(organs, seeds):
    return np.repeat(np.arange(organs), seeds), np.tile(np.arange(seeds), organs)


class Excess(unittest.TestCase):
    def test_over_another_figure_a_multiple_of_it_and_a_threshold(self):
        a, b = np.array([7.0, 3, 0]), np.array([2.0, 1, 0])
        self.assertEqual(excess(a, b).tolist(), [5, 2, 0])
        self.assertEqual(excess(a, b, 3).tolist(), [1, 0, 0])
        self.assertEqual(excess(a, 0.5).tolist(), [6.5, 2.5, -0.5])

    def test_failed_cases(self):
        a, b = np.array([INF, 1, INF]), np.array([1, INF, INF])
        self.assertEqual(excess(a, b, 3).tolist(), [INF, -INF, 0])
        self.assertEqual(excess(a, 0.5).tolist(), [INF, 0.5, INF])


class ConditionInterval(unittest.TestCase):
    def test_median_and_interval(self):
        values, (organs, seeds) = np.random.default_rng(1).normal(2, 1, 60), design(3, 20)
        estimate = condition_interval(values, organs, seeds)
        self.assertEqual((estimate.cases, estimate.median), (60, np.median(values)))
        self.assertEqual((estimate.low, estimate.high), bootstrap_interval(values, organs, seeds))
        self.assertTrue(0 < estimate.low < estimate.median < estimate.high)

    def test_a_threshold_moves_it_by_as_much(self):
        figure, (organs, seeds) = np.random.default_rng(2).exponential(size=60), design(3, 20)
        own, shifted = (condition_interval(excess(figure, by), organs, seeds) for by in (0, 0.25))
        np.testing.assert_allclose([shifted.low, shifted.median, shifted.high],
                                   [own.low - 0.25, own.median - 0.25, own.high - 0.25])  # fmt: skip

    def test_differences_are_above_0_where_ratios_are_above_the_factor(self):
        generator, (organs, seeds) = np.random.default_rng(3), design(3, 6)
        sides = set()
        for factor in np.repeat([1.25, 2.0, 3.0], 12):
            b = generator.lognormal(size=18)
            a = b * generator.lognormal(np.log(2), 1, 18)
            difference = condition_interval(excess(a, b, factor), organs, seeds)
            ratio = condition_interval(a / b, organs, seeds)
            side = (difference.low > 0, difference.high > 0)
            self.assertEqual(side, (ratio.low > factor, ratio.high > factor))
            sides.add(side)
        self.assertEqual(sides, {(True, True), (False, True), (False, False)})

    def test_a_failed_half_has_no_finite_end(self):
        estimate = condition_interval(np.where(np.arange(20) % 2, INF, 1.0), *design(1, 20))
        self.assertEqual((estimate.low, estimate.high), (1, INF))

    def test_too_few_and_nothing(self):
        estimate = condition_interval(np.arange(5.0), *design(1, 5))
        self.assertEqual((estimate.cases, estimate.median), (5, 2))
        self.assertTrue(math.isnan(estimate.low) and math.isnan(estimate.high))
        nothing = condition_interval(*np.empty((3, 0)))
        self.assertEqual(nothing.cases, 0)
        self.assertTrue(math.isnan(nothing.median))


if __name__ == "__main__":
    unittest.main()
