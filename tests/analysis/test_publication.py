"""`figures` on made-up files: medians, tests and what is marked are worked out here, from the cases alone."""

import math
import os
import re
import shutil
import statistics
import subprocess
import unittest
from itertools import combinations

import numpy as np
from made_up_strategies import BETTER, DEPTH, LABELS, SPEEDS, TIME, StrategiesTest, chosen
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Picture
from result_file import ANALYSIS, write_results
from scipy.stats import wilcoxon
from trocar_analysis.case_figures import read_cases
from trocar_analysis.errors import InputError
from trocar_analysis.publication.chosen import conditions_that_vary, figures_of
from trocar_analysis.publication.comparison import compare_strategies
from trocar_analysis.publication.latex import latex
from trocar_analysis.publication.latex_table import chunks
from trocar_analysis.publication.panels import compose, line_of, mark_of, panels_over
from trocar_analysis.publication.publish import Wishes, publish

DIRECTIONS = ",".join(f"{metric}={way}" for metric, way in BETTER.items())


class Publication(StrategiesTest):
    def publish(self, *metrics, **asked):
        write_results(self.file, self.cases)
        self.output = self.folder / "figures"
        return publish(str(self.file), str(self.output), Wishes([*metrics] or [DEPTH], **({"better": BETTER} | asked)))

    def text(self, name):
        return (self.output / name).read_text()

    def refuse(self, words, *metrics, **asked):
        with self.assertRaises(InputError) as raised:
            self.publish(*metrics, **asked)
        self.assertIn(words, str(raised.exception))
        self.assertNotIn("\n", str(raised.exception))

    def compared(self, metric=DEPTH, better=BETTER):
        write_results(self.file, self.cases)
        cases = read_cases(str(self.file), [])
        (figure,) = figures_of(cases, [metric], better)
        return compare_strategies(cases, figure, [], better)

    def part(self, over):
        """The cells of a table's part, by strategy."""
        table = self.text(f"table_{DEPTH}.tex")
        (body,) = re.findall(re.escape(over) + r".*?\\midrule\n(.*?)\\bottomrule", table, re.DOTALL)
        rows = [line.removesuffix(" \\\\").split(" & ") for line in body.strip().split("\n")]
        return {row[0]: row[1:] for row in rows}

    # Numbers

    def test_medians_of_the_table_are_those_of_the_cases(self):
        self.publish()
        parts = {"all conditions": [{}], "by speed": [{"speed": speed} for speed in SPEEDS],
                 "by organ": [{"organ": organ} for organ in ("o0", "o1")]}  # fmt: skip
        for over, columns in parts.items():
            rows = self.part(over)
            self.assertEqual(sorted(rows), sorted(LABELS))
            for label, cells in rows.items():
                for keys, cell in zip(columns, cells):
                    median = statistics.median(case[DEPTH] for case in chosen(self.cases, label=label, **keys))
                    said = cell.replace("\\textbf{", "").replace("}", "").split(" ")[0]
                    self.assertEqual(said, f"{median:.3g}")

    def test_p_is_wilcoxons_over_blocks_by_holm_over_all_pairs(self):
        table = self.compared().table.set_index("label")
        raw = {}
        for pair in combinations(table.index, 2):
            blocks = [
                statistics.median(b[DEPTH] - a[DEPTH] for a, b in zip(*(chosen(self.cases, label=label, organ=organ, seed=seed)
                                                                       for label in pair)))
                for organ in ("o0", "o1") for seed in range(6)
            ]  # fmt: skip
            raw[pair] = wilcoxon(blocks, mode="exact").pvalue
        largest, adjusted = 0.0, {}
        for place, pair in enumerate(sorted(raw, key=raw.get)):
            largest = max(largest, min(1, (len(raw) - place) * raw[pair]))
            adjusted[pair] = largest
        best = table.index[0]
        self.assertTrue(math.isnan(table["p"][best]))
        for label in table.index[1:]:
            self.assertAlmostEqual(table["p"][label], adjusted[best, label])
            differences = [
                b[DEPTH] - a[DEPTH] for a, b in zip(*(chosen(self.cases, label=name) for name in (best, label)))
            ]
            self.assertAlmostEqual(table["difference"][label], statistics.median(differences))

    def test_strategies_that_differ_by_rounding_alone_do_not_differ(self):
        for case in chosen(self.cases, label="nearest-face"):
            twin = next(c for c in chosen(self.cases, label="fuzzy") if all(c[k] == case[k] for k in ("organ", "seed", "speed")))
            case[DEPTH] = twin[DEPTH] * (1 + 1e-15)
        table = self.compared().table.set_index("label")
        self.assertEqual((table["difference"]["nearest-face"], table["p"]["nearest-face"]), (0, 1))

    def test_the_best_is_marked_only_where_intervals_are_apart(self):
        for case in self.cases:
            best = case["label"] == "joint-vertex" and case["speed"] == 20
            case[DEPTH] = case["seed"] / 10 + (0 if best else 1 if case["speed"] == 20 else 0)
        self.publish()
        bold = {label: [cell.startswith("\\textbf") for cell in cells] for label, cells in self.part("by speed").items()}
        self.assertEqual(bold["joint-vertex"], [True, False])
        self.assertEqual([label for label, cells in bold.items() if any(cells)], ["joint-vertex"])

    def test_high_may_be_better(self):
        for case in self.cases:
            case["edge_ratio_min_h_mean"] = case["seed"] / 100 + (label := LABELS.index(case["label"])) + 0 * label
        self.publish("edge_ratio_min_h_mean")
        table = self.text("table_edge_ratio_min_h_mean.tex")
        self.assertIn("joint-vertex & \\textbf{3.02}", table)
        self.assertIn("Higher is better", table)

    def test_nothing_is_marked_where_neither_way_is_better(self):
        said = self.publish(better={})
        table = self.text(f"table_{DEPTH}.tex")
        self.assertNotIn("\\textbf", table)
        self.assertNotIn("mean rank &", table)
        self.assertIn("Neither way is better.", table)
        self.assertIn(f"{DEPTH}: no diagram of ranks: {DEPTH}: neither way is better", "\n".join(said))

    def test_strategies_under_different_conditions_are_not_compared(self):
        self.cases = [case for case in self.cases if (case["label"] == "fuzzy") == (case["speed"] == 20)]
        said = self.publish()
        table = self.text(f"table_{DEPTH}.txt")
        self.assertNotIn("\\textbf", self.text(f"table_{DEPTH}.tex"))
        self.assertIn("Strategies are not compared: under no condition has each of them one value", table)
        self.assertIn(f"{DEPTH}: no diagram of ranks: of 24 conditions none has a value of each of the 4 strategies; choose", said[1])
        self.assertFalse((self.output / f"rank_{DEPTH}.pdf").exists())

    def test_counts_of_failed_cases_and_of_values_that_are_missing(self):
        for case in self.cases:
            case["status"] = "complete"
        self.cases[0].update(status="diverged", **{DEPTH: math.nan})
        self.cases[1][DEPTH] = math.nan
        self.publish()
        caption = self.text(f"table_{DEPTH}.txt")
        # The condition of the second is left out with each of the four strategies.
        self.assertIn("n = 23 cases of each strategy (2 organs, 2 speeds, 6 seeds).", caption)
        self.assertIn("1 of 92 cases failed; a failed case counts as the worst value there is.", caption)
        self.assertIn("1 of 24 conditions are left out: no value with fuzzy (1).", caption)
        self.assertIn(f"{DEPTH}: no value in 1 of 95 complete cases", caption)
        self.assertRegex(caption, r"p [=<] 0\.\d+ \(Friedman's test as Iman and Davenport have it, 12 blocks\); critical "
                                  r"difference of mean ranks \d\.\d\d \(Nemenyi, α = 0\.05\)")  # fmt: skip
        self.assertIn("Wilcoxon's signed-rank test of their medians in 12 blocks, by Holm's correction for all 6 pairs", caption)
        self.assertIn("1 of 92 cases failed", self.text(f"over_speed_{DEPTH}.txt"))

    # Pictures

    def panels(self, over, metric=DEPTH):
        compared = self.compared(metric)
        cases = read_cases(str(self.file), [])
        return compose(panels_over(over, compared.figure, cases, compared.used, compared.labels))

    def test_points_of_a_picture_are_medians_of_the_cases(self):
        for case in self.cases:
            case["scene"] = "sliding" if case["seed"] < 3 else "cutting"
        _, *axes = self.panels("speed").axes
        self.assertEqual(len(axes), 2)
        for panel, scene in zip(axes, ("sliding", "cutting")):
            for label in LABELS:
                (marks,) = [line for line in panel.lines if line.get_label() == label]
                for speed, median in zip(*marks.get_data()):
                    of = chosen(self.cases, label=label, scene=scene, speed=speed)
                    self.assertAlmostEqual(median, statistics.median(case[DEPTH] for case in of))

    def test_a_panel_without_a_value_says_so(self):
        for case in self.cases:
            case["scene"] = "sliding" if case["speed"] == 20 else "cutting"
            case["release"] = "step" if case["seed"] < 3 else "contact"
        self.cases = [case for case in self.cases if (case["scene"], case["release"]) != ("cutting", "step")]
        texts = [text.get_text() for axes in self.panels("organ").axes for text in axes.texts]
        self.assertEqual(texts.count("no value"), 1)

    def test_conditions_that_go_together_are_drawn_once(self):
        def of(**columns):
            for number, case in enumerate(self.cases):
                case.update({name: values[number % len(values)] for name, values in columns.items()})
            write_results(self.file, self.cases)
            return conditions_that_vary(read_cases(str(self.file), []).table)

        self.assertEqual(of(), ["organ", "speed"])
        self.assertEqual(of(organ=["liver@2mm", "sheet@2mm"], organ_facets=[10, 20], speed=[20.0]), ["organ"])
        self.assertEqual(of(organ=["liver@2mm", "liver@4mm"], organ_facets=[10, 20]), ["organ_facets"])
        self.assertEqual(of(edge_stiffness=[1.0, 2.0], rest_stiffness=[5.0, 9.0], organ=["o"], organ_facets=[10]),
                         ["edge_stiffness"])  # fmt: skip

    def test_strategies_look_different_in_grey(self):
        """Pieces of lines as the key has them, converted to grey: any two differ in a good part of their ink."""
        grey = [self.grey(number) for number in range(12)]
        for (m, a), (n, b) in combinations(enumerate(grey), 2):
            self.assertGreater(np.abs(a - b).sum() / min(a.sum(), b.sum()), 0.2, f"strategies {m} and {n}")

    def grey(self, number):
        """How dark each dot of a strategy's line is, from 0 to 1, as a printer makes grey of colours (ITU-R 601)."""
        picture = Picture(figsize=(0.6, 0.2), dpi=200)
        canvas = FigureCanvasAgg(picture)
        axes = picture.add_axes((0, 0, 1, 1))
        axes.axis("off")
        mark = mark_of(line_of("a", number))
        mark.set_data([0.1, 0.5, 0.9], [0.5, 0.5, 0.5])
        mark.set_markevery([1])
        axes.add_line(mark)
        axes.set(xlim=(0, 1), ylim=(0, 1))
        canvas.draw()
        return 1 - np.asarray(canvas.buffer_rgba())[..., :3] @ (0.299, 0.587, 0.114) / 255

    # The folder

    def test_the_index_takes_in_all_that_was_written(self):
        self.publish(DEPTH, TIME)
        taken = re.findall(r"\\input\{\\TrocarFolder/(\S+)\}", self.text("figures.tex"))
        pictures = {path.stem for path in self.output.glob("*.pdf")}
        tables = {path.stem for path in self.output.glob("table_*.tex")}
        self.assertEqual(sorted(taken), sorted(pictures | tables))
        self.assertEqual(
            pictures,
            {f"{kind}_{name}" for kind in ("over_organ", "over_speed", "rank") for name in (DEPTH, TIME)}
            | {f"front_{DEPTH}_against_{TIME}"},
        )
        for name in taken:
            kinds = {path.suffix for path in self.output.glob(f"{name}.*")}
            self.assertEqual(kinds, {".tex", ".txt"} | ({".svg", ".pdf"} if name in pictures else set()))

    def test_the_same_file_gives_the_same_bytes(self):
        write_results(self.file, self.cases)
        made = []
        for number in ("1", "2"):
            output = self.folder / number
            done = subprocess.run(
                ["/usr/bin/python3", "-B", "-m", "trocar_analysis", "figures", self.file, "-o", output, f"--metric={DEPTH}",
                 f"--better={DIRECTIONS}"],
                env=os.environ | {"PYTHONPATH": str(ANALYSIS), "PYTHONHASHSEED": number}, check=True, capture_output=True,
            )  # fmt: skip
            self.assertEqual(done.stderr, b"")
            made.append({path.name: path.read_bytes() for path in output.iterdir()})
        self.assertEqual(made[0].keys(), made[1].keys())
        for name, content in made[0].items():
            self.assertEqual(content, made[1][name], name)
            if name.endswith((".svg", ".pdf")):
                self.assertNotIn(b"Date>", content.replace(b"<dc:date>", b"Date>"), name)
                self.assertNotIn(b"/CreationDate", content, name)

    def test_fonts_are_embedded_as_publishers_ask(self):
        self.publish()
        content = (self.output / f"over_speed_{DEPTH}.pdf").read_bytes()
        self.assertIn(b"/CIDFontType2", content)  # TrueType
        self.assertNotIn(b"/Type3 ", content.replace(b"\n", b" "))

    def test_latex_takes_it(self):
        if shutil.which("pdflatex") is None:
            self.skipTest("no pdflatex: LaTeX of `trocar figures` is NOT compiled; install texlive-latex-recommended")
        names = dict(zip(LABELS, (r"50 % \of_{this} & #that~^", "[first] <b>|\"x\"", "née--ß→ µm³ ∞", "*a*")))
        for case in self.cases:
            case.update(label=names[case["label"]], status="complete")
        self.cases[0]["status"] = "diverged"
        for case in self.cases:
            case["tool_volume_at_rest_max"] = 4.0
        self.publish(DEPTH, "tool_volume_inside_d_max/tool_volume_at_rest_max", TIME)
        done = subprocess.run(
            ["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "preview.tex"], cwd=self.output, capture_output=True,
            text=True, check=False, timeout=200, errors="replace",
        )  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout[-1500:])
        for fault in ("Overfull", "Missing character", "Undefined", "too large"):
            self.assertNotIn(fault, done.stdout)

    def test_text_as_latex(self):
        self.assertEqual(latex("50 % of a_b"), r"50 \% of a\_\allowbreak{}b")
        self.assertEqual(latex("[a] --b"), r"{}[a] -{}-b")
        self.assertEqual(latex("1–2 mm³, µs ≈ ∞"), r"1--2 mm$^3$, $\mu$s $\approx$ $\infty$")
        self.assertEqual(latex("née 中"), "née U+4E2D")

    def test_columns_that_have_no_room_go_below(self):
        self.assertEqual(chunks([20] * 4, 80), [slice(0, 4)])
        self.assertEqual(chunks([20] * 6, 80), [slice(0, 3), slice(3, 6)])
        self.assertEqual(chunks([90, 90], 80), [slice(0, 1), slice(1, 2)])

    # What there is nothing, or little, to draw of

    def test_one_strategy(self):
        self.cases = chosen(self.cases, label="fuzzy")
        said = self.publish()
        self.assertEqual(sorted(path.name for path in self.output.glob("*.pdf")),
                         [f"over_organ_{DEPTH}.pdf", f"over_speed_{DEPTH}.pdf"])  # fmt: skip
        self.assertNotIn("\\textbf", self.text(f"table_{DEPTH}.tex"))
        self.assertIn(f"{DEPTH}: no diagram of ranks: one strategy, so none is better", said)

    def test_one_case(self):
        self.cases = self.cases[:1]
        said = self.publish()
        self.assertEqual([*self.output.glob("*.pdf")], [])
        self.assertIn(f"fuzzy & {self.cases[0][DEPTH]:.3g} & 0", self.text(f"table_{DEPTH}.tex"))
        self.assertIn("no picture, as there is one strategy under one condition", "\n".join(said))

    def test_one_condition(self):
        self.cases = chosen(self.cases, organ="o0", seed=0, speed=20.0)
        self.publish()
        self.assertEqual([path.stem for path in self.output.glob("*.pdf")], [f"over_strategy_{DEPTH}"])

    def test_what_is_refused(self):
        self.refuse("no metric 'depth_maxx'", "depth_maxx")
        self.refuse("no speed '7'", only=["speed=7"])
        (self.folder / "taken").write_text("")
        with self.assertRaises(InputError) as raised:
            publish(str(self.file), str(self.folder / "taken"), Wishes([DEPTH], better=BETTER))
        self.assertIn("is a file; give a folder", str(raised.exception))
        for case in self.cases:
            case.update(status="diverged", **{DEPTH: math.nan})
        self.refuse("none of its 96 cases completed (96 diverged)")
        self.assertFalse((self.folder / "figures").exists())

    def test_a_figure_without_any_value(self):
        for case in self.cases:
            case["drag_mean"] = math.nan
        said = self.publish(DEPTH, "drag_mean")
        self.assertIn("drag_mean: left out, as no case has a value", "\n".join(said))
        self.refuse("no complete case has a value of what is asked for: drag_mean", "drag_mean")

    def test_the_main_figures_are_drawn_where_none_is_asked_for(self):
        write_results(self.file, self.cases)
        done = self.output_of("figures", "out.h5", "-o", "made", f"--better={DIRECTIONS}")
        self.assertIn("made: 5 pictures (SVG and PDF) and 2 tables of 96 cases", done)
        self.assert_refused("figures", "none.h5", "-o", "made", saying=["none.h5: no such file"])


if __name__ == "__main__":
    unittest.main()
