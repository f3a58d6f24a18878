"""`trocar reproduce` from outside, on claim C7 as it stands in experiments/claims.toml and a sweep that takes seconds.

/usr/bin/python3 claims_test.py PROGRAM
"""

import json
import pathlib
import re
import signal
import subprocess
import sys
import tomllib

import h5py

from program_test import ProgramTest, run_tests

HERE = pathlib.Path(__file__).resolve().parent
CLAIMS = (HERE.parents[1] / "experiments" / "claims.toml").read_text(encoding="utf-8")
(C7,) = (f"[[claim]]{one}" for one in CLAIMS.split("[[claim]]") if '\nid = "C7"' in one)

# All that any sweep is measured by: the second path looks at every claim.
METRICS = sorted({name for sweep in tomllib.loads(CLAIMS)["sweep"].values() for name in sweep["metrics"]})

HEAD = f"""[sweep."claims/penetration.toml"]
metrics = {json.dumps(METRICS)}
quick_seeds = 12

[confirmation]
sweeps = ["claims/penetration.toml"]
organs = [{{ file = "koala.obj", size = 100 }}]

"""

SWEEP = """name = "small"
strategies = ["fuzzy-per-vertex", "nearest-face"]
organs = ["sphere@12mm"]
tools = ["prism-12"]
scenes = ["penetration"]
speeds = [20, 400]
seeds = 14
[cycle]
rate = 30
release = ["contact", "step"]
"""


class Claims(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "claims").mkdir()
        self.write("claims/penetration.toml", SWEEP)
        self.claims = self.write("claims.toml", HEAD + C7)
        self.out = self.folder / "out.h5"

    def command(self, *more):
        return ["reproduce", "--claims-file", self.claims, "-o", self.out, *more]

    def again(self, verdicts):
        """What the second path says of the same file, held against the program's verdicts."""
        said = self.write("verdicts.json", verdicts)
        command = [sys.executable, "-B", HERE / "claims_again.py", self.out, "--against", said, "--organs", "sphere@12mm"]
        return subprocess.run(command, capture_output=True, text=True, timeout=120)

    def test_a_table_and_again_by_another_path(self):
        first = self.expect_done(*self.command("--quick", "--claims", "C7"))
        self.assertIn("0 from an earlier run, 96 run", first.stderr)  # 2 strategies, 2 speeds, 2 releases, 12 seeds
        self.assertRegex(first.stdout, r"(?m)^claim +place +release contact +release step +what it says")
        self.assertRegex(first.stdout, r"(?m)^C7 +Fig. 5b–d +(not reproduced|partly|reproduced) \(\d of 2\)")

        second = self.expect_done(*self.command("--quick", "--claims", "C7", "--json"))
        self.assertIn("96 from an earlier run, 0 run", second.stderr)
        (claim,) = json.loads(second.stdout)
        self.assertEqual((claim["id"], [*claim["verdicts"]]), ("C7", ["contact", "step"]))
        self.assertEqual([len(one["conditions"]) for one in claim["verdicts"].values()], [2, 2])
        self.assert_the_same_again(second.stdout)

        markdown = self.expect_done(*self.command("--quick", "--markdown")).stdout
        self.assertIn("| claim | place | release contact | release step | what it says |", markdown)

        # With cases that failed, and a value that does not exist, as well.
        with h5py.File(self.out, "r+") as file:
            cases = file["cases"]
            rapid = (cases["label"].asstr()[:] == "nearest-face") & (cases["speed"][:] == 400)
            status, volume = cases["status"].asstr()[:], cases["tool_volume_inside_d_max"][:]
            status[rapid.nonzero()[0][:9]] = "crashed"
            volume[rapid.nonzero()[0][20]] = float("nan")
            cases["status"][...], cases["tool_volume_inside_d_max"][...] = status, volume
        failed = self.expect_done(*self.command("--quick", "--json")).stdout
        self.assertEqual(json.loads(failed)[0]["verdicts"]["contact"]["conditions"][0]["failed"], 9)
        self.assert_the_same_again(failed)

        # The second path can tell a difference.
        wrong = failed.replace('"holds": false', '"holds": true', 1)
        self.assertNotEqual(wrong, failed)
        self.assertEqual(self.again(wrong).returncode, 1)
        wrong = re.sub(r'("median": -?[0-9]+)', r"\g<1>1", failed, count=1)
        self.assertNotEqual(wrong, failed)
        self.assertEqual(self.again(wrong).returncode, 1)

    def assert_the_same_again(self, verdicts):
        done = self.again(verdicts)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count(": the same"), 2, done.stdout)

    def test_mistakes_are_2(self):
        self.expect_refused('unknown claim "C77"; did you mean "C7"?', *self.command("--claims", "C77"))
        self.expect_refused("nowhere: is no folder", *self.command("--confirmation", self.folder / "nowhere"))
        (self.folder / "empty").mkdir()
        self.expect_refused("lacks koala.obj, an organ of the confirmation set", *self.command("--confirmation", self.folder / "empty"))
        self.expect_refused("none.toml: No such file", "reproduce", "--claims-file", self.folder / "none.toml")
        for whole, broken, message in (
            ("quick_seeds = 12", 'quick_seeds = "x"', "claims.toml:3:15: quick_seeds must be"),
            ("[[claim]]", "[[claim]", "claims.toml:9:"),
            ('id = "C7"', "", "claims.toml:9:1: the key id is missing"),
            ('claims/penetration.toml"]\ndata', 'claims/pen.toml"]\ndata', "pen.toml: there is no such file; claim C7 names it"),
            ('"strain"', '"strian"', 'did you mean "strain"'),
            # What the analysis finds is found before anything is run as well.
            ("times = 3", "tims = 3", "claims.toml: a condition of claim C7: no key 'tims'; did you mean 'times'?"),
            ('figure = "tool_volume_inside', 'figure = "tool_volum_inside', "tool_volum_inside_d_max is of no metric"),
        ):  # fmt: skip
            self.claims.write_text((HEAD + C7).replace(whole, broken, 1), encoding="utf-8")
            self.expect_refused(message, *self.command())
        self.assertFalse(self.out.exists())

    def test_the_same_command_goes_on_after_ctrl_c(self):
        process = subprocess.Popen([self.program, *map(str, self.command("-j", "1"))],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)  # fmt: skip
        self.assertIn("small: 112 cases", process.stderr.readline())
        self.assertIn("of 112 cases done", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        text, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, text), (130, ""), errors)
        self.assertIn("the same command goes on from here", errors)
        done = self.expect_done(*self.command("-j", "1"))
        kept, ran = map(int, re.search(r"small: (\d+) from an earlier run, (\d+) run", done.stderr).groups())
        self.assertGreater(kept, 0)
        self.assertGreater(ran, 0)
        self.assertEqual(kept + ran, 112)
        self.assertIn("C7", done.stdout)


if __name__ == "__main__":
    run_tests()
