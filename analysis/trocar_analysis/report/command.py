"""The command `report`."""

from __future__ import annotations

import argparse

from ..directions import directions_of

DEFAULT_BUDGET = 15  # MB


def add(commands: argparse._SubParsersAction) -> None:
    """Adds it to the commands of the program."""
    report = commands.add_parser("report", help="one HTML page that shows a result file")
    report.add_argument("file", help="result file, as `trocar run` wrote it")
    report.add_argument("-o", "--output", required=True, metavar="FILE", help="page to write, .html")
    report.add_argument(
        "--budget", type=float, default=DEFAULT_BUDGET, metavar="MB",
        help=f"largest size of the page; default: {DEFAULT_BUDGET}",
    )  # fmt: skip
    report.add_argument("--better", default="", metavar="METRIC=low|high,…", help="which way is better")
    report.add_argument("--claims", metavar="FILE", help="the claims and their conditions, TOML")
    report.add_argument("--turns", metavar="FILE", help="how far answers turn for inputs that are almost the same, CSV")
    report.set_defaults(function=run_report)


def run_report(arguments: argparse.Namespace) -> None:
    from .report import ClaimFiles, make_report

    a = arguments
    print(make_report(a.file, a.output, a.budget, directions_of(a.better), ClaimFiles(a.claims, a.turns)))
