"""The verdicts on the paper's claims once more, on another path: each claim written out by hand, as experiments/claims.toml and
results/README.md state it, with h5py, pandas and numpy alone. To be read from top to bottom, as a notebook.

/usr/bin/python3 claims_again.py OUT.h5 [--only C1,C7] [--against VERDICTS.json]

Prints what each condition comes to. With --against, what `trocar reproduce --json` printed of the same file, it compares: medians
to 1e-9, verdicts to the word, counts to the unit, intervals within what two sets of random draws may differ by. Exit code 1 where
anything differs.
"""

import json
import math
import sys

import h5py
import numpy as np
import pandas as pd

THREE_ORGANS = ["sphere@4mm", "gallbladder@2mm", "liver@4mm"]  # of penetration.toml, sliding.toml and grasper.toml
CLEFTS = ["cleft@3mm", "cleft@4mm", "cleft@6mm"]
EVERY_ORGAN = ["sheet@4mm", "rough-sheet@4mm", "sphere@4mm", "tube@4mm", "gallbladder@2mm", "liver@4mm", "cleft@4mm"]
EVERY_STRATEGY = ["fuzzy-per-vertex", "nearest-face", "cylinder-axis", "average-plane", "joint-vertex", "tool-facet"]
SLOW, MODERATE, RAPID = 20, 100, 400  # mm/s
SPEEDS = [SLOW, MODERATE, RAPID]

FEWEST_SEEDS = 12
RESAMPLES = 20_000
THEIR_RESAMPLES = 10_000  # the program's


# ---- Reading the file


def read_table(file, name):
    columns = file[name].items()
    return pd.DataFrame({key: v.asstr()[:] if h5py.check_string_dtype(v.dtype) else v[:] for key, v in columns})


def failed_are_worst(table, failed):
    """Every figure of a case that did not complete is the worst there is. Of those used here high is better for the ratio of
    edges alone. What figures are divided by is neither good nor bad: 1, so that the worst stays the worst."""
    for column in table.select_dtypes("float"):
        if column.startswith("edge_ratio_mean"):
            table.loc[failed, column] = -math.inf
        elif column.startswith(("collided_vertices", "tool_volume_at_rest")):
            table.loc[failed, column] = 1.0
        elif column not in ("speed", "rate"):
            table.loc[failed, column] = math.inf


def read_results(path):
    """`runs`, a row a case, and `answers`, a row for each state and strategy that answered to it. In answers `label` is whose
    the answer is, `run_label` in whose run the state was found."""
    with h5py.File(path) as file:
        runs, answers = read_table(file, "cases"), read_table(file, "states")
    failed_are_worst(runs, runs.status != "complete")
    if len(answers):
        of_run = runs[["case_id", "label", "scene", "organ", "tool", "speed", "seed", "release"]]
        answers = answers.merge(of_run.rename(columns={"label": "run_label"}), on="case_id")
        failed_are_worst(answers, answers.reason != "")
    return runs, answers


# ---- The interval of a median: seeds are drawn within organs


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
    """The lower and the upper median of `values` in each resample, both sorted, and the tail beyond the interval's ends; None
    where seeds are too few. Of an organ's m seeds m - 1 are drawn with replacement and count m / (m - 1) each."""
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


# ---- A condition: median and interval lie on one side of what they are compared with. Too few seeds never do.


def lies(found, side, limit):
    ends = np.array([found["low"], found["median"], found["high"]])
    on_side = {"<": ends < limit, "<=": ends <= limit, ">": ends > limit, ">=": ends >= limit}[side]
    return bool(on_side.all())  # NaN, where there is no interval, lies on no side


judged = []  # a row for each condition, value of `each` and release


def judge(claim, condition, release, each, cases, values, side=None, limit=0.0):
    """`values` of `cases`, a table that says which organ and seed each is of. No `side`: described."""
    values = np.asarray(values, float)
    exists = ~np.isnan(values)
    of_organ, of_seed = cases.organ.to_numpy()[exists], cases.seed.to_numpy()[exists]
    found = estimate(values[exists], of_organ, of_seed)
    found |= {"claim": claim, "condition": condition, "release": release, "each": each, "missing": int((~exists).sum())}
    judged.append(found | {"holds": lies(found, side, limit) if side else None})


