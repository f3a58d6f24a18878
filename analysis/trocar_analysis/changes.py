"""What changed from A to B: each figure over the pairs of each group."""

from __future__ import annotations

import numpy as np
import pandas as pd

from .paired import compare_pairs
from .pairing import Pairing
from .provenance import is_time
from .subject import CASES
from .summary import groups_in_order

# Verdicts that say why there is none.
NO_TIMES, FEW_SEEDS, NO_PAIRS = "not comparable", "too few seeds", "no pairs"


def compare_groups(
    pairing: Pairing, keys: list[str], figures: list[str], better: dict[str, str]
) -> pd.DataFrame:
    """One row per figure and group: the keys, `metric`, `units`; cases of the group by where they are (`only_a`,
    `only_b`, `both`); of those in both, how many failed (`failed_a`, `failed_b`) and how many have no value
    (`no_value_a` has one in B only, `no_value_b` in A only, `no_value` in neither); what is in paired.Change, over
    `pairs` of them, in the stored unit; `comparable`, which times may not be; `verdict`."""
    rows = []
    groups = groups_in_order(pairing.inputs, keys)
    for figure in figures:
        direction = better.get(metric_of(figure), "neither")
        for values, group in groups:
            both = pairing.a.index.intersection(group.index, sort=False)
            a, b, counts = values_of(pairing, figure, both, direction)
            used = a.notna() & b.notna()
            inputs = pairing.inputs.loc[both[used]]
            columns = (a[used], b[used], inputs["organ"], inputs["seed"])
            change = compare_pairs(*(column.to_numpy() for column in columns))
            row = dict(zip(keys, values)) | {"metric": figure, "units": pairing.units.get(figure, "")}
            row |= {
                "only_a": len(group.index.intersection(pairing.only_a)),
                "only_b": len(group.index.intersection(pairing.only_b)), "both": len(both),
            }  # fmt: skip
            row |= counts | vars(change)
            times = pairing.times if is_time(figure) else ""
            row |= {"comparable": not times, "verdict": verdict(row, direction, times)}
            rows.append(row)
    return pd.DataFrame(rows)


def metric_of(figure: str) -> str:
    name = CASES.name_of(figure)
    return name.metric if name else figure


def values_of(
    pairing: Pairing, figure: str, cases: pd.Index, direction: str
) -> tuple[pd.Series, pd.Series, dict[str, int]]:
    """The figure's values in A and B, NaN where a pair cannot be compared, and how many cannot. A case that did not
    complete has the worst value there is: infinite, in the direction that is not better. Where neither is, its pair
    is left out, and counted as failed."""
    worst = {"low": np.inf, "high": -np.inf}.get(direction, np.nan)
    sides, failed = [], []
    for table in (pairing.a, pairing.b):
        rows = table.loc[cases]
        values = rows[figure].astype(float) if figure in rows else pd.Series(np.nan, index=cases)
        failed.append(rows["status"] != "complete")
        sides.append(values.mask(failed[-1], worst))
    complete = ~(failed[0] | failed[1])
    no_a, no_b = (values.isna() & complete_side for values, complete_side in zip(sides, (~failed[0], ~failed[1])))
    counts = {
        "failed_a": int(failed[0].sum()), "failed_b": int(failed[1].sum()),
        "no_value_a": int((no_a & ~no_b).sum()), "no_value_b": int((no_b & ~no_a).sum()),
        "no_value": int((no_a & no_b & complete).sum()),
    }  # fmt: skip
    return sides[0], sides[1], counts


def verdict(row: dict[str, object], direction: str, times: str) -> str:
    """A plain word on a change: what the interval says, and which way is better."""
    if times:
        return NO_TIMES
    if row["pairs"] == 0:
        return NO_PAIRS
    if row["zeros"] == row["pairs"]:
        return "equal"
    if np.isnan(row["low"]):
        return FEW_SEEDS
    if row["low"] <= 0 <= row["high"]:
        return "no clear change"
    grew = row["low"] > 0
    if direction not in ("low", "high"):
        return "more" if grew else "less"
    return "worse" if grew == (direction == "low") else "better"
