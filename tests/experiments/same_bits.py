"""Whether two result files are the same in all that must be the same for the same inputs and program (store.md).

/usr/bin/python3 same_bits.py A.h5 B.h5
prints how many cases B has lost and how many it has twice, and what else differs; exit code 1 where anything does.
"""

import sys
from collections import Counter

import h5py
import numpy as np


def bits(path):
    """The bytes of every dataset that must be the same whenever the inputs and the program are."""
    varying = ("wall_s", "attempts")
    found = {}

    def visit(name, item):
        leaf = name.rpartition("/")[2]
        if not isinstance(item, h5py.Dataset) or name.startswith("provenance/"):
            return
        if leaf.startswith("time_") or leaf in varying:
            return
        data = item[()]
        text = data.dtype == object
        found[name] = [bytes(one) for one in data] if text else np.asarray(data).tobytes()

    with h5py.File(path) as file:
        file.visititems(visit)
        found["attributes"] = {key: str(value) for key, value in file.attrs.items() if key != "created_utc"}
    return found


def case_ids(path):
    with h5py.File(path) as file:
        return list(file["cases/case_id"].asstr()[:])


def compare(expected_path, found_path):
    """The exit code."""
    expected, found = case_ids(expected_path), case_ids(found_path)
    lost = set(expected) - set(found)
    twice = [one for one, count in Counter(found).items() if count > 1]
    print(f"cases {len(found)}, lost {len(lost)}, duplicated {len(twice)}")
    expected_bits, found_bits = bits(expected_path), bits(found_path)
    differing = sorted(
        name for name in expected_bits.keys() | found_bits.keys() if expected_bits.get(name) != found_bits.get(name)
    )
    print(f"datasets that differ: {len(differing)}", *differing[:10], sep="\n  ")
    return 1 if lost or twice or differing else 0


if __name__ == "__main__":
    sys.exit(compare(*sys.argv[1:3]))
