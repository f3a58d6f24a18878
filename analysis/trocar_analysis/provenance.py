"""Which program ran the cases, and on which machine: whether times can be compared, and `show --provenance`."""

from __future__ import annotations

import pandas as pd
from pandas.api.types import is_integer_dtype

from .errors import InputError
from .table import Column, in_one_line, markdown, number

PROGRAM = ("build_id", "git_commit", "git_dirty", "compiler", "flags", "build_type", "libraries")
MACHINE = ("host", "cpu", "cores", "governor", "kernel")

# What makes times incomparable: in a table of one file, whose cases should come from one program, and between
# the programs of two files, which are meant to differ.
IN_ONE_FILE = (*PROGRAM, "host", "cpu")
NAMES = ("git_commit", "git_dirty")  # of a program: two commits may make the same one, and one with changes several
BETWEEN_FILES = ("cpu", "host", "build_type", "flags")


def origins(cases: pd.DataFrame, provenance: pd.DataFrame, path: str) -> pd.DataFrame:
    """The row of /provenance of each case, with the index of `cases`. Without columns when the file has none."""
    if provenance.empty or "provenance_row" not in cases:
        return pd.DataFrame(index=cases.index)
    rows = cases["provenance_row"]
    builds = cases[["build_id"]] if "build_id" in cases else cases[[]]
    if not is_integer_dtype(rows) or not rows.between(0, len(provenance) - 1).all():
        raise InputError(f"{path}: is damaged: provenance_row points to no row of /provenance")
    return builds.join(provenance.iloc[rows].set_index(cases.index))


def differing(origin: pd.DataFrame, facts: tuple[str, ...]) -> list[str]:
    """Those of `facts` that are not the same for all cases; of a program whose build is known not its names."""
    known = [name for name in facts if name in origin and not (name in NAMES and "build_id" in origin)]
    return [name for name in known if origin[name].nunique() > 1]


def is_time(figure: str) -> bool:
    return figure.startswith("time_") or figure == "wall_s"


def warning(origin: pd.DataFrame, times: str = "times") -> list[str]:
    """A line when times of these cases cannot be compared with each other, else none. `times`: what it calls them."""
    facts = differing(origin, IN_ONE_FILE)
    if not facts:
        return []
    programs, machines = set(facts) & set(PROGRAM), set(facts) - set(PROGRAM)
    kinds = [word for word, found in (("programs", programs), ("machines", machines)) if found]
    return [
        f"Warning: cases come from different {' and '.join(kinds)} ({', '.join(facts)}): {times} are not comparable; "
        "see trocar show --provenance"
    ]


def why_not_comparable(a: pd.DataFrame, b: pd.DataFrame) -> str:
    """Why times of cases with the origins `a` and `b` cannot be compared; "" when they can."""
    for name, origin in (("A", a), ("B", b)):
        if missing := [fact for fact in BETWEEN_FILES if fact not in origin]:
            return f"{name} does not say its {', '.join(missing)}"
    both = pd.concat([a, b])
    reasons = []
    for fact in differing(both, BETWEEN_FILES):
        values = [" and ".join(map(str, origin[fact].unique())) for origin in (a, b)]
        reasons.append(f"{fact}: {values[0]} in A, {values[1]} in B")
    return "; ".join(reasons)


def provenance_text(path: str, origin: pd.DataFrame, style: str) -> str:
    """What `show --provenance` prints of these cases, in the style "text", "markdown" or "csv"."""
    if origin.columns.empty:
        raise InputError(f"{path}: does not say how its cases were run (/provenance is empty)")
    groups = runs(origin)
    if style == "csv":
        return groups.to_csv(index=False)
    lines = warning(origin)
    if style == "markdown":
        cells = {name: [(in_one_line(number(value)), "") for value in groups[name]] for name in groups}
        columns = [Column((name, ""), "", True, cells[name]) for name in groups]
        return markdown(columns) + "".join(f"\n- {line}\n" for line in lines)
    told = [name for name in PROGRAM if name in origin and not (name in NAMES and "build_id" in origin)]
    programs = origin[told].drop_duplicates()
    machines = origin[[name for name in ("host", "cpu") if name in origin]].drop_duplicates()
    heading = f"{path}: {len(origin)} cases, {count(programs, 'program')}, {count(machines, 'machine')}"
    blocks = [heading, *lines]
    for _, group in groups.iterrows():
        width = max(map(len, group.index))
        blocks += ["", *(f"{name:<{width}}  {in_one_line(number(value))}" for name, value in group.items())]
    return "\n".join([*blocks, ""])


def count(rows: pd.DataFrame, what: str) -> str:
    return f"{len(rows)} {what}{'s' if len(rows) > 1 else ''}"


def runs(origin: pd.DataFrame) -> pd.DataFrame:
    """One row per distinct program and machine, in the order of the first start: `cases`, what is the same for
    them, and the span of what is not."""
    same = [name for name in (*PROGRAM, *MACHINE) if name in origin]
    rows = []
    for values, group in origin.groupby(same, sort=False, dropna=False) if same else [((), origin)]:
        values = values if isinstance(values, tuple) else (values,)
        row: dict[str, object] = {"cases": len(group)} | dict(zip(same, values))
        if {"start", "end"} <= {*group}:
            row |= {"first_start": group["start"].min(), "last_end": group["end"].max()}
        if "load" in group:
            row |= {"least_load": group["load"].min(), "most_load": group["load"].max()}
        if "argv" in group:
            row["argv"] = "; ".join(dict.fromkeys(group["argv"]))
        rows.append(row)
    table = pd.DataFrame(rows)
    return table.sort_values("first_start", kind="stable") if "first_start" in table else table
