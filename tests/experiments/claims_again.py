"""The verdicts on the paper's claims once more, on another path: each claim written out by hand, as
experiments/claims.toml and results/README.md state it, with h5py, pandas and numpy alone. To be read from top to bottom,
as a notebook.

/usr/bin/python3 claims_again.py OUT.h5 [--turns OUT.turns.csv] [--against VERDICTS.json]

Prints what each condition comes to. With --against, what `trocar reproduce --json` printed of the same file, it compares:
medians to 1e-9, verdicts to the word, counts to the unit, intervals within what two sets of random draws may differ by.
Exit code 1 where anything differs.
"""

import argparse
import math
import sys

import h5py
import numpy as np
import pandas as pd

from again.against import compare
from again.interval import estimate

THREE_ORGANS = ["sphere@4mm", "gallbladder@2mm", "liver@4mm"]  # of penetration.toml, sliding.toml and grasper.toml
CLEFTS = ["cleft@3mm", "cleft@4mm", "cleft@6mm"]
EVERY_ORGAN = ["sheet@4mm", "rough-sheet@4mm", "sphere@4mm", "tube@4mm", "gallbladder@2mm", "liver@4mm", "cleft@4mm"]
EVERY_STRATEGY = ["fuzzy-per-vertex", "nearest-face", "cylinder-axis", "average-plane", "joint-vertex", "tool-facet"]
SLOW, MODERATE, RAPID = 20, 100, 400  # mm/s
SPEEDS = [SLOW, MODERATE, RAPID]


# ---- Reading the file


def read_table(file, name):
    columns = file[name].items()
    return pd.DataFrame({key: v.asstr()[:] if h5py.check_string_dtype(v.dtype) else v[:] for key, v in columns})


def failed_are_worst(table, failed):
    """Every figure of a case that did not complete is the worst there is. Of those used here high is better for the
    ratio of edges alone. What figures are divided by is neither good nor bad: 1, so that the worst stays the worst."""
    for column in table.select_dtypes("float"):
        if column.startswith("edge_ratio_mean"):
            table.loc[failed, column] = -math.inf
        elif column.startswith(("collided_vertices", "tool_volume_at_rest")):
            table.loc[failed, column] = 1.0
        elif column not in ("speed", "rate"):
            table.loc[failed, column] = math.inf


def read_results(path):
    """`runs`, a row a case, and `answers`, a row for each state and strategy that answered to it. In answers `label` is
    whose the answer is, `run_label` in whose run the state was found."""
    with h5py.File(path) as file:
        runs, answers = read_table(file, "cases"), read_table(file, "states")
    failed_are_worst(runs, runs.status != "complete")
    if len(answers):
        of_run = runs[["case_id", "label", "scene", "organ", "tool", "speed", "seed", "release"]]
        answers = answers.merge(of_run.rename(columns={"label": "run_label"}), on="case_id")
        failed_are_worst(answers, answers.reason != "")
    return runs, answers


# ---- A condition: median and interval lie on one side of what they are compared with. Too few seeds never do.


def lies(found, side, limit):
    if math.isnan(found["low"]):
        return False
    ends = np.array([found["low"], found["median"], found["high"]])
    on_side = {"<": ends < limit, "<=": ends <= limit, ">": ends > limit, ">=": ends >= limit}[side]
    return bool(on_side.all())


judged = []  # a row for each condition, value of `each` and release


def judge(claim, condition, release, each, cases, values, side=None, limit=0.0):
    """`values` of `cases`, a table that says which organ and seed each is of. No `side`: described."""
    values = np.asarray(values, float)
    exists = ~np.isnan(values)
    of_organ, of_seed = cases.organ.to_numpy()[exists], cases.seed.to_numpy()[exists]
    found = estimate(values[exists], of_organ, of_seed)
    found |= {"claim": claim, "condition": condition, "release": release, "each": each, "missing": int((~exists).sum())}
    judged.append(found | {"holds": lies(found, side, limit) if side else None})


def of_whole_runs(answers, figure, per=()):
    """The states of one run are not independent of each other: a run and who answered make one value. Over the states
    of which all figures exist, it is the mean of the figures' sum, divided by that of `per` where it is given. An answer
    that failed makes it a failure: the worst stays the worst in a mean."""
    columns = [*figure, *per]
    means = answers.dropna(subset=columns).groupby(OF_ANSWERS, as_index=False)[columns].mean()
    value = means[list(figure)].sum(axis=1) / (means[list(per)].sum(axis=1) if per else 1)
    everyone = answers[OF_ANSWERS].drop_duplicates()
    return everyone.merge(means.assign(value=value), on=OF_ANSWERS, how="left", validate="one_to_one")


def side_by_side(of, than, keys):
    """Rows of two tables that agree in `keys`; columns of the second end in _than."""
    return of.merge(than, on=keys, suffixes=("", "_than"), validate="one_to_one")


def excess(a, b, times=1.0):
    """a - times * b; two that are infinite alike do not differ."""
    a, b = a.to_numpy(), times * b.to_numpy()
    with np.errstate(invalid="ignore"):
        return np.where(a == b, 0.0, a - b)


SAME_RUN = ["scene", "organ", "tool", "speed", "seed"]  # what runs that differ in the strategy have in common
SAME_STATES = [*SAME_RUN, "run_label"]  # the run in which the states were found that both answered to
OF_ANSWERS = [*SAME_STATES, "label"]


# ---- The claims


