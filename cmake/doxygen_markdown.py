"""doxygen_markdown.py FILE: a Markdown file as Doxygen 1.9 understands it; Doxygen calls it for every page.

GitHub resolves a link from the folder that the file lies in. Doxygen takes the first file of that name, of which there
are many README.md, and knows no anchors of headings. So every heading gets a label that is made of the file's path and
the heading's words, and links to Markdown files become references to labels; links to other files become plain
text; and images are named from the top folder. Doxygen also leaves links alone whose target has neither a dot nor a slash, and shows the backticks of a
reference's text.
"""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPIED = ("LICENSE", "CITATION.cff", "references.bib")  # HTML_EXTRA_FILES of the Doxyfile


def label(path, heading=""):
    """Of a page or, with the anchor that GitHub makes of a heading, of a section."""
    return re.sub(r"\W", "_", f"{path.with_suffix('')}#{heading}" if heading else str(path.with_suffix("")))


def anchor(heading):
    return re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")


def link(page, match):
    text, target = match.groups()
    if re.match(r"\w+:", target):
        return match.group()
    file, _, heading = target.partition("#")
    place = pathlib.Path(os.path.relpath(ROOT / page.parent / file if file else ROOT / page, ROOT))
    if (ROOT / place).is_dir() and (ROOT / place / "README.md").exists():
        place /= "README.md"
    if place.suffix == ".md":
        return f"[{' '.join(text.replace('`', '').split())}](@ref {label(place, heading)})"
    return f"[{text}](./{place})" if str(place) in COPIED or not (ROOT / place).exists() else text


def image(page, match):
    """Doxygen looks for images from the top folder."""
    text, target = match.groups()
    return match[0] if re.match(r"\w+:", target) else f"![{text}]({os.path.relpath(ROOT / page.parent / target, ROOT)})"


def translate(page, text):
    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)  # every second one is code
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"!\[([^][]*)\]\(([^() ]*)\)", lambda match: image(page, match), parts[i])
        parts[i] = re.sub(r"(?<!!)\[([^][]*)\]\(([^() ]*)\)", lambda match: link(page, match), parts[i])
        parts[i] = re.sub(r"^(#+ )(.*)$", lambda match: f"{match[0]} {{#{label(page, anchor(match[2]))}}}", parts[i],
                          flags=re.MULTILINE)
    # The first heading is the page's; a page that is a table alone has none.
    if not re.search(r"^# ", "".join(parts[::2]), flags=re.MULTILINE):
        parts.insert(0, f"# {page.stem.replace('_', ' ').capitalize()} {{#{label(page)}}}\n\n")
    return re.sub(r" \{#\w+\}$", f" {{#{label(page)}}}", "".join(parts), count=1, flags=re.MULTILINE)


if __name__ == "__main__":
    file = pathlib.Path(sys.argv[1]).resolve()
    print(translate(file.relative_to(ROOT), file.read_text(encoding="utf-8")), end="")
