"""sleep_differences.py FULL.h5 SLEEPING.h5: how the figures of a sweep that was run with sleep differ from those of the
full simulation, as a Markdown table. Cases pair by what they were run with. A figure is taken to be as large as the
hundredth part of its mean over all cases at least, so that a share of next to nothing does not count."""

import sys

import h5py
import numpy as np
import pandas as pd

ALIKE = 0.02
KEYS = ["label", "scene", "organ", "tool", "speed", "rate", "release", "seed"]
NO_FIGURES = ("time_", "wall_s", "edge_stiffness", "rest_stiffness", "judged_rate", "recovery")


def cases(path):
    with h5py.File(path) as file:
        columns = {name: column[:] for name, column in file["cases"].items() if column.dtype.kind in "fiuO"}
    table = pd.DataFrame({name: values for name, values in columns.items() if values.ndim == 1})
    for name in table.columns[table.dtypes == object]:
        table[name] = table[name].str.decode("utf-8")
    return table


def differences(full, sleeping):
    """Of each case the difference over the figure."""
    scale = max(np.mean(np.abs(full)) / 100, np.finfo(float).tiny)
    return np.where(full == sleeping, 0, np.abs(full - sleeping) / np.maximum(np.abs(full), scale))


def main():
    full, sleeping = map(cases, sys.argv[1:])
    pairs = full.merge(sleeping, on=KEYS, suffixes=("", "_sleeping"), validate="one_to_one")
    if len(pairs) != len(full) or len(pairs) != len(sleeping):
        sys.exit("the files are not of the same cases")
    print(f"{len(pairs)} cases with sleep beside the same in full.\n")
    print("| figure | median difference | within 2 % | mean over all cases, full | with sleep | change |\n| --- | ---: | ---: | ---: | ---: | ---: |")
    for name in full.columns[full.dtypes == float]:
        if name in KEYS or name.startswith(NO_FIGURES) or not name.endswith(("_mean", "_max")):
            continue
        a, b = pairs[name].to_numpy(), pairs[name + "_sleeping"].to_numpy()
        exists = np.isfinite(a) & np.isfinite(b)
        if not exists.any() or not a[exists].any():
            continue
        off = differences(a[exists], b[exists])
        alike = (off <= ALIKE).mean()
        mean, asleep = a[exists].mean(), b[exists].mean()
        print(f"| {name} | {100 * np.median(off):.3f} % | {100 * alike:.1f} % | {mean:.4g} | {asleep:.4g} | {100 * (asleep / mean - 1):+.2f} % |")


if __name__ == "__main__":
    main()
