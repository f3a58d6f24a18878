"""A sweep as small multiples: a row of panels per figure, a column per release, the swept condition along x, a line
per strategy (and speed) with its name at its end."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Picture
from matplotlib.style import context

from . import palette
from .case_figures import Figure
from .pictures import save_each
from .sensitivity import Sweep
from .sensitivity_panel import (
    Line, draw_line, is_category, lines_of, places, scale_of, select, set_x, set_y, shift, tick_texts,
)  # fmt: skip
from .sensitivity_table import notes, shown_unit

# Inches.
LEFT, UNIT_LEFT, MARGIN = 0.72, 0.46, 0.14  # of the first panel; from it to its unit; around the picture
WIDTH, PANEL_HEIGHT = 5.7, 1.3  # of the panels of a row; of one, where the names at the lines' ends need no more
BETWEEN, ROW_GAP = 0.2, 0.5  # from panel to panel
TITLE, RELEASE = 0.24, 0.58  # from the upper edge down to the title and to the releases
TOP, TOP_ALONE = 1.0, 0.68  # to the first row, below releases or without
ROW_TITLE = 0.13  # above a panel
NAME_GAP, NAME_STEP, NAME_LETTER = 0.3, 0.15, 0.068  # from a panel to names; from one to the next; width of a letter
AXIS, AXIS_NAME, TICK_LINE = 0.62, 0.26, 0.13  # below the last row; from its name down; a further line of ticks
NOTE_LINE = 0.17
NOTE_LETTER = 0.06
DPI = 160  # of a PNG

HELD = {"contact": "held while in contact", "step": "held in its step only"}  # a handled vertex
BETTER = {"low": "↓ lower is better", "high": "↑ higher is better"}
TAKEN = {
    "mean": "mean of the steps", "max": "largest of the steps", "final": "of the last step",
    "p50": "median of the steps", "p95": "95 % quantile of the steps", "p99": "99 % quantile of the steps",
}  # fmt: skip


def draw_sweep(sweep: Sweep, files: list[str]) -> None:
    """Writes the picture into each of the files, .svg or .png. InputError where one cannot be written."""
    with context([palette.STYLE, {"svg.fonttype": "none"}]):  # text that a reader can search and copy
        save_each(compose(sweep), files)


@dataclass(frozen=True)
class Layout:
    """Where panels are, inches."""

    columns: int
    rows: int
    width: float  # of a panel
    height: float
    top: float  # of the first row

    @property
    def right(self) -> float:
        return self.left(self.columns) - BETWEEN

    @property
    def end(self) -> float:
        """The lower edge of the last row."""
        return self.above(self.rows) - ROW_GAP

    def left(self, column: int) -> float:
        return LEFT + column * (self.width + BETWEEN)

    def above(self, row: int) -> float:
        return self.top + row * (self.height + ROW_GAP)


def compose(sweep: Sweep) -> Picture:
    lines = lines_of(sweep)
    # The first release of a sweep file, which tells strategies apart best, on the right beside their names.
    panels = sweep.points[sweep.panels].drop_duplicates().to_dict("records")[::-1] if sweep.panels else [{}]
    layout = Layout(
        len(panels), len(sweep.figures), (WIDTH - (len(panels) - 1) * BETWEEN) / len(panels),
        max(PANEL_HEIGHT, NAME_STEP * len(lines)), TOP if sweep.panels else TOP_ALONE,
    )  # fmt: skip
    at = places(sweep)
    ticks = tick_texts(at, is_category(sweep), layout.width)
    width = layout.right + NAME_GAP + NAME_LETTER * max(len(line.name) for line in lines) + MARGIN
    said = [part for note in notes(sweep) for part in textwrap.wrap(note, int((width - 2 * MARGIN) / NOTE_LETTER))]
    below = layout.end + AXIS + TICK_LINE * max(text.count("\n") for text in ticks)
    canvas = start(width, below + NOTE_LINE * len(said) + MARGIN)
    canvas.text(MARGIN, TITLE, f"Sensitivity to: {sweep.over_words}", va="center", fontsize=11, fontweight="bold")
    for row, figure in enumerate(sweep.figures):
        of_row = [add_panel(canvas, layout, row, column) for column in range(len(panels))]
        draw_row(of_row, sweep, figure, panels, lines, at)
        title_row(canvas, figure, layout.above(row))
        for axes in of_row:
            set_x(axes, at, is_category(sweep))
            axes.set_xticklabels(ticks if row == layout.rows - 1 else [])
        name_lines(canvas, of_row[-1], lines, layout, row)
    for column, panel in enumerate(panels):
        title_column(canvas, layout.left(column), panel.get("release"))
    canvas.text((LEFT + layout.right) / 2, below - AXIS_NAME, axis_words(sweep), ha="center", va="center")
    for k, note in enumerate(said):
        canvas.text(MARGIN, below + NOTE_LINE * (k + 0.5), note, va="center", fontsize=8, color=palette.FAINT_INK)
    return canvas.figure


def start(width: float, height: float) -> Axes:
    """Axes over a whole new picture, in inches, y down."""
    picture = Picture(figsize=(width, height), dpi=DPI)
    FigureCanvasAgg(picture)
    canvas = picture.add_axes((0, 0, 1, 1))
    canvas.set(xlim=(0, width), ylim=(height, 0))
    canvas.axis("off")
    canvas.set_zorder(1)  # lines to names begin on the panels
    return canvas


def add_panel(canvas: Axes, layout: Layout, row: int, column: int) -> Axes:
    picture = canvas.figure
    width, height = picture.get_size_inches()
    place = (layout.left(column) / width, 1 - (layout.above(row) + layout.height) / height, layout.width / width,
             layout.height / height)  # fmt: skip
    axes = picture.add_axes(place, facecolor=palette.BACKGROUND)
    axes.spines[:].set_visible(False)
    axes.set_axisbelow(True)
    axes.grid(color="white", linewidth=1)
    axes.tick_params(length=0, labelcolor=palette.FAINT_INK, labelsize=8)
    return axes


def draw_row(
    of_row: list[Axes], sweep: Sweep, figure: Figure, panels: list[dict], lines: list[Line], at: dict[object, float]
) -> None:  # fmt: skip
    """A figure's panels, on one scale."""
    points = sweep.points[sweep.points["metric"] == figure.name]
    unit, factor = shown_unit(figure.unit, points)
    points = points.assign(**{name: points[name] * factor for name in ("median", "low", "high")})
    scale = scale_of(points)
    for axes, panel in zip(of_row, panels):
        set_y(axes, scale)
        for line in lines:
            draw_line(axes, line, select(points, panel | line.keys), at, scale, sweep.over)
        if axes is not of_row[0]:
            axes.set_yticklabels([])
    of_row[0].set_ylabel((unit or figure.counted) + (", log scale" if scale.is_log else ""))
    inches = of_row[0].get_position().width * of_row[0].figure.get_figwidth()
    of_row[0].yaxis.set_label_coords(-UNIT_LEFT / inches, 0.5)


