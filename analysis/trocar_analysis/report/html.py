"""The report's HTML file: the page's script and style, the JSON text and the blocks, all in one."""

from __future__ import annotations

import json
from pathlib import Path

from ..errors import InputError
from .blocks import Blocks

PAGE = Path(__file__).resolve().parents[2] / "page" / "dist"

TEMPLATE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; worker-src blob:">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<div id="app"><noscript>This report needs JavaScript.</noscript></div>
<script type="application/json" id="report">{report}</script>
{blocks}
<script>{script}</script>
</body>
</html>
"""


def html_text(title: str, report: dict, blocks: Blocks) -> str:
    """@param report goes into the page as JSON; NaN does not: say null instead"""
    return TEMPLATE.format(
        title=escaped(title), style=part("page.css"), report=json_in_html(report), blocks=blocks.tags(),
        script=part("page.js").replace("</script", "<\\/script"),
    )  # fmt: skip


def part(name: str) -> str:
    try:
        return (PAGE / name).read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{PAGE / name}: cannot be read; `make page` makes it") from error


def json_in_html(report: dict) -> str:
    return json.dumps(report, ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")
