"""Text as LaTeX has it. What this writes needs no package but those of figures.tex, and no font encoding but the default."""

from __future__ import annotations

import re
import unicodedata

SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_\allowbreak{}", "/": r"/\allowbreak{}",
    "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": "$<$", ">": "$>$", "|": "$|$", '"': "''",
    "–": "--", "—": "---", "…": r"\dots{}", "∞": r"$\infty$", "×": r"$\times$", "≈": r"$\approx$", "α": r"$\alpha$",
    "−": "$-$", "·": r"$\cdot$", "µ": r"$\mu$", "μ": r"$\mu$", "²": r"$^2$", "³": r"$^3$", "°": r"$^\circ$",
    "≤": r"$\le$", "≥": r"$\ge$", "↓": r"$\downarrow$", "↑": r"$\uparrow$", "†": r"\dag{}", "’": "'", "\u00a0": "~",
}  # fmt: skip
LETTERS = re.compile("[\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u00ff]")  # that every LaTeX knows


def latex(text: str) -> str:
    """The text, to be printed as it is, whatever it holds. A letter of which LaTeX's default fonts know nothing loses its
    accents, or is given by its number."""
    whole = "".join(map(letter, " ".join(text.split())))
    whole = re.sub("-(?=-)", "-{}", whole) if "--" in text else whole
    return f"{{}}{whole}" if whole[:1] in ("[", "*") else whole  # behind \\ they would be its argument


def letter(sign: str) -> str:
    if sign in SPECIAL:
        return SPECIAL[sign]
    if sign.isascii() and sign.isprintable() or LETTERS.match(sign):
        return sign
    plain = "".join(part for part in unicodedata.normalize("NFKD", sign) if part.isascii() and part.isprintable())
    return "".join(SPECIAL.get(part, part) for part in plain) or f"U+{ord(sign):04X}"
