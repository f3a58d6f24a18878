"""`rules`: pictures of a rule base, from what `trocar fuzzy plot` has sampled of it: the terms of its variables, and the
weights that it infers."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.style import context

from . import palette
from .curves import apart, crossings, peak
from .errors import InputError
from .snapshot import save

WIDTH, DPI = 7.0, 200  # of a picture, inches; of a PNG
LEFT, RIGHT, BETWEEN, BELOW = 0.55, 0.12, 0.32, 0.48  # around panels, inches
TITLE_HEIGHT, LEGEND_HEIGHT, ANGLES_HEIGHT = 0.42, 0.26, 0.4
PANEL_HEIGHT, ROW_GAP = 1.55, 0.85
COLUMNS = 3  # panels in a row, at most
LETTER = 0.075  # width of one in a label, inches
LABEL_LEVEL = 0.13  # from one line of labels to the next, membership
SPOT = {"boxstyle": "circle,pad=0.15", "facecolor": palette.BACKGROUND, "edgecolor": "none"}  # below a line's number
COLLISION_INDEX = "I_C"
CORNERS = (180, 135, 90, 45, 0)  # degrees: ticks of the angle whose cosine I_C is


def draw_rules(path: str) -> str:
    """Writes memberships and response, each as .svg and .png, into the folder that the file names, which is made if
    need be; returns a line on each picture. The file is JSON: `output`, the folder; `title`, the rule base's name;
    `inputs`: `name`, `x` and `terms` (`name`, `y` over x); `outputs`: `name` and `terms` (`name`, `value`); `response`:
    `x`, values of I_C, and `passes`: `label` and, under each output's name, its values over x."""
    described = json.loads(Path(path).read_text(encoding="utf-8"))
    folder = Path(described["output"])
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be made a folder ({error.strerror or error})") from error
    pictures = {"memberships": compose_memberships, "response": compose_response}
    files = []
    with context([palette.STYLE, {"svg.fonttype": "none"}]):  # text that a reader can search and copy
        for name, compose in pictures.items():
            figure = compose(described)
            for ending in ("svg", "png"):
                files.append(str(folder / f"{name}.{ending}"))
                save(figure, files[-1])
    return "\n".join(files)


