"""Files that a run is made from: copied once by their content, and held to it by every worker."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from pathlib import Path

from .._errors import refused

Inputs = dict[str, str]
"""Files and the SHA-256 of their bytes, hexadecimal. Names are those of the command line, from the folder of the caller on."""


def of_run(folder: Path, named: tuple[str, ...]) -> Inputs:
    """The files that the run in ``folder`` was made from, by its record, and those that are ``named``."""
    record = json.loads((folder / "run.json").read_text())
    scenario = record["scenario"]["file"]
    listed = [scenario, *record["references"], *record["model"]["files"]]
    names = [file["file"] for file in listed if file is not None] + list(named)
    # What is built into the program is no file; the program's version covers it.
    return {name: content(Path(name)) for name in names if Path(name).is_file()}


def content(path: Path) -> str:
    """SHA-256 of a file, hexadecimal."""
    with open(path, "rb") as file:
        hasher = hashlib.sha256()
        while piece := file.read(1 << 20):
            hasher.update(piece)
    return hasher.hexdigest()


def lay_out(inputs: Inputs, tree: Path) -> None:
    """Copies the files into ``tree``, under the names that they have from the folder of the caller on. Files of absolute names stay."""
    for name, expected in inputs.items():
        if os.path.isabs(name):
            continue
        place = Path(os.path.normpath(tree / name))
        if not place.is_relative_to(tree):
            help = "call this from a folder above all files of the run, or name the scenario by its absolute path"
            raise refused(name, "this file lies outside the folder of the caller", found=name, expected="a file below it", help=help)
        _make_way(tree, name)
        if not (place.is_file() and content(place) == expected):
            new = place.with_name(f".{place.name}.{os.getpid()}.tmp")
            shutil.copyfile(name, new)
            os.replace(new, place)


def _make_way(tree: Path, name: str) -> None:
    """Makes the folders of ``name`` one after the other: a name may lead through a folder and out of it again."""
    place = tree
    for part in ("", *Path(name).parts[:-1]):
        place = place / part
        place.mkdir(exist_ok=True)


def faults(inputs: Inputs, tree: Path) -> list[str]:
    """What is wrong with the files that a worker has, one line a file."""
    found = []
    for name, expected in inputs.items():
        path = Path(os.path.normpath(tree / name))
        has = content(path) if path.is_file() else "no file"
        if has != expected:
            found.append(f"{path}: found {has[:12]}, expected the version {expected[:12]} (SHA-256) of this job")
    return found
