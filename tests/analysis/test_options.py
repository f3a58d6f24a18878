"""`show` by the options of strategies: groups and filters, against figures computed by hand, and what is refused."""

import csv
import io
import json
import tempfile
import unittest
from pathlib import Path

from result_file import write_results
from trocar_analysis.errors import InputError
from trocar_analysis.show import Wishes, show_cases, show_states

# label → options of its strategy
OPTIONS = {
    "last": {"aggregate": "last", "feedback": True, "width": 0.5},
    "sum": {"aggregate": "sum", "feedback": True, "width": 10.0},
    "open": {"aggregate": "sum", "feedback": False, "width": 2.0},
    "plain": {},
}


def rows(depths, metric="depth_max_d_max", **more):
    """A case, or an answer, for every label of `depths`."""
    shared = [(f"c{number}", label, depth) for number, (label, depth) in enumerate(depths.items())]
    return [
        {"case_id": case_id, "strategy": "fuzzy" if OPTIONS[label] else "plain", "label": label,
         "options": json.dumps(OPTIONS[label]), metric: depth} | more
        for case_id, label, depth in shared
    ]  # fmt: skip


DEPTHS = {"last": 1.0, "sum": 3.0, "open": 5.0, "plain": 9.0}


class Table(unittest.TestCase):
    show = staticmethod(show_cases)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "out.h5"

    def table(self, only=(), by=None, metrics=("depth_max",), style="text"):
        return self.show(str(self.file), Wishes(list(only), by, list(metrics), style))

    def medians(self, *keys, only=()):
        said = csv.DictReader(io.StringIO(self.table(only, list(keys), style="csv")))
        return {tuple(row[key] for key in keys): float(row["median"]) for row in said}

    def assert_refused(self, saying, **wishes):
        with self.assertRaises(InputError) as refused:
            self.table(**wishes)
        for words in saying:
            self.assertIn(words, str(refused.exception))


class Cases(Table):

    def test_groups_and_cases_without_the_option(self):
        write_results(self.file, rows(DEPTHS))
        self.assertEqual(self.medians("aggregate"), {("last",): 1, ("sum",): 4, ("–",): 9})
        medians = self.medians("feedback", "strategy")
        self.assertEqual(medians, {("true", "fuzzy"): 2, ("false", "fuzzy"): 5, ("–", "plain"): 9})

    def test_markdown_has_the_options_as_columns(self):
        write_results(self.file, rows(DEPTHS))
        lines = self.table(by=["aggregate", "feedback"], style="markdown").splitlines()
        self.assertEqual(lines[0], "| aggregate | feedback | cases | failed | depth_max_d_max, mm |")
        self.assertIn("| sum | false | 1 | 0 | 5 |", lines)
        self.assertIn("| – | – | 1 | 0 | 9 |", lines)

    def test_numbers_are_in_their_order_and_absent_ones_last(self):
        write_results(self.file, rows(DEPTHS))
        lines = self.table(by=["width"], style="markdown").splitlines()[2:]
        self.assertEqual([line.split()[1] for line in lines], ["0.5", "2", "10", "–"])

    def test_filters(self):
        write_results(self.file, rows(DEPTHS))
        self.assertEqual(self.medians("label", only=["aggregate=sum"]), {("sum",): 3, ("open",): 5})
        self.assertEqual(self.medians("label", only=["aggregate=sum", "feedback=true"]), {("sum",): 3})
        self.assertEqual(self.medians("label", only=["width=10", "width=0.5"]), {("last",): 1, ("sum",): 3})

    def test_a_column_wins_over_an_option(self):
        write_results(self.file, rows({"last": 1.0}, options='{"speed": 7.0}', speed=100.0))
        self.assertEqual(self.medians("speed"), {("100.0",): 1})

    def test_an_option_is_no_figure(self):
        write_results(self.file, rows(DEPTHS))
        self.assert_refused(["no metric 'width'"], metrics=["width"])

    def test_mistakes_name_the_nearest(self):
        write_results(self.file, rows(DEPTHS))
        self.assert_refused(["no column or option 'agregate'", "'aggregate'"], by=["agregate"])
        self.assert_refused(["no column or option 'sped'", "'speed'"], by=["sped"])
        for wrong, said in (
            ("feedbak=true", ["no key 'feedbak'", "'feedback'"]),
            ("aggregate=lats", ["no aggregate 'lats'", "'last'"]),
            ("aggregate=–", ["there are: last, sum"]),
            ("width=3", ["there are: 0.5, 10, 2"]),
        ):
            self.assert_refused(said, only=[wrong])

    def test_options_that_are_no_json(self):
        for damage in ("{aggregate", "[1]"):
            write_results(self.file, rows(DEPTHS, options=damage))
            self.assert_refused(["is damaged", "options"])


class States(Table):
    show = staticmethod(show_states)

    def setUp(self):
        """The states of two runs, c0 and c2; all answers to those of c0 are 100 mm deeper."""
        super().setUp()
        runs = [case for case in rows(DEPTHS) if case["label"] in ("last", "open")]
        answers = []
        for run, deeper in zip(runs, (100, 0)):
            depths = {label: depth + deeper for label, depth in DEPTHS.items()}
            answers += [answer | {"case_id": run["case_id"], "step": 3} for answer in rows(depths, "depth_max_h")]
        write_results(self.file, runs, states=answers)

    def test_of_the_strategy_that_answered(self):
        self.assertEqual(self.medians("aggregate"), {("last",): 51, ("sum",): 54, ("–",): 59})
        self.assertEqual(self.medians("label", only=["feedback=false"]), {("open",): 55})

    def test_of_the_run_in_which_the_state_was_found(self):
        self.assertEqual(self.medians("run_aggregate"), {("last",): 104, ("sum",): 4})
        self.assertEqual(self.medians("label", only=["run_feedback=false", "aggregate=last"]), {("last",): 1})

    def test_a_mistake_names_the_nearest(self):
        self.assert_refused(["'run_aggregate'"], by=["run_agregate"])


if __name__ == "__main__":
    unittest.main()