def compose_memberships(described: dict) -> Figure:
    """The paper's Fig. 2: the terms of each variable. Variables with the same terms share a panel."""
    inputs = [(draw_input, group, names_of(group)) for group in alike(described["inputs"])]
    outputs = [(draw_output, group, f"{names_of(group)} inferred") for group in alike(described["outputs"])]
    panels = inputs + outputs
    rows = -(-len(panels) // COLUMNS)
    height = TITLE_HEIGHT + ANGLES_HEIGHT + rows * PANEL_HEIGHT + (rows - 1) * ROW_GAP + BELOW
    figure = start(f"{described['title']}: membership functions", height)
    for row in range(rows):
        of_row = panels[row * COLUMNS : (row + 1) * COLUMNS]
        widths = [1.7 if is_collision_index(group) else 1.0 for _, group, _ in of_row]
        top = TITLE_HEIGHT + ANGLES_HEIGHT + row * (PANEL_HEIGHT + ROW_GAP)
        for column, (axes, (draw, group, names)) in enumerate(zip(add_row(figure, top, widths, "membership"), of_row)):
            draw(axes, group)
            axes.set_xlabel(f"({chr(ord('a') + row * COLUMNS + column)}) {names}")
    return figure


def alike(variables: list[dict]) -> list[list[dict]]:
    """The variables in groups that differ in nothing but the name, in the order of the first of each."""
    groups: dict[str, list[dict]] = {}
    for variable in variables:
        terms = {key: value for key, value in variable.items() if key != "name"}
        groups.setdefault(json.dumps(terms, sort_keys=True), []).append(variable)
    return list(groups.values())


def names_of(group: list[dict]) -> str:
    """Such as "I_P, I_S, I_E before": what follows their first words once where it is the same."""
    first, rest = zip(*(variable["name"].partition(" ")[::2] for variable in group))
    if len(set(rest)) > 1:
        return ", ".join(as_formula(variable["name"]) for variable in group)
    return f"{', '.join(map(as_formula, first))} {rest[0]}".strip()


def is_collision_index(group: list[dict]) -> bool:
    return [variable["name"] for variable in group] == [COLLISION_INDEX]


def draw_input(axes: Axes, group: list[dict]) -> None:
    x = np.array(group[0]["x"])
    terms = {term["name"]: np.array(term["y"]) for term in group[0]["terms"]}
    for number, y in enumerate(terms.values()):
        axes.plot(x, y, color=palette.series(number), linewidth=1.6, zorder=3)
    axes.set(xlim=(x[0], x[-1]), xticks=(x[0], (x[0] + x[-1]) / 2, x[-1]))
    label_terms(axes, [(name, peak(x, y)) for name, y in terms.items()])
    if is_collision_index(group):
        mark_crossings(axes, crossings(x, np.array(list(terms.values()))))
        add_angles(axes)


def draw_output(axes: Axes, group: list[dict]) -> None:
    """Its terms are constants: a line at each."""
    values = {term["name"]: term["value"] for term in group[0]["terms"]}
    low, high = min(0.0, *values.values()), max(1.0, *values.values())
    for number, value in enumerate(values.values()):
        axes.plot([value, value], [0, 1], color=palette.series(number), linewidth=1.6, clip_on=False, zorder=3)
        axes.plot([value], [1], "o", color=palette.series(number), markersize=4.5, clip_on=False, zorder=3)
    axes.set(xlim=(low, high), xticks=sorted(set(values.values())))
    label_terms(axes, list(values.items()))


def label_terms(axes: Axes, places: list[tuple[str, float]]) -> None:
    """Each term's name above x, in its line's colour; in a second line, or further up, where there is no room."""
    low, high = axes.get_xlim()
    letter = (high - low) * LETTER / (axes.get_position().width * WIDTH)
    levels: list[float] = []  # where the last label of each line of labels ends
    for number, (name, x) in sorted(enumerate(places), key=lambda item: item[1][1]):
        width = len(name) * letter
        start_x = min(max(x - width / 2, low), high - width)
        level = next((k for k, end in enumerate(levels) if end + letter < start_x), len(levels))
        levels[level : level + 1] = [start_x + width]
        axes.annotate(name, (start_x + width / 2, 1.05 + LABEL_LEVEL * level), color=palette.series(number),
                      ha="center", va="bottom", fontsize=8, annotation_clip=False)  # fmt: skip
    axes.set_ylim(0, 1.05 + LABEL_LEVEL * len(levels))


def mark_crossings(axes: Axes, points: list[tuple[float, float]]) -> None:
    """Where neighbouring terms weigh the same; ε where that is at ∓ε."""
    low, high = axes.get_xlim()
    others = [x for x in axes.get_xticks() if all(abs(x - at) > 0.08 * (high - low) for at, _ in points)]
    axes.set_xticks(sorted([*others, *(x for x, _ in points)]))
    sizes = [abs(x) for x, _ in points]
    is_threshold = len(points) == 2 and points[0][0] < 0 < points[1][0] and max(sizes) - min(sizes) < 1e-3
    for x, y in points:
        axes.plot([x, x], [0, y], color=palette.INK, linewidth=0.8, linestyle=(0, (2, 2)), zorder=2)
        axes.plot([x], [y], "o", color=palette.INK, markersize=3.5, zorder=4)
        if is_threshold:
            axes.annotate("ε" if x > 0 else "−ε", (x, y), (0, 13), textcoords="offset points", ha="center")


def plain_number(value: float) -> str:
    """Four decimals at most."""
    return f"{value:.4f}".rstrip("0").rstrip(".").replace("-", "−")


def add_angles(axes: Axes) -> None:
    """An axis on top: the angle between motion and normal."""
    low, high = axes.get_xlim()
    top = axes.twiny()
    top.set(xlim=(low, high))
    shown = [angle for angle in CORNERS if low - 1e-9 <= np.cos(np.radians(angle)) <= high + 1e-9]
    top.set_xticks([np.cos(np.radians(angle)) for angle in shown], [f"{angle}°" for angle in shown])
    top.set_xlabel("angle between motion and facet normal", labelpad=5)
    plain(top)


def compose_response(described: dict) -> Figure:
    """What the rule base makes of I_C: a panel per weight, a line per pass."""
    x, passes = np.array(described["response"]["x"]), described["response"]["passes"]
    names = [output["name"] for output in described["outputs"]]
    above = TITLE_HEIGHT + LEGEND_HEIGHT
    figure = start(f"{described['title']}: weights inferred", above + PANEL_HEIGHT + BELOW)
    for axes, name in zip(add_row(figure, above, [1.0] * len(names), "weight"), names):
        lines = np.array([one[name] for one in passes])
        for k, y in enumerate(lines):
            axes.plot(x, y, color=palette.series(k), linestyle=palette.dashes(k), linewidth=1.6, zorder=3)
        low, high = min(0.0, lines.min()), max(1.0, lines.max())
        axes.set(xlim=(x[0], x[-1]), ylim=(low, high + 0.08 * (high - low)), xlabel=as_formula(COLLISION_INDEX))
        axes.annotate(as_formula(name), (0, 1), (2, 4), "axes fraction", "offset points", fontsize=10)
        number_lines(axes, x, lines)
    handles = [
        Line2D([], [], color=palette.series(k), linestyle=palette.dashes(k), linewidth=1.6) for k in range(len(passes))
    ]
    labels = [f"{k + 1}  {one['label']}" for k, one in enumerate(passes)]
    height = figure.get_figheight()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(LEFT / WIDTH, 1 - (TITLE_HEIGHT - 0.07) / height),
                  ncols=len(passes), frameon=False, borderaxespad=0, borderpad=0, handlelength=2.6,
                  columnspacing=1.2)  # fmt: skip
    return figure


