"""Cliff's delta, Holm's correction and Pareto fronts against published examples, answers by hand and brute force."""

import itertools
import math
import unittest

import numpy as np
from trocar_analysis.effects import cliffs_delta, holm
from trocar_analysis.pareto import pareto_front

INF = math.inf


class CliffsDelta(unittest.TestCase):
    def test_published_example(self):
        # Hogarty and Kromrey (1999), as in the manual of R's effsize.
        treatment, control = np.array([10, 10, 20, 20, 20, 30, 30, 30, 40, 50]), np.array([10, 20, 30, 40, 40, 50])
        self.assertEqual(cliffs_delta(treatment, control), -0.25)
        self.assertEqual(cliffs_delta(control, treatment), 0.25)

    def test_failed_cases(self):
        self.assertEqual(cliffs_delta(np.array([INF, 3]), np.array([INF, INF])), -0.5)
        self.assertEqual(cliffs_delta(np.array([INF, INF]), np.array([1.0, -INF])), 1)
        self.assertEqual(cliffs_delta(np.array([INF]), np.array([INF])), 0)

    def test_nothing(self):
        self.assertTrue(math.isnan(cliffs_delta(np.array([]), np.array([1.0]))))
        self.assertTrue(math.isnan(cliffs_delta(np.array([1.0]), np.array([]))))

    def test_brute_force(self):
        generator = np.random.default_rng(1)
        for _ in range(50):
            a, b = (generator.choice([-INF, 0, 1, 2, 3, INF], generator.integers(1, 12)) for _ in range(2))
            pairs = [(x > y) - (x < y) for x, y in itertools.product(a.tolist(), b.tolist())]
            self.assertAlmostEqual(cliffs_delta(a, b), sum(pairs) / len(pairs), 12)


class Holm(unittest.TestCase):
    def test_published_examples(self):
        # The manual of Pingouin's holm, and Demšar's step-down example (2006), which rejects the first two.
        adjusted = holm(np.array([0.50, 0.003, 0.32, 0.054, 0.0003]))
        np.testing.assert_allclose(adjusted, [0.64, 0.012, 0.64, 0.162, 0.0015])
        self.assertEqual((holm(np.array([0.016, 0.019, 0.607])) <= 0.05).tolist(), [True, True, False])

    def test_none_is_below_that_of_a_smaller_one(self):
        np.testing.assert_allclose(holm(np.array([0.01, 0.04, 0.03])), [0.03, 0.06, 0.06])
        self.assertEqual(holm(np.array([0.9, 0.8])).tolist(), [1, 1])
        self.assertEqual(holm(np.array([0.2])).tolist(), [0.2])
        self.assertEqual(len(holm(np.array([]))), 0)

    def test_it_rejects_what_his_procedure_does(self):
        generator = np.random.default_rng(2)
        for _ in range(200):
            p = generator.choice([1e-3, 0.01, 0.0101, 0.02, 0.04, 0.3], generator.integers(1, 7))
            rejected = np.zeros(len(p), bool)
            while not rejected.all():  # one after the other, until one is not below its bound
                left = np.flatnonzero(~rejected)
                smallest = left[p[left].argmin()]
                if p[smallest] > 0.05 / len(left):
                    break
                rejected[smallest] = True
            self.assertEqual((holm(p) <= 0.05).tolist(), rejected.tolist(), p)


class ParetoFront(unittest.TestCase):
    def front(self, *points):
        return pareto_front(*np.array(points, float).T).tolist()

    def test_by_hand(self):
        front = self.front((1, 5), (2, 3), (3, 3), (4, 1), (4, 2), (9, 9))
        self.assertEqual(front, [True, True, False, True, False, False])

    def test_equal_points_are_both_on_it_or_both_not(self):
        self.assertEqual(self.front((1, 1), (1, 1), (2, 2), (2, 2)), [True, True, False, False])

    def test_failed_cases(self):
        self.assertEqual(self.front((1, 2), (INF, 1), (INF, INF), (INF, 1)), [True, True, False, True])
        self.assertEqual(self.front((INF, INF), (INF, INF)), [True, True])

    def test_alone_and_nothing(self):
        self.assertEqual(self.front((3, 3)), [True])
        self.assertEqual(pareto_front(np.array([]), np.array([])).tolist(), [])

    def test_against_a_sweep(self):
        generator = np.random.default_rng(3)
        for _ in range(50):
            points = generator.choice([0.0, 1, 2, 3, 4, INF], (generator.integers(1, 25), 2))
            lowest, front = math.nan, set()
            for x, y in sorted(set(map(tuple, points.tolist()))):
                if not y >= lowest:  # the second figure has to fall where the first grows
                    front.add((x, y))
                    lowest = y
            self.assertEqual(self.front(*points), [tuple(point) in front for point in points.tolist()])


if __name__ == "__main__":
    unittest.main()
