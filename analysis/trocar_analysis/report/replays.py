"""The replays that the report holds: the counterpart of page/src/replay/replay_data.ts."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass, field

import numpy as np
import pandas as pd

from ..deepest import deepest_step
from ..recording import Recording
from ..store import CONDITIONS, MOMENTS, ResultFile
from ..view import choose_view
from .blocks import Blocks
from .contact import Contact, contact
from .frames import LEAST, kept_steps
from .lattice import SPACING, changes, lattice_of, narrowest, reachable

# Series whose values the replay prints.
PRINTED = (
    "collided_vertices", "depth_max_h", "depth_max_d", "facets_crossing_h", "facets_crossing_d", "tool_volume_inside_h",
    "tool_volume_inside_d",
)  # fmt: skip

SAFETY = 0.95  # of the budget is aimed at: thinner replays take a little more for each step


@dataclass
class Packing:
    """What is being packed, and what need not be worked out again when it is packed anew with fewer steps."""

    file: ResultFile
    table: pd.DataFrame
    contacts: dict[tuple[str, int], list[Contact]] = field(default_factory=dict)
    not_places: dict[str, np.ndarray] = field(default_factory=dict)  # per case: steps that cannot be drawn


@dataclass(frozen=True)
class CaseSet:
    """Cases under the same conditions, which the page puts side by side."""

    number: int
    cases: pd.DataFrame
    conditions: str  # in words

    def weight(self, file: ResultFile) -> int:
        """About in proportion to what its replays take."""
        return sum(int(np.prod(file.replay_size(case_id))) for case_id in self.cases["case_id"])


def pack_replays(
    file: ResultFile, table: pd.DataFrame, blocks: Blocks, budget_bytes: int
) -> tuple[list[dict], list[str]]:
    """Replays as JSON, their arrays in `blocks`, in not more than that many bytes of the report; and what is left out."""
    packing, sets = Packing(file, table), case_sets(file, table)
    kept, share = sets, 1.0
    while True:
        replays, packed, size = pack_sets(packing, kept, share, budget_bytes)
        if size <= budget_bytes:
            blocks.take(packed)
            return replays, notes(packing, sets, kept, replays, budget_bytes)
        fits = SAFETY * budget_bytes / size
        if all(replay["frames"]["shape"][0] <= LEAST for replay in replays):
            kept = kept[: min(len(kept) - 1, int(len(kept) * fits))]
        share *= fits


def case_sets(file: ResultFile, table: pd.DataFrame) -> list[CaseSet]:
    """The cases with a replay, by conditions, in the table's order."""
    recorded = table[[file.has_replay(case_id) for case_id in table["case_id"]]]
    if recorded.empty:
        return []
    shared = [name for name in CONDITIONS if name in recorded]
    groups = [group for _, group in recorded.groupby(shared, sort=False, dropna=False)] if shared else [recorded]
    varied = [name for name in shared if recorded[name].nunique() > 1]
    return [CaseSet(number, group, words(group.iloc[0], varied)) for number, group in enumerate(groups)]


def words(case: pd.Series, varied: list[str]) -> str:
    """The conditions: what every reader asks for first, and what else differs between the sets."""
    first = [name for name in ("scene", "organ", "tool", "speed") if name in case]
    units = {"speed": "{:g} mm/s", "rate": "{:g} Hz", "release": "release {}", "seed": "seed {}"}
    others = [name for name in varied if name not in first]
    return " · ".join(units.get(name, "{}" if name in first else f"{name} {{}}").format(case[name]) for name in first + others)


def pack_sets(
    packing: Packing, sets: list[CaseSet], share: float, budget_bytes: int
) -> tuple[list[dict], Blocks, float]:
    """Packs this share of the steps. Ends early where it is more than the budget, with an estimate of the whole size."""
    blocks, replays, done = Blocks(), [], 0
    weights = [one.weight(packing.file) for one in sets]
    for one, weight in zip(sets, weights):
        replays += pack_set(packing, one, share, blocks)
        done += weight
        size = blocks.size() + len(json.dumps(replays))
        if size > budget_bytes:
            return replays, blocks, size * sum(weights) / done
    return replays, blocks, 0 if not sets else size


def pack_set(packing: Packing, one: CaseSet, share: float, blocks: Blocks) -> list[dict]:
    """All with the same steps, as far as they go: they stand side by side."""
    recordings = {case_id: packing.file.recording(case_id) for case_id in one.cases["case_id"]}
    longest = max(recordings.values(), key=lambda recording: recording.steps)
    touched = [step for recording in recordings.values() for step in np.flatnonzero(list(map(len, recording.moved)))[:1]]
    first, deepest = min(touched, default=0), deepest_step(longest.tool_poses)
    steps = kept_steps(longest.steps, [int(first), deepest], int(share * longest.steps))
    sight = choose_view(longest.rest_positions, longest.tool_at(deepest), longest.tool_poses, deepest)
    shared = {
        "set": one.number, "conditions": one.conditions, "firstContact": int(first), "deepest": deepest,
        "view": {
            "centre": sight.centre.tolist(), "right": sight.right.tolist(), "axis": sight.axis.tolist(),
            "halfWidth": sight.half_width, "halfHeight": sight.half_height,
        },
    }  # fmt: skip
    return [
        shared | pack_case(packing, row, recordings[row["case_id"]], steps, blocks) for _, row in one.cases.iterrows()
    ]


