"""Makes the file of a picture small enough to be committed: few colours, short numbers."""

from __future__ import annotations

import base64
import io
import re
from pathlib import Path

from PIL import Image

COLOURS, EMBEDDED_COLOURS = 256, 128  # of a .png, and of each picture in an .svg
EMBEDDED = re.compile(r'(data:image/png;base64,)([A-Za-z0-9+/=\s]+)(")')
PATH_DATA = re.compile(r'( d=")([^"]*)(")')
NUMBER = re.compile(r"-?\d+\.\d{2,}")
CURVE = re.compile("[QC]")


def shrink(path: str) -> None:
    file = Path(path)
    if file.suffix.lower() == ".png":
        file.write_bytes(few_colours(file.read_bytes(), COLOURS))
        return
    text = EMBEDDED.sub(with_few_colours, file.read_text(encoding="utf-8"))
    file.write_text(PATH_DATA.sub(with_short_numbers, text), encoding="utf-8")


def few_colours(png: bytes, colours: int) -> bytes:
    """The same picture with a palette of its own."""
    picture = Image.open(io.BytesIO(png)).convert("RGB")
    target = io.BytesIO()
    reduced = picture.quantize(colours, Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE)
    reduced.save(target, "PNG", optimize=True)
    return target.getvalue()


def with_few_colours(match: re.Match) -> str:
    return match[1] + base64.b64encode(few_colours(base64.b64decode(match[2]), EMBEDDED_COLOURS)).decode() + match[3]


def with_short_numbers(match: re.Match) -> str:
    """Coordinates in tenths of a point. Behind the first point of a line those of the others need no letter."""
    data = " ".join(NUMBER.sub(lambda number: f"{float(number[0]):.1f}", match[2]).split())
    return match[1] + (data if CURVE.search(data) else data.replace("L ", "")) + match[3]
