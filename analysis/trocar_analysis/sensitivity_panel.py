"""A panel of a sweep's picture: the points of its lines, their intervals, and its axes."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator
from matplotlib.transforms import ScaledTranslation, Transform
from pandas.api.types import is_numeric_dtype

from . import palette
from .sensitivity import Sweep

DODGE = 3.4  # points between neighbouring lines' marks at one value: intervals stand beside each other
MARK_SIZE, FAILED_SIZE, MARK_EDGE = 4.4, 8.5, 1.1  # points
LOG_FROM = 20  # largest over smallest median: from there on the axis is logarithmic
MOST_LOG_TICKS = 6
HEADROOM = 0.08  # of a panel, above its highest mark
LOG_BEYOND = 0.35  # beyond the outermost values of a logarithmic axis, of the mean distance between two
CATEGORY_BEYOND = 0.5
TICK_LETTER = 0.066  # inches, width of one in a tick's label

FAINT_LINE, FAINT_WIDTH = 0.4, 0.9  # between categories, where nothing is: opacity; points


@dataclass(frozen=True)
class Line:
    """One strategy, at one speed where they are told apart."""

    name: str
    keys: dict[str, object]  # columns of the sweep's points, and its values there
    color: str
    marker: str
    dashes: str | tuple
    is_filled: bool
    shift: float  # along x, points


@dataclass(frozen=True)
class Scale:
    """The y axis of a row of panels."""

    low: float
    high: float
    is_log: bool

    def edges(self, values: np.ndarray) -> np.ndarray:
        """The values, infinite ones at the panel's edge."""
        return np.clip(values, self.low, self.high)


def lines_of(sweep: Sweep) -> list[Line]:
    """A line's colour and mark are its strategy's, its dashes and whether its marks are filled its speed's."""
    speeds = sorted(sweep.points["speed"].unique()) if "speed" in sweep.lines else [None]
    labels = list(dict.fromkeys(sweep.points["label"]))
    lines = []
    for k, label in enumerate(labels):
        for m, speed in enumerate(speeds):
            keys = {"label": label} | ({"speed": speed} if speed is not None else {})
            name = label if speed is None else f"{label}, {speed:g} mm/s"
            shift = DODGE * (len(lines) - (len(labels) * len(speeds) - 1) / 2)
            lines.append(
                Line(name, keys, palette.series(k), palette.marker(k), palette.dashes(m), m % 2 == 0, shift)
            )  # fmt: skip
    return lines


def is_category(sweep: Sweep) -> bool:
    return not is_numeric_dtype(sweep.points[sweep.over])


def places(sweep: Sweep) -> dict[object, float]:
    """Each value of the swept column, in order, and its x: itself, or its number where it is a category."""
    values = list(dict.fromkeys(sweep.cases[sweep.over]))
    if is_category(sweep):
        return {value: float(k) for k, value in enumerate(values)}
    return {value: float(value) for value in sorted(values)}


def select(points: pd.DataFrame, keys: dict[str, object]) -> pd.DataFrame:
    """The rows with these values."""
    chosen = np.ones(len(points), bool)
    for name, value in keys.items():
        chosen &= (points[name] == value).to_numpy()
    return points[chosen]


def scale_of(points: pd.DataFrame) -> Scale:
    """That of a figure's points: from 0, or logarithmic where positive medians differ much."""
    ends = points[["median", "low", "high"]].to_numpy(float)
    finite = ends[np.isfinite(ends)]
    if len(finite) == 0:
        return Scale(0, 1, False)
    medians = points["median"][np.isfinite(points["median"])]
    if finite.min() > 0 and medians.max() > LOG_FROM * medians.min():
        room = (finite.max() / finite.min()) ** HEADROOM
        return Scale(finite.min() / room, finite.max() * room, True)
    low, high = min(0.0, finite.min()), max(0.0, finite.max())
    room = HEADROOM * (high - low) or 1
    return Scale(low - room if low < 0 else -room / 2, high + room, False)


