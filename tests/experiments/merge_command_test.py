"""`trocar run --shard` and `trocar merge`: the parts of a sweep make the whole again.

/usr/bin/python3 merge_command_test.py PROGRAM
"""

import os
import shutil

import h5py

from program_test import ProgramTest, run_tests

SWEEP = """name = "small"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@12mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400, 800]
seeds = 3
"""

VARYING = ("wall_s", "attempts", "provenance_row")  # and times


def text(values):
    return [value.decode() if isinstance(value, bytes) else value for value in values]


class MergeCommand(ProgramTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("sweep.toml", SWEEP)
        self.whole = self.folder / "whole.h5"
        self.merged = self.folder / "merged.h5"

    def run_shard(self, number, count, *more):
        out = self.folder / f"shard{number}.h5"
        self.expect_done("run", self.sweep, "-o", out, "--shard", f"{number}/{count}", *more)
        return out

    def column(self, path, name):
        with h5py.File(path) as file:
            return text(file[f"cases/{name}"][()])

    def contents(self, path):
        """All that a result file says of its cases, but for what differs from run to run."""
        with h5py.File(path) as file:
            found = {}
            file["series"].visititems(lambda name, item: found.update({name: item}) if hasattr(item, "dtype") else None)
            series = {name: item[()].tobytes() for name, item in found.items() if "/time_" not in name}
            cases = {name: item[()].tolist() for name, item in file["cases"].items()
                     if not name.startswith("time_") and name not in VARYING}  # fmt: skip
        return series, repr(cases)

    # Shards

    def test_shards_are_disjoint_balanced_and_hold_whole_scenes(self):
        ids, scenes = [], []
        for number in (1, 2, 3, 4):
            out = self.run_shard(number, 4)
            ids += self.column(out, "case_id")
            scenes.append(set(zip(self.column(out, "speed"), self.column(out, "seed"))))
            self.assertIn(len(self.column(out, "case_id")), (2, 4))  # 6 scenes of 2 cases
        self.assertEqual(len(ids), 12)
        self.assertEqual(len(set(ids)), 12)
        self.assertEqual(sum(map(len, scenes)), 6)

    def test_a_dry_run_shows_the_shard(self):
        self.assertIn("shard 2/3: 4 cases, 4 of them to run",
                      self.expect_done("run", self.sweep, "--shard", "2/3", "--dry-run").stdout)  # fmt: skip

    def test_bad_shards_are_2(self):
        for bad in ("0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1 /2", "99999999999999999999/1"):
            self.expect_refused("expected i/n with 1 ≤ i ≤ n", "run", self.sweep, "-o", self.whole, f"--shard={bad}")
        self.expect_refused("at most 6 shards", "run", self.sweep, "-o", self.whole, "--shard", "7/7")
        self.assertFalse(self.whole.exists())

    # Merging

    def test_merged_shards_are_what_one_run_leaves(self):
        shards = [self.run_shard(number, 3) for number in (1, 2, 3)]
        self.expect_done("run", self.sweep, "-o", self.whole)
        text = self.expect_done("merge", shards[2], shards[0], shards[1], "-o", self.merged).stdout
        self.assertIn("12 cases from 3 files: 12 complete", text)
        self.assertEqual(self.contents(self.merged), self.contents(self.whole))
        again = self.expect_done("merge", self.folder / "shard1.h5", *shards, self.merged, "-o", self.merged).stdout
        self.assertIn("12 results were left out", again)
        self.assertEqual(self.contents(self.merged), self.contents(self.whole))
        self.assertIn("0 run in", self.expect_done("run", self.sweep, "-o", self.merged).stdout)

    def test_missing_cases_are_3_and_run_goes_on_from_there(self):
        result = self.run_program("merge", self.run_shard(1, 3), "-o", self.merged)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("8 of the sweep's 12 cases are missing", result.stdout)
        self.assertIn("4 from an earlier run, 8 run", self.expect_done("run", self.sweep, "-o", self.merged).stdout)

    def test_a_complete_result_is_not_replaced_by_less(self):
        self.expect_done("run", self.sweep, "-o", self.whole)
        less, newest = self.folder / "less.h5", ["2100-01-01T00:00:00Z"]
        self.expect_done("run", self.sweep, "-o", less, "--metrics", "depth_max")
        with h5py.File(less, "r+") as file:
            file["cases/status"][3] = "crashed"
            file["provenance/end"][...] = newest * len(file["provenance/end"])
        for inputs in ((less, self.whole), (self.whole, less)):
            self.expect_done("merge", *inputs, "-o", self.merged)
            self.assertEqual(self.contents(self.merged), self.contents(self.whole))
            self.merged.unlink()

    def test_tables_only_leaves_out_series_and_can_be_made_whole(self):
        tables = self.folder / "tables.h5"
        self.expect_done("run", self.sweep, "-o", self.whole, "--replay")
        self.expect_done("merge", self.whole, "-o", tables, "--tables-only")
        with h5py.File(tables) as file:
            self.assertEqual((len(file["series"]), len(file["replay"]), len(file["cases/case_id"])), (0, 0, 12))
        self.assertEqual(self.contents(tables)[1], self.contents(self.whole)[1])
        for command in ("show", "compare"):
            files = [tables] if command == "show" else [tables, self.whole]
            self.assertIn("nearest-face", self.expect_done(command, *files).stdout)

        # Of two results of one run the whole one is taken, and none is ever replaced by less.
        for inputs in ((tables, self.whole), (self.whole, tables)):
            self.expect_done("merge", *inputs, "-o", self.merged)
            self.assertEqual(self.contents(self.merged), self.contents(self.whole))
        for more in ((self.whole, "-o", self.whole, "--tables-only"), (tables, "-o", self.whole)):
            self.expect_refused("holds the series of 12 cases, which would be lost", "merge", *more)

        self.assertIn("0 from an earlier run, 12 run", self.expect_done("run", self.sweep, "-o", tables).stdout)
        self.assertEqual(self.contents(tables), self.contents(self.whole))

    def test_a_folder_of_parts_is_merged(self):
        parts = self.folder / "results"
        parts.mkdir()
        for number in (1, 2):
            shutil.move(self.run_shard(number, 2), parts)
        (parts / "notes.txt").write_text("not a result")
        self.expect_done("merge", parts, "-o", self.merged)
        self.assertEqual(len(self.column(self.merged, "case_id")), 12)

    def test_of_a_case_in_two_files_the_newer_is_taken(self):
        one, two = self.run_shard(1, 2), self.folder / "two.h5"
        shutil.copy(one, two)
        with h5py.File(one, "r+") as file:
            file["provenance/end"][...] = ["2009-11-05T12:00:00Z"] * len(file["provenance/end"])
            file["cases/build_id"][...] = ["old"] * len(file["cases/build_id"])
        self.run_program("merge", two, one, "-o", self.merged)
        self.assertNotIn("old", self.column(self.merged, "build_id"))
        self.assertEqual(len(self.column(self.merged, "case_id")), 6)

    def test_programs_and_machines_that_differ_are_told(self):
        one, two = self.run_shard(1, 2), self.run_shard(2, 2)
        self.assertNotIn("warning", self.expect_done("merge", one, two, "-o", self.merged).stderr)
        with h5py.File(one, "r+") as file:
            file["cases/build_id"][...] = ["another"] * len(file["cases/build_id"])
            file["provenance/host"][...] = ["elsewhere"] * len(file["provenance/host"])
        errors = self.expect_done("merge", one, two, "-o", self.merged).stderr
        self.assertRegex(errors, "2 programs .*6 of another.*not comparable")
        self.assertRegex(errors, "2 machines .*6 of elsewhere")

    def test_a_case_that_did_not_complete_is_3(self):
        one, two = self.run_shard(1, 2), self.run_shard(2, 2)
        with h5py.File(two, "r+") as file:
            file["cases/status"][0] = "crashed"
        result = self.run_program("merge", one, two, "-o", self.merged)
        self.assertEqual(result.returncode, 3)
        self.assertIn("11 complete, 1 crashed", result.stdout)

    def test_what_does_not_belong_together_is_refused_by_name(self):
        one = self.run_shard(1, 2)
        self.sweep.write_text(SWEEP.replace("small", "other"))
        other = self.folder / "other.h5"
        self.expect_done("run", self.sweep, "-o", other, "--only", "seed=1")
        self.expect_refused("other.h5: comes from another sweep than", "merge", one, other, "-o", self.merged)
        with h5py.File(one, "r+") as file:
            file.attrs.modify("schema_version", 99)
        self.expect_refused("shard1.h5: has schema version 99", "merge", other, one, "-o", self.merged)
        self.expect_refused("none.h5: No such file", "merge", self.folder / "none.h5", "-o", self.merged)
        self.expect_refused("is not whole", "merge", self.unfinished(other), "-o", self.merged)
        (self.folder / "empty").mkdir()
        self.expect_refused("holds no result file", "merge", self.folder / "empty", "-o", self.merged)
        self.assertFalse(self.merged.exists())

    def unfinished(self, path):
        copy = self.folder / "unfinished.h5"
        shutil.copy(path, copy)
        with h5py.File(copy, "r+") as file:
            del file.attrs["complete"]
        return copy

    def test_a_sweep_whose_mesh_changed_is_another_one(self):
        one, two = self.run_shard(1, 2), self.run_shard(2, 2)
        with h5py.File(two, "r+") as file:
            del file.attrs["sweep_case_ids_hash"]
            file.attrs["sweep_case_ids_hash"] = "another"
        self.expect_refused("shard2.h5: a mesh, rule or motion file", "merge", one, two, "-o", self.merged)

    def test_an_output_that_would_lose_cases_is_left_alone(self):
        one, two = self.run_shard(1, 2), self.run_shard(2, 2)
        before = two.read_bytes()
        self.expect_refused("shard2.h5: holds 6 cases that no input holds", "merge", one, "-o", two)
        self.assertEqual(two.read_bytes(), before)
        self.merged.write_text("my notes")
        self.expect_refused("merged.h5", "merge", one, two, "-o", self.merged)
        self.assertEqual(self.merged.read_text(), "my notes")
        self.assertFalse(os.path.exists(f"{self.merged}.parts"))


if __name__ == "__main__":
    run_tests()
