"""`snapshot`: a picture of one step of a case, the strategies that met the same conditions side by side."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerTuple
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.style import context

from . import palette
from .deepest import deepest_step
from .drawing import draw_step
from .errors import InputError
from .store import ResultFile, Step, find_case, only_case, siblings
from .view import View, choose_view

PANEL_WIDTH = 3.6  # inches
LONE_PANEL_WIDTH = 7.0
TITLE_HEIGHT = 0.5  # above each row of panels, inches
LEGEND_HEIGHT = 0.32  # also of the line at the top
MARGIN = 0.08
DPI = 200

MOMENT_WORDS = {"found": "before handling", "handled": "after handling", "deformed": "after deformation"}


def snapshot(path: str, case_prefix: str | None, step_text: str, output: str, alone: bool, moment: str) -> str:
    """Writes the picture to `output` and returns a line that says what is on it. Without a case the file's
    replays must all be under the same conditions."""
    if Path(output).suffix.lower() not in (".png", ".svg"):
        raise InputError(f"{output}: a picture's name ends in .png or .svg")
    with ResultFile(path) as results:
        cases = results.cases_table()
        case = find_case(cases, case_prefix) if case_prefix else only_case(with_replay(results, cases))
        poses = results.tool_poses(case["case_id"])
        number = choose_step(step_text, poses)
        shown = [case] if alone else [row for _, row in siblings(cases, case).iterrows()]
        panels = [
            (row, results.step(row["case_id"], number))
            for row in shown
            if results.has_replay(row["case_id"]) and number < len(results.tool_poses(row["case_id"]))
        ]
    own = next(step for row, step in panels if row["case_id"] == case["case_id"])
    view = choose_view(own.rest_positions, own.tool_positions, poses, number)
    with context(palette.STYLE):
        figure = compose(panels, view, number, moment)
        save(figure, output)
    missing = len(shown) - len(panels)
    note = f"; {missing} more cases under these conditions have no replay of this step" if missing else ""
    return f"{output}: step {number} of {', '.join(row['label'] for row, _ in panels)}{note}"


def with_replay(results: ResultFile, cases: pd.DataFrame) -> pd.DataFrame:
    recorded = cases[[results.has_replay(case_id) for case_id in cases["case_id"]]]
    if recorded.empty:
        raise InputError(f"{results.path}: no case has a replay; record one with `trocar run … --replay`")
    return recorded


def choose_step(asked: str, poses: np.ndarray) -> int:
    """The number of a step, from an integer or "deepest"."""
    if asked == "deepest":
        return deepest_step(poses)
    try:
        number = int(asked)
    except ValueError:
        raise InputError(f"--step {asked}: is neither a whole number nor 'deepest'") from None
    if not -len(poses) <= number < len(poses):
        raise InputError(f"--step {asked}: is out of range; the case has steps 0 to {len(poses) - 1}")
    return number % len(poses)


def compose(panels: list[tuple[pd.Series, Step]], view: View, number: int, moment: str) -> Figure:
    columns = 2 if len(panels) == 4 else min(len(panels), 3)
    rows = math.ceil(len(panels) / columns)
    panel_width = PANEL_WIDTH if columns > 1 else LONE_PANEL_WIDTH
    panel_height = panel_width * view.half_height / view.half_width
    width = columns * (panel_width + MARGIN) + MARGIN
    height = rows * (panel_height + TITLE_HEIGHT) + 2 * LEGEND_HEIGHT
    figure = Figure(figsize=(width, height), dpi=DPI)
    FigureCanvasAgg(figure)
    for index, (case, step) in enumerate(panels):
        row, column = divmod(index, columns)
        left = MARGIN + column * (panel_width + MARGIN)
        top = height - LEGEND_HEIGHT - TITLE_HEIGHT - row * (panel_height + TITLE_HEIGHT)
        axes = figure.add_axes(
            (left / width, (top - panel_height) / height, panel_width / width, panel_height / height)
        )
        draw_step(axes, step, moment, view)
        add_title(axes, case["label"], step, number)
    add_scale(figure.axes[0], view)
    case = panels[0][0]
    conditions = [str(case[name]) for name in ("scene", "organ", "tool") if name in case]
    conditions += [f"{case['speed']:g} mm/s"] if "speed" in case else []
    conditions += [f"seed {case['seed']}"] if "seed" in case else []
    figure.text(
        MARGIN / width, 1 - 0.5 * LEGEND_HEIGHT / height, " · ".join([*conditions, MOMENT_WORDS[moment]]),
        va="center", color=palette.FAINT_INK, fontsize=9,
    )
    add_legend(figure)
    return figure


def add_title(axes: Axes, label: str, step: Step, number: int) -> None:
    facts = [f"step {number}"]
    if "time" in step.values:
        facts[0] += f", {step.values['time']:.3f} s"
    if "collided_vertices" in step.values:
        facts.append(f"{step.values['collided_vertices']:.0f} collided")
    facts.append(f"{len(step.moved)} moved")
    place = {"xy": (0, 1), "xycoords": "axes fraction", "textcoords": "offset points"}
    axes.annotate(label, xytext=(0, 18), fontsize=11, fontweight="bold", **place)
    axes.annotate(" · ".join(facts), xytext=(0, 6), fontsize=8.5, color=palette.FAINT_INK, **place)


def add_scale(axes: Axes, view: View) -> None:
    length = max(size for size in (1, 2, 5, 10, 20, 50) if size == 1 or size < 0.5 * view.half_width)
    x, y = -0.94 * view.half_width, -0.92 * view.half_height
    axes.plot([x, x + length], [y, y], color=palette.INK, linewidth=2, solid_capstyle="butt", zorder=9)
    axes.annotate(f"{length} mm", (x, y), (0, 4), "data", "offset points", fontsize=8, zorder=9)


def add_legend(figure: Figure) -> None:
    arrow = {"linestyle": "none", "marker": r"$\rightarrow$"}
    entries = {
        "organ": Patch(facecolor=palette.ORGAN),
        "its section": Patch(facecolor=palette.ORGAN_SECTION, edgecolor=palette.ORGAN_OUTLINE),
        "tool": Patch(facecolor=palette.TOOL, alpha=0.6),
        "organ in or across the tool": (
            Patch(facecolor=palette.PENETRATION),
            Patch(facecolor=palette.FACET_IN_TOOL),
        ),
        "displacement": Line2D([], [], color=palette.DISPLACEMENT, markersize=13, **arrow),
        "tool's motion": Line2D([], [], color=palette.TOOL_OUTLINE, markersize=16, **arrow),
    }
    figure.legend(
        list(entries.values()), list(entries), handler_map={tuple: HandlerTuple(ndivide=None, pad=0)},
        loc="lower center", ncol=len(entries), columnspacing=1.4,
        handletextpad=0.5, frameon=False, fontsize=8.5,
    )  # fmt: skip


def save(figure: Figure, output: str) -> None:
    try:
        figure.savefig(output, metadata={"Date": None} if output.lower().endswith(".svg") else None)
    except OSError as error:
        raise InputError(f"{output}: cannot be written ({error.strerror or error})") from error
