"""Makes deliberate errors in the metrics' code, one at a time, and sees whether a test finds each of them.

Each metric has a file here, <metric>.toml: the sources it is computed by, the tests that hold it, and at least three
mutations, a text of a source and what it is replaced by. A mutation is caught when the tests of the metrics, built with it,
fail (or do not end). What was caught is written down in caught.json with a hash of those sources, tests and mutations: a
metric is tried again when one of them has changed, or with --all.

Exit codes: 0 every mutation is caught, 1 one is not, 2 a mutation cannot be made or does not compile."""

from __future__ import annotations

import argparse
import dataclasses
import hashlib
import json
import queue
import re
import subprocess
import sys
import threading
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BOOK = HERE / "caught.json"
SOURCES = "experiments/metrics"
TESTS = "tests/experiments/metrics"
TARGET = "test_metrics"
TEST_SECONDS = 120
FEWEST = 3  # mutations of each metric
BUILD_FLAGS = [
    "-GNinja", "-DCMAKE_BUILD_TYPE=", "-DCMAKE_CXX_FLAGS=-O1", "-DTROCAR_BUILD_BENCHMARKS=OFF", "-DTROCAR_LINK_PROGRAM=OFF",
    "-DTROCAR_WARNINGS_AS_ERRORS=OFF",
]  # fmt: skip


class BadMutation(Exception):
    """A mutation that cannot be made: its text is not there exactly once, or it does not compile."""


@dataclasses.dataclass(frozen=True)
class Mutation:
    metric: str
    file: str  # of SOURCES
    what: str  # the error, in words
    old: str
    new: str

    def pattern(self) -> re.Pattern:
        """The old text, wherever its lines are broken."""
        return re.compile(r"\s+".join(map(re.escape, self.old.split())))


@dataclasses.dataclass(frozen=True)
class Metric:
    name: str
    hash: str  # of its sources, tests and mutations
    mutations: list[Mutation]


def read_metric(path: Path) -> Metric:
    text = path.read_bytes()
    table = tomllib.loads(text.decode())
    mutations = [
        Mutation(path.stem, one.get("file", table["sources"][0]), one["what"], one["old"], one["new"])
        for one in table["mutation"]
    ]
    if len(mutations) < FEWEST:
        raise BadMutation(f"{path.name}: has {len(mutations)} mutations; a metric needs {FEWEST}")
    for one in mutations:
        found = len(one.pattern().findall((ROOT / SOURCES / one.file).read_text()))
        if found != 1:
            raise BadMutation(f"{path.name}: {one.file} holds this text {found} times, not once:\n{one.old}")
    digest = hashlib.sha256(text)
    for folder, names in ((SOURCES, table["sources"]), (TESTS, table["tests"])):
        for name in names:
            digest.update((ROOT / folder / name).read_bytes())
    return Metric(path.stem, digest.hexdigest(), mutations)


def read_metrics() -> list[Metric]:
    listed = re.findall(r"^TROCAR_METRIC\((\w+)\)", (ROOT / SOURCES / "metrics.inc").read_text(), re.MULTILINE)
    missing = [name for name in listed if not (HERE / f"{name}.toml").exists()]
    if missing:
        raise BadMutation(f"no mutations for {', '.join(missing)}: write {HERE.name}/{missing[0]}.toml")
    return [read_metric(HERE / f"{name}.toml") for name in listed]


class Workshop:
    """A copy of the tree with a build of its own, in which one error at a time is made."""

    def __init__(self, folder: Path):
        self.source, self.build = folder / "source", folder / "build"
        self.copy_tree()
        self.run(["cmake", "-S", self.source, "-B", self.build, *BUILD_FLAGS])
        self.compile()
        if self.tests_fail():
            raise BadMutation("the tests of the metrics fail without any mutation")

    def copy_tree(self) -> None:
        """Files that are as they should be are left alone, and what was built of them is kept; others, such as the one
        with an error of a run that was cut off, are new, and so is what is built of them."""
        tracked = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=ROOT, check=True, capture_output=True, text=True,
        )  # fmt: skip
        wanted = {name for name in tracked.stdout.split("\0") if name and (ROOT / name).is_file()}
        for path in self.source.rglob("*"):
            if path.is_file() and str(path.relative_to(self.source)) not in wanted:
                path.unlink()
        for name in wanted:
            right, copy = (ROOT / name).read_bytes(), self.source / name
            if not copy.exists() or copy.read_bytes() != right:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(right)

    def run(self, command: list) -> None:
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise BadMutation(f"{' '.join(map(str, command))}\n{(done.stdout + done.stderr)[-3000:]}")

    def compile(self) -> None:
        self.run(["cmake", "--build", self.build, "--target", TARGET, "--parallel", "1"])

    def tests_fail(self) -> bool:
        program = self.build / TESTS / TARGET
        try:
            command = [program, "--gtest_brief=1", "--gtest_fail_fast"]
            return subprocess.run(command, capture_output=True, timeout=TEST_SECONDS).returncode != 0
        except subprocess.TimeoutExpired:
            return True

    def catches(self, mutation: Mutation) -> bool:
        file = self.source / SOURCES / mutation.file
        right = file.read_text()
        file.write_text(mutation.pattern().sub(lambda _: mutation.new, right))
        try:
            self.compile()
            return self.tests_fail()
        finally:
            file.write_text(right)


def catch_all(mutations: list[Mutation], folder: Path, jobs: int) -> list[Mutation]:
    """Those that no test finds."""
    free: queue.Queue[Workshop] = queue.Queue()
    lock = threading.Lock()
    survivors = []
    for worker in range(min(jobs, len(mutations))):
        free.put(Workshop(folder / str(worker)))

    def attempt(mutation: Mutation) -> None:
        workshop = free.get()
        try:
            caught = workshop.catches(mutation)
        finally:
            free.put(workshop)
        with lock:
            print(f"{'caught' if caught else 'NOT CAUGHT'}: {mutation.metric}: {mutation.what}", flush=True)
            if not caught:
                survivors.append(mutation)

    with ThreadPoolExecutor(jobs) as pool:
        list(pool.map(attempt, mutations))
    return survivors


def mutate(everything: bool, names: list[str], folder: Path, jobs: int) -> int:
    metrics = read_metrics()
    book = json.loads(BOOK.read_text()) if BOOK.exists() else {}
    to_try = [one for one in metrics if everything or one.name in names or book.get(one.name) != one.hash]
    if names:
        to_try = [one for one in to_try if one.name in names]
    mutations = [mutation for one in to_try for mutation in one.mutations]
    survivors = catch_all(mutations, folder, jobs) if mutations else []
    escaped = {mutation.metric for mutation in survivors}
    known = {one.name for one in metrics}
    book = {name: hash for name, hash in book.items() if name in known and name not in escaped}
    book |= {one.name: one.hash for one in to_try if one.name not in escaped}
    BOOK.write_text(json.dumps(book, indent=1, sort_keys=True) + "\n")
    total = sum(len(one.mutations) for one in metrics)
    before = total - len(mutations)
    print(f"{total - len(survivors)}/{total} mutations caught ({len(mutations)} tried now, {before} in {BOOK.name})")
    return 1 if survivors else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("metrics", nargs="*", help="only these")
    parser.add_argument("--all", action="store_true", help="also those that were caught before and have not changed")
    parser.add_argument("--folder", type=Path, default=ROOT / "build" / "mutate", help="where to build")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    try:
        return mutate(arguments.all, arguments.metrics, arguments.folder, arguments.jobs)
    except BadMutation as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
