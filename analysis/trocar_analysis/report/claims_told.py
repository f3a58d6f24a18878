"""The paper's claims, judged on the cases that the file holds: what `claims` prints, for the page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

from ..claims.claim_data import Sources
from ..claims.claim_file import Claim, read_claims
from ..claims.claim_table import Answer, conditions_table, left_out, legend, silent, verdict_text
from ..claims.reproduce import answer_of
from ..claims.verdicts import NO_DATA, NO_VALUE, NOT, PARTLY, PENDING, REPRODUCED, TOO_FEW, Verdict
from ..errors import InputError
from ..table import Column

CANNOT = "cannot be judged"


@dataclass(frozen=True)
class ClaimFiles:
    claims: str | None = None  # TOML
    turns: str | None = None  # CSV


def claims_told(files: ClaimFiles, sources_of: Callable[[str | None], Sources]) -> dict:
    """Every claim with its verdicts, and what to say above and below. Not a claim where none are given."""
    if files.claims is None:
        return {"claims": [], "about": ["No file of claims was given, so none is judged here."], "legend": []}
    sources = sources_of(files.turns)
    told = [told_claim(claim, sources) for claim in read_claims(files.claims)]
    return {"claims": told, "about": about(told, files), "legend": legend("text")}


def told_claim(claim: Claim, sources: Sources) -> dict:
    """A claim that the file lacks a column for is told with what it lacks."""
    said = {"id": claim.id, "place": claim.place, "says": claim.says, "pending": claim.pending}
    try:
        answer = answer_of(claim, sources)
    except InputError as error:
        verdicts = [{"release": "", "confirmation": False, "word": CANNOT, "text": CANNOT}]
        return said | {"verdicts": verdicts, "table": None, "notes": [sentence(str(error))]}
    table = conditions_table(answer, sources.units) if any(one.judged for one in answer.verdicts.values()) else None
    notes = [note for note in (left_out(answer), silent(answer)) if note]
    return said | {"verdicts": verdicts_of(answer), "table": table and told_table(table), "notes": notes}


def sentence(words: str) -> str:
    return f"{words[0].upper()}{words[1:]}."


def verdicts_of(answer: Answer) -> list[dict]:
    """Under each release, and those on the confirmation set where there is one."""
    told = [told_verdict(release, one, False) for release, one in answer.verdicts.items()]
    confirmed = [told_verdict(release, one, True) for release, one in answer.confirmation.items()]
    return told + [one for one in confirmed if one["word"] not in (NO_DATA, PENDING)]


def told_verdict(release: str, verdict: Verdict, confirmation: bool) -> dict:
    return {
        "release": release, "confirmation": confirmation, "word": verdict.word, "text": verdict_text(verdict),
    }  # fmt: skip


def told_table(columns: list[Column]) -> dict:
    return {
        "columns": [{"title": "".join(one.title), "isText": one.is_text} for one in columns],
        "rows": [[" ".join(filter(None, cell)) for cell in row] for row in zip(*(one.cells for one in columns))],
    }


def about(told: list[dict], files: ClaimFiles) -> list[str]:
    """How many came out how, and that they are this file's."""
    releases = dict.fromkeys(one["release"] for claim in told for one in claim["verdicts"] if one["release"])
    order = (REPRODUCED, PARTLY, NOT, TOO_FEW, NO_VALUE, NO_DATA)
    said = []
    for release in releases:
        words = Counter(
            one["word"] for claim in told for one in claim["verdicts"]
            if one["release"] == release and not one["confirmation"]
        )  # fmt: skip
        counts = ", ".join(f"{words[word]} {word}" for word in order if words[word])
        others = sum(count for word, count in words.items() if word not in order)
        rest = f"; {others} set no limit or cannot be looked at yet" if others else ""
        said.append(f"Release {release}: of {words.total()} claims {counts or 'none is judged'}{rest}.")
    if lacking := sum(claim["verdicts"][0]["word"] == CANNOT for claim in told):
        said.append(f"{lacking} of {len(told)} claims cannot be judged: the file lacks a figure that they ask for.")
    said.append(
        "Claims are judged on the cases that this file holds, whatever they were run for; trocar reproduce runs those that "
        "each claim asks for, with enough seeds."
    )
    if files.turns is None:
        said.append("No table of turns was given: claims on them count as not run.")
    return said
