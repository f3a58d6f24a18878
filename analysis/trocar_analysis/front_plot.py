"""The picture of `front`: a point per strategy with its intervals, those on the front joined by a line of steps."""

from __future__ import annotations

import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Picture
from matplotlib.style import context
from matplotlib.text import Text
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

from . import palette
from .case_figures import Figure
from .front import ENDS, Front
from .label_places import place_labels
from .pictures import save_each
from .sensitivity_panel import FAILED_SIZE, MARK_EDGE, Scale, log_ticks, plain
from .sensitivity_plot import NOTE_LETTER, NOTE_LINE, TAKEN, Layout, add_panel, start
from .sensitivity_table import shown_unit

# Inches.
LEFT, MARGIN = 0.72, 0.14  # of the panel; around the picture
WIDTH, HEIGHT, TOP = 6.5, 4.2, 0.94  # of the panel; from the upper edge down to it
TITLE, SUBTITLE = 0.22, 0.43  # from the upper edge down
Y_TITLE, X_TITLE, BELOW = 0.15, 0.42, 0.66  # above the panel; below it; from it down to the notes
LABEL_ROOM = 0.05  # around a name
LEADER_FROM = 0.1  # distance between a point and its name from which on a line joins them
MARK_SIZE, MARK_REACH = 6.5, 0.055  # points; inches around a point

LOG_FROM = 30  # largest over smallest median: from there on an axis is logarithmic
LOG_BELOW = 30  # … and it goes so far below the smallest, at most: an interval may end anywhere
ROOM = 0.1  # of an axis, beyond the outermost values on either side
MOST_TICKS = 7
STEPS = "front"  # the line's label
STEPS_WIDTH, STEPS_OPACITY = 6, 0.13  # of the line of steps: wide, since intervals lie along it
FAINT = 0.45  # opacity
LOWER = {"low": ("↓ lower is better", "← lower is better"), "high": ("↑ higher is better", "→ higher is better")}


def draw_front(front: Front, files: list[str]) -> None:
    """Writes the picture into each of the files, .svg or .png. InputError where one cannot be written."""
    with context([palette.STYLE, {"svg.fonttype": "none"}]):  # text that a reader can search and copy
        save_each(compose(front), files)


def compose(front: Front) -> Picture:
    said = [line for note in [*front.notes, *front.cautions]
            for line in textwrap.wrap(note, int((LEFT + WIDTH) / NOTE_LETTER), break_on_hyphens=False)]  # fmt: skip
    layout = Layout(1, 1, WIDTH, HEIGHT, TOP)
    bottom = TOP + HEIGHT
    canvas = start(LEFT + WIDTH + MARGIN, bottom + BELOW + NOTE_LINE * len(said) + MARGIN)
    canvas.text(MARGIN, TITLE, "Pareto front", va="center", fontsize=11, fontweight="bold")
    canvas.text(MARGIN, SUBTITLE, ", ".join(front.only) or "all cases", va="center", fontsize=8, color=palette.FAINT_INK)
    axes = add_panel(canvas, layout, 0, 0)
    x, x_unit, x_scale = along(front, front.against, "against_")
    y, y_unit, y_scale = along(front, front.figure, "")
    set_axis(axes, "x", x_scale)
    set_axis(axes, "y", y_scale)
    title_axis(canvas, front.figure, y_unit, y_scale, TOP - Y_TITLE, LOWER[front.figure.better][0])
    title_axis(canvas, front.against, x_unit, x_scale, bottom + X_TITLE, LOWER[front.against.better][1])
    steps = front_steps(x[:, 0], y[:, 0], front.points["on_front"].to_numpy())
    axes.plot(*steps.T, color=palette.INK, linewidth=STEPS_WIDTH, alpha=STEPS_OPACITY, solid_joinstyle="round", zorder=2,
              label=STEPS)  # fmt: skip
    draw_points(axes, front, x, y)
    name_points(canvas, axes, front, x, y, steps)
    for k, note in enumerate(said):
        canvas.text(MARGIN, bottom + BELOW + NOTE_LINE * (k + 0.5), note, va="center", fontsize=8,
                    color=palette.FAINT_INK)  # fmt: skip
    return canvas.figure


def along(front: Front, figure: Figure, prefix: str) -> tuple[np.ndarray, str, Scale]:
    """A figure's median and the ends of its interval, [strategies, 3], as they are drawn: in a unit that people read,
    which is given, too, and what is infinite at the panel's edge."""
    values = front.points[[f"{prefix}{name}" for name in ENDS]].set_axis(ENDS, axis=1)
    unit, factor = shown_unit(figure.unit, values)
    values = values.to_numpy(float) * factor
    scale = scale_of(values)
    return scale.edges(values), unit, scale


def scale_of(values: np.ndarray) -> Scale:
    """That of medians and ends of intervals, [strategies, 3]: logarithmic where all are positive and the medians differ
    much, else from 0 where that leaves half of the axis to the values."""
    finite, medians = values[np.isfinite(values)], values[np.isfinite(values[:, 0]), 0]
    if len(medians) == 0:
        return Scale(0, 1, False)
    if finite.min() > 0 and medians.max() > LOG_FROM * medians.min():
        low, high = max(finite.min(), medians.min() / LOG_BELOW), finite.max()
        room = (high / low) ** ROOM
        return Scale(low / room, high * room, True)
    low, high = finite.min(), finite.max()
    if 0 < low < high / 2:
        low = 0.0
    if low / 2 < high < 0:
        high = 0.0
    room = ROOM * (high - low) or abs(high) / 2 or 1
    return Scale(low - room, high + room, False)


