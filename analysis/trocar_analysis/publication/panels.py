"""A figure over the values of a condition, as a paper shows it: small multiples by scene and release, no title and no notes
but the figure's name: the caption has the rest. Strategies are told apart by mark, by whether it is filled and by dashes as
well as by colour, so that it can be read in grey."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Picture
from matplotlib.lines import Line2D

from .. import palette
from ..case_figures import Cases, Figure
from ..sensitivity import Sweep, along_with, points_of
from ..sensitivity_panel import DODGE, MARK_EDGE, MARK_SIZE, TICK_LETTER, Line, is_category, places, select, set_x, tick_texts
from ..sensitivity_plot import BETTER, LEFT, MARGIN, Layout, add_panel, axis_words, draw_row, start

# Inches.
WIDTH, HEIGHT = 5.5, 1.1  # of a row's panels; of one
BETWEEN, ROW_GAP = 0.2, 0.3  # as Layout has them: between panels; it has 0.5 between rows
TITLE, KEY, KEY_LINE, KEY_LETTER, KEY_MARK = 0.14, 0.34, 0.152, 0.0575, 0.52  # from the upper edge down; of the key
HEADS = 0.46  # from the key down to the first row
AXIS, AXIS_ALONE, TICK_LINE = 0.6, 0.3, 0.13  # below the last row, with what is along it or without; a further line of ticks
SLOPE = 30  # degrees, of names that have no room beside each other
SPREAD = 0.8  # of the room between two values, that the marks at one take at most

ROWS, COLUMNS = "scene", "release"  # by which panels are told apart


@dataclass(frozen=True)
class Panels:
    """What is drawn."""

    sweep: Sweep  # of one figure
    rows: list[dict]  # the keys that the panels of a row share: a scene, or none
    columns: list[dict]  # … and those of a column: a release, or none
    lines: list[Line]


def panels_over(over: str, figure: Figure, cases: Cases, used: pd.DataFrame, labels: list[str]) -> Panels:
    """A figure of the cases `used` over a condition, or over the strategies themselves ("label"). `labels`: all strategies of
    the file: each looks the same in every picture."""
    apart = [name for name in (ROWS, COLUMNS) if name != over and name in used and used[name].nunique() > 1]
    keys = [*apart, *([over] if over != "label" else []), "label"]
    along = [name for name in along_with(used, over, {*apart, "label"}) if {name, over} != {"organ", "organ_facets"}]
    sweep = Sweep(
        over, "strategy" if over == "label" else cases.words.get(over, over), cases.units, apart, ["label"], [figure],
        points_of(used, keys, [figure]), used, along, cases.cautions([figure], used.index),
    )  # fmt: skip
    rows, columns = (
        [{name: value} for value in used[name].unique()] if name in apart else [{}] for name in (ROWS, COLUMNS)
    )
    shown = [label for label in labels if label in set(used["label"])]
    shifts = np.zeros(len(shown)) if over == "label" else spread_out(len(shown), len(places(sweep)), len(columns))
    lines = [line_of(label, labels.index(label), shift) for label, shift in zip(shown, shifts)]
    return Panels(sweep, rows, columns, lines)


def line_of(label: str, number: int, shift: float = 0) -> Line:
    """How a strategy is drawn; `number` in the order of the file. Twelve are told apart in grey."""
    is_filled = (number + number // len(palette.MARKERS)) % 2 == 0  # neighbours differ, and so do those of one mark
    return Line(label, {"label": label}, palette.series(number), palette.marker(number), palette.dashes(number), is_filled,
                float(shift))  # fmt: skip


def spread_out(lines: int, values: int, columns: int) -> np.ndarray:
    """How far marks at one value stand beside each other, points."""
    room = SPREAD * 72 * panel_width(columns) / values
    return min(DODGE, room / lines) * (np.arange(lines) - (lines - 1) / 2)


def panel_width(columns: int) -> float:
    return (WIDTH - (columns - 1) * BETWEEN) / columns


def compose(panels: Panels) -> Picture:
    sweep, lines = panels.sweep, panels.lines
    at = places(sweep)
    layout = Layout(len(panels.columns), len(panels.rows), panel_width(len(panels.columns)), HEIGHT, 0)
    texts, slope, room = ticks_of(sweep, at, layout.width)
    key_columns = max(1, int((WIDTH + LEFT) / (KEY_MARK + KEY_LETTER * max(len(line.name) for line in lines))))
    key_lines = 0 if sweep.over == "label" else -(-len(lines) // key_columns)
    layout = replace(layout, top=KEY + KEY_LINE * key_lines + (HEADS if sweep.panels else 0.1))
    bottom = layout.above(len(panels.rows) - 1) + HEIGHT
    words = "" if sweep.over == "label" else axis_words(sweep)
    canvas = start(layout.right + MARGIN, bottom + room + (AXIS if words else AXIS_ALONE))
    for number, row in enumerate(panels.rows):
        of_row = [add_panel(canvas, layout, number, column) for column in range(len(panels.columns))]
        points = select(sweep.points, row)
        draw_row(of_row, replace(sweep, points=points), sweep.figures[0], panels.columns, lines, at)
        for axes, column in zip(of_row, panels.columns):
            set_x(axes, at, is_category(sweep))
            axes.set_xticklabels([])
            if select(points, column)["median"].isna().all():
                axes.text(0.5, 0.5, "no value", transform=axes.transAxes, ha="center", va="center", fontsize=8,
                          color=palette.FAINT_INK)  # fmt: skip
            if number == len(panels.rows) - 1:
                axes.set_xticklabels(texts, rotation=slope, ha="right" if slope else "center", rotation_mode="anchor")
        name_panels(canvas, layout, number, row, panels.columns)
    if key_lines:
        draw_key(canvas.figure, lines, key_columns)
    title(canvas, sweep.figures[0])
    canvas.text((LEFT + layout.right) / 2, bottom + room + 0.42, words, ha="center", va="center")
    return canvas.figure


def ticks_of(sweep: Sweep, at: dict[object, float], width: float) -> tuple[list[str], int, float]:
    """What the ticks say, how they slope, and the inches that they need beyond a line."""
    if not is_category(sweep):
        return tick_texts(at, False, width), 0, 0
    longest = max(len(word) for value in at for word in str(value).split())
    if longest * TICK_LETTER > width / len(at):
        most = max(len(str(value)) for value in at)
        return [str(value) for value in at], SLOPE, most * TICK_LETTER * float(np.sin(np.radians(SLOPE)))
    texts = tick_texts(at, True, width)
    return texts, 0, TICK_LINE * max(text.count("\n") for text in texts)


def name_panels(canvas: Axes, layout: Layout, number: int, row: dict, columns: list[dict]) -> None:
    """The row's scene above its first panel, and the releases above all."""
    above = layout.above(number)
    for name, value in row.items():
        canvas.text(LEFT, above - 0.1, f"{name}: {value}", va="center", fontsize=8, fontweight="bold")
    for place, column in enumerate(columns if number == 0 else []):
        for name, value in column.items():
            canvas.text(layout.left(place), above - (0.28 if row else 0.1), f"{name}: {value}", va="center", fontsize=8,
                        color=palette.FAINT_INK)  # fmt: skip


