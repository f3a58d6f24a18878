"""What `trocar run` runs again, and what it keeps: --retry-failed, --fresh, attempts.

/usr/bin/python3 resume_test.py PROGRAM
"""

import os
import signal
import subprocess
import time

import h5py

from program_test import ProgramTest, run_tests

SWEEP = """name = "small"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@12mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 2
"""


OCTAHEDRON = """OFF
6 8 0
0 0 1
1 0 0
0 1 0
-1 0 0
0 -1 0
0 0 -1
3 0 1 2
3 0 2 3
3 0 3 4
3 0 4 1
3 5 2 1
3 5 3 2
3 5 4 3
3 5 1 4
"""


class Resume(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        self.out = self.folder / "out.h5"
        self.fresh_parts = self.folder / "out.h5.fresh.parts"

    def run_sweep(self, *more):
        return self.run_program("run", self.sweep, "-o", self.out, *more)

    def column(self, name):
        with h5py.File(self.out) as file:
            return file[f"cases/{name}"][()].tolist()

    def let_one_fail(self):
        with h5py.File(self.out, "r+") as file:
            file["cases/status"][1] = "crashed"

    def test_failed_cases_are_kept_unless_they_are_to_be_retried(self):
        self.run_sweep()
        self.let_one_fail()
        result = self.run_sweep()
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("3 complete, 1 crashed (4 from an earlier run, 0 run", result.stdout)
        self.assertIn("--retry-failed", result.stdout)
        self.assertIn("4 cases, 1 of them to run", self.run_sweep("--retry-failed", "--dry-run").stdout)
        result = self.run_sweep("--retry-failed")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("4 complete (3 from an earlier run, 1 run", result.stdout)

    def test_attempts_are_counted_over_runs(self):
        self.run_sweep()
        self.assertEqual(self.column("attempts"), [1, 1, 1, 1])
        self.let_one_fail()
        self.run_sweep("--retry-failed")
        self.assertEqual(self.column("attempts"), [1, 2, 1, 1])

    def test_fresh_runs_everything_and_counts_anew(self):
        self.run_sweep()
        self.let_one_fail()
        result = self.run_sweep("--fresh")
        self.assertIn("4 complete (0 from an earlier run, 4 run", result.stdout)
        self.assertEqual(self.column("attempts"), [1, 1, 1, 1])
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.h5", "sweep.toml"])

    def test_fresh_keeps_cases_that_it_is_not_asked_for(self):
        self.run_sweep()
        self.assertIn("2 run", self.run_sweep("--fresh", "--only", "seed=1").stdout)
        self.assertEqual(self.column("seed"), [1, 2, 1, 2])

    def test_a_fresh_run_that_is_cut_off_leaves_the_old_result_and_goes_on(self):
        self.sweep.write_text(SWEEP.replace("@12mm", "@3mm").replace("seeds = 2", "seeds = 10"))
        self.run_sweep()
        before = self.out.read_bytes()
        process = subprocess.Popen([self.program, "run", self.sweep, "-o", self.out, "-j", "2", "--fresh"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)  # fmt: skip
        self.assertIn("of 20 cases done", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        text, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("is as it was before", text)
        self.assertEqual(self.out.read_bytes(), before)
        kept = len(os.listdir(self.fresh_parts))
        self.assertGreater(kept, 0)
        # A run that is not fresh does not see them.
        self.assertIn("20 from an earlier run, 0 run", self.run_sweep().stdout)
        self.assertEqual(len(os.listdir(self.fresh_parts)), kept)
        self.assertIn(f"{kept} from an earlier run, {20 - kept} run", self.run_sweep("--fresh").stdout)
        self.assertFalse(self.fresh_parts.exists())
        self.assertNotEqual(self.out.read_bytes(), before)

    def test_cases_of_a_mesh_that_has_changed_are_not_lost(self):
        mesh = self.write("organ.off", OCTAHEDRON)
        self.sweep.write_text(SWEEP.replace('"sphere@12mm"', '{ file = "organ.off", size = 100 }'))
        first = self.run_sweep()
        self.assertEqual(first.returncode, 0, first.stderr)
        before = self.out.read_bytes()
        mesh.write_text(OCTAHEDRON + "# the same organ\n")
        for more in ((), ("--only", "seed=1"), ("--dry-run",)):
            self.expect_refused("holds 4 cases that this sweep does not have", "run", self.sweep, "-o", self.out, *more)
        self.assertEqual(self.out.read_bytes(), before)
        self.assertEqual(sorted(os.listdir(self.folder)), ["organ.off", "out.h5", "sweep.toml"])
        self.assertEqual(self.run_sweep("--fresh").returncode, 0)
        self.assertEqual(len(self.column("case_id")), 4)

    def test_files_of_others_in_the_parts_folder_stay(self):
        theirs = self.folder / "out.h5.parts" / "notes" / "mine.txt"
        theirs.parent.mkdir(parents=True)
        theirs.write_text("mine")
        self.assertEqual(self.run_sweep().returncode, 0)
        self.assertEqual(theirs.read_text(), "mine")
        self.assertEqual(os.listdir(theirs.parents[1]), ["notes"])

    def test_a_signal_to_the_whole_job_is_no_crash(self):
        """As `timeout` and batch systems send it."""
        self.sweep.write_text(SWEEP.replace("@12mm", "@6mm").replace("seeds = 2", "seeds = 8"))
        for _ in range(3):
            process = subprocess.Popen([self.program, "run", self.sweep, "-o", self.out, "-j", "2"],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                       start_new_session=True)  # fmt: skip
            process.stderr.readline()
            os.killpg(process.pid, signal.SIGTERM)
            _, errors = process.communicate(timeout=60)
            self.assertIn(process.returncode, (0, 130), errors)
            self.assertNotIn("crashed", errors)
        self.assertEqual(self.run_sweep().returncode, 0)

    def test_time_in_which_the_job_stands_still_does_not_count(self):
        self.sweep.write_text(SWEEP.replace("@12mm", "@6mm").replace("seeds = 2", "seeds = 6"))
        process = subprocess.Popen([self.program, "run", self.sweep, "-o", self.out, "-j", "1", "--case-seconds", "8"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   start_new_session=True)  # fmt: skip
        process.stderr.readline()
        os.killpg(process.pid, signal.SIGSTOP)
        time.sleep(9)
        os.killpg(process.pid, signal.SIGCONT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, errors)

    def test_a_log_on_a_full_disk_stops_nothing(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([self.program, "run", self.sweep, "-o", self.out],
                                  stdout=subprocess.PIPE, stderr=full, text=True, timeout=60)  # fmt: skip
        self.assertEqual(done.returncode, 0)
        self.assertIn("4 complete", done.stdout)

    def test_fresh_does_not_write_over_what_is_not_its_own(self):
        self.run_sweep()
        before = self.out.read_bytes()
        self.sweep.write_text(SWEEP.replace("small", "other"))
        self.expect_refused("another sweep", "run", self.sweep, "-o", self.out, "--fresh")
        self.assertEqual(self.out.read_bytes(), before)
        self.assertEqual(self.run_sweep("--fresh", "--retry-failed").returncode, 2)


if __name__ == "__main__":
    run_tests()