def judge_claims(runs, answers, release, organs):
    prism = runs[(runs.release == release) & (runs.tool == "prism-12")]
    penetration = prism[(prism.scene == "penetration") & prism.organ.isin(organs)]
    sliding = prism[(prism.scene == "sliding") & prism.organ.isin(organs)]
    cutting = prism[(prism.scene == "cutting") & prism.organ.isin(CLEFTS)]

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
        fewer = excess(both.tool_crossings_mean, both.tool_crossings_mean_than)
        judge("C5", 2, release, {"speed": speed}, both, fewer, "<")

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
    three = answers[answers.organ.isin(organs)]
    prism = three[three.tool == "prism-12"]

    def more_than_fuzzy(here, label, figure, per=()):
        """Runs with what `label` and fuzzy-per-vertex answered to the same states, and how much more the former's is."""
        here = here[here.label.isin([label, "fuzzy-per-vertex"])]
        values = of_whole_runs(here, figure, per)
        both = side_by_side(values[values.label == label], values[values.label == "fuzzy-per-vertex"], SAME_STATES)
        return both, excess(both.value, both.value_than)

    for speed in SPEEDS:
        # C3: sliding treated as penetration pulls vertices together.
        here = prism[(prism.scene == "sliding") & (prism.speed == speed)]
        always = "fuzzy, always penetration"
        judge("C3", 1, release, {"speed": speed}, *more_than_fuzzy(here, always, ["edge_ratio_mean_h"]), "<")
        judge("C3", 2, release, {"speed": speed}, *more_than_fuzzy(here, always, ["drag"]), ">")

        # C4, first condition: joint displacement moves vertices further.
        for scene in ("penetration", "sliding"):
            here = prism[(prism.scene == scene) & (prism.speed == speed)]
            further = more_than_fuzzy(here, "joint-vertex", ["displacement_mean"])
            judge("C4", 1, release, {"scene": scene, "speed": speed}, *further, ">")

        # C8: with tool-facet displacement vectors cross.
        for tool in ("prism-12", "grasper"):
            here = three[(three.scene == "penetration") & (three.tool == tool) & (three.speed == speed)]
            crossing = more_than_fuzzy(here, "tool-facet", ["displacement_crossings"], ["collided_vertices"])
            judge("C8", 1, release, {"tool": tool, "speed": speed}, *crossing, ">")

        # C10: the average plane leaves facets across the tool.
        here = prism[(prism.scene == "penetration") & (prism.speed == speed)]
        crossing = more_than_fuzzy(here, "average-plane", ["facets_crossing_h"], ["collided_vertices"])
        judge("C10", 1, release, {"speed": speed}, *crossing, ">")

        # C9: on a rough sheet facets cross, on a flat one less. A seed is the same place on both.
        for label in ("cylinder-axis", "average-plane"):
            here = answers[(answers.tool == "prism-12") & (answers.scene == "penetration") & (answers.speed == speed)]
            here = here[here.label == label]
            values = of_whole_runs(here, ["flipped_facets", "self_crossings_h"], ["collided_vertices"])
            rough, flat = (values[values.organ == organ] for organ in ("rough-sheet@4mm", "sheet@4mm"))
            both = side_by_side(rough, flat, ["seed", "run_label"])
            judge("C9", 1, release, {"label": label, "speed": speed}, both, excess(both.value, both.value_than), ">")


def judge_turns(path, release):
    """C11, where the program has measured it: how far answers turn when inputs hardly do. It knows no organ."""
    turns = pd.read_csv(path).assign(organ="")
    for condition, (label, side, limit) in enumerate([("tool-facet", ">=", 40), ("fuzzy-per-vertex", "<=", 10)], 1):
        of_label = turns[turns.label == label]
        judge("C11", condition, release, {}, of_label, of_label.largest_turn, side, limit)


# ---- What the conditions of a claim make together


def verdict(rows):
    if any(row["n"] == 0 for row in rows):
        return "no value" if all(row["n"] or row["missing"] for row in rows) else "not run"
    asked = [row for row in rows if row["holds"] is not None]
    if not asked:
        return "described"
    if any(math.isnan(row["low"]) for row in asked):
        return "too few seeds"
    held = sum(row["holds"] for row in asked)
    return "reproduced" if held == len(asked) else "partly" if held else "not reproduced"


def verdicts():
    """Rows and verdict of each claim and release."""
    of_claim = {}
    for row in judged:
        of_claim.setdefault((row["claim"], row["release"]), []).append(row)
    return {key: (rows, verdict(rows)) for key, rows in of_claim.items()}


def show(found):
    for (claim, release), (rows, word) in sorted(found.items(), key=lambda item: (int(item[0][0][1:]), item[0][1])):
        print(f"{claim} {release}: {word}")
        for row in rows:
            each = ", ".join(f"{key} {value}" for key, value in row["each"].items())
            holds = {None: "", True: "holds", False: "does not hold"}[row["holds"]]
            print(f"    {row['condition']} {each}: n {row['n']}, without value {row['missing']}, median "
                  f"{row['median']:.6g} [{row['low']:.6g}, {row['high']:.6g}] {holds}")  # fmt: skip


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("file")
    options.add_argument("--turns", help="the CSV file beside it, for C11")
    options.add_argument("--against", help="what `trocar reproduce --json` printed")
    options.add_argument("--organs", action="append", help="of the sweeps that have three, if these have others")
    given = options.parse_args()
    runs, answers = read_results(given.file)
    for release in ("contact", "step"):
        judge_claims(runs, answers, release, given.organs or THREE_ORGANS)
        if given.turns:
            judge_turns(given.turns, release)
    found = verdicts()
    show(found)
    return 1 if given.against and compare(found, given.against) else 0


if __name__ == "__main__":
    sys.exit(main())
