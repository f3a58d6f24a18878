"""Diagrams as files."""

from __future__ import annotations

from io import BytesIO

from PIL import Image
from matplotlib.figure import Figure

from .errors import InputError
from .snapshot import save

COLORS = 256  # of a PNG


def save_each(picture: Figure, files: list[str]) -> None:
    """Writes a diagram into each of the files, .svg or .png; into none if one of them is neither. InputError where one
    cannot be written."""
    for file in files:
        if not file.lower().endswith((".png", ".svg")):
            raise InputError(f"{file}: a picture's name ends in .png or .svg")
    for file in files:
        save_small(picture, file) if file.lower().endswith(".png") else save(picture, file)


def save_small(picture: Figure, file: str) -> None:
    """A PNG of few colours: a third of the size, and it looks the same."""
    whole = BytesIO()
    picture.savefig(whole, format="png")
    try:
        Image.open(whole).convert("RGB").quantize(COLORS, dither=Image.Dither.NONE).save(file, optimize=True)
    except OSError as error:
        raise InputError(f"{file}: cannot be written ({error.strerror or error})") from error
