"""What the tests of exports share: a recorded case, exported by the built program, and what is stored of it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np


class ExportedCase(unittest.TestCase):
    """The first case with a replay, exported at all moments in all formats."""

    program = results = pictures = None  # set by run_tests

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="trocar-export-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name) / "case"
        with h5py.File(cls.results) as file:
            cls.case_id = next(case for case in file["cases/case_id"].asstr() if case in file["replay"])
            cls.stored = {name: data[...] for name, data in file[f"replay/{cls.case_id}"].items()}
            cls.times = file[f"series/{cls.case_id}/time"][...]
        moments = [word for moment in ("found", "handled", "deformed") for word in ("--moment", moment)]
        command = [cls.program, "export", cls.results, "--case", cls.case_id, "-o", cls.folder, *moments]
        subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def busiest_step(cls):
        """The step in which the strategy moved most vertices."""
        return int(np.diff(cls.stored["moved_offsets"]).argmax())

    def moved(self, step):
        first, end = self.stored["moved_offsets"][step : step + 2]
        return self.stored["moved"][first:end]


def run_tests():
    """Of the test file that is run: `/usr/bin/python3 FILE PROGRAM RESULTS PICTURES`, a folder for what was drawn."""
    ExportedCase.pictures, ExportedCase.results, ExportedCase.program = (
        pathlib.Path(sys.argv.pop()).resolve() for _ in range(3)
    )
    ExportedCase.pictures.mkdir(parents=True, exist_ok=True)
    unittest.main()
