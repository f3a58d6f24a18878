"""`figure`: the panels that a file describes, drawn from the replays of a result file."""

from __future__ import annotations

from pathlib import Path

from matplotlib.style import context

from .. import palette
from ..errors import InputError
from ..options import option_columns
from ..snapshot import save, with_replay
from ..store import ResultFile
from .figure_file import read_figure
from .page import compose
from .shown import Shown, check_same_state, conditions, differing, facts, find_step
from .small_file import shrink


def draw_figure(path: str, description: str, output: str) -> str:
    """Writes the picture to `output` and returns a line on each panel."""
    if Path(output).suffix.lower() not in (".png", ".svg"):
        raise InputError(f"{output}: a picture's name ends in .png or .svg")
    wanted = read_figure(description)
    shown: dict[str, Shown] = {}
    with ResultFile(path) as results:
        cases = with_replay(results, results.cases_table())
        cases = cases.join(option_columns(cases, path))
        for panel in wanted.panels:
            try:
                shown[panel.letter] = find_step(results, cases, panel)
            except InputError as error:
                raise InputError(f"{description}: panel {panel.letter}: {error}") from error
    for one in shown.values():
        if one.panel.state_of:
            check_same_state(description, one, shown[one.panel.state_of])
    with context(palette.STYLE):
        save(compose(wanted, list(shown.values())), output)
    shrink(output)
    differ = differing(list(shown.values()))
    return "\n".join([f"{output}:", *(f"{letter}) {in_words(one, differ)}" for letter, one in shown.items())])


def in_words(one: Shown, differ: list[str]) -> str:
    return " · ".join([str(one.case["label"]), *conditions(one.case, differ), f"step {one.number}", *facts(one)])
