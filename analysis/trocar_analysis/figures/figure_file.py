"""Reads the description of a figure, such as analysis/figures/fig5.toml, and checks it. analysis/figures/README.md says
what its keys mean."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import InputError, unknown
from ..store import MOMENTS
from ..toml_file import read_toml

SURFACES = ("solid", "wire")
VECTORS = ("none", "all", "crossing")  # of displacement: not drawn; drawn; drawn, and told apart by whether they cross


@dataclass(frozen=True)
class ViewRule:
    """How a panel is seen. Lengths in mm, angles in degrees."""

    width: float  # of what a panel shows
    height: float
    elevation: float  # of the eye over the plane across the tool's axis
    turn: float  # of the eye about the tool's axis, from where `snapshot` looks from
    rise: float  # of the picture's centre over the tool's tip, along the tool's axis


@dataclass(frozen=True)
class Panel:
    """One picture: a step of a case, seen in one way."""

    letter: str
    title: str
    where: dict[str, object]  # column or option → value: they leave one case with a replay
    step: str | int  # a rule of steps.py, or a number
    moment: str  # "found", "handled" or "deformed"
    surface: str  # one of SURFACES
    vectors: str  # one of VECTORS
    state_of: str  # letter of the panel that has the same organ before handling, or ""
    facts: dict[str, str]  # series → words behind its value in this step


@dataclass(frozen=True)
class FigureFile:
    title: str
    caption: str
    columns: int
    view: ViewRule
    panels: tuple[Panel, ...]


FIGURE_KEYS = {"title", "caption", "columns", "view", "panel", "every_panel"}
PANEL_KEYS = set(Panel.__dataclass_fields__)
VIEW_KEYS = set(ViewRule.__dataclass_fields__)
OPTIONAL = {"step": "arrived", "moment": "deformed", "surface": "solid", "vectors": "none", "state_of": "", "facts": {}}
TYPES = {"letter": str, "title": str, "where": dict, "step": (str, int), "facts": dict, "state_of": str, "caption": str,
         "columns": int, "view": dict, "panel": list, "every_panel": dict}  # fmt: skip
KIND_WORDS = {str: "a text", dict: "a table", int: "a whole number", list: "[[panel]]", (str, int): "a rule, or a number"}
CHOICES = {"moment": MOMENTS, "surface": SURFACES, "vectors": VECTORS}


def read_figure(path: str) -> FigureFile:
    content = read_toml(path, "the description of a figure")
    try:
        return figure_of(content)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error


def figure_of(content: dict) -> FigureFile:
    content = {"every_panel": {}} | content
    check("the figure", content, FIGURE_KEYS, FIGURE_KEYS)
    check("[view]", content["view"], VIEW_KEYS, VIEW_KEYS)
    for key, value in content["view"].items():
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise InputError(f"[view]: {key} is {value!r}; expected a number")
    if min(content["view"]["width"], content["view"]["height"]) <= 0 or content["columns"] < 1:
        raise InputError("width, height and columns of a figure are greater than 0")
    panels = tuple(panel_of(number, content["every_panel"] | panel) for number, panel in enumerate(content["panel"], 1))
    if not panels:
        raise InputError("has no [[panel]]")
    letters = [panel.letter for panel in panels]
    for number, panel in enumerate(panels):
        if panel.letter in letters[:number]:
            raise InputError(f"has panel {panel.letter} twice")
        if panel.state_of and panel.state_of not in letters:
            raise InputError(f"panel {panel.letter}: {unknown('panel', panel.state_of, letters)}")
    view = ViewRule(**{key: float(value) for key, value in content["view"].items()})
    return FigureFile(content["title"], content["caption"], content["columns"], view, panels)


def panel_of(number: int, table: dict) -> Panel:
    name = f"panel {table.get('letter', number)}"
    table = OPTIONAL | table
    check(name, table, PANEL_KEYS, PANEL_KEYS)
    for key, choices in CHOICES.items():
        if table[key] not in choices:
            raise InputError(f"{name}: {key} is {table[key]!r}; expected {' or '.join(choices)}")
    return Panel(**table)


def check(what: str, table: dict, known: set[str], needed: set[str]) -> None:
    """That the keys are known ones, none is missing, and each value is of its kind."""
    for key, value in table.items():
        if key not in known:
            raise InputError(f"{what}: {unknown('key', key, known)}")
        if not isinstance(value, TYPES.get(key, object)):
            raise InputError(f"{what}: {key} is {value!r}; expected {KIND_WORDS[TYPES[key]]}")
    for key in sorted(needed - set(table)):
        raise InputError(f"{what}: lacks {key}")


