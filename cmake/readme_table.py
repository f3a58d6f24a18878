"""readme_table.py README TABLE [--check]: puts a Markdown table between the README's lines `<!-- table -->`, or says
whether it is there (exit code 1 when it is not)."""

import pathlib
import sys

MARK = "<!-- table -->\n"


def main():
    readme, table = (pathlib.Path(name) for name in sys.argv[1:3])
    text = readme.read_text(encoding="utf-8")
    before, _, after = text.split(MARK)
    right = before + MARK + table.read_text(encoding="utf-8") + MARK + after
    if "--check" not in sys.argv[3:]:
        readme.write_text(right, encoding="utf-8")
    elif text != right:
        sys.exit(f"{readme}: its table is not that of {table}; run `make figures`")


if __name__ == "__main__":
    main()
