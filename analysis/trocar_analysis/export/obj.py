"""Wavefront OBJ."""

from __future__ import annotations

from .surface import Surface


def obj_text(surface: Surface) -> str:
    """Nine significant digits give a float32 back as it was."""
    lines = [f"# {surface.words}", f"o {surface.name}"]
    lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in surface.positions.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (surface.facets + 1).tolist()]
    return "\n".join(lines) + "\n"
