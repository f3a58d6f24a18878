"""Lays out the panels of a figure, with their words, a legend and the caption."""

from __future__ import annotations

from textwrap import wrap

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .. import palette
from ..camera import Camera
from ..rendering import FINER
from ..snapshot import MARGIN, MOMENT_WORDS, add_scale
from .eye import place_camera
from .figure_file import FigureFile
from .panel import draw_panel
from .shown import Shown, conditions, differing, facts

WIDTH = 7.4  # of the figure, inches
DPI = 150
TITLE_HEIGHT, LEGEND_HEIGHT = 0.3, 0.28
PANEL_TITLE_HEIGHT, FACT_LINE = 0.34, 0.15  # above and below each panel
CAPTION_LINE = 0.165
CAPTION_WIDTH = 122  # letters
GAP = 0.08  # below a row
# What panels that share a camera have in common, besides the rule that chose their steps.
PLACE = ("scene", "organ", "tool", "seed")


def compose(wanted: FigureFile, shown: list[Shown]) -> Figure:
    columns = wanted.columns
    panel_width = (WIDTH - MARGIN) / columns - MARGIN
    panel_height = panel_width * wanted.view.height / wanted.view.width
    in_rows = [shown[first : first + columns] for first in range(0, len(shown), columns)]
    facts_heights = [FACT_LINE * max(len(one.panel.facts) for one in row) for row in in_rows]
    lines = wrap(wanted.caption, CAPTION_WIDTH)
    below = LEGEND_HEIGHT + CAPTION_LINE * len(lines) + 2 * MARGIN
    height = TITLE_HEIGHT + len(in_rows) * (PANEL_TITLE_HEIGHT + panel_height + GAP) + sum(facts_heights) + below
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    cameras: dict[tuple, Camera] = {}
    for index, one in enumerate(shown):
        row, column = divmod(index, columns)
        left = MARGIN + column * (panel_width + MARGIN)
        above = row * (panel_height + GAP) + (row + 1) * PANEL_TITLE_HEIGHT + sum(facts_heights[:row])
        top = height - TITLE_HEIGHT - above
        axes = figure.add_axes(
            (left / WIDTH, (top - panel_height) / height, panel_width / WIDTH, panel_height / height)
        )
        place = (one.panel.step, *(one.case[name] for name in PLACE if name in one.case))
        if place not in cameras:
            pixels = round(panel_width * DPI) * FINER
            cameras[place] = place_camera(one.view, one.step.tool_tip, wanted.view, pixels)
            add_scale(axes, cameras[place])
        draw_panel(axes, cameras[place], one.step, one.way, one.panel)
        add_words(axes, one, differing(shown))
    add_frame(figure, wanted, shown, height, lines)
    return figure


def add_words(axes: Axes, one: Shown, differ: list[str]) -> None:
    place = {"xycoords": "axes fraction", "textcoords": "offset points"}
    title = f"{one.panel.letter}) {one.panel.title}"
    said = " · ".join([*conditions(one.case, differ), f"step {one.number}"])
    axes.annotate(title, (0, 1), (0, 14), fontsize=8.8, fontweight="bold", **place)
    axes.annotate(said, (0, 1), (0, 4), fontsize=7.2, color=palette.FAINT_INK, **place)
    axes.annotate("\n".join(facts(one)), (0, 0), (0, -3), fontsize=7.2, va="top", linespacing=1.3, **place)


def add_frame(figure: Figure, wanted: FigureFile, shown: list[Shown], height: float, lines: list[str]) -> None:
    """What stands above and below the panels: what the figure is of, what its colours mean, its caption."""
    left = MARGIN / WIDTH
    figure.text(left, 1 - 0.14 / height, wanted.title, va="center", fontsize=11, fontweight="bold")
    figure.text(1 - left, 1 - 0.14 / height, shared_words(shown), va="center", ha="right", fontsize=7.2,
                color=palette.FAINT_INK)  # fmt: skip
    figure.text(left, (CAPTION_LINE * len(lines) + MARGIN) / height, "\n".join(lines), va="top", fontsize=8.2,
                linespacing=1.35)  # fmt: skip
    add_legend(figure, shown, (CAPTION_LINE * len(lines) + 2 * MARGIN) / height)


def shared_words(shown: list[Shown]) -> str:
    """The conditions in which no two panels differ."""
    names = ("scene", "organ", "tool", "speed", "release", "seed")
    shared = [name for name in names if len({one.case.get(name) for one in shown}) == 1]
    moments = {one.panel.moment for one in shown}
    said = [MOMENT_WORDS[moment] for moment in moments if len(moments) == 1]
    return " · ".join(conditions(shown[0].case, shared) + said)


def add_legend(figure: Figure, shown: list[Shown], bottom: float) -> None:
    """Of what there is in the panels."""
    marked = {one.panel.surface for one in shown if one.panel.moment != "found"}
    vectors = {one.panel.vectors for one in shown}
    arrow = {"linestyle": "none", "marker": r"$\rightarrow$", "markersize": 12}
    entries = {
        "organ": Patch(facecolor=palette.ORGAN, edgecolor=palette.ORGAN_OUTLINE),
        "tool": Patch(facecolor=palette.TOOL, alpha=0.6),
        "its motion": Line2D([], [], color=palette.TOOL_OUTLINE, **arrow),
    }
    if "solid" in marked:
        entries["facets in or across the tool"] = Patch(facecolor=palette.FACET_IN_TOOL_DARK)
    if "wire" in marked:
        entries["edges of facets in or across it" if "solid" not in marked else "their edges"] = Line2D(
            [], [], color=palette.FACET_IN_TOOL_DARK
        )
    if vectors != {"none"}:
        entries["displacement of a vertex"] = Line2D([], [], color=palette.DISPLACEMENT, **arrow)
    if "crossing" in vectors:
        entries["that crosses a neighbour's"] = Line2D([], [], color=palette.CROSSING, **arrow)
    figure.legend(
        list(entries.values()), list(entries), loc="lower left", bbox_to_anchor=(0, bottom), ncol=len(entries),
        columnspacing=1.4, handletextpad=0.5, frameon=False, fontsize=7.6, borderaxespad=0.1,
    )  # fmt: skip
