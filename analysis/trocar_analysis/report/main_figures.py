"""The figures that the overview compares strategies by."""

from __future__ import annotations

from dataclasses import dataclass

import pandas as pd


@dataclass(frozen=True)
class MainFigure:
    name: str  # a column, or a quotient of two
    title: str
    short: str  # heads a column of the overview's table


# The first that a file has is what strategies are ranked by. Where the organ is open the tool has no volume in it.
LEFT_INSIDE = (
    MainFigure(
        "tool_volume_inside_d_max/tool_volume_at_rest_max",
        "Tool left inside the organ, of the volume there is to clear", "left inside",
    ),
    MainFigure("depth_max_d_max", "Deepest vertex of the organ left inside the tool", "depth left"),
    MainFigure("facets_crossing_d_mean", "Organ facets that cross the tool's surface", "facets crossing"),
)  # fmt: skip
TIME = MainFigure("time_handle_p99", "Time of handling: 99 % of a case's steps take less", "handling, 99 %")
COSTS = (
    MainFigure("displacement_mean_mean", "How far handling moves a collided vertex", "displacement"),
    MainFigure("drag_mean", "How far handling drags vertices along with the tool", "drag"),
    MainFigure("strain_max", "Strain of the edges near the tool", "strain"),
    TIME,
    MainFigure("time_cycle_p50", "Time of a cycle: half of a case's steps take less", "cycle, median"),
)


def main_figures(table: pd.DataFrame) -> list[MainFigure]:
    """Those whose columns the table has, with a value in some complete case."""
    complete = table[table["status"] == "complete"] if (table["status"] == "complete").any() else table
    return [one for one in (*LEFT_INSIDE, *COSTS) if has(table, complete, one)]


def has(table: pd.DataFrame, complete: pd.DataFrame, figure: MainFigure) -> bool:
    parts = figure.name.split("/")
    return all(part in table and complete[part].notna().any() for part in parts) or (
        all(part in table for part in parts) and (complete["status"] != "complete").all()
    )