def title(canvas: Axes, figure: Figure) -> None:
    text = canvas.text(MARGIN, TITLE, figure.title, va="center", fontweight="bold")
    canvas.annotate(BETTER.get(figure.better, ""), (1, 0.5), (6, 0), text, "offset points", va="center", fontsize=8,
                    color=palette.FAINT_INK)  # fmt: skip


def draw_key(picture: Picture, lines: list[Line], columns: int) -> None:
    height = picture.get_figheight()
    key = picture.legend(
        handles=[mark_of(line) for line in lines], ncol=columns, loc="upper left", frameon=False, fontsize=8,
        bbox_to_anchor=(MARGIN / picture.get_figwidth(), 1 - KEY / height), borderpad=0, borderaxespad=0,
        handlelength=3.2, columnspacing=1.2, handletextpad=0.5, labelspacing=0.35,
    )  # fmt: skip
    key.set_zorder(2)


def mark_of(line: Line) -> Line2D:
    """A piece of a line, as the key has it."""
    return Line2D(
        [], [], color=line.color, linestyle=line.dashes, linewidth=palette.SERIES_WIDTH, marker=line.marker,
        markersize=MARK_SIZE, markerfacecolor=line.color if line.is_filled else "white", markeredgewidth=MARK_EDGE,
        label=line.name,
    )  # fmt: skip