def side_by_side(of, than, keys):
    """Rows of two tables that agree in `keys`; columns of the second end in _than."""
    return of.merge(than, on=keys, suffixes=("", "_than"), validate="one_to_one")


def excess(a, b, times=1.0):
    """a - times * b; two that are infinite alike do not differ."""
    a, b = a.to_numpy(), times * b.to_numpy()
    with np.errstate(invalid="ignore"):
        return np.where(a == b, 0.0, a - b)


SAME_RUN = ["scene", "organ", "tool", "speed", "seed"]  # what runs that differ in the strategy have in common
SAME_STATE = ["case_id", "step"]


# ---- The claims


def judge_claims(runs, answers, release):
    runs = runs[runs.release == release]
    prism, three = runs[runs.tool == "prism-12"], runs.organ.isin(THREE_ORGANS)
    penetration = prism[(prism.scene == "penetration") & three]
    sliding = prism[(prism.scene == "sliding") & three]
    cutting = prism[(prism.scene == "cutting") & runs.organ.isin(CLEFTS)]

    # C1 and C2: fuzzy leaves no interpenetration, going in and sliding along.
    for claim, motion in (("C1", penetration), ("C2", sliding)):
        for speed in (SLOW, MODERATE):
            fuzzy = motion[(motion.label == "fuzzy-per-vertex") & (motion.speed == speed)]
            judge(claim, 1, release, {"speed": speed}, fuzzy, fuzzy.depth_max_d_max, "<=", 0.5)
            part = fuzzy.tool_volume_inside_d_max / fuzzy.tool_volume_at_rest_max
            judge(claim, 2, release, {"speed": speed}, fuzzy, part, "<=", 0.05)

    # C4, second condition: joint displacement strains more.
    for scene, motion in (("penetration", penetration), ("sliding", sliding)):
        for speed in SPEEDS:
            at_speed = motion[motion.speed == speed]
            joint, fuzzy = (at_speed[at_speed.label == label] for label in ("joint-vertex", "fuzzy-per-vertex"))
            both = side_by_side(joint, fuzzy, SAME_RUN)
            more = excess(both.strain_mean, both.strain_mean_than)
            judge("C4", 2, release, {"scene": scene, "speed": speed}, both, more, ">")

    # C5: joint displacement takes vertices through the tool, fuzzy fewer.
    for speed in SPEEDS:
        at_speed = cutting[cutting.speed == speed]
        joint, fuzzy = (at_speed[at_speed.label == label] for label in ("joint-vertex", "fuzzy-per-vertex"))
        judge("C5", 1, release, {"speed": speed}, joint, joint.tool_crossings_mean, ">", 0)
        both = side_by_side(fuzzy, joint, SAME_RUN)
        judge("C5", 2, release, {"speed": speed}, both, excess(both.tool_crossings_mean, both.tool_crossings_mean_than), "<")

    # C6 and C7: nearest-face goes in slowly as well as fuzzy, rapidly far worse than either.
    volume, volume_than = "tool_volume_inside_d_max", "tool_volume_inside_d_max_than"
    nearest, fuzzy = (penetration[penetration.label == label] for label in ("nearest-face", "fuzzy-per-vertex"))
    both = side_by_side(nearest[nearest.speed == SLOW], fuzzy[fuzzy.speed == SLOW], SAME_RUN)
    judge("C6", 1, release, {}, both, excess(both[volume], both[volume_than], 1.25), "<=")
    both = side_by_side(nearest[nearest.speed == RAPID], nearest[nearest.speed == SLOW], ["organ", "seed"])
    judge("C7", 1, release, {}, both, excess(both[volume], both[volume_than], 3), ">")
    both = side_by_side(nearest[nearest.speed == RAPID], fuzzy[fuzzy.speed == RAPID], SAME_RUN)
    judge("C7", 2, release, {}, both, excess(both[volume], both[volume_than], 2), ">")

    # C12: real time, for every strategy on every organ.
    here = prism[(prism.scene == "penetration") & (prism.speed == MODERATE)]
    for label in EVERY_STRATEGY:
        for organ in EVERY_ORGAN:
            cases = here[(here.label == label) & (here.organ == organ)]
            judge("C12", 1, release, {"label": label, "organ": organ}, cases, cases.time_cycle_p99, "<=", 25e6)

    # C13: described, what remains with fuzzy.
    for scene, motion in (("penetration", penetration), ("sliding", sliding)):
        for speed in SPEEDS:
            fuzzy = motion[(motion.label == "fuzzy-per-vertex") & (motion.speed == speed)]
            judge("C13", 1, release, {"scene": scene, "speed": speed}, fuzzy, fuzzy.displacement_crossings_mean)
            judge("C13", 2, release, {"scene": scene, "speed": speed}, fuzzy, fuzzy.facets_crossing_d_mean)

    if not len(answers):
        return
    answers = answers[answers.release == release]
    three = answers[answers.organ.isin(THREE_ORGANS)]
    prism = three[three.tool == "prism-12"]

    def same_states(cases, one, other):
        return side_by_side(cases[cases.label == one], cases[cases.label == other], SAME_STATE)

    for speed in SPEEDS:
        # C3: sliding treated as penetration pulls vertices together.
        here = prism[(prism.scene == "sliding") & (prism.speed == speed)]
        both = same_states(here, "fuzzy, always penetration", "fuzzy-per-vertex")
        judge("C3", 1, release, {"speed": speed}, both, excess(both.edge_ratio_mean_h, both.edge_ratio_mean_h_than), "<")
        judge("C3", 2, release, {"speed": speed}, both, excess(both.drag, both.drag_than), ">")

        # C4, first condition: joint displacement moves vertices further.
        for scene in ("penetration", "sliding"):
            here = prism[(prism.scene == scene) & (prism.speed == speed)]
            both = same_states(here, "joint-vertex", "fuzzy-per-vertex")
            further = excess(both.displacement_mean, both.displacement_mean_than)
            judge("C4", 1, release, {"scene": scene, "speed": speed}, both, further, ">")

        # C8: with tool-facet displacement vectors cross.
        for tool in ("prism-12", "grasper"):
            here = three[(three.scene == "penetration") & (three.tool == tool) & (three.speed == speed)]
            both = same_states(here, "tool-facet", "fuzzy-per-vertex")
            a = both.displacement_crossings / both.collided_vertices
            b = both.displacement_crossings_than / both.collided_vertices_than
            judge("C8", 1, release, {"tool": tool, "speed": speed}, both, excess(a, b), ">")

        # C10: the average plane leaves facets across the tool.
        here = prism[(prism.scene == "penetration") & (prism.speed == speed)]
        both = same_states(here, "average-plane", "fuzzy-per-vertex")
        a = both.facets_crossing_h / both.collided_vertices
        b = both.facets_crossing_h_than / both.collided_vertices_than
        judge("C10", 1, release, {"speed": speed}, both, excess(a, b), ">")

        # C9: on a rough sheet facets cross, on a flat one less. The states of the two are not the same, so that what is
        # paired is a run's mean over its states.
        for label in ("cylinder-axis", "average-plane"):
            here = answers[(answers.tool == "prism-12") & (answers.scene == "penetration") & (answers.speed == speed)]
            here = here[here.label == label]
            here = here.assign(crossed=(here.flipped_facets + here.self_crossings_h) / here.collided_vertices)
            of_run = here.groupby(["organ", "run_label", "seed"], as_index=False).crossed.mean()
            rough, flat = (of_run[of_run.organ == organ] for organ in ("rough-sheet@4mm", "sheet@4mm"))
            both = side_by_side(rough, flat, ["run_label", "seed"])
            judge("C9", 1, release, {"label": label, "speed": speed}, both, excess(both.crossed, both.crossed_than), ">")
