"""Draws cases of a sweep at random, and runs one of them.

For the oracle alone; it shares nothing with the program's judge.
"""

import re
import subprocess

COUNT = 5
LINE = re.compile(
    r"(?P<id>[0-9a-f]{32})  (?P<strategy>.*), (?P<organ>[^,]*), (?P<tool>[^,]*), (?P<scene>[^,]*), "
    r"(?P<speed>[^,]*) mm/s, seed (?P<seed>\d+)"
)
RELEASES = ("contact", "step")


def list_cases(program, sweep):
    """Every case of the sweep in the program's order; the dry run does not tell the release, so each is asked for."""
    cases = []
    for release in RELEASES:
        command = [program, "run", sweep, "--dry-run", "--only", f"release={release}"]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        cases += [{**match.groupdict(), "release": release} for match in LINE.finditer(text)]
    return cases


def covers(cases):
    """Five different organs, so closed and open ones, and strategies; every scene, speed and release. A tool that
    slides turns, except on a flat sheet."""
    turning = any(case["scene"] == "sliding" and case["organ"].split("@")[0] != "sheet" for case in cases)
    wanted = {"organ": COUNT, "strategy": COUNT, "scene": 4, "speed": 3, "release": len(RELEASES)}
    return turning and all(len({case[key] for case in cases}) == count for key, count in wanted.items())


def draw_cases(cases, generator):
    """The first of many draws of five among all cases that covers what it should."""
    while True:
        drawn = [cases[index] for index in generator.choice(len(cases), COUNT, replace=False, shuffle=False)]
        if covers(drawn):
            return drawn


def run_case(program, sweep, case, out):
    command = [program, "run", sweep, "-o", out, "--replay", "--jobs", "1"]
    for key in ("strategy", "organ", "tool", "scene", "speed", "seed", "release"):
        command += ["--only", f"{key}={case[key]}"]
    subprocess.run(command, capture_output=True, text=True, check=True)

