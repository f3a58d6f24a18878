"""What the metrics of a file are, in words: the page's glossary."""

from __future__ import annotations

import pandas as pd

from ..store import INPUTS, OUTCOME, ResultFile
from ..subject import CASES

# What the file adds to a metric's words to say when it is taken; the page says it beside the figures.
MOMENTS = (", after handling", ", after deformation", ", as the step found the organ", ", after the last step")


def glossary(file: ResultFile, table: pd.DataFrame, better: dict[str, str]) -> list[dict]:
    """Each metric with its unit, which way is better ("" where the program does not say), and its columns."""
    units, words = file.units(), file.long_names()
    metrics: dict[str, dict] = {}
    for column in table:
        if column in (*INPUTS, *OUTCOME):
            continue
        name = CASES.name_of(column)
        metric = name.metric if name else column
        entry = metrics.setdefault(metric, {
            "metric": metric, "unit": units.get(column, ""), "better": better.get(metric, ""),
            "words": metric_words(words.get(column, "")), "columns": [],
        })  # fmt: skip
        entry["columns"].append(column)
    return [*metrics.values()]


def metric_words(said: str) -> str:
    """What a column is, without its figure and moment."""
    words, _, figure = said.rpartition(": ")
    if figure.endswith("over the window") or figure.endswith("in the window"):
        said = words
    for moment in MOMENTS:
        said = said.removesuffix(moment)
    return said
