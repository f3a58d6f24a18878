"""Which way is better of a metric, as the program says it: --better depth_max=low,edge_ratio_min=high,…"""

from __future__ import annotations


def directions_of(better: str) -> dict[str, str]:
    """The argument of --better: metric → "low" or "high"; "neither" of one that is not judged."""
    return dict(word.split("=", 1) for word in better.split(",") if "=" in word)
