"""The median of values and its interval, as analysis/README.md describes it: seeds are drawn within organs."""

import math

import numpy as np

FEWEST_SEEDS = 12
RESAMPLES = 20_000
THEIR_RESAMPLES = 10_000  # the program's


def students_t(probability, degrees):
    """Where Student's t distribution has `probability`, more than half, below it: its density summed up finely."""
    x = np.linspace(0, 100, 2_000_001)
    density = (1 + x**2 / degrees) ** (-(degrees + 1) / 2)
    whole = math.exp(math.lgamma((degrees + 1) / 2) - math.lgamma(degrees / 2)) / math.sqrt(degrees * math.pi)
    below = 0.5 + whole * np.cumsum((density[1:] + density[:-1]) / 2 * (x[1] - x[0]))
    return x[1:][np.searchsorted(below, probability)]


def tail_of(degrees, known={}):
    """The part of the resamples beyond either end: as far out as t's 2.5 % are, on a normal distribution."""
    if degrees not in known:
        known[degrees] = math.erfc(students_t(0.975, degrees) / math.sqrt(2)) / 2
    return known[degrees]


def resampled_medians(values, organs, seeds):
    """The lower and the upper median of `values` in each resample, both sorted, and the tail beyond the interval's ends;
    None where seeds are too few. Of an organ's m seeds m - 1 are drawn with replacement and count m / (m - 1) each."""
    seeds_of = {organ: sorted(set(seeds[organs == organ])) for organ in sorted(set(organs))}
    several = [len(of_organ) for of_organ in seeds_of.values() if len(of_organ) > 1]
    if sum(several) < FEWEST_SEEDS:
        return None
    whole = math.lcm(*(m - 1 for m in several))  # weights as whole numbers: half of them is then exact
    generator = np.random.default_rng(1)
    weights = {}  # of an organ's seed: how much it counts in each resample
    for organ, of_organ in seeds_of.items():
        m = len(of_organ)
        drawn = generator.multinomial(m - 1, np.full(m, 1 / m), size=RESAMPLES) if m > 1 else None
        for k, seed in enumerate(of_organ):
            weights[organ, seed] = drawn[:, k] * m * (whole // (m - 1)) if m > 1 else np.full(RESAMPLES, whole)
    order = np.argsort(values, kind="stable")
    values, rows = values[order], [weights[organs[k], seeds[k]] for k in order]
    lower, upper = np.empty(RESAMPLES), np.empty(RESAMPLES)
    for first in range(0, RESAMPLES, 1000):
        part = slice(first, first + 1000)
        so_far = np.cumsum([row[part] for row in rows], axis=0)
        lower[part] = values[np.argmax(2 * so_far >= so_far[-1], axis=0)]
        upper[part] = values[np.argmax(2 * so_far > so_far[-1], axis=0)]
    return np.sort(lower), np.sort(upper), tail_of(sum(several) - len(several))


def middle(values):
    """The median. Midway between -inf and inf lies 0."""
    values = np.sort(values)
    low, high = values[(len(values) - 1) // 2], values[len(values) // 2]
    return low if low == high else 0.0 if math.isinf(low) and math.isinf(high) else (low + high) / 2


def estimate(values, organs, seeds):
    """Median and interval of `values`, and between what the ends of an interval from other draws have to lie."""
    found = {"n": len(values), "median": middle(values) if len(values) else math.nan, "low": math.nan, "high": math.nan}
    drawn = resampled_medians(values, organs, seeds)
    if drawn is None:
        return found
    lower, upper, tail = drawn
    margin = 4.5 * math.sqrt(tail * (1 - tail) * (1 / THEIR_RESAMPLES + 1 / RESAMPLES))
    ranks = [max(0, round(part * RESAMPLES)) for part in (tail - margin, tail, tail + margin)]
    found["low"], found["high"] = lower[ranks[1]], upper[-1 - ranks[1]]
    found["low_between"] = lower[max(0, ranks[0] - 1)], lower[ranks[2] + 1]
    found["high_between"] = upper[-2 - ranks[2]], upper[min(-1, -ranks[0])]
    return found
