"""What is wrong with what was asked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Fault:
    """One fault of one file, or of what was asked of it."""

    file: str
    """File, as it was named; the scenario's for faults of a call."""
    line: int | None
    """Line of the file, from 1, where the fault has a place."""
    column: int | None
    """Column in characters, from 1."""
    key: str | None
    """Dotted path of the key, as ``raster.sweeps``."""
    title: str
    """One sentence that says what is wrong."""
    found: str | None
    """What was found."""
    expected: str | None
    """What was expected."""
    help: str | None
    """What to do."""


class InputError(ValueError):
    """A scenario, a model, a pose or a name that cannot be used. All faults are in one exception.

    >>> import lunoid
    >>> try:
    ...     lunoid.open("no/such.toml")
    ... except lunoid.InputError as error:
    ...     print(error.file, len(error.faults))
    no/such.toml 1
    """

    faults: tuple[Fault, ...]
    """All faults, in the order of the files; at least one."""

    def __init__(self, text: str, faults: Iterable[Mapping[str, Any]] = ()) -> None:
        super().__init__(text)
        found = tuple(Fault(**fault) for fault in faults)
        self.faults = found or (Fault("", None, None, None, text, None, None, None),)

    @property
    def file(self) -> str:
        """File of the first fault."""
        return self.faults[0].file

    @property
    def line(self) -> int | None:
        """Line of the first fault, from 1."""
        return self.faults[0].line

    @property
    def found(self) -> str | None:
        """What was found by the first fault."""
        return self.faults[0].found

    @property
    def expected(self) -> str | None:
        """What was expected instead."""
        return self.faults[0].expected

    @property
    def help(self) -> str | None:
        """What to do about the first fault."""
        return self.faults[0].help


def refused(file: str, title: str, *, found: object = None, expected: str | None = None, help: str | None = None) -> InputError:
    """An error of a call, with the fields of one fault."""
    text = f"{file}: {title}"
    if expected is not None:
        text += f"; expected {expected}"
    if help is not None:
        text += f"; {help}"
    words = None if found is None else str(found)
    fault = dict(file=file, line=None, column=None, key=None, title=title, found=words, expected=expected, help=help)
    return InputError(text, [fault])