def draw_line(axes: Axes, line: Line, points: pd.DataFrame, at: dict[object, float], scale: Scale, over: str) -> None:
    """The medians in the order of x, their intervals and a × on those with failed cases."""
    points = points.dropna(subset=["median"])
    x = points[over].map(at).to_numpy(float)
    order = np.argsort(x)
    points, x = points.iloc[order], x[order]
    y, low, high = (scale.edges(points[name].to_numpy(float)) for name in ("median", "low", "high"))
    shifted = shift(axes, line)
    opacity, width = (1, palette.SERIES_WIDTH) if is_numeric_dtype(points[over]) else (FAINT_LINE, FAINT_WIDTH)
    axes.plot(x, y, color=line.color, linestyle=line.dashes, linewidth=width, alpha=opacity, transform=shifted,
              zorder=3)  # fmt: skip
    has_interval = ~np.isnan(low)
    axes.vlines(x[has_interval], low[has_interval], high[has_interval], color=line.color,
                linewidth=palette.INTERVAL_WIDTH, transform=shifted, zorder=4)  # fmt: skip
    axes.plot(x, y, line.marker, color=line.color, markersize=MARK_SIZE, transform=shifted, zorder=5, clip_on=False,
              markerfacecolor=line.color if line.is_filled else "white", markeredgewidth=MARK_EDGE,
              label=line.name)  # fmt: skip
    has_failed = points["failed"].to_numpy() > 0
    axes.plot(x[has_failed], y[has_failed], "x", color=palette.INK, markersize=FAILED_SIZE, markeredgewidth=MARK_EDGE,
              transform=shifted, zorder=6, clip_on=False)  # fmt: skip


def shift(axes: Axes, line: Line) -> Transform:
    return axes.transData + ScaledTranslation(line.shift / 72, 0, axes.figure.dpi_scale_trans)


def set_y(axes: Axes, scale: Scale) -> None:
    axes.set_yscale("log" if scale.is_log else "linear")
    axes.set_ylim(scale.low, scale.high)
    if scale.is_log:
        axes.yaxis.set_major_locator(FixedLocator(log_ticks(scale)))
    else:
        axes.yaxis.set_major_locator(MaxNLocator(5, steps=(1, 2, 2.5, 5, 10)))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: plain(value)))


def log_ticks(scale: Scale) -> list[float]:
    """As many steps of each power of ten as are few enough to read."""
    powers = range(int(np.floor(np.log10(scale.low))), int(np.ceil(np.log10(scale.high))) + 1)
    for steps in ((1, 2, 5), (1, 3), (1,)):
        ticks = [step * 10.0**power for power in powers for step in steps]
        ticks = [tick for tick in ticks if scale.low <= tick <= scale.high]
        if len(ticks) <= MOST_LOG_TICKS:
            break
    return ticks


def set_x(axes: Axes, at: dict[object, float], names_categories: bool) -> None:
    """Ticks are the values that there are, and no others."""
    x = np.array(list(at.values()))
    if names_categories or x.min() <= 0:
        beyond = CATEGORY_BEYOND * (x.max() - x.min()) / (len(x) - 1)
        axes.set_xlim(x.min() - beyond, x.max() + beyond)
    else:
        axes.set_xscale("log")
        beyond = (x.max() / x.min()) ** (LOG_BEYOND / (len(x) - 1))
        axes.set_xlim(x.min() / beyond, x.max() * beyond)
    axes.xaxis.set_major_locator(FixedLocator(x))
    axes.xaxis.set_minor_locator(NullLocator())


def tick_texts(at: dict[object, float], names_categories: bool, width: float) -> list[str]:
    """What the ticks of a panel say that is `width` inches wide: categories in several lines where need be; of numbers
    those that have room."""
    if names_categories:
        letters = max(4, int(width / len(at) / TICK_LETTER))
        return [textwrap.fill(str(value), letters) for value in at]
    x = np.log(list(at.values())) if min(at.values()) > 0 else np.array(list(at.values()))
    inches = (x - x[0]) / (x[-1] - x[0]) * width * 0.85
    texts, end = [], -np.inf
    for value, place in zip(at.values(), inches):
        half = len(plain(value)) * TICK_LETTER / 2
        has_room = place - half > end
        texts.append(plain(value) if has_room else "")
        end = place + half + TICK_LETTER if has_room else end
    return texts


def plain(value: float) -> str:
    """Three significant digits, thousands apart."""
    return (f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}").replace("-", "−")
