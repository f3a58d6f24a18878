"""Reads the campaign of python_test.cpp without any code of ours.

Usage: read_store.py tables|xdmf <campaign.h5> <replay.xdmf>. Exit status 77 when a package is missing.
"""

import importlib
import json
import sys
import xml.etree.ElementTree
from pathlib import Path

try:
    import h5py
    import numpy
    import pandas
    import xarray

    importlib.import_module("h5netcdf")  # xarray's engine
except ImportError as error:
    print(error)
    sys.exit(77)


def check_table(table):
    assert list(table["case_id"]) == ["a2", "a1"], table
    assert list(table["status"]) == ["timed_out", "timed_out"], table
    assert list(table["seed"]) == [2**62, 2**62], table
    assert list(table["speed"]) == [0.1, 0.1], table
    assert list(table["options"]) == ['{"ε": 0.7071}'] * 2, table
    assert table["depth_max_d_max"].isna().all(), table


def check_states(table):
    assert list(table["state"]) == [0, 1, 2], table
    assert list(table["case_id"]) == ["a2", "a1", "a1"], table
    assert list(table["step"]) == [2, 1, 1], table
    assert list(table["strategy"]) == ["tool-facet", "tool-facet", "µ"], table
    assert table["drag"].isna()[0] and list(table["drag"][1:]) == [0.5, 0.25], table


def frame(group):
    return pandas.DataFrame(
        {name: data.asstr()[:] if data.dtype == object else data[:] for name, data in group.items()}
    )


def check_tables(campaign):
    with h5py.File(campaign) as file:
        assert file.attrs["schema_version"] == 2 and file.attrs["complete"] == 1
        assert file.attrs["sweep_toml"] == '[sweep]\nname = "µ test"\n'
        cases, states = frame(file["cases"]), frame(file["states"])
        check_table(cases)
        assert list(cases)[:3] == ["case_id", "build_id", "strategy"], "columns lost their order"
        check_states(states)
        assert list(states) == ["state", "case_id", "step", "strategy", "drag"], "columns lost their order"
        assert len(states.merge(cases, on="case_id")) == 3
        missing = file["series/a1/depth_max_d"].attrs["missing"]
        assert json.loads(missing) == {"no vertex inside": [[1, 1]]}, missing
        assert "missing" not in file["series/a1/recovery"].attrs

        unlabelled = []
        file.visititems(
            lambda name, item: unlabelled.append(name)
            if isinstance(item, h5py.Dataset)
            and not (isinstance(item.attrs.get("units"), str) and item.attrs.get("long_name"))
            else None
        )
        assert not unlabelled, unlabelled
        assert h5py.h5ds.is_scale(file["cases/case_id"].id)
        assert h5py.h5ds.is_attached(file["cases/speed"].id, file["cases/case_id"].id, 0)
        assert file["cases/speed"].dims[0][0] == file["cases/case_id"]
        assert len(file["cases/case_id"].attrs["REFERENCE_LIST"]) == len(file["cases"]) - 1
        assert h5py.h5ds.is_scale(file["states/state"].id)
        assert h5py.h5ds.is_attached(file["states/case_id"].id, file["states/state"].id, 0)
        assert file["replay/a1/found"].chunks == (1, 4, 3) and file["replay/a1/found"].dtype == numpy.float32
        assert file["replay/a1/found"].compression == "gzip" and file["replay/a1/found"].shuffle

    check_table(xarray.open_dataset(campaign, group="cases", engine="h5netcdf").to_dataframe().reset_index())
    states = xarray.open_dataset(campaign, group="states", engine="h5netcdf")
    assert states["drag"].dims == ("state",) and states["drag"].attrs["units"] == "mm"
    check_states(states.to_dataframe().reset_index())
    series = xarray.open_dataset(campaign, group="series/a1", engine="h5netcdf", phony_dims="sort")
    assert series["depth_max_d"].values[2] == 0.25 and series["depth_max_d"].attrs["units"] == "mm"


def numbers(words):
    return tuple(int(word) for word in words.split())


def check_xdmf(campaign, xdmf):
    root = xml.etree.ElementTree.parse(xdmf).getroot()
    times = [float(time.get("Value")) for time in root.iter("Time")]
    assert times == [0.1, 0.2, 0.3], times
    assert [grid.get("Name") for grid in root.findall("Domain/Grid")] == ["nearest-face a1"]
    items = [item for item in root.iter("DataItem") if item.get("Format") == "HDF"]
    assert len(items) == 3 * 6, len(items)
    for item in items:
        place, _, slab = item.text.partition("|")
        name, dataset = place.split(":")
        assert (Path(xdmf).parent / name).samefile(campaign), name
        with h5py.File(Path(xdmf).parent / name) as file:
            shape = numbers(item.get("Dimensions"))
            if slab:
                start, stride, count, whole = map(numbers, slab.split(":"))
                assert (start[0] in range(3), start[1:], stride) == (True, (0, 0), (1, 1, 1)), item.text
                assert file[dataset].shape == whole and (count[0], count[1:]) == (1, shape), item.text
            else:
                assert file[dataset].shape == shape, item.text
            assert file[dataset].dtype.itemsize == int(item.get("Precision")), item.text


if sys.argv[1] == "tables":
    check_tables(sys.argv[2])
else:
    check_xdmf(sys.argv[2], sys.argv[3])
