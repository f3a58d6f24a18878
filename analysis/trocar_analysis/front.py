"""`front`: what two figures can be had together: each strategy's medians of both, and the Pareto front: those that no
other one beats in both, as a table; front_plot.py draws them."""

from __future__ import annotations

from dataclasses import dataclass, field

import pandas as pd

from .case_figures import Cases, Figure, judged_figure, pooled_words, read_cases
from .equal_conditions import conditions_in, equal_conditions
from .errors import InputError
from .pareto import pareto_front
from .rank import BETTER, median_column, plain
from .ranks import order_of
from .table import Column, aligned, markdown

FEWEST_STRATEGIES = 2
ENDS = ["median", "low", "high"]


@dataclass(frozen=True)
class Wishes:
    """What a user asks of `front`."""

    metric: str  # a column, or a quotient "a/b" of two
    against: str  # another one
    only: list[str] = field(default_factory=list)  # filters "key=value" (see only_rows)
    better: dict[str, str] = field(default_factory=dict)  # metric → "low", "high"


@dataclass(frozen=True)
class Front:
    """What is drawn and tabulated."""

    figure: Figure  # along y
    against: Figure  # along x
    points: pd.DataFrame  # one row per strategy, see points_of
    only: list[str]  # what the cases were chosen by
    notes: list[str]  # what the points are, and what was left out
    cautions: list[str]  # what to say of times


def read_front(path: str, asked: Wishes) -> Front:
    """The strategies of a result file by two figures. InputError for a figure of which neither way is better, and where
    no condition has a value of both for each strategy."""
    return front_of(read_cases(path, asked.only), asked)


def front_of(cases: Cases, asked: Wishes) -> Front:
    """As read_front, of cases that have been read, by `asked.only`."""
    figure, against = (judged_figure(name, cases, asked.better) for name in (asked.metric, asked.against))
    if figure.name == against.name:
        raise InputError(f"--metric and --against are both {figure.name}; a front is of two figures")
    equal = equal_conditions(cases, [figure, against], FEWEST_STRATEGIES)
    points = points_of(figure, equal.medians(figure), against, equal.medians(against))
    n, pooled = equal.conditions, pooled_words(equal.used, conditions_in(equal.used))
    said = [
        f"A point is a strategy's medians over n = {n} cases" + (f" ({pooled})" if pooled else "")
        + ("; too few seeds for intervals." if points["low"].isna().all()
           else ", its bars their 95 % bootstrap intervals, seeds drawn within organs."),
        "On the front: no other strategy is as good in both figures and better in one, by the medians.",
    ]  # fmt: skip
    if failed := points["failed"].sum():
        said.append(f"{failed} of {points['cases'].sum()} cases failed: × marks a strategy with some of them; a failed "
                    "case counts as the worst value there is, at the panel's edge.")  # fmt: skip
    cautions = cases.cautions([figure, against], equal.used.index)
    return Front(figure, against, points, asked.only, said + equal.notes, cautions)


def points_of(figure: Figure, medians: pd.DataFrame, against: Figure, others: pd.DataFrame) -> pd.DataFrame:
    """EqualConditions.medians of the one figure, and of the other one as `against_median`, `against_low` and
    `against_high`; `on_front`. Those on the front are first, in its order from what is best in the figure along x."""
    points = medians.join(others[ENDS].add_prefix("against_"))
    first, second = (
        order_of((values if way == "low" else -values).to_numpy(float))
        for values, way in ((points["median"], figure.better), (points["against_median"], against.better))
    )
    points = points.assign(on_front=pareto_front(first, second), first=first, second=second)
    ordered = points.sort_values(["on_front", "second", "first"], ascending=[False, True, True], kind="stable")
    return ordered.drop(columns=["first", "second"]).reset_index(drop=True)


def csv_text(front: Front) -> str:
    """One row per strategy, in full precision and the stored unit, quotients in percent."""
    one, other = front.figure, front.against
    said = {"metric": one.name, "units": one.unit, "better": one.better}
    said |= {"against": other.name, "against_units": other.unit, "against_better": other.better}
    ends = [f"against_{name}" for name in ENDS]
    columns = ["label", *[*said][:3], *ENDS, *[*said][3:], *ends, "cases", "failed", "on_front"]
    return front.points.assign(**said)[columns].to_csv(index=False)


def markdown_text(front: Front) -> str:
    return markdown(columns_of(front)) + "\n" + "".join(f"- {note}\n" for note in notes(front))


def plain_text(front: Front) -> str:
    return "\n".join([*aligned(columns_of(front), with_quartiles=True), "", *notes(front), ""])


def notes(front: Front) -> list[str]:
    """What is said below the table."""
    ways = "; ".join(f"{figure.name}: {BETTER[figure.better]}" for figure in (front.figure, front.against))
    return [f"{ways}.", *front.notes, *front.cautions]


def columns_of(front: Front) -> list[Column]:
    points = front.points
    others = points[[f"against_{name}" for name in ENDS]].set_axis(ENDS, axis=1)
    return [
        Column(("strategy", ""), "", True, plain(points["label"])),
        median_column(front.figure, points),
        median_column(front.against, others),
        Column(("failed", ""), "", False, plain(points["failed"])),
        Column(("on the front", ""), "", True, plain("yes" if on else "no" for on in points["on_front"])),
    ]
