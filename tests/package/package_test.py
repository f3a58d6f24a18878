"""Installs a build into a folder outside the source tree and uses it there: as a library, from the project consumer/,
and as a program.

/usr/bin/python3 package_test.py BUILD [option of the consumer's cmake]…
"""

import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD, *CONFIGURE_OPTIONS = sys.argv[1:]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
CONSUMER = SOURCE / "tests" / "package" / "consumer"
NEEDED = ("numpy", "h5py", "pandas", "scipy", "matplotlib")  # by `trocar show` and `trocar report`

SWEEP = """name = "installed"
strategies = ["nearest-face"]
organs = ["sphere@10mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 1
"""


def run(*command, **options):
    answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if answer.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))} ended with {answer.returncode}:\n{answer.stdout}")
    return answer.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="trocar-package-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.prefix = cls.folder / "installed"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)

    def test_another_project_runs_a_strategy(self):
        build = self.folder / "consumer"
        run("cmake", "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", *CONFIGURE_OPTIONS)
        run("cmake", "--build", build)
        said = run(build / "consumer")
        moved = re.fullmatch(r"vertex 0 goes to +(\S+) +(\S+) +(\S+) mm, outside the tool\n", said)
        self.assertIsNotNone(moved, said)
        # Ahead of the tool's end, which is at z = 9 mm, by the clearance of 0.01 mm.
        self.assertAlmostEqual(float(moved[3]), 8.99, delta=1e-4, msg=said)

    @unittest.skipUnless(all(map(importlib.util.find_spec, NEEDED)), f"needs {', '.join(NEEDED)} of Debian's python3")
    def test_the_installed_program_finds_its_analysis(self):
        program = self.prefix / "bin" / "trocar"
        (self.folder / "sweep.toml").write_text(SWEEP)
        run(program, "run", "sweep.toml", "-o", "out.h5", cwd=self.folder)
        self.assertIn("nearest-face", run(program, "show", "out.h5", cwd=self.folder))
        page = self.prefix / "share" / "trocar" / "analysis" / "page" / "dist" / "page.css"
        if not page.exists():
            self.skipTest("the page of reports was not built (make page)")
        run(program, "report", "out.h5", "-o", "report.html", cwd=self.folder)
        self.assertIn(page.read_text()[:200], (self.folder / "report.html").read_text())

    def test_the_package_can_be_moved(self):
        files = list(self.prefix.rglob("*.cmake"))
        self.assertTrue(files)
        for file in files:
            for place in (str(SOURCE), str(self.prefix)):
                self.assertNotIn(place, file.read_text(), file.name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
