"""The table of cases in a report: numbers in full, texts as codes, reasons of missing values."""

from __future__ import annotations

import base64
import gzip
import math
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
from result_file import write_results

from trocar_analysis.report.blocks import KINDS, Blocks
from trocar_analysis.report.columns import pack_columns
from trocar_analysis.store import ResultFile


def unpacked(blocks: Blocks, block: dict) -> np.ndarray:
    """As the page reads a block."""
    packed = re.search(rf'id="{re.escape(block["block"])}">([^<]*)<', blocks.tags()).group(1)
    kind = np.dtype(KINDS[block["kind"]])
    planes = np.frombuffer(gzip.decompress(base64.b64decode(packed)), np.uint8).reshape(kind.itemsize, -1)
    return np.ascontiguousarray(planes.T).view(kind).reshape(block["shape"])


class Columns(unittest.TestCase):
    def columns_of(self, cases: list[dict], better: dict[str, str] | None = None) -> dict[str, dict]:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "out.h5"
            write_results(path, [{"case_id": f"c{k}"} | case for k, case in enumerate(cases)])
            self.blocks = Blocks()
            with ResultFile(path) as file:
                columns = pack_columns(file.cases_table(), file, better or {}, self.blocks)
        return {column["name"]: column for column in columns}

    def values(self, column: dict) -> list:
        values = unpacked(self.blocks, column["values"])
        return [column["levels"][code] for code in values] if "levels" in column else [*values]

    def test_numbers_are_those_of_the_file_to_the_last_bit(self) -> None:
        numbers = [0.1 + 0.2, 1e-300, -0.0, 2**53 + 1.0, math.pi]
        columns = self.columns_of([{"depth_max_d_max": number} for number in numbers])
        self.assertEqual(self.values(columns["depth_max_d_max"]), numbers)
        self.assertEqual(columns["depth_max_d_max"]["values"]["kind"], "f8")

    def test_texts_are_codes_into_levels_as_they_come(self) -> None:
        columns = self.columns_of([{"organ": "liver"}, {"organ": "Magen & <Öse>"}, {"organ": "liver"}])
        self.assertEqual(columns["organ"]["levels"], ["liver", "Magen & <Öse>"])
        self.assertEqual(self.values(columns["organ"]), ["liver", "Magen & <Öse>", "liver"])
        self.assertEqual(columns["organ"]["values"]["kind"], "u2")

    def test_more_levels_than_two_bytes_number(self) -> None:
        count = 2**16 + 2
        columns = self.columns_of([{} for _ in range(count)])
        self.assertEqual(columns["case_id"]["values"]["kind"], "u4")
        self.assertEqual(self.values(columns["case_id"])[-1], f"c{count - 1}")

    def test_what_a_column_is(self) -> None:
        columns = self.columns_of([{}], {"depth_max": "low", "time_handle": "neither"})
        said = {name: (columns[name]["role"], columns[name].get("part")) for name in ("speed", "seed", "strategy", "status")}
        self.assertEqual(
            said,
            {"speed": ("input", "condition"), "seed": ("input", "condition"), "strategy": ("input", None), "status": ("outcome", None)},
        )
        depth, time = columns["depth_max_d_max"], columns["time_handle_p50"]
        self.assertEqual((depth["role"], depth["better"], depth["unit"]), ("figure", "low", "mm"))
        self.assertEqual((time["role"], time["better"]), ("figure", None))

    def test_a_case_without_label_has_its_strategy_as_label(self) -> None:
        self.assertEqual(self.values(self.columns_of([{"strategy": "mine"}])["label"]), ["mine"])

    def test_options_that_differ_are_columns_of_inputs(self) -> None:
        options = ['{"plane":"tangent","same":1}', '{"plane":"chord","same":1}', '{"other":true}']
        columns = self.columns_of([{"options": said} for said in options])
        self.assertEqual((columns["plane"]["role"], columns["plane"]["part"]), ("input", "option"))
        self.assertEqual(self.values(columns["plane"]), ["tangent", "chord", "–"])
        self.assertNotIn("same", columns)
        self.assertNotIn("other", columns)

    def test_why_a_figure_has_no_value(self) -> None:
        nan = {"depth_max_d_max": math.nan}
        columns = self.columns_of([
            {"missing": ""},
            nan | {"missing": '{"depth_max_d":{"no vertex inside":3}}'},
            nan | {"missing": "", "status": "diverged"},
            nan | {"missing": ""},
        ])  # fmt: skip
        why = columns["depth_max_d_max"]["why"]
        self.assertEqual(self.values(why), ["", "no vertex inside", "diverged", "no reason recorded"])
        self.assertNotIn("why", columns["time_handle_p50"])
        self.assertNotIn("missing", columns)


if __name__ == "__main__":
    unittest.main()
