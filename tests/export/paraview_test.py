"""ParaView opens replays: the .xdmf over a result file, and the .pvd that `trocar export` writes. It needs pvbatch with
Debian's python3-paraview, and an X server, such as xvfb-run's; without ParaView it says so and is skipped.

xvfb-run -a /usr/bin/python3 paraview_test.py PROGRAM PICTURES
"""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
from PIL import Image

from exported_case import ExportedCase, run_tests

FRAMES = pathlib.Path(__file__).with_name("paraview_frames.py")


def why_not():
    """Why ParaView cannot be run here; "" if it can."""
    if shutil.which("pvbatch") is None:
        return "pvbatch is not installed"
    with tempfile.NamedTemporaryFile("w", suffix=".py") as script:
        script.write("import paraview.simple\n")
        script.flush()
        tried = subprocess.run(["pvbatch", script.name], capture_output=True, text=True)
    return "" if tried.returncode == 0 else "pvbatch has no module paraview; python3-paraview brings it"


class ParaView(ExportedCase):
    @classmethod
    def setUpClass(cls):
        reason = why_not()
        if reason:
            print(f"NOT TESTED with ParaView: {reason}", flush=True)
            raise unittest.SkipTest(reason)
        super().setUpClass()

    def look(self, path, reader):
        """What ParaView sees; nothing may stand on its error output."""
        command = ["pvbatch", "--force-offscreen-rendering", FRAMES, path, reader, self.busiest_step(), self.pictures]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        said = [line for line in done.stdout.splitlines() if line]
        self.assertEqual([line[:5] for line in said], ["seen "], done.stdout[:2000])
        self.assertNotIn("ERR", done.stderr)
        return json.loads(said[0].removeprefix("seen "))

    def check(self, seen, moment, arrays):
        self.assertEqual(seen["times"], self.times.tolist())
        self.assertEqual(set(map(int, seen["steps"])), {0, self.busiest_step(), len(self.times) - 1})
        for step, (organ, tool) in ((int(step), surfaces) for step, surfaces in seen["steps"].items()):
            np.testing.assert_array_equal(np.array(organ["points"], np.float32), self.stored[moment][step])
            np.testing.assert_allclose(tool["points"], self.stored["tool_placed"][step], rtol=0, atol=2e-5)
            self.assertEqual(organ["facets"], len(self.stored["facets"]))
            self.assertEqual(tool["facets"], len(self.stored["tool_facets"]))
            self.assertLessEqual(arrays, set(organ["arrays"]))

    def check_pictures(self, name):
        chosen, last = (
            np.asarray(Image.open(self.pictures / f"paraview_{name}_{which}.png").convert("RGB")).astype(int)
            for which in ("chosen", "last")
        )
        for picture in (chosen, last):
            shown = np.abs(picture - picture[0, 0]).max(axis=2) > 8
            self.assertGreater(shown.mean(), 0.02, "the picture is all but empty")
        self.assertGreater((np.abs(chosen - last).max(axis=2) > 8).mean(), 0.005, "the steps look the same")

    def test_pvd(self):
        self.check(self.look(self.folder / "handled.pvd", "PVDReader"), "handled", {"displacement", "moved"})
        self.check_pictures("handled.pvd")

    def test_xdmf_of_the_case(self):
        for reader in ("Xdmf3ReaderT", "Xdmf3ReaderS"):
            with self.subTest(reader):
                self.check(self.look(self.folder / "replay.xdmf", reader), "deformed", {"found", "handled"})
                self.check_pictures("replay.xdmf")

    def test_xdmf_of_the_campaign(self):
        seen = self.look(self.results.with_suffix(".xdmf"), "Xdmf3ReaderT")
        last = seen["steps"][str(self.busiest_step())]
        organs = [np.array(one["points"], np.float32) for one in last]
        stored = self.stored["deformed"][self.busiest_step()]
        self.assertTrue(any(np.array_equal(organ, stored) for organ in organs), "the case is not in it")


if __name__ == "__main__":
    run_tests()
