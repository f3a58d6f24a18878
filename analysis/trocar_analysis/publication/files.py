"""Files of the folder: pictures as SVG and PDF, texts. The same result file gives the same bytes: no dates."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from matplotlib.figure import Figure as Picture
from matplotlib.style import context

from .. import palette
from ..errors import InputError

# PDF: fonts as TrueType, which publishers ask for. SVG: text that a reader can search and copy.
FONTS = {"svg.fonttype": "none", "pdf.fonttype": 42}
NO_DATES = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}


def make_folder(path: str) -> Path:
    folder = Path(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise InputError(f"{path}: is a file; give a folder for the figures") from error
    except OSError as error:
        raise InputError(f"{path}: no such folder can be made ({error.strerror})") from error
    return folder


def save_picture(folder: Path, name: str, compose: Callable[[], Picture]) -> None:
    with context([palette.STYLE, FONTS]):
        picture = compose()
        for kind, dates in NO_DATES.items():
            file = folder / f"{name}.{kind}"
            try:
                picture.savefig(file, metadata=dates)
            except OSError as error:
                raise InputError(f"{file}: cannot be written ({error.strerror or error})") from error


def save_text(folder: Path, name: str, text: str) -> None:
    try:
        (folder / name).write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{folder / name}: cannot be written ({error.strerror or error})") from error


def file_name(figure: str) -> str:
    """Of a figure: a column's name is one, a quotient's gets one."""
    return re.sub(r"[^\w-]", "_", figure.replace("/", "_per_"), flags=re.ASCII)
