"""What the tests of exports share: a sweep with replays, a case of it exported by the built program, what is stored of it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np


SWEEP = pathlib.Path(__file__).with_name("export.toml")


class ExportedCase(unittest.TestCase):
    """The first case, exported at all moments in all formats."""

    program = pictures = None  # set by run_tests

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="trocar-export-")
        cls.addClassCleanup(folder.cleanup)
        cls.results, cls.folder = (pathlib.Path(folder.name) / name for name in ("results.h5", "case"))
        cls.run_program("run", SWEEP, "--replay", "-o", cls.results)
        with h5py.File(cls.results) as file:
            cls.case_id = file["cases/case_id"].asstr()[0]
            cls.stored = {name: data[...] for name, data in file[f"replay/{cls.case_id}"].items()}
            cls.times = file[f"series/{cls.case_id}/time"][...]
        moments = [word for moment in ("found", "handled", "deformed") for word in ("--moment", moment)]
        cls.run_program("export", cls.results, "--case", cls.case_id, "-o", cls.folder, *moments)

    @classmethod
    def run_program(cls, *words):
        done = subprocess.run(list(map(str, (cls.program, *words))), capture_output=True, text=True)
        if done.returncode != 0:
            raise AssertionError(f"trocar {words[0]} ended with {done.returncode}: {done.stderr}")

    @classmethod
    def busiest_step(cls):
        """The step in which the strategy moved most vertices."""
        return int(np.diff(cls.stored["moved_offsets"]).argmax())

    def moved(self, step):
        first, end = self.stored["moved_offsets"][step : step + 2]
        return self.stored["moved"][first:end]


def run_tests():
    """Of the test file that is run: `/usr/bin/python3 FILE PROGRAM PICTURES`, a folder for what is drawn."""
    ExportedCase.pictures, ExportedCase.program = (pathlib.Path(sys.argv.pop()).resolve() for _ in range(2))
    ExportedCase.pictures.mkdir(parents=True, exist_ok=True)
    unittest.main()