def title_row(canvas: Axes, figure: Figure, top: float) -> None:
    title = canvas.text(LEFT, top - ROW_TITLE, figure.title, va="center", fontweight="bold")
    taken = TAKEN.get(figure.name.partition("/")[0].rpartition("_")[2], "")
    said = ", ".join(filter(None, [taken, BETTER.get(figure.better, "")]))
    canvas.annotate(said, (1, 0.5), (6, 0), title, "offset points", va="center", fontsize=8, color=palette.FAINT_INK)


def title_column(canvas: Axes, left: float, release: str | None) -> None:
    if release is None:
        return
    title = canvas.text(left, RELEASE, f"release: {release}", va="center", fontweight="bold")
    canvas.annotate(HELD.get(release, ""), (1, 0.5), (6, 0), title, "offset points", va="center", fontsize=8,
                    color=palette.FAINT_INK)  # fmt: skip


def name_lines(canvas: Axes, axes: Axes, lines: list[Line], layout: Layout, row: int) -> None:
    """Each line's name beside its last point, and a thin line to it."""
    top, bottom, right = layout.above(row), layout.above(row) + layout.height, layout.right
    ends = []
    marks = {mark.get_label(): mark for mark in axes.lines}
    for line in lines:
        x, y = marks[line.name].get_data()
        if len(x):
            ends.append((line, canvas.transData.inverted().transform(shift(axes, line).transform((x[-1], y[-1])))))
    if not ends:
        canvas.text(right + NAME_GAP, (top + bottom) / 2, "no value", va="center", fontsize=8, color=palette.FAINT_INK)
        return
    heights = keep_apart(np.array([place[1] for _, place in ends]), NAME_STEP, top, bottom)
    for (line, (x, y)), at in zip(ends, heights):
        canvas.plot([x, right + NAME_GAP * 0.3, right + NAME_GAP - 0.05], [y, y, at], color=line.color, linewidth=0.6,
                    solid_joinstyle="round")  # fmt: skip
        canvas.text(right + NAME_GAP, at, line.name, va="center", fontsize=8, color=line.color)


def keep_apart(wanted: np.ndarray, step: float, low: float, high: float) -> np.ndarray:
    """Places near the wanted ones, in their order, `step` or more apart and from low to high where there is room:
    the least squares of what they are moved (pooled adjacent violators)."""
    order = np.argsort(wanted, kind="stable")
    pools: list[list[float]] = []  # mean and size of each
    for k, place in enumerate(wanted[order]):
        pools.append([place - k * step, 1])
        while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
            mean, size = pools.pop()
            pools[-1] = [(pools[-1][0] * pools[-1][1] + mean * size) / (pools[-1][1] + size), pools[-1][1] + size]
    level = np.concatenate([[mean] * int(size) for mean, size in pools])
    kept = np.empty(len(wanted))
    kept[order] = np.clip(level, low, max(low, high - step * (len(wanted) - 1))) + step * np.arange(len(wanted))
    return kept


def axis_words(sweep: Sweep) -> str:
    unit = sweep.units.get(sweep.over)
    return ", ".join(filter(None, [sweep.over_words, unit, "" if is_category(sweep) else "log scale"]))
