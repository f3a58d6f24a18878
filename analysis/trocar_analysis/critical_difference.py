"""The critical-difference diagram (Demšar 2006): strategies on an axis of mean ranks, the best on the right, and bars
across those that the ranks do not tell apart."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.style import context

from . import palette
from .errors import InputError
from .pictures import save_each
from .ranks import ALPHA, Friedman, Ranks, critical_difference, friedman, not_told_apart

# Inches, from the axis's left end to the right and from the upper edge down.
LENGTH = 3.5  # of the axis
SIDE = 1.75  # beside it, for names; more where one is longer
LETTER = 0.075  # width of one in a name
MARGIN = 0.12
DPI = 200
TITLE, SUBTITLE, DIFFERENCE, AXIS = 0.22, 0.42, 0.68, 1.08  # heights
TICK = 0.06
FIRST_BAR, BAR_STEP, BAR_OVERHANG = 0.12, 0.1, 0.05  # below the axis; from one to the next; beyond the outermost ranks
FIRST_NAME, NAME_STEP = 0.22, 0.24  # below the last bar; from one to the next
CAPTION = 0.28  # below the last name
CAPTION_LINE, CAPTION_LETTER = 0.155, 0.058  # height of one; width of a letter
BAR_WIDTH = 3.6  # points


def draw_critical_difference(
    ranks: Ranks, title: str, files: list[str], subtitle: str = "", notes: Sequence[str] = ()
) -> None:
    """Writes the diagram into each of the files, .svg or .png, with the notes below. InputError where one cannot be
    written, or where there is nothing to draw."""
    with context([palette.STYLE, {"svg.fonttype": "none"}]):  # text that a reader can search and copy
        save_each(compose(ranks, title, subtitle, notes), files)


def compose(ranks: Ranks, title: str, subtitle: str = "", notes: Sequence[str] = ()) -> Figure:
    blocks, strategies = ranks.of_block.shape
    if blocks < 2 or strategies < 3:
        raise InputError(
            f"{title}: {blocks} blocks in which each of {strategies} strategies has a value; ranks are compared of 3 "
            "strategies or more over 2 blocks or more"
        )
    difference = critical_difference(strategies, blocks)
    levels = stack(not_told_apart(ranks.mean, difference), ranks.mean)
    labels = [label(ranks, number) for number in range(strategies)]
    side = max(SIDE, 2 * MARGIN + LETTER * max(map(len, labels)))
    names = AXIS + FIRST_BAR + max(0, len(levels) - 1) * BAR_STEP + FIRST_NAME
    last = names + ((strategies + 1) // 2 - 1) * NAME_STEP
    letters = int((LENGTH + 2 * side - 2 * MARGIN) / CAPTION_LETTER)
    said = [line for note in [*caption(ranks), *notes] for line in textwrap.wrap(note, letters, break_on_hyphens=False)]
    axes = start(side, last + CAPTION + CAPTION_LINE * len(said) + MARGIN)
    axes.text(MARGIN - side, TITLE, title, va="center", fontsize=11, fontweight="bold")
    axes.text(MARGIN - side, SUBTITLE, subtitle, va="center", fontsize=8, color=palette.FAINT_INK)
    draw_axis(axes, strategies)
    draw_difference(axes, difference, strategies)
    draw_names(axes, ranks.mean, labels, side, names)
    draw_bars(axes, levels, ranks)
    for number, words in enumerate(said):
        axes.text(MARGIN - side, last + CAPTION + CAPTION_LINE * (number + 0.5), words, va="center", fontsize=8,
                  color=palette.FAINT_INK)  # fmt: skip
    return axes.figure


def stack(groups: list[list[int]], mean_ranks: np.ndarray) -> list[list[list[int]]]:
    """The groups level by level, so that the bars of a level are clear of each other."""
    ends = place(mean_ranks, len(mean_ranks))
    levels: list[list[list[int]]] = []
    for group in groups:
        free = (level for level in levels if ends[level[-1][-1]] - ends[group[0]] > 4 * BAR_OVERHANG)
        level = next(free, None)
        if level is None:
            levels.append([group])
        else:
            level.append(group)
    return levels


def label(ranks: Ranks, number: int) -> str:
    failed = f", {ranks.failed[number]} failed" if ranks.failed[number] else ""
    return f"{ranks.strategies[number]}  {ranks.mean[number]:.2f}{failed}"


def start(side: float, height: float) -> Axes:
    """Axes over a whole new figure, in inches."""
    figure = Figure(figsize=(LENGTH + 2 * side, height), dpi=DPI)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(-side, LENGTH + side), ylim=(height, 0))
    axes.axis("off")
    return axes


def place(rank: np.ndarray | float, strategies: int) -> np.ndarray | float:
    """Where a mean rank is on the axis, inches: 1 on the right."""
    return (strategies - rank) / (strategies - 1) * LENGTH


def draw_axis(axes: Axes, strategies: int) -> None:
    line(axes, [0, LENGTH], [AXIS, AXIS])
    for rank in range(1, strategies + 1):
        x = place(rank, strategies)
        line(axes, [x, x], [AXIS - TICK, AXIS])
        axes.text(x, AXIS - TICK - 0.03, str(rank), ha="center", va="bottom", fontsize=8)
    axes.text(LENGTH + 0.12, AXIS - TICK - 0.03, "mean rank, best: 1", va="bottom", fontsize=8,
              color=palette.FAINT_INK)  # fmt: skip


def draw_difference(axes: Axes, difference: float, strategies: int) -> None:
    """A line as long as it is, with ends; only its length in numbers where the axis is too short for it."""
    if difference > strategies - 1:
        axes.text(0, DIFFERENCE, f"CD = {difference:.2f}, more than ranks can differ", va="center", fontsize=8)
        return
    right = place(strategies - difference, strategies)
    line(axes, [0, right], [DIFFERENCE, DIFFERENCE], 1.6)
    for x in (0, right):
        line(axes, [x, x], [DIFFERENCE - TICK, DIFFERENCE + TICK], 1.6)
    axes.text(right + 0.08, DIFFERENCE, f"CD = {difference:.2f}", va="center", fontsize=8)


def draw_names(axes: Axes, mean_ranks: np.ndarray, labels: list[str], side: float, top: float) -> None:
    """The better half on the right, the others on the left, the outermost on top: no two lines cross."""
    order = np.argsort(mean_ranks, kind="stable").tolist()
    better = len(order) // 2
    right, left = (order[:better], "right", LENGTH + side - MARGIN), (order[better:][::-1], "left", MARGIN - side)
    for numbers, align, edge in (right, left):
        for step, number in enumerate(numbers):
            x, y = place(mean_ranks[number], len(order)), top + step * NAME_STEP
            axes.text(edge, y - 0.03, labels[number], ha=align, va="bottom")
            line(axes, [x, x, edge], [AXIS, y, y], palette.ARROW_WIDTH, palette.FAINT_INK)


def draw_bars(axes: Axes, levels: list[list[list[int]]], ranks: Ranks) -> None:
    for number, level in enumerate(levels):
        y = AXIS + FIRST_BAR + number * BAR_STEP
        for group in level:
            best, worst = (place(ranks.mean[end], len(ranks.strategies)) for end in (group[0], group[-1]))
            line(axes, [worst - BAR_OVERHANG, best + BAR_OVERHANG], [y, y], BAR_WIDTH)


def line(axes: Axes, x: list[float], y: list[float], width: float = 1.0, color: str = palette.INK) -> None:
    axes.plot(x, y, color=color, linewidth=width, solid_capstyle="butt", solid_joinstyle="miter")


def caption(ranks: Ranks) -> list[str]:
    left_out = f"; {ranks.left_out} left out, where one has no value" if ranks.left_out else ""
    return [
        f"{len(ranks.of_block)} blocks{left_out}. That all rank alike: {p_words(friedman(ranks.of_block))} (Friedman, "
        "Iman and Davenport).",
        f"Bars join what differs by less than CD (Nemenyi, α = {ALPHA:g}).",
    ]


def p_words(test: Friedman) -> str:
    return "p < 0.0001" if test.p_f < 1e-4 else f"p = {test.p_f:.4f}"
