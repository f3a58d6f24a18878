"""Makes the pages of build/docs/html with Doxygen, of every header and every Markdown file. A warning is an error, and
so is a dead link between pages.

Two kinds of warning are no errors. Members of a class without a comment of their own: `Box::size()` and
`PlacedTool::pose()` say what they are, and a comment that repeats a name is no documentation; the class has to have
one, and so has every function, type and constant outside classes. And a template's specialisations: its comment is
theirs.
"""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
OUT = ROOT / "build" / "docs"
UNTOLD = re.compile(r"warning: (Member .* of (class|struct) \S.*|Compound \S+<.*>) is not documented\.$")


def run_doxygen():
    """Doxygen's warnings."""
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"project\(trocar VERSION (\S+)", project)[1]
    subprocess.run(["doxygen", "cmake/Doxyfile"], cwd=ROOT, env={**os.environ, "TROCAR_VERSION": version}, check=True)
    return (OUT / "warnings.txt").read_text(encoding="utf-8").splitlines()


class Page(html.parser.HTMLParser):
    """Where a page's links lead, and what can be linked to in it."""

    def __init__(self, file):
        super().__init__()
        self.targets, self.anchors = set(), set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.targets.add(value)
            elif name in ("id", "name"):
                self.anchors.add(value)


def dead_links():
    folder = OUT / "html"
    pages = {file.name: Page(file) for file in folder.glob("*.html")}
    for name, page in sorted(pages.items()):
        for target in sorted(page.targets):
            link = urllib.parse.urlsplit(target)
            # Doxygen 1.9.4 links to the section of nested classes also where all of them are private.
            if link.scheme or target == "#nested-classes":
                continue
            file = urllib.parse.unquote(link.path) or name
            anchor = urllib.parse.unquote(link.fragment)
            if not (folder / file).exists() or (anchor and file in pages and anchor not in pages[file].anchors):
                yield f"{name}: dead link to {target}"


def main():
    warnings = run_doxygen()
    errors = [line for line in warnings if not UNTOLD.search(line)]
    untold = len(warnings) - len(errors)
    errors += dead_links()
    print(*errors, sep="\n", end="\n" if errors else "")
    print(f"build/docs/html/index.html: {len(errors)} errors; {untold} members of classes have no comment of their own")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
