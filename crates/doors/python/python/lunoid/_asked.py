"""Arguments of calls: what cannot be one is refused as every other fault is."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Iterable, Mapping
from typing import Any

from ._errors import refused

MOST = 2**32 - 1
"""Largest number of a frame, a sweep or a pixel."""


def counted(file: str, name: str, value: object, *, least: int = 0, most: int = MOST) -> int:
    """A whole number from ``least`` to ``most``."""
    try:
        number = least - 1 if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        number = least - 1
    if not least <= number <= most:
        expected = f"a whole number from {least}" + ("" if most == MOST else f" to {most}")
        raise refused(file, f"{name} {value!r}", found=repr(value), expected=expected)
    return number


def real(file: str, name: str, value: object) -> float:
    """A finite number."""
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number):
        raise refused(file, f"`{name}` is {value!r}", found=repr(value), expected="a finite number")
    return number


def path(file: str, name: str, value: object) -> str:
    """Name of a file or a folder."""
    try:
        return os.fsdecode(value)  # type: ignore[arg-type]
    except TypeError:
        raise refused(file, f"`{name}` is {value!r}", found=repr(value), expected="a path") from None


def word(file: str, name: str, value: object, among: tuple[str, ...] = ()) -> str:
    """A text; one of ``among``, where there are any."""
    if not isinstance(value, str) or (among and value not in among):
        raise refused(file, f"`{name}` is {value!r}", found=repr(value), expected=f"one of {', '.join(among)}" if among else "a text")
    return value


def listed(file: str, name: str, values: object) -> list[Any]:
    """Several values; a single text is none."""
    if isinstance(values, str | bytes | Mapping) or not isinstance(values, Iterable):
        raise refused(file, f"`{name}` is {values!r}", found=repr(values), expected="a list")
    return list(values)


def keyed(file: str, name: str, values: object) -> list[tuple[str, Any]]:
    """Keys with their values; none if it is None."""
    if values is None:
        return []
    if not isinstance(values, Mapping):
        raise refused(file, f"`{name}` is {values!r}", found=repr(values), expected='a dictionary, as {"loader.access_ns": 90}')
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
