"""The notebooks run from the first cell to the last, on a made-up file, and what they print is worked out here."""

import importlib.util
import json
import math
import os
import statistics
import unittest

import h5py
import numpy as np
from made_up_strategies import DEPTH, made_up
from result_file import ANALYSIS, ProgramTest, write_results

NOTEBOOKS = sorted((ANALYSIS / "notebook").glob("*.ipynb"))
NEEDED = {"nbclient": "python3-nbclient", "nbformat": "python3-nbformat", "ipykernel": "python3-ipykernel"}
MISSING = [package for module, package in NEEDED.items() if importlib.util.find_spec(module) is None]


class Notebook(ProgramTest):
    def test_there_is_one(self):
        self.assertEqual([path.name for path in NOTEBOOKS], ["compare_strategies.ipynb"])

    def test_they_are_committed_without_outputs(self):
        for path in NOTEBOOKS:
            for cell in json.loads(path.read_text())["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), path.name)

    @unittest.skipIf(MISSING, f"notebooks are NOT run: install {' '.join(MISSING)}")
    def test_it_runs_on_a_result_file(self):
        cases = made_up(seeds=7)
        write_results(self.file, cases)
        with h5py.File(self.file, "a") as file:
            for case in cases:
                group = file.create_group(f"series/{case['case_id']}")
                group["time"], group["depth_max_d"] = np.arange(1, 4) / 30, np.array([0.0, case[DEPTH], math.nan])
                group["depth_max_d"].attrs.update(units="mm", long_name="how deep")
        printed, pictures = self.run_notebook(NOTEBOOKS[0])
        self.assertIn(f"{self.file}: 112 cases, {{'complete': 112}}", printed)
        self.assertIn("{'pairs': 28, 'unpaired_a': 0,", printed)
        for speed in (20.0, 400.0):
            b, a = (
                {(case["organ"], case["seed"]): case[DEPTH] for case in cases
                 if case["label"] == label and case["speed"] == speed}
                for label in ("nearest-face", "fuzzy")
            )  # fmt: skip
            median = statistics.median(b[key] - a[key] for key in a)
            self.assertIn(f"{speed:g} mm/s: nearest-face − fuzzy: {median:.2f} mm (", printed)
        self.assertNotIn("nan", printed)
        self.assertEqual(pictures, 2)

    def run_notebook(self, path):
        """What its cells print, and how many pictures they show."""
        import nbformat
        from nbclient import NotebookClient

        notebook = nbformat.read(path, as_version=4)
        client = NotebookClient(
            notebook, timeout=200, kernel_name="python3", resources={"metadata": {"path": str(path.parent)}}
        )
        given = os.environ | {"TROCAR_RESULTS": str(self.file), "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
        client.execute(env=given)
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        printed = "".join(output["text"] for output in outputs if output.get("name") == "stdout")
        return printed, sum("image/png" in output.get("data", {}) for output in outputs)


if __name__ == "__main__":
    unittest.main()
