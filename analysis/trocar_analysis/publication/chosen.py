"""Which figures the folder has, and over which conditions."""

from __future__ import annotations

from dataclasses import replace

import pandas as pd

from ..case_figures import Cases, Figure
from ..errors import InputError
from ..report.main_figures import TIME, main_figures
from ..sensitivity import SWEPT, Wishes, along_with, choose
from ..subject import tally

AGAINST = ("strain_max", TIME.name)  # what the first figure's fronts are against, where none are asked for


def figures_of(cases: Cases, metrics: list[str] | None, better: dict[str, str]) -> list[Figure]:
    """Those that are asked for, else the report's. InputError where no case has a value of any."""
    table, path = cases.table, cases.path
    complete = table[table["status"] == "complete"]
    if complete.empty:
        how = tally(table["status"].value_counts().to_dict())
        raise InputError(
            f"{path}: none of its {len(table)} cases completed ({how}): there are no figures to draw; see trocar show "
            "--failures"
        )
    main = {one.name: one.title for one in main_figures(complete)}
    names = metrics or [*main]
    if not names:
        raise InputError(f"{path}: has none of the main figures; name one with --metric")
    chosen = choose(path, table, Wishes("", names, better=better), cases.units)
    if not any(has_value(figure, complete) for figure in chosen):
        why = "; ".join(figure.lacking for figure in chosen)
        raise InputError(f"{path}: no complete case has a value of what is asked for: {why}")
    return [replace(figure, title=main.get(figure.name, figure.title)) for figure in chosen]


def has_value(figure: Figure, complete: pd.DataFrame) -> bool:
    return bool(figure.values.loc[complete.index].notna().any())


def words_of(figure: Figure, cases: Cases) -> str:
    """What a figure is, as the file says it."""
    column, _, divisor = figure.name.partition("/")
    said = cases.words.get(column, "")
    return f"{said}; as part of {divisor}: {cases.words.get(divisor, '')}" if divisor and said else said


def conditions_that_vary(table: pd.DataFrame) -> list[str]:
    """Over which a figure is drawn. Of those that go together, one: of organs their facets if they are one shape, else
    their names."""
    several = [name for name in SWEPT if name in table and table[name].nunique() > 1]
    is_one_shape = table["organ"].str.partition("@")[0].nunique() == 1
    several = [name for name in several if name != ("organ" if is_one_shape else "organ_facets") or
               (name == "organ" and "organ_facets" not in several)]  # fmt: skip
    kept: list[str] = []
    for name in several:
        if not any(name in along_with(table, other, set()) and other in along_with(table, name, set()) for other in kept):
            kept.append(name)
    return kept
