"""The command line of `export`."""

from __future__ import annotations

import argparse

FORMATS = ("obj", "ply", "vtp")
MOMENTS = ("found", "handled", "deformed")


def add(commands: argparse._SubParsersAction) -> None:
    export = commands.add_parser("export", help="a recorded case as meshes for other programs")
    export.add_argument("file", help="result file of a run with --replay")
    export.add_argument("--case", required=True, metavar="ID", help="case id, or an unambiguous beginning")
    export.add_argument("-o", "--output", required=True, metavar="FOLDER", help="made where it is missing")
    export.add_argument("--format", action="append", choices=FORMATS, help="may be given several times; default: all")
    export.add_argument(
        "--moment", action="append", choices=MOMENTS,
        help="before handling, after it, or after the deformation; may be given several times; default: deformed",
    )  # fmt: skip
    export.add_argument("--steps", metavar="A:B", help="from step A to before step B, from 0; default: all")
    export.set_defaults(function=run)


def run(arguments: argparse.Namespace) -> None:
    from .export import Wishes, export_case

    a = arguments
    formats = [name for name in FORMATS if name in (a.format or FORMATS)]
    moments = [name for name in MOMENTS if name in (a.moment or ("deformed",))]
    print(export_case(a.file, a.output, Wishes(a.case, formats, moments, a.steps)))
