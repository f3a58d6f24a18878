"""Compares what a file says with what the oracle answers, metric by metric.

For the oracle alone; it shares nothing with the program's judge.
"""

import json

import numpy as np

# Of a metric's steps in a case, those that the oracle may leave open because rounding decides whether a vertex counts.
OPEN_STEPS = 0.05
SAMPLED = ("tool_volume_inside_h", "tool_volume_inside_d", "tool_volume_at_rest", "recovery")  # answered at some steps only, by design
# The strategy's own count, what it would have answered to rings that begin elsewhere, and clocks: a replay tells what a
# strategy did, and there is no strategy here to be asked again.
NOT_IN_REPLAY = ("fallbacks", "order_spread", "time")


def compare_series(name, stored, answer):
    """Complaints about one series."""
    if len(stored) != len(answer.known):
        return [f"{name}: {len(stored)} values, not {len(answer.known)}"]
    wrong = []
    open_steps = np.count_nonzero(~answer.known)
    if name not in SAMPLED and open_steps > OPEN_STEPS * len(stored):
        wrong.append(f"{name}: rounding leaves {open_steps} of {len(stored)} steps open")
    missing = answer.known & (np.isnan(stored) != np.isnan(answer.low))
    with np.errstate(invalid="ignore"):
        off = answer.known & ((stored < answer.low) | (stored > answer.high))
    for step in np.flatnonzero(missing | off)[:3]:
        interval = f"{answer.low[step]:.9g} to {answer.high[step]:.9g}"
        wrong.append(f"{name}: {stored[step]:.9g} at step {step}, not {interval}")
    more = np.count_nonzero(missing | off) - 3
    return wrong + ([f"{name}: and at {more} more steps"] if more > 0 else [])


def figures(series, window):
    """Mean, maximum and last of the values that exist in the window; NaN where none does."""
    values = series[window > 0]
    values = values[~np.isnan(values)]
    if len(values) == 0:
        return {"mean": np.nan, "max": np.nan, "final": np.nan}
    return {"mean": values.mean(), "max": values.max(), "final": values[-1]}


def compare_missing(name, stored, columns, window):
    """Complaints about how many values of the window the file says are missing, whatever the reasons."""
    told = sum(json.loads(columns["missing"] or "{}").get(name, {}).values())
    missing = np.count_nonzero(np.isnan(stored[window > 0]))
    return [] if told == missing else [f"{name}: {missing} values are missing in the window, not {told} as stored"]


def compare_figures(name, stored, columns, window):
    """Complaints about a case's figures, which must be those of the stored series up to the order of a sum."""
    wrong = []
    for figure, expected in figures(stored, window).items():
        column = f"{name}_{figure}"
        if column not in columns:
            wrong.append(f"{column}: not in the file")
        elif not np.isclose(columns[column], expected, rtol=1e-12, atol=1e-15, equal_nan=True):
            wrong.append(f"{column}: {columns[column]:.17g}, not {expected:.17g}")
    return wrong
