"""A disk that is full, or not to be written to: nothing finished is lost, and the next run goes on.

/usr/bin/python3 full_disk_test.py PROGRAM
"""

import os
import shutil
import subprocess

import h5py

from program_test import ProgramTest, run_tests

SWEEP = """name = "small"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@8mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 5
"""


class FullDisk(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        self.disk = self.folder / "disk"
        self.disk.mkdir()
        self.out = self.disk / "out.h5"

    def mount(self, options):
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", self.disk], capture_output=True, text=True)
        if mounted.returncode != 0:
            self.skipTest(f"cannot mount a small disk here ({mounted.stderr.strip()})")
        self.addCleanup(subprocess.run, ["umount", "-l", self.disk], check=True)

    def remount(self, options):
        subprocess.run(["mount", "-o", f"remount,{options}", self.disk], check=True)

    def run_sweep(self, *more):
        return self.run_program("run", self.sweep, "-o", self.out, "-j", "2", *more)

    def cases(self, path):
        with h5py.File(path) as file:
            return {name: item[()].tolist() for name, item in file["cases"].items()
                    if not name.startswith("time_") and name not in ("wall_s", "attempts")}  # fmt: skip

    def series(self, path):
        with h5py.File(path) as file:
            return {f"{case}/{name}": values[()].tobytes() for case, group in file["series"].items()
                    for name, values in group.items() if not name.startswith("time_")}  # fmt: skip

    def expect_same_as_undisturbed(self):
        whole = self.folder / "whole.h5"
        self.expect_done("run", self.sweep, "-o", whole, "--replay")
        self.assertEqual(repr(self.cases(self.out)), repr(self.cases(whole)))
        self.assertEqual(self.series(self.out), self.series(whole))

    def expect_full(self, result):
        self.assertEqual(result.returncode, 3, result.stderr + result.stdout)
        self.assertIn("No space left on device", result.stderr)
        self.assertIn(str(self.out), result.stderr)
        left = [path.name for path in self.disk.rglob("*") if ".tmp." in path.name]
        self.assertEqual(left, [])

    def test_a_disk_that_fills_up_while_cases_run(self):
        self.mount("size=2200k")
        result = self.run_sweep("--replay")
        self.expect_full(result)
        self.assertIn("finished cases are kept in", result.stderr)
        kept = list((self.disk / "out.h5.parts").glob("*.h5"))
        self.assertGreater(len(kept), 0)
        self.assertLess(len(kept), 10)
        self.remount("size=20m")
        result = self.run_sweep("--replay")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"{len(kept)} from an earlier run, {10 - len(kept)} run", result.stdout)
        self.expect_same_as_undisturbed()

    def test_a_disk_that_has_no_room_for_the_merged_file(self):
        self.mount("size=20m")
        whole = self.folder / "whole.h5"
        self.expect_done("run", self.sweep, "-o", whole, "--replay")
        # Room for the parts and half of what they are merged into.
        probe = self.folder / "parts"
        probe.mkdir()
        for seed in range(1, 6):
            for strategy in ("nearest-face", "fuzzy-per-vertex"):
                self.expect_done("run", self.sweep, "-o", probe / f"{strategy}{seed}.h5", "--replay",
                                 "--only", f"seed={seed}", "--only", f"strategy={strategy}")  # fmt: skip
        pages = sum(-(-path.stat().st_size // 4096) for path in probe.glob("*.h5"))
        self.remount(f"size={(pages + whole.stat().st_size // 8192) * 4}k")
        result = self.run_sweep("--replay")
        self.expect_full(result)
        self.assertEqual(len(list((self.disk / "out.h5.parts").glob("*.h5"))), 10)
        self.remount("size=20m")
        result = self.run_sweep("--replay")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("10 from an earlier run, 0 run", result.stdout)
        self.expect_same_as_undisturbed()

    def test_a_disk_that_is_read_only(self):
        self.mount("size=2m")
        self.remount("ro")
        self.expect_refused("Read-only file system", "run", self.sweep, "-o", self.out)

    def test_a_folder_that_vanishes_during_the_run(self):
        self.sweep.write_text(SWEEP.replace("@8mm", "@3mm").replace("seeds = 5", "seeds = 20"))
        process = subprocess.Popen([self.program, "run", self.sweep, "-o", self.out], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)  # fmt: skip
        self.assertIn("of 40 cases done", process.stderr.readline())
        shutil.rmtree(self.disk)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, errors)
        self.assertIn("No such file or directory", errors)
        self.assertIn("no case is kept", errors)

    def test_what_a_killed_run_left_is_tidied_up(self):
        litter = self.disk / f"out.h5.tmp.{os.uname().nodename}.1"
        litter.write_bytes(b"half a file")
        self.run_sweep("--only", "seed=1")
        self.assertEqual(os.listdir(self.disk), ["out.h5"])


if __name__ == "__main__":
    run_tests()
