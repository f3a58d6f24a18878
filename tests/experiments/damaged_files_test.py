"""Result files that Trocar did not write, or that were damaged since: refused with a message, never a crash.

/usr/bin/python3 damaged_files_test.py PROGRAM
"""

import os
import random
import resource
import shutil
import subprocess

from program_test import ProgramTest, run_tests

SWEEP = """name = "small"
strategies = ["nearest-face"]
organs = ["sphere@12mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 1
"""


def mutated(data, draw):
    """Some flipped bytes, a run of one byte, or the beginning only."""
    data = bytearray(data)
    kind = draw.randrange(4)
    if kind == 0:
        return data[: draw.randrange(len(data))]
    if kind == 1:
        start, length = draw.randrange(len(data)), draw.randrange(1, 64)
        data[start : start + length] = bytes([draw.choice((0, 255))]) * len(data[start : start + length])
        return data
    for _ in range(draw.randrange(1, 40)):
        data[draw.randrange(len(data))] = draw.randrange(256)
    return data


class DamagedFiles(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        self.whole = self.folder / "whole.h5"
        self.expect_done("run", self.sweep, "-o", self.whole, "--metrics", "drag")
        self.bad = self.folder / "bad.h5"

    def try_mutations(self, count, seed, act, expected):
        """`act` has to end with one of the `expected` exit codes for each of `count` mutations."""
        data, draw = self.whole.read_bytes(), random.Random(seed)
        refused = 0
        for number in range(count):
            self.bad.write_bytes(mutated(data, draw))
            result = act()
            self.assertIn(result.returncode, expected, f"{number}: {result.stderr}")
            self.assertNotIn("Traceback", result.stderr, number)
            if result.returncode == 2:
                refused += 1
                self.assertIn("bad.h5", result.stderr, number)
        self.assertGreater(refused, count // 8)
        if "TROCAR_SANITIZED" not in os.environ:  # sanitizers have memory of their own
            self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 1_000_000)  # kB

    def test_merge(self):
        out = self.folder / "out.h5"

        def merge():
            out.unlink(missing_ok=True)
            return self.run_program("merge", self.bad, "-o", out)

        self.try_mutations(100, 1, merge, (0, 2, 3))

    def test_run(self):
        self.try_mutations(30, 2, lambda: self.run_program("run", self.sweep, "-o", self.bad), (0, 2, 3))

    def test_show(self):
        self.try_mutations(8, 3, lambda: self.run_program("show", self.bad), (0, 2))

    def test_an_analysis_that_crashes_names_the_file(self):
        # A package that ends the process, in the place of one that the analysis uses.
        self.write("h5py.py", "import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)\n")
        shutil.copy(self.whole, self.bad)
        result = subprocess.run([self.program, "show", self.bad], capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": str(self.folder)})  # fmt: skip
        self.assertEqual(result.returncode, 2)
        self.assertIn("bad.h5: is damaged: reading it ended with signal 11", result.stderr)


if __name__ == "__main__":
    run_tests()
