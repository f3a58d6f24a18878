"""`figures` on the command line."""

from __future__ import annotations

import argparse

from ..directions import directions_of


def add(commands: argparse._SubParsersAction) -> None:
    command = commands.add_parser("figures", help="diagrams, LaTeX tables and captions for a paper, into a folder")
    command.add_argument("file", help="result file")
    command.add_argument("-o", "--output", required=True, metavar="DIR", help="folder; made where it is missing")
    command.add_argument(
        "--only", action="append", default=[], metavar="KEY=VALUE",
        help="these cases only; values of one key are alternatives; may be given several times",
    )  # fmt: skip
    command.add_argument(
        "--metric", action="append", metavar="NAME",
        help="a column, a metric (all its columns) or a quotient of two columns, A/B; may be given several times; "
        "default: the main ones that the file has",
    )  # fmt: skip
    command.add_argument("--better", default="", metavar="METRIC=low|high,…", help="which way is better")
    command.set_defaults(function=run)


def run(arguments: argparse.Namespace) -> None:
    from .publish import Wishes, publish

    a = arguments
    for line in publish(a.file, a.output, Wishes(a.metric, a.only, directions_of(a.better))):
        print(line)
