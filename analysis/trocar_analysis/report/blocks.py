"""Arrays inside the report's HTML: each as base64 of gzip, in a <script> of its own, which the page unpacks when it wants
it (page/src/blocks.ts)."""

from __future__ import annotations

import base64
import gzip
import html

import numpy as np

KINDS = {"f8": "<f8", "f4": "<f4", "i4": "<i4", "i2": "<i2", "u4": "<u4", "u2": "<u2", "u1": "u1"}


class Blocks:
    """The arrays of one report."""

    def __init__(self) -> None:
        self._packed: dict[str, str] = {}
        self._size = 0

    def add(self, name: str, values: np.ndarray, kind: str) -> dict:
        """Packs an array as numbers of this kind. What it returns belongs in the report's JSON: the page finds the array by it."""
        packed = pack(values, kind)
        if name in self._packed:
            raise ValueError(f"two arrays of the report are called {name}")
        self._packed[name] = packed
        self._size += len(packed)
        return {"block": name, "kind": kind, "shape": list(values.shape)}

    def add_once(self, name: str, values: np.ndarray, kind: str) -> dict:
        """As add; an array of this name is taken to be the same."""
        if name in self._packed:
            return {"block": name, "kind": kind, "shape": list(values.shape)}
        return self.add(name, values, kind)

    def take(self, others: Blocks) -> None:
        """Adds the arrays of others."""
        if both := self._packed.keys() & others._packed.keys():
            raise ValueError(f"two arrays of the report are called {sorted(both)[0]}")
        self._packed |= others._packed
        self._size += others._size

    def size(self) -> int:
        """Bytes that they take in the file."""
        return self._size

    def tags(self) -> str:
        """As HTML."""
        return "\n".join(
            f'<script type="text/plain" id="{html.escape(name, quote=True)}">{packed}</script>'
            for name, packed in self._packed.items()
        )


def pack(values: np.ndarray, kind: str) -> str:
    """Bytes of one significance lie together: they pack better."""
    raw = np.ascontiguousarray(values, dtype=KINDS[kind])
    planes = raw.reshape(-1).view(np.uint8).reshape(-1, raw.dtype.itemsize).T
    return base64.b64encode(gzip.compress(planes.tobytes(), compresslevel=6, mtime=0)).decode("ascii")
