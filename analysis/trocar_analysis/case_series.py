"""All series of a case read at once. h5py's objects take most of the time that reading small arrays takes: this goes
below them."""

from __future__ import annotations

from dataclasses import dataclass

import h5py
import numpy as np
from h5py import h5a, h5d, h5g, h5s


@dataclass(frozen=True)
class CaseSeries:
    """The series of a case. All have one value a step."""

    names: list[str]
    values: np.ndarray  # [series, steps], in the stored units; NaN where there is none
    missing: list[str]  # why a series lacks values, as JSON: reason → ranges of steps, both ends included; "" for none


def read_case_series(group: h5py.Group, case_id: str) -> CaseSeries:
    """@param group /series. ValueError where the series of the case differ in length."""
    names, rows, missing = [], [], []
    case = h5g.open(group.id, case_id.encode()) if case_id in group else None
    for number in range(case.get_num_objs() if case else 0):
        name = case.get_objname_by_idx(number)
        series = h5d.open(case, name)
        if len(series.shape) != 1 or (rows and series.shape != rows[0].shape):
            raise ValueError(f"the series of {case_id} differ in length")
        rows.append(np.empty(series.shape))
        series.read(h5s.ALL, h5s.ALL, rows[-1])
        names.append(name.decode())
        missing.append(read_text(series, b"missing"))
    return CaseSeries(names, np.array(rows), missing)


def read_text(series: h5d.DatasetID, attribute: bytes) -> str:
    if not h5a.exists(series, attribute):
        return ""
    said = h5a.open(series, attribute)
    value = np.empty(said.shape, said.dtype)
    said.read(value)
    text = value.item()
    return text.decode("utf-8", "replace") if isinstance(text, bytes) else str(text)
