"""benchmark_tables.py FOLDER: what the benchmarks' JSON files of a folder say, as Markdown tables. Figures are medians of the
repetitions."""

import json
import pathlib
import sys

TIMES = ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))


def time(seconds):
    scale, unit = next((one for one in TIMES if seconds >= one[0]), TIMES[-1])
    return f"{seconds / scale:.3g} {unit}"


def size(count):
    for scale, unit in ((1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if count >= scale:
            return f"{count / scale:.3g} {unit}"
    return f"{count:.0f} B"


def number(value):
    return f"{value:,.0f}" if value >= 1000 else f"{value:.3g}"


def yes(value):
    return "yes" if value else "**no**"


# Of each table: the beginning of its benchmarks' names, what the rest of a name says, then columns: heading, counter, how it
# is written.
TABLES = (
    ("penetration/", ("strategy", "organ"), (
        ("cycle, median", "cycle_p50_s", time), ("99 %", "cycle_p99_s", time), ("mean", "cycle_mean_s", time),
        ("tool moves, median", "tool_moves_p50_s", time), ("detect", "detect_p50_s", time),
        ("handle, mean", "handle_mean_s", time), ("deform", "deform_p50_s", time), ("collided", "collided", number),
        ("held", "held", number), ("moving", "moving", number), ("least", "least_s", time),
        ("mean / least", "mean_over_least", number))),
    ("pivot/", ("strategy",), (
        ("cycle, median", "cycle_p50_s", time), ("99 %", "cycle_p99_s", time), ("detect, 99 %", "detect_p99_s", time),
        ("handle, 99 %", "handle_p99_s", time), ("deform, 99 %", "deform_p99_s", time), ("collided", "collided", number),
        ("handle a collided vertex", "handle_collided_s", time), ("steps", "steps", number))),
    ("bullet/", ("strategy", "organ"), (
        ("Bullet", "bullet_s", time), ("in order", "bullet_in_order_s", time), ("shuffled", "bullet_shuffled_s", time),
        ("fresh", "bullet_fresh_s", time), ("Trocar", "trocar_s", time), ("none asleep", "awake_s", time),
        ("Bullet / Trocar", "ratio", number), ("tool moves", "ratio_tool_moves", number),
        ("Bullet / none asleep", "ratio_awake", number), ("contacts, Bullet", "bullet_contacts", number),
        ("Trocar", "trocar_contacts", number), ("dent, mm, Bullet", "bullet_dent_mm", number),
        ("Trocar", "trocar_dent_mm", number), ("comparable", "comparable", yes))),
    ("fcl/", ("organ",), (
        ("FCL", "fcl_s", time), ("refit", "fcl_refit_s", time), ("collide", "fcl_collide_s", time),
        ("Trocar, detect", "trocar_s", time), ("FCL / Trocar", "ratio", number), ("facets found, FCL", "fcl_facets", number),
        ("Trocar", "trocar_facets", number), ("comparable", "comparable", yes))),
    ("cgal/", ("tool",), (
        ("facets", "tool_facets", number), ("CGAL, a point", "cgal_s", time), ("Trocar", "trocar_s", time),
        ("CGAL / Trocar", "ratio", number), ("points", "points", number), ("inside", "inside", number),
        ("disagreements", "disagreements", number))),
    ("handling/", ("tool", "strategy"), (
        ("a collided vertex", "per_vertex_s", time), ("collided", "collided", number),
        ("facets of the tool", "tool_facets", number), ("convex", "convex", lambda value: "yes" if value else "no"))),
    ("fuzzy/", ("what",), (("a facet", "per_facet", time), ("fuzzylite / inference", "ratio", number))),
    ("start/", ("facets, about",), (
        ("all", "real_time_s", time), ("organ", "organ_s", time), ("scene", "scene_s", time), ("cycle", "cycle_s", time),
        ("peak memory", "peak_B", size), ("file", "file_B", size))),
)


def read(folder):
    contexts, medians = {}, {}
    for path in sorted(folder.glob("*_benchmark.json")):
        content = json.loads(path.read_text(encoding="utf-8"))
        contexts[path.stem] = content["context"]
        for run in content["benchmarks"]:
            if run.get("aggregate_name") == "median":
                medians[run["run_name"]] = {**run, "real_time_s": run["real_time"]}
    return contexts, medians


def origin(contexts):
    ways = {tuple(context.get(key, "unknown") for key in ("cpu", "compiler", "flags", "commit", "commit_is_all"))
            for context in contexts.values()}
    for cpu, compiler, flags, commit, is_all in sorted(ways):
        dirty = "" if is_all == "yes" else ", with changes"
        yield f"On {cpu}, by {compiler} with `{flags}`, commit {commit[:12]}{dirty}."
    loads = [context["load_avg"][0] for context in contexts.values() if context.get("load_avg")]
    if loads:
        cores = next(iter(contexts.values()))["num_cpus"]
        yield f"When the programs began, {min(loads):.1f} to {max(loads):.1f} processes were ready to run on {cores} cores."


def table(beginning, names, columns, medians):
    rows = []
    for run, figures in medians.items():
        if run.startswith(beginning):
            parts = run.removeprefix(beginning).split("/")[:len(names)]
            parts = [f"{int(part):,}" if part.isdigit() else part for part in parts]
            rows.append(parts + [write(figures[counter]) if counter in figures else "" for _, counter, write in columns])
    if not rows:
        return
    heads = [*names, *(head for head, _, _ in columns)]
    yield f"`{beginning.rstrip('/')}`"
    yield ""
    yield f"| {' | '.join(heads)} |"
    yield f"|{' --- |' * len(names)}{' ---: |' * len(columns)}"
    yield from (f"| {' | '.join(row)} |" for row in rows)
    yield ""


def main():
    contexts, medians = read(pathlib.Path(sys.argv[1]))
    if not medians:
        sys.exit(f"{sys.argv[1]}: no medians of benchmarks; `make bench` writes them to build/bench")
    print("\n".join(origin(contexts)), end="\n\n")
    for one in TABLES:
        for line in table(*one, medians):
            print(line)


if __name__ == "__main__":
    main()
