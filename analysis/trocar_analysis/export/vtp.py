"""VTK's XML files: a surface (.vtp), and surfaces over time (.pvd)."""

from __future__ import annotations

import base64
import zlib
from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from .surface import Surface

KINDS = {"f4": "Float32", "f8": "Float64", "i8": "Int64", "u1": "UInt8"}
HEADER = '<?xml version="1.0"?>\n<VTKFile type="{}" version="1.0" byte_order="LittleEndian"{}>\n'


def vtp_bytes(surface: Surface) -> bytes:
    """Every array is packed with zlib and written as base64 in its place."""
    vertices, facets = len(surface.positions), len(surface.facets)
    ends = np.arange(3, 3 * facets + 1, 3)
    lines = [
        HEADER.format("PolyData", ' header_type="UInt64" compressor="vtkZLibDataCompressor"')
        + f"<!-- {escape(surface.words).replace('--', '- -')} -->",
        "<PolyData>",
        "<FieldData>", data_array("TimeValue", np.array([surface.time]), ' NumberOfTuples="1"'), "</FieldData>",
        f'<Piece NumberOfPoints="{vertices}" NumberOfPolys="{facets}">',
        "<PointData>", *arrays(surface.at_vertices), "</PointData>",
        "<CellData>", *arrays(surface.at_facets), "</CellData>",
        "<Points>", data_array("Points", surface.positions), "</Points>",
        "<Polys>", data_array("connectivity", surface.facets.reshape(-1).astype(np.int64)),
        data_array("offsets", ends), "</Polys>",
        "</Piece>", "</PolyData>", "</VTKFile>", "",
    ]  # fmt: skip
    return "\n".join(lines).encode()


def arrays(named: dict[str, np.ndarray]) -> Iterable[str]:
    return (data_array(name, values) for name, values in named.items())


def data_array(name: str, values: np.ndarray, more: str = "") -> str:
    """One block of data: how many there are, its size, that of a smaller last one, its size when packed; then itself."""
    kind = f"{values.dtype.kind}{values.dtype.itemsize}"
    raw = values.astype(f"<{kind}").tobytes()
    packed = zlib.compress(raw)
    sizes = np.array([1, len(raw), 0, len(packed)], "<u8").tobytes()
    text = (base64.b64encode(sizes) + base64.b64encode(packed)).decode("ascii")
    if values.ndim == 2:
        more += f' NumberOfComponents="{values.shape[1]}"'
    return f'<DataArray type="{KINDS[kind]}" Name={quoteattr(name)} format="binary"{more}>{text}</DataArray>'


def pvd_text(times: list[float], files: list[list[str]]) -> str:
    """At each time the files in its list, one part each."""
    sets = [
        f'<DataSet timestep="{time!r}" part="{part}" file={quoteattr(name)}/>'
        for time, names in zip(times, files)
        for part, name in enumerate(names)
    ]
    return "\n".join([HEADER.format("Collection", "") + "<Collection>", *sets, "</Collection>", "</VTKFile>", ""])
