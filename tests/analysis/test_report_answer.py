"""The overview's answer in words: it says no more than ranks and intervals do."""

from __future__ import annotations

import unittest

from trocar_analysis.report.answer import answer


def row(label: str, rank: float | None, median: float | str, low: float | None = None, high: float | None = None) -> dict:
    return {"label": label, "meanRank": rank, "median": median, "low": low, "high": high, "cases": 28, "failed": 0}


def comparison(*rows: dict, name: str = "depth_max_d_max", difference: float = 0.5, unit: str = "mm") -> dict:
    ranks = {"blocks": 14, "difference": difference} if rows and rows[0]["meanRank"] is not None else None
    return {"name": name, "title": "Depth left", "unit": unit, "factor": 1, "better": "low", "rows": [*rows], "ranks": ranks,
            "why": "" if ranks else "too few", "notes": [], "lacking": {}}  # fmt: skip


def counts(*labels: str, failed: int = 0) -> list[dict]:
    return [{"label": label, "cases": 28, "complete": 28 - failed, "failed": {"diverged": failed} if failed else {}} for label in labels]


class Answer(unittest.TestCase):
    def said(self, *comparisons: dict, failed: int = 0) -> str:
        return " ".join(answer([*comparisons], counts("a", "b", "c", failed=failed)))

    def test_told_apart_by_ranks_and_intervals(self):
        said = self.said(comparison(row("a", 1, 1, 0.9, 1.1), row("b", 2, 2, 1.9, 2.1), row("c", 3, 4, 3, 5)))
        self.assertIn("a ranks first by “depth left”: mean rank 1.00 of 3 over 14 blocks, median 1 mm [0.9–1.1].", said)
        self.assertIn("The ranks tell it apart from all others.", said)
        self.assertNotIn("overlap", said)

    def test_not_told_apart_by_ranks(self):
        said = self.said(comparison(row("a", 1.4, 1, 0.9, 1.1), row("b", 1.6, 2, 1.9, 2.1), row("c", 3, 4, 3, 5)))
        self.assertIn("The ranks do not tell it apart from b (median 2 mm [1.9–2.1]).", said)

    def test_intervals_that_overlap_are_said_to(self):
        told_apart = self.said(comparison(row("a", 1, 1, 0.9, 2), row("b", 2, 2, 1.9, 2.1), row("c", 3, 4, 3, 5)))
        self.assertIn("but its interval overlaps with that of b (median 2 mm [1.9–2.1], intervals overlap)", told_apart)
        near = self.said(comparison(row("a", 1, 1, 0.9, 2), row("b", 1.2, 2, 1.9, 2.1), row("c", 3, 4, 3, 5)))
        self.assertIn("do not tell it apart from b (median 2 mm [1.9–2.1], intervals overlap)", near)

    def test_the_best_median_is_another_ones(self):
        said = self.said(comparison(row("a", 1, 2, 1.9, 2.1), row("b", 2, 1, 0.9, 1.1), row("c", 3, 4, 3, 5)))
        self.assertIn("The best median is that of b, 1 mm [0.9–1.1]; the two intervals do not overlap.", said)

    def test_without_intervals_nothing_is_sure(self):
        said = self.said(comparison(row("a", None, 1), row("b", None, 2)))
        self.assertIn("Lowest median of “depth left”: a, median 1 mm. Not ranked: too few.", said)
        self.assertIn("too few seeds for intervals", said)

    def test_what_it_costs_in_time(self):
        left = comparison(row("a", 1, 1, 0.9, 1.1), row("b", 2, 2, 1.9, 2.1), row("c", 3, 4, 3, 5))
        times = comparison(row("c", 1, 3, 2, 4), row("b", 2, 5, 4, 6), row("a", 3, 9, 8, 10), name="time_handle_p99", unit="µs")
        said = self.said(left, times)
        self.assertIn("In time it costs 9 µs [8–10] of handling (99 % of a case's steps take less).", said)
        self.assertIn("The fastest is c, 3 µs [2–4]; by the figure above: median 4 mm [3–5].", said)

    def test_worse_only_where_intervals_are_clear_of_each_other(self):
        left = comparison(row("a", 1, 1, 0.9, 1.1), row("b", 2, 2, 1.9, 2.1))
        clear = comparison(row("b", 1, 1, 0.9, 1.1), row("a", 2, 2, 1.9, 2.1), name="drag_mean")
        blurred = comparison(row("b", 1, 1, 0.9, 2), row("a", 2, 2, 1.9, 2.1), name="drag_mean")
        self.assertIn("and worse, in: depth left (2 mm [1.9–2.1]; b 1 mm [0.9–1.1])", self.said(left, clear))
        self.assertNotIn("worse, in", self.said(left, blurred))

    def test_failures(self):
        left = comparison(row("a", 1, 1, 0.9, 1.1), row("b", 2, "inf", 2, "inf"), row("c", 3, "inf", "inf", "inf"))
        said = self.said(left, failed=2)
        self.assertIn("6 of 84 cases failed, 2 of them of a", said)

    def test_what_half_failed_has_no_median(self):
        left = comparison(row("a", 1, "inf", 1, "inf"), row("b", 2, 2, 1.9, 2.1))
        times = comparison(row("b", 1, 1, 0.9, 1.1), row("a", 2, "inf", 2, "inf"), name="time_handle_p99")
        said = self.said(left, times, failed=14)
        self.assertIn("over 14 blocks, without a median, since half of its cases or more failed.", said)
        self.assertNotIn("∞", said.replace("–∞]", ""))
        self.assertNotIn("In time it costs", said)

    def test_nothing_that_all_have(self):
        self.assertIn("The file does not answer it", self.said(comparison()))

    def test_no_case_completed(self):
        self.assertIn("No case completed", self.said(comparison(row("a", 1, "inf")), failed=28))


if __name__ == "__main__":
    unittest.main()
