"""The command line: `/usr/bin/python3 -m trocar_analysis show|compare|sensitivity|rank|front|… …`. Exit code 0 when
done, 1 when `compare` found what it should fail on, 2 for bad usage or input, with one line on stderr that says what
is wrong, 3 for a bug in here, with the traceback on stderr."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import traceback
from collections.abc import Callable

from .directions import directions_of
from .errors import InputError
from .export import command as export_command
from .publication import command as publication_command
from .report import command as report_command

# Where the modules that Debian packages separately come from.
DEBIAN_PACKAGES = {name: f"python3-{name}" for name in ("numpy", "h5py", "pandas", "scipy", "matplotlib")}
DEBIAN_PACKAGES["PIL"] = "python3-pil"


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:
        raise InputError(f"{message} (see {self.prog} --help)")


def make_parser() -> argparse.ArgumentParser:
    parser = Parser(prog="trocar", description="Looks at a result file.")
    names = "show|compare|sensitivity|rank|front|claims|snapshot|figure|figures|report|export|scene|metrics|rules"
    commands = parser.add_subparsers(dest="command", required=True, metavar=names)

    show = commands.add_parser("show", help="a table of what the file holds")
    show.add_argument("file", help="result file, as `trocar run` wrote it")
    subject = show.add_mutually_exclusive_group()
    subject.add_argument("--each", action="store_true", help="one row per case, as CSV in full precision")
    subject.add_argument("--failures", action="store_true", help="the cases that did not complete, one a line")
    subject.add_argument(
        "--provenance", action="store_true", help="which programs on which machines the cases come from"
    )
    subject.add_argument(
        "--states", action="store_true",
        help="the same-state comparison: label and strategy are those that answered, run_label and "
        "run_strategy those in whose run the state was found",
    )  # fmt: skip
    show.add_argument(
        "--only", action="append", default=[], metavar="KEY=VALUE",
        help="these rows only; values of one key are alternatives; may be given several times",
    )  # fmt: skip
    show.add_argument(
        "--by", metavar="COLUMN,…", help="columns or options of strategies to group by; default: what differs"
    )
    show.add_argument(
        "--metric", action="append", metavar="NAME",
        help="a column, or a metric: then all its columns; may be given several times",
    )  # fmt: skip
    style = show.add_mutually_exclusive_group()
    style.add_argument("--csv", action="store_true", help="a tidy table in full precision")
    style.add_argument("--markdown", action="store_true", help="a Markdown table")
    show.set_defaults(function=run_show)

    comparison = commands.add_parser("compare", help="what changed from one file to another, case by case")
    comparison.add_argument("a", metavar="A", help="result file")
    comparison.add_argument("b", metavar="B", help="result file of the same sweep, of another program for example")
    comparison.add_argument(
        "--only", action="append", default=[], metavar="KEY=VALUE",
        help="these cases only; values of one key are alternatives; may be given several times",
    )  # fmt: skip
    comparison.add_argument(
        "--by", metavar="COLUMN,…", help="inputs or options of strategies to group by; default: label"
    )
    comparison.add_argument(
        "--metric", action="append", metavar="NAME",
        help="a column, or a metric: then all its columns; may be given several times",
    )  # fmt: skip
    comparison.add_argument(
        "--fail-on", action="append", default=[], metavar="CONDITION",
        help='such as "depth_max_d_max > +5%%", or outcomes; may be given several times',
    )  # fmt: skip
    comparison.add_argument(
        "--better", default="", metavar="METRIC=low|high,…", help="which way is better; others are not judged"
    )
    style = comparison.add_mutually_exclusive_group()
    style.add_argument("--csv", action="store_true", help="a tidy table in full precision")
    style.add_argument("--markdown", action="store_true", help="a Markdown table")
    comparison.set_defaults(function=run_compare)

    sensitivity = commands.add_parser("sensitivity", help="figures over the values of one condition, as a picture")
    sensitivity.add_argument("file", help="result file")
    sensitivity.add_argument("--over", required=True, metavar="COLUMN", help="the condition along x, such as speed")
    sensitivity.add_argument(
        "-o", "--output", action="append", required=True, metavar="FILE",
        help="picture: .png or .svg; may be given several times",
    )  # fmt: skip
    sensitivity.add_argument(
        "--only", action="append", default=[], metavar="KEY=VALUE",
        help="these cases only; values of one key are alternatives; may be given several times",
    )  # fmt: skip
    sensitivity.add_argument(
        "--metric", action="append", metavar="NAME",
        help="a column, a metric (all its columns) or a quotient of two columns, A/B; may be given several times",
    )  # fmt: skip
    sensitivity.add_argument("--better", default="", metavar="METRIC=low|high,…", help="which way is better")
    style = sensitivity.add_mutually_exclusive_group()
    style.add_argument("--csv", action="store_true", help="print what is drawn, in full precision")
    style.add_argument("--markdown", action="store_true", help="print what is drawn as a Markdown table")
    sensitivity.set_defaults(function=run_sensitivity)

    rank = commands.add_parser("rank", help="which strategies do better by one figure, and which are not told apart")
    add_of_one_file(rank)
    rank.set_defaults(function=run_rank)

    front = commands.add_parser("front", help="the Pareto front of two figures, as a picture")
    add_of_one_file(front)
    front.add_argument("--against", required=True, metavar="NAME", help="the other figure, along x")
    front.set_defaults(function=run_front)

    claims = commands.add_parser("claims", help="the paper's claims, judged on a result file")
    claims.add_argument("claims", help="the claims and their conditions, TOML")
    claims.add_argument("file", nargs="?", help="result file, as `trocar reproduce` wrote it")
    claims.add_argument("--check", action="store_true", help="only read the claims: is anything wrong with them?")
    claims.add_argument("--turns", metavar="FILE", help="how far answers turn for inputs that are almost the same, CSV")
    claims.add_argument("--only", metavar="ID,…", help="these claims only")
    claims.add_argument("--better", default="", metavar="METRIC=low|high,…", help="which way is better")
    style = claims.add_mutually_exclusive_group()
    style.add_argument("--json", action="store_true", help="every number, in full precision and the stored unit")
    style.add_argument("--markdown", action="store_true", help="Markdown")
    claims.set_defaults(function=run_claims)

    snapshot = commands.add_parser("snapshot", help="a picture of one step, strategies side by side")
    snapshot.add_argument("file", help="result file of a run with --replay")
    snapshot.add_argument(
        "--case", metavar="ID",
        help="case id, or an unambiguous beginning; needed where replays of several conditions are in the file",
    )  # fmt: skip
    snapshot.add_argument(
        "--step", default="deepest", metavar="K", help="from 0, or -1, -2, … from the end; default: deepest"
    )
    snapshot.add_argument("-o", "--output", required=True, metavar="FILE", help="picture: .png or .svg")
    snapshot.add_argument("--alone", action="store_true", help="this case only, without the other strategies")
    snapshot.add_argument(
        "--moment", choices=("found", "handled", "deformed"), default="handled",
        help="before handling, after it, or after the deformation; default: handled",
    )  # fmt: skip
    snapshot.set_defaults(function=run_snapshot)

    figure = commands.add_parser("figure", help="steps of cases side by side, as a file describes")
    figure.add_argument("file", help="result file of a run with --replay")
    figure.add_argument("--panels", required=True, metavar="FILE", help="description of the figure, TOML")
    figure.add_argument("-o", "--output", required=True, metavar="FILE", help="picture: .png or .svg")
    figure.set_defaults(function=run_figure)

    scene = commands.add_parser("scene", help="a picture of a scene that `trocar snapshot --scene` has laid out")
    scene.add_argument("file", help="description of the scene, JSON")
    scene.add_argument("-o", "--output", required=True, metavar="FILE", help="picture: .png or .svg")
    scene.set_defaults(function=run_scene)

    metrics = commands.add_parser("metrics", help="pictures of what `trocar snapshot --metric` has measured")
    metrics.add_argument("file", help="description of the pictures, JSON")
    metrics.set_defaults(function=run_metrics)

    rules = commands.add_parser("rules", help="pictures of the rule base that `trocar fuzzy plot` has sampled")
    rules.add_argument("file", help="description of the rule base, JSON")
    rules.set_defaults(function=run_rules)

    publication_command.add(commands)
    report_command.add(commands)
    export_command.add(commands)
    return parser


def add_of_one_file(command: Parser) -> None:
    """What `rank` and `front` both take."""
    command.add_argument("file", help="result file")
    command.add_argument("--metric", required=True, metavar="NAME", help="a column, or a quotient of two columns, A/B")
    command.add_argument(
        "-o", "--output", action="append", required=True, metavar="FILE",
        help="picture: .png or .svg; may be given several times",
    )  # fmt: skip
    command.add_argument(
        "--only", action="append", default=[], metavar="KEY=VALUE",
        help="these cases only; values of one key are alternatives; may be given several times",
    )  # fmt: skip
    command.add_argument("--better", default="", metavar="METRIC=low|high,…", help="which way is better")
    style = command.add_mutually_exclusive_group()
    style.add_argument("--csv", action="store_true", help="a tidy table in full precision")
    style.add_argument("--markdown", action="store_true", help="a Markdown table")


def run_show(arguments: argparse.Namespace) -> None:
    from .show import Wishes, show_cases, show_each, show_failures, show_provenance, show_states

    if (arguments.failures or arguments.provenance) and (arguments.by or arguments.metric):
        raise InputError("--failures and --provenance take no --by and no --metric: they show cases, not figures")
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else None
    wishes = Wishes(arguments.only, names_of(arguments.by), arguments.metric, style_of(arguments), width)
    if arguments.each and (arguments.by or arguments.markdown):
        raise InputError("--each takes no --by and no --markdown: it is one row per case, as CSV")
    chosen = {"states": show_states, "each": show_each, "failures": show_failures, "provenance": show_provenance}
    table = next((function for name, function in chosen.items() if getattr(arguments, name)), show_cases)
    sys.stdout.write(table(arguments.file, wishes))
    sys.stdout.flush()


def run_compare(arguments: argparse.Namespace) -> int:
    """1 when a condition of --fail-on is violated, 2 when one cannot be evaluated."""
    from .compare import Comparison, compare

    a = arguments
    asked = Comparison(a.only, names_of(a.by), a.metric, a.fail_on, directions_of(a.better), style_of(a))
    table, judgement = compare(a.a, a.b, asked)
    sys.stdout.write(table)
    sys.stdout.flush()
    for line in judgement.violated:
        print(f"trocar: fails on {line}", file=sys.stderr)
    for line in judgement.not_evaluated:
        print(f"trocar: cannot evaluate {line}", file=sys.stderr)
    return 2 if judgement.not_evaluated else 1 if judgement.violated else 0


def run_sensitivity(arguments: argparse.Namespace) -> None:
    from .sensitivity import Wishes, read_sweep
    from .sensitivity_plot import draw_sweep
    from .sensitivity_table import csv_text, markdown_text

    a = arguments
    sweep = read_sweep(a.file, Wishes(a.over, a.metric, a.only, directions_of(a.better)))
    draw_sweep(sweep, a.output)
    pictures = "".join(f"{file}\n" for file in a.output)
    for caution in sweep.cautions if a.csv else ():
        print(caution, file=sys.stderr)
    sys.stdout.write(csv_text(sweep) if a.csv else markdown_text(sweep) if a.markdown else pictures)
    sys.stdout.flush()


def run_rank(arguments: argparse.Namespace) -> None:
    from .rank import Wishes, csv_text, draw_ranking, markdown_text, plain_text, read_ranking

    a = arguments
    ranking = read_ranking(a.file, Wishes(a.metric, a.only, directions_of(a.better)))
    draw_ranking(ranking, a.output)
    tell(a, ranking, ranking.cautions, {"csv": csv_text, "markdown": markdown_text, "text": plain_text})


def run_front(arguments: argparse.Namespace) -> None:
    from .front import Wishes, csv_text, markdown_text, plain_text, read_front
    from .front_plot import draw_front

    a = arguments
    front = read_front(a.file, Wishes(a.metric, a.against, a.only, directions_of(a.better)))
    draw_front(front, a.output)
    tell(a, front, front.cautions, {"csv": csv_text, "markdown": markdown_text, "text": plain_text})


def tell(arguments: argparse.Namespace, found: object, cautions: list[str], texts: dict[str, Callable]) -> None:
    """Prints the table of what was drawn; a CSV has no place for the cautions."""
    for caution in cautions if arguments.csv else ():
        print(caution, file=sys.stderr)
    sys.stdout.write(texts[style_of(arguments)](found))
    sys.stdout.flush()


def run_claims(arguments: argparse.Namespace) -> None:
    from .claims.claim_file import read_claims
    from .claims.reproduce import reproduce

    a = arguments
    if a.check:
        read_claims(a.claims)
        return
    if a.file is None:
        raise InputError("the result file is missing")
    style = "json" if a.json else "markdown" if a.markdown else "text"
    sys.stdout.write(reproduce(a.claims, a.file, a.turns, names_of(a.only), directions_of(a.better), style))
    sys.stdout.flush()


def names_of(by: str | None) -> list[str] | None:
    return [name.strip() for name in by.split(",")] if by else None


def style_of(arguments: argparse.Namespace) -> str:
    return "csv" if arguments.csv else "markdown" if arguments.markdown else "text"


def run_snapshot(arguments: argparse.Namespace) -> None:
    from .snapshot import snapshot

    a = arguments
    print(snapshot(a.file, a.case, a.step, a.output, a.alone, a.moment))


def run_figure(arguments: argparse.Namespace) -> None:
    from .figures.figure import draw_figure

    print(draw_figure(arguments.file, arguments.panels, arguments.output))


def run_scene(arguments: argparse.Namespace) -> None:
    from .scene_picture import draw_scene

    print(draw_scene(arguments.file, arguments.output))


def run_metrics(arguments: argparse.Namespace) -> None:
    from .metric_picture import draw_metrics

    print(draw_metrics(arguments.file))


def run_rules(arguments: argparse.Namespace) -> None:
    from .rule_plot import draw_rules

    print(draw_rules(arguments.file))


def run() -> int:
    """Does what the command line asks for. Throws what nobody has foreseen."""
    try:
        arguments = make_parser().parse_args()
        return arguments.function(arguments) or 0
    except InputError as error:
        print(f"trocar: {error}", file=sys.stderr)
    except ModuleNotFoundError as error:
        package = DEBIAN_PACKAGES.get((error.name or "").partition(".")[0])
        if package is None:
            raise
        print(f"trocar: the analysis needs the Debian package {package}; install it", file=sys.stderr)
    except MemoryError:
        print("trocar: the memory does not suffice, or the file is damaged", file=sys.stderr)
    except BrokenPipeError:
        let_go_of_output()  # its reader (such as `head`) has seen enough
        return 0
    except OSError as error:
        if error.errno is None:  # h5py's own, of what store.py should have refused
            raise
        let_go_of_output()
        where = f"{error.filename}: " if error.filename else ""
        print(f"trocar: {where}{error.strerror}", file=sys.stderr)
    return 2


def let_go_of_output() -> None:
    """Keeps Python from complaining when, at its end, it cannot write what it still has for stdout."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def main() -> int:
    if sys.stdout is None:  # it was closed
        print("trocar: standard output is closed: nothing can be shown", file=sys.stderr)
        return 2
    sys.stdout.reconfigure(errors="replace")  # a terminal that cannot show "µ" shows "?"
    try:
        return run()
    except Exception:
        # Python's own exit code for it is 1, which says that `compare` has found something.
        traceback.print_exc()
        print(
            "trocar: this is a bug of the analysis and says nothing about the results; please report it with the "
            "lines above",
            file=sys.stderr,
        )
        return 3


if __name__ == "__main__":
    sys.exit(main())
