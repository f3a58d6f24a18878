"""Reads experiments/claims.toml, which says what its keys mean, and checks it."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import InputError, unknown
from ..subject import CASES, STATES
from ..toml_file import read_toml
from .claim_sweeps import Sweep, read_sweeps

RELATIONS = ("<", ">", "<=", ">=")
DATA = ("runs", "answers", "turns")
TIMES = "time_"  # how the columns of every case's times begin

Where = dict[str, tuple]  # column → the values that rows may have in it


@dataclass(frozen=True)
class Condition:
    """One figure of one group of cases, on its own or against that of another group."""

    data: str
    figure: tuple[str, ...]  # columns, summed
    per: tuple[str, ...]  # columns, summed; none: the figure itself
    of: Where
    than: Where  # empty: the figure is compared with `limit`
    relation: str  # "" when the figure is described only
    limit: float = 0
    times: float = 1
    each: dict[str, object] = field(default_factory=dict)  # what distinguishes it from others written with it
    sweeps: tuple[Sweep, ...] = ()  # whose cases it is judged on; none: all

    @property
    def asks_for_more(self) -> bool:
        """Whether it holds where the figure is large."""
        return self.relation.startswith(">")


@dataclass(frozen=True)
class Claim:
    id: str
    place: str
    says: str
    pending: str  # why it cannot be judged yet; "" when it can
    conditions: tuple[Condition, ...]


CLAIM_KEYS = {"id", "place", "says", "sweeps", "data", "where", "condition", "pending"}
CONDITION_KEYS = {"figure", "per", "where", "each", "of", "than", "is", "limit", "times", "data"}


def read_claims(path: str) -> list[Claim]:
    content = read_toml(path, "the file of claims")
    claims = content.get("claim")
    if not isinstance(claims, list) or not claims:
        raise InputError(f"{path}: has no [[claim]]")
    try:
        read = [read_claim(claim, Path(path).parent) for claim in claims]
        for claim, table in zip(read, claims):
            check_figures(claim, table.get("sweeps", []), content.get("sweep", {}))
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    ids = [claim.id for claim in read]
    if twice := next((one for one in ids if ids.count(one) > 1), None):
        raise InputError(f"{path}: has claim {twice} twice")
    return read


def check_figures(claim: Claim, sweeps: list[str], notes: dict) -> None:
    """That the cases of the claim's sweeps are measured by what its conditions ask for."""
    for one in claim.conditions:
        for column in (*one.figure, *one.per) if one.data != "turns" else ():
            name = (STATES if one.data == "answers" else CASES).name_of(column)
            if name is None:
                raise InputError(f"claim {claim.id}: {column} is no figure of a case, such as depth_max_d_max")
            for sweep in sweeps:
                if name.metric not in notes.get(sweep, {}).get("metrics", []) and not name.metric.startswith(TIMES):
                    raise InputError(f"claim {claim.id}: {column} is of no metric that {sweep} is measured by")


def choose_claims(claims: list[Claim], ids: list[str] | None) -> list[Claim]:
    for one in ids or []:
        if one not in {claim.id for claim in claims}:
            raise unknown("claim", one, [claim.id for claim in claims])
    return [claim for claim in claims if not ids or claim.id in ids]


def read_claim(table: dict, folder: Path) -> Claim:
    if not isinstance(table, dict):
        raise InputError(f"a claim is {table!r}; expected a table, [[claim]]")
    name = f"claim {table.get('id', 'without id')}"
    check_keys(name, table, CLAIM_KEYS)
    for key in ("id", "place", "says"):
        if not isinstance(table.get(key), str):
            raise InputError(f"{name}: expected a text as its {key}")
    sweeps = read_sweeps(folder, table.get("sweeps", []))
    conditions = [one for entry in table.get("condition", []) for one in read_condition(name, table, entry, sweeps)]
    if not conditions and "pending" not in table:
        raise InputError(f"{name}: has neither conditions nor the reason why it is pending")
    # What is said stands in the cells of tables: no line breaks.
    said = (" ".join(table.get(key, "").split()) for key in ("id", "place", "says", "pending"))
    return Claim(*said, conditions=tuple(conditions))


def read_condition(name: str, claim: dict, entry: dict, sweeps: tuple[Sweep, ...]) -> list[Condition]:
    """A condition for each value, or pair of values, of its `each`."""
    check_keys(f"a condition of {name}", entry, CONDITION_KEYS)
    check_kinds(name, claim, entry)
    data, relation = entry.get("data", claim.get("data")), entry.get("is", "")
    if data not in DATA:
        raise InputError(f"{name}: data is \"{data}\"; expected {' or '.join(DATA)}")
    if relation and relation not in RELATIONS:
        raise InputError(f"{name}: is \"{relation}\"; expected one of {' '.join(RELATIONS)}")
    if relation and ("limit" in entry) == ("than" in entry):
        raise InputError(f"{name}: a condition with `is` needs either limit or than")
    if not relation and (useless := {"limit", "than", "times"} & entry.keys()):
        keys = " and ".join(sorted(useless))
        raise InputError(f"{name}: a condition has {keys} but no `is`, one of {' '.join(RELATIONS)}")
    if "times" in entry and "than" not in entry:
        raise InputError(f"{name}: a condition has times but no than, whose figure it multiplies")
    if not entry.get("figure"):
        raise InputError(f"{name}: a condition has no figure")
    shared = claim.get("where", {}) | entry.get("where", {})
    each = {key: as_tuple(values) for key, values in entry.get("each", {}).items()}
    conditions = []
    for values in itertools.product(*each.values()):
        chosen = dict(zip(each, values))
        common = shared | chosen
        conditions.append(Condition(
            data, as_tuple(entry["figure"]), as_tuple(entry.get("per", ())),
            where(common | entry.get("of", {})), where(common | entry["than"]) if "than" in entry else {},
            relation, float(entry.get("limit", 0)), float(entry.get("times", 1)), chosen, sweeps,
        ))  # fmt: skip
    return conditions


def check_kinds(name: str, claim: dict, entry: dict) -> None:
    for key in ("where", "each", "of", "than"):
        for table in (claim, entry):
            if not isinstance(table.get(key, {}), dict):
                raise InputError(f"{name}: {key} is {table[key]!r}; expected a table such as {{ speed = 20 }}")
    for key, values in entry.get("each", {}).items():
        if not isinstance(values, list) or not values:
            raise InputError(f"{name}: each.{key} is {values!r}; expected a list of values")
    for key in ("limit", "times"):
        if isinstance(entry.get(key, 0), bool) or not isinstance(entry.get(key, 0), (int, float)):
            raise InputError(f"{name}: {key} is {entry[key]!r}; expected a number")


def where(table: dict) -> Where:
    return {column: as_tuple(values) for column, values in table.items()}


def as_tuple(value: object) -> tuple:
    return tuple(value) if isinstance(value, (list, tuple)) else (value,)


def check_keys(what: str, table: dict, known: set[str]) -> None:
    for key in table:
        if key not in known:
            raise InputError(f"{what}: {unknown('key', key, known)}")
