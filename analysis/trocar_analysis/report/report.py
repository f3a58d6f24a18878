"""`report`: puts together what the page shows (page/src/report.ts) and writes it as one file."""

from __future__ import annotations

import json
import os
import tomllib
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ..claims.claim_data import read_sources
from ..errors import InputError
from ..store import SCHEMA_VERSION, ResultFile
from .blocks import Blocks
from .claims_told import ClaimFiles, claims_told
from .columns import pack_columns
from .glossary import glossary
from .html import html_text
from .overview import overview_of
from .provenance_rows import pack_provenance
from .replays import pack_replays
from .series import pack_series

__all__ = ["ClaimFiles", "make_report"]

MB = 1_000_000
ROOM = 0.01  # of the budget: for what the parts are glued together with
REPLAYS = 2 / 3  # of what the essential leaves of the budget; series have the rest


@dataclass(frozen=True)
class Made:
    """A report that has been written."""

    path: str
    size: int  # bytes
    notes: list[str]  # what is not in it

    def __str__(self) -> str:
        return "\n".join([f"{self.path} ({self.size / MB:.1f} MB)", *self.notes])


def make_report(path: str, output: str, budget_mb: float, better: dict[str, str], claim_files: ClaimFiles) -> Made:
    """Writes the report of a result file. InputError where there is nothing to show, or where not even the table of cases
    fits in the budget."""
    refuse_output(path, output)
    if not budget_mb > 0:
        raise InputError(f"--budget {budget_mb:g}: expected MB, more than 0")
    blocks = Blocks()
    with ResultFile(path) as file:
        table = file.cases_table()
        if table.empty:
            raise InputError(f"{path}: has no cases; a report needs some: run its sweep")
        report = essential(file, table, better, claim_files, blocks)
        left = int(budget_mb * MB * (1 - ROOM)) - checked_size(path, report, blocks, budget_mb)
        add_details(report, file, table, blocks, left)
    text = html_text(report["title"], report, blocks).encode()
    write_at_once(output, text)
    return Made(output, len(text), report["notes"])


def refuse_output(path: str, output: str) -> None:
    """Before any work is done."""
    there = Path(output)
    if there.is_dir():
        raise InputError(f"{output}: is a folder; give the name of the page (.html) in it")
    if there.exists() and Path(path).exists() and there.samefile(path):
        raise InputError(f"{output}: is the result file; give another name for the page")
    if not there.parent.is_dir():
        raise InputError(f"{output}: there is no folder {there.parent}")


def essential(
    file: ResultFile, table: pd.DataFrame, better: dict[str, str], claim_files: ClaimFiles, blocks: Blocks
) -> dict:
    """All but the replays and series of cases."""
    columns = pack_columns(table, file, better, blocks)
    provenance, row_of = pack_provenance(table, file, blocks)
    origin = file.origin()
    return {
        "title": title_of(file, origin["sweep_toml"]),
        "file": file.path.name,
        "schema": SCHEMA_VERSION,
        "createdUtc": origin["created_utc"],
        "generator": origin["generator"],
        "sweepToml": origin["sweep_toml"],
        "planned": file.sweep_cases(),
        "cases": len(table),
        "labels": list(dict.fromkeys(table["label"])),
        "columns": [*columns, row_of],
        "provenance": provenance,
        "glossary": glossary(file, table, better),
        "overview": overview_of(file, table, better)
        | {"claims": claims_told(claim_files, lambda turns: read_sources(str(file.path), turns, better))},
        "series": {},
        "replays": [],
        "notes": part_words(file, table),
    }


def title_of(file: ResultFile, sweep: str) -> str:
    """The sweep's name, where it has one."""
    try:
        name = tomllib.loads(sweep).get("name", "")
    except tomllib.TOMLDecodeError:  # such as that of `trocar reproduce`, which is of several sweeps
        name = ""
    return name if isinstance(name, str) and name else file.path.stem


def part_words(file: ResultFile, table: pd.DataFrame) -> list[str]:
    whole = file.sweep_cases()
    if whole is None or whole <= len(table):
        return []
    return [f"The file holds {len(table)} of the sweep's {whole} cases; trocar run runs the others."]


def checked_size(path: str, report: dict, blocks: Blocks, budget_mb: float) -> int:
    """What the page takes without any replay or series, bytes."""
    size = len(html_text(report["title"], report, blocks).encode())
    needed = size / MB / (1 - ROOM)
    if needed > budget_mb:
        raise InputError(
            f"{path}: the page with its {report['cases']} cases takes {size / MB:.2f} MB without any series or replay, and "
            f"--budget is {budget_mb:g}; give --budget {int(needed * 10) / 10 + 0.1:.1f} or more"
        )
    return size


def add_details(report: dict, file: ResultFile, table: pd.DataFrame, blocks: Blocks, left: int) -> None:
    """The replays and series that fit."""
    before = blocks.size()
    replays, of_replays = pack_replays(file, table, blocks, int(left * REPLAYS)) if file.recorded_cases() else ([], [])
    left -= blocks.size() - before + len(json.dumps(replays))
    series, of_series = pack_series(file, table, blocks, max(left, 0))
    report |= {"replays": replays, "series": series}
    report["notes"] += [*of_replays, *of_series]


def write_at_once(output: str, text: bytes) -> None:
    """So that nobody finds half a page."""
    part = f"{output}.tmp.{os.getpid()}"
    try:
        try:
            Path(part).write_bytes(text)
            os.replace(part, output)
        finally:
            Path(part).unlink(missing_ok=True)
    except OSError as error:
        raise InputError(f"{output}: cannot be written ({error.strerror or error})") from error