def set_axis(axes: Axes, which: str, scale: Scale) -> None:
    axis = getattr(axes, f"{which}axis")
    axes.set(**{f"{which}scale": "log" if scale.is_log else "linear", f"{which}lim": (scale.low, scale.high)})
    axis.set_major_locator(
        FixedLocator(log_ticks(scale)) if scale.is_log else MaxNLocator(MOST_TICKS, steps=(1, 2, 2.5, 5, 10))
    )
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: plain(value)))


def title_axis(canvas: Axes, figure: Figure, unit: str, scale: Scale, height: float, better: str) -> None:
    title = canvas.text(MARGIN, height, figure.title, va="center", fontweight="bold")
    taken = TAKEN.get(figure.name.partition("/")[0].rpartition("_")[2], "")
    unit = (unit or figure.counted).removeprefix("1")  # which says nothing
    said = ", ".join(filter(None, [unit, "log scale" if scale.is_log else "", taken, better]))
    canvas.annotate(said, (1, 0.5), (6, 0), title, "offset points", va="center", fontsize=8, color=palette.FAINT_INK)


def front_steps(x: np.ndarray, y: np.ndarray, on_front: np.ndarray) -> np.ndarray:
    """The corners of the line that joins the points on the front, which are in its order: from each to the next, it turns
    where both figures are the worse of the two."""
    x, y = x[on_front], y[on_front]
    corners = np.stack([np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1]], axis=1)
    return corners


def draw_points(axes: Axes, front: Front, x: np.ndarray, y: np.ndarray) -> None:
    """Points, their intervals, and a × on those with failed cases."""
    for k, point in front.points.iterrows():
        color, opacity = palette.series(point["number"]), 1 if point["on_front"] else FAINT
        bar = {"color": color, "linewidth": palette.INTERVAL_WIDTH, "alpha": opacity, "zorder": 3}
        if not np.isnan(x[k]).any():
            axes.hlines(y[k, 0], *x[k, 1:], **bar)
        if not np.isnan(y[k]).any():
            axes.vlines(x[k, 0], *y[k, 1:], **bar)
        axes.plot(x[k, 0], y[k, 0], palette.marker(point["number"]), color=color, markersize=MARK_SIZE, clip_on=False,
                  markerfacecolor=color if point["on_front"] else "white", markeredgewidth=MARK_EDGE, zorder=4,
                  alpha=1 if point["on_front"] else 0.8, label=point["label"])  # fmt: skip
        if point["failed"]:
            axes.plot(x[k, 0], y[k, 0], "x", color=palette.INK, markersize=1.4 * FAILED_SIZE, markeredgewidth=MARK_EDGE,
                      clip_on=False, zorder=5)  # fmt: skip


def name_points(canvas: Axes, axes: Axes, front: Front, x: np.ndarray, y: np.ndarray, steps: np.ndarray) -> None:
    """Each strategy's name beside its point, with a thin line to it where it stands further off."""
    names = [
        canvas.text(0, 0, point["label"], ha="center", va="center", fontsize=8.5,
                    fontweight="bold" if point["on_front"] else "normal",
                    color=palette.INK if point["on_front"] else palette.FAINT_INK)
        for _, point in front.points.iterrows()
    ]  # fmt: skip
    points = inches(axes, np.stack([x[:, 0], y[:, 0]], axis=1))
    sizes = np.array([size_of(name) for name in names]) + LABEL_ROOM
    bars = [inches(axes, np.array([(end, y[k, 0]) for end in x[k, 1:]])) for k in range(len(names))]
    bars += [inches(axes, np.array([(x[k, 0], end) for end in y[k, 1:]])) for k in range(len(names))]
    corners = inches(axes, steps)
    lines = np.array([*(bar for bar in bars if not np.isnan(bar).any()), *zip(corners[:-1], corners[1:])])
    places = place_labels(points, sizes, (WIDTH, HEIGHT), lines, MARK_REACH)
    for name, place, point, size in zip(names, places, points, sizes):
        name.set_position((LEFT + place[0], TOP + HEIGHT - place[1]))
        end = np.clip(point, place - size / 2, place + size / 2)
        if np.hypot(*(end - point)) > LEADER_FROM:
            ends = np.stack([point, end])
            canvas.plot(LEFT + ends[:, 0], TOP + HEIGHT - ends[:, 1], color=palette.FAINT_INK, linewidth=0.6)


def inches(axes: Axes, points: np.ndarray) -> np.ndarray:
    """Where points of the data are in the panel, from its lower left corner."""
    return axes.transAxes.inverted().transform(axes.transData.transform(points)) * (WIDTH, HEIGHT)


def size_of(name: Text) -> tuple[float, float]:
    """Width and height, inches."""
    box = name.get_window_extent()
    return box.width / name.figure.dpi, box.height / name.figure.dpi
