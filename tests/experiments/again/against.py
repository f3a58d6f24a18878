"""What came out on this path, held against what `trocar reproduce --json` said."""

import json
import math


def numbered(conditions):
    """Theirs, by number and `each`: those of one `each` are in the order of the claims' file."""
    counts = {}
    for one in conditions:
        each = json.dumps(one["each"], sort_keys=True)
        counts[each] = counts.get(each, 0) + 1
        yield (counts[each], each), one


def agree(value, other):
    """`other` is None where the program has no number."""
    return math.isnan(value) if other is None else math.isclose(value, other, rel_tol=1e-9, abs_tol=1e-9)


def is_between(other, ends):
    return ends[0] <= other <= ends[1] or any(agree(end, other) for end in ends)


def differences(said, rows, word):
    """What the program said of a claim under one release, against what came out here; a line each."""
    if said["verdict"] != word:
        yield f"verdict {said['verdict']}, here {word}"
    theirs = dict(numbered(said["conditions"]))
    here = {(row["condition"], json.dumps(row["each"], sort_keys=True)): row for row in rows}
    if theirs.keys() != here.keys():
        yield f"other conditions: {sorted(theirs.keys() ^ here.keys())}"
    for key in theirs.keys() & here.keys():
        one, row = theirs[key], here[key]
        limit = 0.0 if one["than"] else one["limit"]  # theirs are differences from the limit
        median, low, high = (None if one[end] is None else float(one[end]) + limit for end in ("median", "low", "high"))
        if (one["n"], one["lacking"]) != (row["n"], row["missing"]):
            yield f"{key}: n {one['n']}, without value {one['lacking']}, here {row['n']}, {row['missing']}"
        if not agree(row["median"], median):
            yield f"{key}: median {median}, here {row['median']}"
        if one["holds"] != (None if math.isnan(row["low"]) else row["holds"]):
            yield f"{key}: holds is {one['holds']}, here {row['holds']}"
        if (low is None) != math.isnan(row["low"]):
            yield f"{key}: low end {low}, here {row['low']}"
        elif low is not None and not (is_between(low, row["low_between"]) and is_between(high, row["high_between"])):
            yield f"{key}: interval [{low}, {high}], here {row['low_between']} to {row['high_between']}"


def compare(found, path):
    """How many claims differ, under either release, from what `trocar reproduce --json` said."""
    wrong = 0
    with open(path, encoding="utf-8") as file:
        theirs = {claim["id"]: claim for claim in json.load(file)}
    for name, claim in theirs.items():
        for release, said in claim["verdicts"].items():
            if not any(one["n"] or one["lacking"] for one in said["conditions"]) and (name, release) not in found:
                print(f"{name} {release}: {said['verdict']}, nothing to compare")
                continue
            lines = list(differences(said, *found.get((name, release), ([], "not run"))))
            print(f"{name} {release}: {'DIFFERS' if lines else 'the same'}", *lines, sep="\n    ")
            wrong += bool(lines)
    return wrong
