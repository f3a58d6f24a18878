"""The colours and line widths that all figures share."""

ORGAN = "#dd9482"  # outer surface
ORGAN_INSIDE = "#a9584d"  # the same seen from inside
ORGAN_SECTION = "#f6d9cf"  # cut through the organ
ORGAN_OUTLINE = "#8a4036"
TOOL = "#5f88ad"  # steel
TOOL_OPACITY = 0.3
TOOL_OUTLINE = "#274a68"
PENETRATION = "#dc1f2a"  # organ inside the tool, in section
FACET_IN_TOOL = "#ff6a5e"  # organ facets inside or across the tool
FACET_IN_TOOL_DARK = "#a3001b"  # the same where there is no red section beside it: darker than the organ for the colour-blind
DISPLACEMENT = "#161b26"
CROSSING = "#ffd400"  # displacements that cross each other
INK = "#1d2330"  # text
FAINT_INK = "#626a76"
BACKGROUND = "#f4f6f8"  # of a panel

# Lines of a diagram that differ in kind; told apart by the colour-blind too (Okabe and Ito), and by their dashes.
SERIES = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00", "#56b4e9")
DASHES = ("solid", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (5, 1.2, 1.2, 1.2)))
MARKERS = ("o", "s", "^", "D", "v", "P")  # of measured points: they tell lines apart in grey, too

OUTLINE_WIDTH = 1.1  # points
ARROW_WIDTH = 0.9  # points
SERIES_WIDTH = 1.5  # points: a line of a diagram
INTERVAL_WIDTH = 1.1  # points: the bar of an interval

# Matplotlib's settings for every figure.
STYLE = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9,
    "text.color": INK,
    "savefig.facecolor": "white",
    "svg.hashsalt": "trocar",  # the same picture gives the same file
}


def series(number: int) -> str:
    """The colour of a diagram's line; they repeat where there are many."""
    return SERIES[number % len(SERIES)]


def dashes(number: int) -> str | tuple:
    """Its dashes."""
    return DASHES[number % len(DASHES)]


def marker(number: int) -> str:
    """The mark of its points."""
    return MARKERS[number % len(MARKERS)]
