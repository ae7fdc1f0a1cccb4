"""The command ``lunoid``: where it is, which version it has, and what it says."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .._errors import InputError, refused

_REFUSALS = (2, 3)
"""Exit codes of the command for what was asked of it: words, and files."""


class FarmError(RuntimeError):
    """A run that cannot be drawn or joined; its text says what the command said."""


def find(program: str | None) -> str:
    """Path of the command: ``program``, else what the variable LUNOID names, else ``lunoid`` of the search path."""
    name = program or os.environ.get("LUNOID") or "lunoid"
    found = shutil.which(name)
    if found is None:
        help = "build it with `cargo build --release`, and name it by the variable LUNOID or by farm.on(program=...)"
        raise refused(name, "no such program", found=name, expected="the command lunoid", help=help)
    return os.path.abspath(found)


def version(program: str) -> str:
    """What ``program`` says of its version: number, commit and result family."""
    return _answer([program, "--version"], Path.cwd()).strip()


def call(words: Sequence[str], folder: Path, shadows: Path, asked_of: str | None = None) -> str:
    """Runs a command in ``folder`` and returns what it prints. Shadow boundaries are kept in ``shadows``. Where it refuses what was asked of the
    file ``asked_of``, the error is an InputError."""
    return _answer(words, folder, environment(shadows), asked_of)


def environment(shadows: Path) -> dict[str, str]:
    """The variables of a command that keeps shadow boundaries in ``shadows``."""
    return {**os.environ, "LUNOID_SHADOW_CACHE": str(shadows)}


def status(program: str, folder: Path) -> dict[str, Any]:
    """The first run of ``lunoid farm status`` in ``folder``; empty where there are no shards yet."""
    ended = subprocess.run([program, "farm", "status", str(folder), "--json"], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        return {}
    run: dict[str, Any] = json.loads(ended.stdout)["runs"][0]
    return run


def _answer(words: Sequence[str], folder: Path, variables: dict[str, str] | None = None, asked_of: str | None = None) -> str:
    try:
        ended = subprocess.run(words, cwd=folder, env=variables, capture_output=True, text=True, check=False)
    except OSError as error:
        raise FarmError(f"{words[0]}: cannot be run: {error}") from error
    if asked_of is not None and ended.returncode in _REFUSALS:
        raise _refusal(said(ended.stderr), asked_of)
    if ended.returncode != 0:
        raise FarmError(said(ended.stderr) or f"{' '.join(words)}: ended with code {ended.returncode}")
    return ended.stdout


def _refusal(text: str, file: str) -> InputError:
    """What the command said, as a fault with the file and the place that it names first, or of ``file``."""
    place = re.search(r"^ *--> (.+?)(?::(\d+):(\d+))?$", text, re.MULTILINE)
    at, line, column = place.groups() if place else (file, None, None)
    title = (text.splitlines() or ["refused"])[0]
    numbers = dict(line=line and int(line), column=column and int(column))
    return InputError(text, [dict(file=at, key=None, title=title, found=None, expected=None, help=None, **numbers)])


def said(text: str) -> str:
    """What a command said on standard error, without the word in front."""
    return text.strip().removeprefix("error: ")
