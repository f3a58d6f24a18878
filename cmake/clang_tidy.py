"""Runs clang-tidy on the sources of a build folder and remembers which were clean.

A source is checked again when it, a header of ours that it includes, its compile command, a .clang-tidy that it is
under or the version of clang-tidy changed. Stamps of clean sources lie in build/lint/.
"""

import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import shlex
import subprocess
import sys
import time

CLANG_TIDY = "clang-tidy-22"
ROOT = pathlib.Path(__file__).resolve().parent.parent
STAMPS = ROOT / "build" / "lint"


def own_files(entry):
    """Every file of ours that a finding in a source depends on: itself, what it includes, its .clang-tidy files."""
    command = shlex.split(entry["command"])
    compiler = next(i for i, word in enumerate(command) if not word.endswith("ccache"))
    end = command.index("-o")
    answer = subprocess.run([*command[compiler:end], "-MM", entry["file"]], cwd=entry["directory"],
                            capture_output=True, text=True)
    if answer.returncode != 0:
        sys.exit(answer.stderr)
    rule = answer.stdout.replace("\\\n", " ").split(":", 1)[1]
    files = {pathlib.Path(entry["directory"], name).resolve() for name in shlex.split(rule)}
    files |= {folder / ".clang-tidy" for folder in pathlib.Path(entry["file"]).parents}
    return sorted(file for file in files if file.is_relative_to(ROOT) and file.exists())


def stamp_of(entry, version):
    digest = hashlib.sha256(version + entry["command"].encode())
    for file in own_files(entry):
        digest.update(str(file).encode() + b"\0" + file.read_bytes())
    return STAMPS / digest.hexdigest()


def check(entry, build, version):
    stamp = stamp_of(entry, version)
    name = pathlib.Path(entry["file"]).relative_to(ROOT)
    if stamp.exists():
        return True
    started = time.monotonic()
    answer = subprocess.run([CLANG_TIDY, "--quiet", "-p", build, entry["file"]], capture_output=True, text=True)
    clean = answer.returncode == 0
    print(f"{name}: {'clean' if clean else 'not clean'} ({time.monotonic() - started:.0f} s)", flush=True)
    if clean:
        stamp.touch()
    else:
        print(answer.stdout, answer.stderr, flush=True)
    return clean


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", help="folder with compile_commands.json")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()

    build = pathlib.Path(arguments.build).resolve()
    entries = json.loads((build / "compile_commands.json").read_text())
    entries = [entry for entry in entries if not pathlib.Path(entry["file"]).is_relative_to(build)]  # generated
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    STAMPS.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        clean = list(pool.map(lambda entry: check(entry, build, version), entries))
    print(f"clang-tidy: {clean.count(True)} of {len(clean)} sources are clean")
    return 0 if all(clean) else 1


if __name__ == "__main__":
    sys.exit(main())
