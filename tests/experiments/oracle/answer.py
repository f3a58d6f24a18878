"""What the oracle answers for one metric: an interval for every step.

The replay holds positions in float32 and the program judged them in float64, so a decision that lies within that
rounding may have gone either way. An answer is therefore the least and the largest value that the program may store.
It shares nothing with the program's judge.
"""

from dataclasses import dataclass

import numpy as np

# A coordinate below 128 mm in float32 is off by at most 3.8e-6 mm, a vertex by 6.6e-6 mm, the tool's place by as much
# again, its turn (6e-8 of at most 80 mm) by 5e-6 mm.
ROUNDING = 2e-5  # mm


@dataclass
class Answer:
    """Least and largest value a step, both NaN where there is none; steps that are not `known` are not compared."""

    low: np.ndarray
    high: np.ndarray
    known: np.ndarray

    @classmethod
    def unknown(cls, steps):
        return cls(np.full(steps, np.nan), np.full(steps, np.nan), np.zeros(steps, bool))

    def set(self, step, low, high):
        self.low[step], self.high[step], self.known[step] = low, high, True

    def set_value(self, step, value, tolerance):
        self.set(step, value - tolerance, value + tolerance)

    def set_count(self, step, verdicts):
        """Counts verdicts of 1 (certain), 0 (within rounding), −1 (certainly not)."""
        self.set(step, np.sum(verdicts > 0), np.sum(verdicts >= 0))

    def set_missing(self, step):
        self.set(step, np.nan, np.nan)


class Answers(dict):
    """Answers by the name of the series; an unheard-of name starts out unknown at every step."""

    def __init__(self, steps):
        super().__init__()
        self.steps = steps

    def __missing__(self, name):
        self[name] = Answer.unknown(self.steps)
        return self[name]
