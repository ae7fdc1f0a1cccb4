"""What all workers of a job agree on: program, inputs, shards. It stands in the folder of the shards, so that a job goes on there."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Literal

from .._errors import refused
from . import _inputs, _program, _worker
from ._job import Job

SCHEMA = "lunoid.farm/1"

BY_COST: Final = "by cost"

_SHARDS_A_WORKER = 4
"""Shards by cost for each worker: costs are times of a small raster, so the last ones even out what they miss."""


@dataclass(frozen=True)
class Plan:
    """Everything of a job that is settled before a worker starts."""

    farm: Path
    """Folder of the shards, beside the joined run."""
    program: str
    version: str
    by: Literal["cost", "count"]
    shards: int
    inputs: dict[str, str]

    def folder(self, name: str, number: int) -> Path:
        """Folder of a shard of the run ``name``."""
        return self.farm / f"{name}-shard-{number}-of-{self.shards}"

    def forget(self) -> None:
        """Lets the folder be that of another job."""
        (self.farm / "job.json").unlink(missing_ok=True)

    @property
    def costs(self) -> str | None:
        """Folder of the run whose times share the frames out."""
        return str(self.farm / "costs") if self.by == "cost" else None


def plan(job: Job, shards: Literal["by cost"] | int, workers: int, named: str | None) -> Plan:
    """Settles what is to be done. A folder that has the same job already goes on as it was begun.

    One frame is drawn first: faults of the job are told of once, its files are listed, and its shadow boundaries are made before any worker
    needs them.
    """
    by: Literal["cost", "count"] = "cost" if shards == BY_COST else "count"
    farm = Path(f"{job.out}-farm")
    if Path(job.out).exists() and not Path(job.out).is_dir():
        raise refused(job.out, "something else stands where the joined run is to be", expected="a folder, or nothing", help="choose another out")
    program = _program.find(named)
    version = _program.version(program)
    asked = {"schema": SCHEMA, "program": version, "words": job.words, "by": by}
    _make(farm)
    _draw(program, _first_frame(job), farm, "trial")
    inputs = _inputs.of_run(farm / "trial", job.files)
    held = _held(farm, {**asked, "inputs": inputs})
    if held is None:
        if by == "cost":
            _draw(program, [*job.costs, "--fresh"], farm, "costs")
            start, end = json.loads((farm / "costs" / "run.json").read_text())["range"]
            shards = min(end - start, _SHARDS_A_WORKER * workers)
        held = {**asked, "inputs": inputs, "shards": shards}
    if by == "count" and held["shards"] != shards:
        expected = f"the {held['shards']} shards that its folder was begun with"
        help = f"ask for as many, or remove {farm}"
        raise refused(str(farm), f"{shards} shards", found=shards, expected=expected, help=help)
    _inputs.lay_out(inputs, _worker.tree(farm))
    _write(farm / "job.json", held)
    return Plan(farm, program, version, by, int(held["shards"]), inputs)


def _make(farm: Path) -> None:
    try:
        farm.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        help = "choose another out"
        raise refused(str(farm), f"the folder of the shards cannot be made: {error.strerror}", expected="a folder, or nothing", help=help) from error


def _first_frame(job: Job) -> list[str]:
    first = int(job.frames[1].split("..")[0]) if job.frames else 0
    # A shard of one: what has no shards is refused here.
    span = ["--frames", f"{first}..{first + 1}", "--shard", "1/1"]
    return [job.scenario, *job.stage, *job.raster, *span, "--no-page", "--fresh"]


def _draw(program: str, words: list[str], farm: Path, name: str) -> None:
    out = ["--out", str(farm / name), "--quiet", "--no-progress"]
    _program.call([program, "replay", *words, *out], Path.cwd(), _worker.shadows(farm), asked_of=words[0])


def _held(farm: Path, asked: dict[str, Any]) -> dict[str, Any] | None:
    """The job that the folder has, if it is the one that is asked for."""
    path = farm / "job.json"
    if not path.exists():
        return None
    try:
        held = json.loads(path.read_text())
        shards = held.pop("shards")
    except (ValueError, KeyError, AttributeError, TypeError) as error:
        raise refused(str(path), f"no job of a farm: {error}", expected=SCHEMA, help=f"remove {farm}") from error
    for key, value in asked.items():
        if held.get(key) != value:
            help = f"remove {farm}, or choose another out"
            title = f"this folder has another job: `{key}` differs"
            raise refused(str(path), title, found=_short(held.get(key)), expected=_short(value), help=help)
    if not (isinstance(shards, int) and shards > 0):
        raise refused(str(path), f"shards = {shards!r}", found=shards, expected="a whole number from 1 on", help=f"remove {farm}")
    return {**held, "shards": shards}


def _short(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{name} {str(found)[:12]}" for name, found in value.items())
    return str(value)


def _write(path: Path, document: dict[str, Any]) -> None:
    new = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    new.write_text(json.dumps(document, indent=2) + "\n")
    os.replace(new, path)