def number_lines(axes: Axes, x: np.ndarray, lines: np.ndarray) -> None:
    """The legend's number on each line, where it is furthest from the others; not on one that no place tells apart."""
    for k, place in enumerate(apart(lines)):
        if place is not None:
            axes.annotate(str(k + 1), (x[place], lines[k][place]), color=palette.series(k), fontsize=8,
                          fontweight="bold", ha="center", va="center", zorder=5, bbox=SPOT)  # fmt: skip


def start(title: str, height: float) -> Figure:
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    figure.text(LEFT / WIDTH, 1 - 0.5 * TITLE_HEIGHT / height, title, va="center", fontsize=11, fontweight="bold")
    return figure


def add_row(figure: Figure, top: float, widths: list[float], upright: str) -> list[Axes]:
    """Panels side by side, `top` inches below the figure's upper edge, as wide as `widths` are to each other. `upright`:
    what the first one's axis says."""
    height = figure.get_figheight()
    unit = (WIDTH - LEFT - RIGHT - BETWEEN * (len(widths) - 1)) / sum(widths)
    row, left = [], LEFT
    for width in widths:
        bottom = height - top - PANEL_HEIGHT
        axes = figure.add_axes(
            (left / WIDTH, bottom / height, unit * width / WIDTH, PANEL_HEIGHT / height), facecolor=palette.BACKGROUND
        )
        axes.set_yticks([0, 0.5, 1], [""] * 3 if row else ["0", "0.5", "1"])
        axes.xaxis.set_major_formatter(lambda value, _: plain_number(value))
        axes.grid(axis="y", color="white", linewidth=1)
        plain(axes)
        if row:
            axes.tick_params(axis="y", length=0)
        else:
            axes.set_ylabel(upright)
        row.append(axes)
        left += unit * width + BETWEEN
    return row


def plain(axes: Axes) -> None:
    axes.spines[:].set_visible(False)
    axes.set_axisbelow(True)
    axes.tick_params(length=3, color=palette.FAINT_INK, labelcolor=palette.FAINT_INK, labelsize=8)
    for axis in (axes.xaxis, axes.yaxis):
        axis.label.set(color=palette.INK, fontsize=9)


def as_formula(name: str) -> str:
    """I_P with its subscript."""
    return re.sub(r"\b([A-Za-z])_(\w+)", r"$\1_{\2}$", name)
