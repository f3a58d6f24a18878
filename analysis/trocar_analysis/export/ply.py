"""PLY, binary."""

from __future__ import annotations

import numpy as np

from .surface import Surface

FACE = np.dtype([("corners", "u1"), ("vertices", "<i4", 3)])


def ply_bytes(surface: Surface) -> bytes:
    faces = np.empty(len(surface.facets), FACE)
    faces["corners"], faces["vertices"] = 3, surface.facets
    header = [
        "ply", "format binary_little_endian 1.0", f"comment {surface.words}",
        f"element vertex {len(surface.positions)}", "property float x", "property float y", "property float z",
        f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", "",
    ]  # fmt: skip
    return "\n".join(header).encode() + surface.positions.astype("<f4").tobytes() + faces.tobytes()
