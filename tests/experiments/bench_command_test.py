"""Drives `trocar bench`: what its table holds and what it refuses. Nothing here looks at how long a step took.

/usr/bin/python3 bench_command_test.py PROGRAM
"""

import re

from program_test import ProgramTest, run_tests

PHASES = ["move", "detect", "handle", "deform", "cycle"]
STRATEGIES = ["fuzzy-per-vertex", "nearest-face", "cylinder-axis", "average-plane", "joint-vertex", "tool-facet"]

TETRAHEDRON_OFF = """OFF
4 4 0
0 0 1
2 0 -1
-1 1.7 -1
-1 -1.7 -1
3 0 1 2
3 0 2 3
3 0 3 1
3 1 3 2
"""


def blocks_of(text):
    """Of each strategy, by its name: numbers of collided vertices, times by phase, the line of budgets."""
    blocks = {}
    for block in text.split("\n\n")[1:-1]:
        lines = block.splitlines()
        name, median, most = re.fullmatch(r"(\S+); collided vertices of a step: (\d+) \(median\), (\d+) \(most\)", lines[0]).groups()
        assert lines[1].split() == ["ms", "p50", "p95", "p99", "max"], lines[1]
        times = {phase: list(map(float, numbers)) for phase, *numbers in (line.split() for line in lines[2:-1])}
        blocks[name] = (int(median), int(most)), times, lines[-1]
    return blocks


class Bench(ProgramTest):
    def test_tells_every_phase_of_every_strategy(self):
        text = self.expect_done("bench", "--organ", "sphere@4mm", "--steps", 30).stdout
        self.assertRegex(text, r"^organ sphere@4mm: \d+ vertices, \d+ facets\nstart-up: [\d.]+ s, .* peak memory so far \d+ MB\n")
        self.assertRegex(text, r"\n\npeak memory \d+ MB, with what placed the tool on the organ\n$")
        blocks = blocks_of(text)
        self.assertEqual(list(blocks), STRATEGIES)
        for name, ((median, most), times, _) in blocks.items():
            with self.subTest(name):
                self.assertLessEqual(median, most)
                self.assertGreater(most, 0)
                self.assertEqual(list(times), PHASES)
                for phase, numbers in times.items():
                    self.assertEqual(numbers, sorted(numbers), phase)
                # No phase is slower than the whole; what is printed is rounded.
                for phase in PHASES[:-1]:
                    for part, whole in zip(times[phase], times["cycle"]):
                        self.assertLessEqual(part, whole + 1e-4)

    def test_what_is_said_of_a_budget_is_what_the_cycle_took(self):
        _, times, budgets = blocks_of(self.expect_done("bench", "--organ", "sphere@10mm", "--strategy", "nearest-face").stdout)["nearest-face"]
        said = re.findall(r"(1/30 s|1/40 s|1 ms): (meets|misses), ([\d.]+) % of steps over", budgets)
        self.assertEqual([budget for budget, _, _ in said], ["1/30 s", "1/40 s", "1 ms"])
        for (_, verdict, over), limit in zip(said, (1000 / 30, 1000 / 40, 1)):
            p50, p95, p99, most = times["cycle"]
            self.assertEqual(verdict, "meets" if float(over) <= 1 else "misses")
            for at, shares_over in ((p50, 50), (p95, 5), (p99, 1), (most, 0)):
                if abs(at - limit) > 1e-3:
                    self.assertEqual(at > limit, float(over) > shares_over, (at, limit, over))

    def test_steps_are_as_many_as_asked_for(self):
        def counted(*arguments):
            text = self.expect_done("bench", "--organ", "sphere@10mm", "--strategy", "nearest-face", *arguments).stdout
            return tuple(map(int, re.search(r"\n(\d+) steps count \(entry points: (\d+)\), after a run to warm up; one thread\n", text).groups()))

        few, one = counted("--steps", 1)
        self.assertEqual(one, 1)
        steps, points = counted("--steps", few + 1)
        self.assertGreater(steps, few)
        self.assertEqual(points, 2)
        self.assertGreaterEqual(counted()[0], 300)

    def test_takes_an_organ_from_a_file(self):
        organ = self.write("tetra.off", TETRAHEDRON_OFF)
        arguments = ["--strategy", "nearest-face", "--strategy", "tool-facet", "--tool", "prism-6", "--steps", 1]
        text = self.expect_done("bench", "--organ", organ, "--size", 100, *arguments).stdout
        self.assertIn("organ tetra s100: 4 vertices, 4 facets\n", text)
        self.assertIn("tool prism-6, straight in and out at 100 mm/s\n", text)
        self.assertEqual(list(blocks_of(text)), ["nearest-face", "tool-facet"])

    def test_bad_input_is_2(self):
        broken = self.write("broken.off", TETRAHEDRON_OFF[:40])
        small = self.write("small.off", TETRAHEDRON_OFF)
        for message, *arguments in (
            ("there is no file of that name either", "--organ", self.folder / "none.off"),
            (str(broken), "--organ", broken),
            ("--size is for an organ from a mesh file", "--organ", "sphere@10mm", "--size", 10),
            ('did you mean "nearest-face"?', "--organ", "sphere@10mm", "--strategy", "nearest-fase"),
            ("prism-1", "--organ", "sphere@10mm", "--tool", "prism-1"),
            ('use a larger organ (its "size")', "--organ", small),
            ("--steps", "--steps", 0),
        ):
            with self.subTest(message):
                self.expect_refused(message, "bench", *arguments)


if __name__ == "__main__":
    run_tests()
