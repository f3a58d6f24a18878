"""What users are told when something they gave does not work."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

SHOWN = 12  # names that an error lists at most


class InputError(Exception):
    """Bad usage or input. Its message is one line: what was expected, what was found, what to do."""


def unknown(kind: str, given: str, known: Iterable[str]) -> InputError:
    """The error for a name that does not exist, with the nearest right one or the first few there are."""
    names = sorted(set(known))
    nearest = difflib.get_close_matches(given, names, n=1, cutoff=0.5)
    few = ", ".join(names[:SHOWN]) + (", …" if len(names) > SHOWN else "")
    hint = f"did you mean '{nearest[0]}'?" if nearest else f"there are: {few or 'none'}"
    return InputError(f"no {kind} '{given}'; {hint}")
