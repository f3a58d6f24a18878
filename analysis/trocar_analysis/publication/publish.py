"""`figures`: writes the folder: for each figure its diagrams, its table and their captions, and an index of them all."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from .. import front_plot
from ..case_figures import Cases, Figure, read_cases
from ..critical_difference import compose as compose_ranks
from ..errors import InputError
from ..front import Wishes as FrontWishes
from ..front import front_of
from ..rank import BETTER, counted
from .captions import caption_front, caption_over, caption_ranks, caption_table, notes_of_table
from .chosen import AGAINST, conditions_that_vary, figures_of
from .comparison import Compared, compare_strategies, reason
from .files import file_name, make_folder, save_picture, save_text
from .latex import latex
from .latex_table import table_text, unit_of
from .panels import compose, panels_over

FOLDER = "\\TrocarFolder"  # in LaTeX: where the files are, from where LaTeX runs

PREVIEW = """\\documentclass{article}
\\usepackage[a4paper, margin=20mm]{geometry}
\\usepackage{graphicx, booktabs}
\\begin{document}
\\input{figures}
\\end{document}
"""


@dataclass(frozen=True)
class Wishes:
    """What a user asks of `figures`."""

    metrics: list[str] | None = None  # columns, metrics, or quotients "a/b" of two columns; None: the main ones
    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"


class Pages:
    """The folder while it is written, and what it holds so far."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.index: list[str] = []  # names of what LaTeX takes in, "" between figures
        self.pictures = self.tables = 0
        self.lacks: dict[str, list[str]] = {}  # why something could not be made: what

    def cannot(self, what: str, why: str) -> None:
        self.lacks.setdefault(why, []).append(what)

    def add_picture(self, name: str, compose_it: object, caption: list[str]) -> None:
        save_picture(self.folder, name, compose_it)
        self.add_text(name, caption, (
            f"\\begin{{figure}}[htbp]\n\\centering\n\\includegraphics[width=\\linewidth]{{{FOLDER}/{name}}}\n"
            f"\\caption{{{latex(' '.join(caption))}}}\n\\label{{fig:{name}}}\n\\end{{figure}}\n"
        ))  # fmt: skip
        self.pictures += 1

    def add_text(self, name: str, caption: list[str], text: str) -> None:
        save_text(self.folder, f"{name}.txt", " ".join(caption) + "\n")
        save_text(self.folder, f"{name}.tex", text)
        self.index.append(name)


def publish(path: str, output: str, asked: Wishes) -> list[str]:
    """Draws and tabulates the figures of a result file into a folder. What it returns says what was written and what could
    not be made, and why. InputError where there is nothing to show."""
    cases = read_cases(path, asked.only)
    figures = figures_of(cases, asked.metrics, asked.better)
    pages = Pages(make_folder(output))
    for figure in figures:
        compared = compare_strategies(cases, figure, asked.only, asked.better)
        add_figure(pages, compared, cases, asked)
        pages.index.append("")
    add_fronts(pages, figures, cases, asked)
    save_text(pages.folder, "figures.tex", index_text(pages.index, Path(path).name))
    save_text(pages.folder, "preview.tex", PREVIEW)
    return [
        f"{output}: {counted(pages.pictures, 'picture')} (SVG and PDF) and {counted(pages.tables, 'table')} of "
        f"{counted(len(cases.table), 'case')}; figures.tex takes in all of them, preview.tex is a document of them",
        *(f"{', '.join(what)}: {why}" for why, what in pages.lacks.items()),
    ]


def add_figure(pages: Pages, compared: Compared, cases: Cases, asked: Wishes) -> None:
    """All of one figure."""
    figure, used = compared.figure, compared.used
    name = file_name(figure.name)
    if figure.values.loc[used.index].isna().all():
        pages.cannot(figure.name, f"left out, as no case has a value ({figure.lacking})")
        return
    conditions = conditions_that_vary(used)
    overs = conditions or (["label"] if len(compared.labels) > 1 else [])
    if not overs:
        pages.cannot(figure.name, "no picture, as there is one strategy under one condition; the table has the value")
    for over in overs:
        panels = panels_over(over, figure, cases, used, compared.labels)
        over_name = f"over_{'strategy' if over == 'label' else over}_{name}"
        pages.add_picture(over_name, lambda panels=panels: compose(panels), caption_over(compared, panels, asked.only))
    if compared.ranking:
        ranks = compared.ranking.ranks
        pages.add_picture(f"rank_{name}", lambda: compose_ranks(ranks, figure.title), caption_ranks(compared, asked.only))
    else:
        pages.cannot(figure.name, f"no diagram of ranks: {compared.no_ranking}")
    caption, notes = caption_table(compared, unit_of(compared)[0], asked.only), notes_of_table(compared)
    text = table_text(compared, cases, conditions, latex(" ".join(caption)), latex(" ".join(notes)), name)
    pages.add_text(f"table_{name}", [*caption, *notes], text)
    pages.tables += 1


def add_fronts(pages: Pages, figures: list[Figure], cases: Cases, asked: Wishes) -> None:
    """The first figure of which one way is better, against each of the others that are asked for, or against those of
    AGAINST."""
    judged = [figure for figure in figures if figure.better in BETTER]
    for other in judged[1:]:
        if asked.metrics is None and other.name not in AGAINST:
            continue
        wishes = FrontWishes(judged[0].name, other.name, asked.only, asked.better)
        try:
            front = front_of(cases, wishes)
        except InputError as error:
            pages.cannot(f"front of {judged[0].name} and {other.name}", f"not drawn: {reason(error, cases)}")
            continue
        titled = replace(front, figure=replace(front.figure, title=judged[0].title),
                         against=replace(front.against, title=other.title), notes=[], cautions=[])  # fmt: skip
        name = f"front_{file_name(judged[0].name)}_against_{file_name(other.name)}"
        pages.add_picture(name, lambda titled=titled: front_plot.compose(titled), caption_front(front))


def index_text(names: list[str], file: str) -> str:
    lines = [
        f"% Figures and tables of {' '.join(file.split())}, made by trocar figures. Needs graphicx and booktabs.",
        "% In a document elsewhere: \\newcommand{\\TrocarFolder}{folder of this file} before \\input{…/figures}.",
        f"\\providecommand{{{FOLDER}}}{{.}}",
    ]
    lines += [f"\\input{{{FOLDER}/{name}}}" if name else "\\clearpage" for name in names]
    return "\n".join([*lines, ""])