def pack_case(packing: Packing, case: pd.Series, recording: Recording, steps: np.ndarray, blocks: Blocks) -> dict:
    case_id = case["case_id"]
    whole = np.all([reachable(recording.positions[moment]) for moment in MOMENTS], axis=0)
    packing.not_places[case_id] = np.flatnonzero(~whole)
    steps = steps[steps < recording.steps]
    steps = steps[whole[steps]]
    lattice = lattice_of(recording.rest_positions)
    rest = lattice.numbers(recording.rest_positions)
    moments = np.stack([recording.positions[moment][steps] for moment in MOMENTS], axis=1)
    unsigned = changes(lattice.numbers(moments.reshape(-1, *rest.shape)), rest)
    touching = [one for step in steps for one in contacts_of(packing, case_id, recording, int(step))]
    names = [name for name in PRINTED if name in recording.series]
    nothing = np.empty(0)
    return {
        "caseId": case_id,
        "label": case["label"],
        "status": case["status"],
        "steps": recording.steps,
        "organ": organ(recording, lattice.origin, rest, blocks),
        "tool": tool(recording, blocks),
        "frames": blocks.add(f"replay-{case_id}-frames", steps, "u4"),
        "time": blocks.add(f"replay-{case_id}-time", recording.series.get("time", np.arange(recording.steps))[steps], "f8"),
        "poses": blocks.add(f"replay-{case_id}-poses", recording.tool_poses[steps], "f4"),
        "positions": blocks.add(f"replay-{case_id}-positions", unsigned, narrowest(unsigned)),
        "moved": lists(f"replay-{case_id}-moved", [recording.moved[step] for step in steps], blocks),
        "movedBy": blocks.add(
            f"replay-{case_id}-moved-by", np.concatenate([nothing.reshape(0, 3), *(recording.moved_by[step] for step in steps)]), "f4"
        ),
        "crossing": lists(f"replay-{case_id}-crossing", [one.facets for one in touching], blocks),
        "inside": lists(f"replay-{case_id}-inside", [one.vertices for one in touching], blocks),
        "depths": blocks.add(f"replay-{case_id}-depths", np.concatenate([nothing, *(one.depths for one in touching)]), "f4"),
        "series": names,
        "values": blocks.add(f"replay-{case_id}-values", np.array([recording.series[name][steps] for name in names]), "f8"),
    }  # fmt: skip


def contacts_of(packing: Packing, case_id: str, recording: Recording, step: int) -> list[Contact]:
    """Of the three moments of a step."""
    if (case_id, step) not in packing.contacts:
        placed = recording.tool_at(step)
        packing.contacts[case_id, step] = [
            contact(recording.positions[moment][step].astype(float), recording.facets, placed, recording.tool_facets)
            for moment in MOMENTS
        ]
    return packing.contacts[case_id, step]


def lists(name: str, values: list[np.ndarray], blocks: Blocks) -> dict:
    """Lists of numbers, one after the other: list k is values[offsets[k] … offsets[k+1]]."""
    return {
        "offsets": blocks.add(f"{name}-offsets", np.cumsum([0, *map(len, values)]), "u4"),
        "values": blocks.add(name, np.concatenate([np.empty(0, int), *values]), "u4"),
    }


def organ(recording: Recording, origin: np.ndarray, rest: np.ndarray, blocks: Blocks) -> dict:
    """Stored once, whichever cases it is of."""
    name = "organ-" + digest(rest, recording.facets)
    return {
        "facets": blocks.add_once(f"{name}-facets", recording.facets, "u4"),
        "rest": blocks.add_once(f"{name}-rest", rest, "i4"),
        "origin": origin.tolist(),
        "spacing": SPACING,
    }


def tool(recording: Recording, blocks: Blocks) -> dict:
    """Stored once, whichever cases it is of."""
    name = "tool-" + digest(recording.tool_positions, recording.tool_facets)
    return {
        "facets": blocks.add_once(f"{name}-facets", recording.tool_facets, "u4"),
        "positions": blocks.add_once(f"{name}-positions", recording.tool_positions, "f4"),
    }


def digest(*arrays: np.ndarray) -> str:
    return hashlib.sha256(b"".join(np.ascontiguousarray(array).tobytes() for array in arrays)).hexdigest()[:16]


def notes(
    packing: Packing, sets: list[CaseSet], kept: list[CaseSet], replays: list[dict], budget_bytes: int
) -> list[str]:
    """What the report does not have of the replays of the file."""
    said = []
    budget = f"so that the replays fit into {budget_bytes / 1e6:.3g} MB"
    for one in kept:
        mine = [replay for replay in replays if replay["set"] == one.number]
        longest = max(mine, key=lambda replay: replay["steps"])
        frames = longest["frames"]["shape"][0] + len(packing.not_places[longest["caseId"]])
        if frames < longest["steps"]:
            said.append(
                f"replay of {one.conditions}: {longest['frames']['shape'][0]} of {longest['steps']} steps are kept, evenly and all "
                f"around the first contact and the deepest step, {budget}"
            )
    for replay in replays:
        if len(lost := packing.not_places[replay["caseId"]]):
            said.append(
                f"replay of {replay['label']} ({replay['caseId']}): {len(lost)} of {replay['steps']} steps are left out, from step "
                f"{lost[0]} on: positions of the organ are not finite there"
            )
    for one in sets[len(kept) :]:
        cases = "1 case is" if len(one.cases) == 1 else f"{len(one.cases)} cases are"
        said.append(f"replay of {one.conditions}: its {cases} left out, {budget}")
    return said
