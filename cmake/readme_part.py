"""readme_part.py README NAME FILE [--check]: puts a file between the README's lines `<!-- NAME -->`, or says whether it
is there (exit code 1 when it is not). A file that is no Markdown becomes a block of code."""

import pathlib
import sys


def main():
    readme, name, source = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    part = source.read_text(encoding="utf-8")
    if source.suffix != ".md":
        part = f"```{source.suffix[1:]}\n{part}```\n"
    mark = f"<!-- {name} -->\n"
    text = readme.read_text(encoding="utf-8")
    before, _, after = text.split(mark)
    right = before + mark + part + mark + after
    if "--check" not in sys.argv[4:]:
        readme.write_text(right, encoding="utf-8")
    elif text != right:
        sys.exit(f"{readme}: its part `{name}` is not {source}; to put it there: "
                 f"{sys.argv[0]} {readme} {name} {source}")


if __name__ == "__main__":
    main()
