"""What tests that drive the built program from outside share."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest


class ProgramTest(unittest.TestCase):
    """Each test has a folder of its own."""

    program = ""  # set by run_tests

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_program(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, timeout=120)

    def expect_refused(self, message, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(message, result.stderr)

    def expect_done(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result


def run_tests():
    """Of the test file that is run: `/usr/bin/python3 FILE PROGRAM`."""
    ProgramTest.program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
