"""The folder that an export fills: what is in it is one export, and nothing of anybody else's is touched."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import InputError

MARK = "case.json"  # says what the export is of
OWNER = "trocar export"  # its generator

UNFINISHED = ".unfinished."
# What exports leave in a folder, those that were cut off included; replay.xdmf the program adds.
OWN = re.compile(
    r"(organ_(found|handled|deformed)|tool)_\d{4,}\.(obj|ply|vtp)|(found|handled|deformed)\.pvd"
    rf"|{re.escape(MARK)}|replay\.xdmf(\.tmp\..+)?|{re.escape(UNFINISHED)}.+"
)


@contextmanager
def filled(folder: Path) -> Iterator[Path]:
    """A new folder inside `folder` to write to. At the end its files take the place of the export that `folder` holds, if
    any; where something goes wrong before, that stays as it was. InputError for a folder with other things in it, or one that
    cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        refuse_others(folder)
        unfinished = folder / f"{UNFINISHED}{socket.gethostname()}.{os.getpid()}"
        unfinished.mkdir()
        try:
            yield unfinished
            publish(unfinished, folder)
        finally:
            shutil.rmtree(unfinished, ignore_errors=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be written ({error.strerror or error})") from error


def refuse_others(folder: Path) -> None:
    names = sorted(entry.name for entry in folder.iterdir())
    others = [name for name in names if not OWN.fullmatch(name)]
    if others or (any(not name.startswith(UNFINISHED) for name in names) and not is_marked(folder)):
        raise InputError(
            f"{folder}: holds {(others or names)[0]}, which is no earlier export's; give a new or an empty folder"
        )


def is_marked(folder: Path) -> bool:
    try:
        return json.loads((folder / MARK).read_text(encoding="utf-8")).get("generator") == OWNER
    except (OSError, ValueError, AttributeError):
        return False


def publish(unfinished: Path, folder: Path) -> None:
    """Whole files, each under its final name at once. The mark is there throughout: cut off in between, the folder is
    still known as an export's."""
    os.replace(unfinished / MARK, folder / MARK)
    for entry in folder.iterdir():
        if entry.name.startswith(UNFINISHED) and entry != unfinished:
            shutil.rmtree(entry)
        elif entry.is_file() and entry.name != MARK:
            entry.unlink()
    for entry in unfinished.iterdir():
        os.replace(entry, folder / entry.name)
