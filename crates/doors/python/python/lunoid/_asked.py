"""Arguments of calls: what cannot be one is refused as every other fault is."""

from __future__ import annotations

import math
import numbers
import operator
import os
from collections.abc import Iterable, Mapping, Set
from typing import Any

from ._errors import InputError, refused

MOST = 2**32 - 1
"""Largest number of a frame, a sweep or a pixel."""


_MOST_SHOWN = 80
"""Most characters of a value that a message shows."""


def shown(value: object) -> str:
    """A value in a message."""
    try:
        text = repr(value)
    except ValueError:
        text = "a number of too many digits"
    return text if len(text) <= _MOST_SHOWN else text[:_MOST_SHOWN] + "..."


def _wrong(file: str, name: str, value: object, expected: str) -> InputError:
    return refused(file, f"`{name}` is {shown(value)}", found=shown(value), expected=expected)


def counted(file: str, name: str, value: object, *, least: int = 0, most: int = MOST) -> int:
    """A whole number from ``least`` to ``most``."""
    try:
        number = least - 1 if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        number = least - 1
    if not least <= number <= most:
        title = f"{name} {shown(value)}"
        raise refused(file, title, found=shown(value), expected=f"a whole number from {least} to {most}")
    return number


def real(file: str, name: str, value: object) -> float:
    """A finite number."""
    single = value.item() if getattr(value, "ndim", None) == 0 and hasattr(value, "item") else value
    try:
        number = float(single) if isinstance(single, numbers.Real) and not isinstance(single, bool) else math.nan
    except OverflowError:
        number = math.nan
    if not math.isfinite(number):
        raise _wrong(file, name, value, "a finite number")
    return number


def flag(file: str, name: str, value: object) -> bool:
    """True or False."""
    if not isinstance(value, bool):
        raise _wrong(file, name, value, "True or False")
    return value


def _is_text(value: str) -> bool:
    """Whether a text is one that files and commands can have."""
    return value != "" and "\0" not in value and not any("\ud800" <= letter <= "\udfff" for letter in value)


def path(file: str, name: str, value: object) -> str:
    """Name of a file or a folder."""
    try:
        found = os.fsdecode(value)  # type: ignore[arg-type]
    except TypeError:
        found = ""
    if not _is_text(found):
        raise _wrong(file, name, value, "a path")
    return found


def word(file: str, name: str, value: object, among: tuple[str, ...] = ()) -> str:
    """A text; one of ``among``, where there are any."""
    if not isinstance(value, str) or not _is_text(value) or (among and value not in among):
        raise _wrong(file, name, value, f"one of {', '.join(among)}" if among else "a text")
    return value


def listed(file: str, name: str, values: object) -> list[Any]:
    """Several values in an order; a single text is none."""
    if isinstance(values, str | bytes | Mapping | Set) or not isinstance(values, Iterable):
        raise _wrong(file, name, values, "a list")
    return list(values)


def keyed(file: str, name: str, values: object) -> list[tuple[str, Any]]:
    """Keys with their values; none if it is None."""
    if values is None:
        return []
    if not isinstance(values, Mapping):
        raise _wrong(file, name, values, 'a dictionary, as {"loader.access_ns": 90}')
    return [(word(file, name, key), value) for key, value in values.items()]


def process() -> int:
    """The process that runs this."""
    return os.getpid()


def same_process(file: str, what: str, made_in: int) -> None:
    """Sees that a drive or a loop is used in the process that made it: a fork has none of its threads, and would wait for them for ever."""
    if os.getpid() != made_in:
        title = f"this {what} belongs to process {made_in}, and this is process {os.getpid()}"
        help = "open the scenario in the child, or start workers by `spawn`"
        raise refused(file, title, found=os.getpid(), expected=f"process {made_in}", help=help)
