"""What makes two programs the same to `trocar run`: their code, not the commit they were built from.

/usr/bin/python3 build_id_test.py PROGRAM
"""

import os
import re
import stat

from program_test import ProgramTest, run_tests

STAMP = re.compile(rb"trocar was built from the commit (\S{7,64}) +(clean|dirty)")

SWEEP = """name = "one"
strategies = ["nearest-face"]
organs = ["sphere@12mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 1
"""


class BuildId(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        with open(self.program, "rb") as file:
            self.bytes = file.read()

    def use(self, name, data):
        """From now on run_program starts a program of these bytes."""
        path = self.folder / name
        path.write_bytes(data)
        os.chmod(path, stat.S_IRWXU)
        self.program = str(path)

    def patched(self, start, text):
        return self.bytes[:start] + text + self.bytes[start + len(text) :]

    def run_sweep(self):
        return self.expect_done("run", self.sweep, "-o", self.folder / "out.h5").stdout

    def test_the_commit_is_in_one_place(self):
        self.assertEqual(len(STAMP.findall(self.bytes)), 1)
        self.assertNotIn(b".note.gnu.build-id", self.bytes)

    def test_programs_of_another_commit_are_the_same_program(self):
        self.run_sweep()
        stamp = STAMP.search(self.bytes)
        other = b"x" * len(stamp[1])
        tree = b"clean" if stamp[2] == b"dirty" else b"dirty"
        self.use("committed", self.patched(stamp.start(1), other + stamp[0][stamp.end(1) - stamp.start() : -5] + tree))
        version = self.expect_done("--version").stdout
        self.assertIn("x" * len(other), version)
        self.assertEqual(", with changes" in version, tree == b"dirty")
        self.assertIn("0 run in", self.run_sweep())

    def test_a_change_of_anything_else_is_another_program(self):
        self.run_sweep()
        self.use("changed", self.patched(self.bytes.index(b"from an earlier run"), b"F"))
        self.assertIn("1 run in", self.run_sweep())


if __name__ == "__main__":
    run_tests()
