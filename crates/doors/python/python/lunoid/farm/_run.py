"""A job on an engine, from its shards to the joined run."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from .. import _asked
from .._errors import refused
from . import _program, _worker
from ._engines import Engine, choose
from ._job import Job
from ._plan import BY_COST, Plan, plan
from ._program import FarmError
from ._progress import Progress, show
from ._report import Report, SetAside
from ._worker import Outcome, Task

_MOST_WORKERS = 1024
"""Most plain processes, and most threads of a worker."""
_LOOK_S = 0.05
"""Time between two looks at the tasks (s)."""
_TELL_S = 2.0
"""Time between two tellings of progress (s)."""
_ALONE_S = 60.0
"""Time that a run waits for an engine that has no worker (s)."""


def on(engine: Any = None, *, workers: int | None = None, threads: int = 1, program: str | None = None) -> Farm:
    """The workers of ``engine``: None for plain processes, a ``dask.distributed.Client``, the module ``ray`` or what ``ray.init``
    returned; ``"dask"`` or ``"ray"`` starts one on this computer.

    ``workers``: number of plain processes, as many as there are processors if left out. ``threads``: threads of each worker; no bit depends
    on them. ``program``: the command lunoid, by its path on every worker; else each worker has it from its variable LUNOID or its search path.

    >>> from lunoid import farm
    >>> farm.on(None, workers=2)
    <lunoid.farm.Farm of 2 workers by processes>
    """
    if workers is not None:
        workers = _asked.counted("farm.on", "workers", workers, least=1, most=_MOST_WORKERS)
    threads = _asked.counted("farm.on", "threads", threads, least=1, most=_MOST_WORKERS)
    command = None if program is None else _asked.path("farm.on", "program", program)
    return Farm(choose(engine, workers), threads, command)


@dataclass
class _Shard:
    """A shard that is not done."""

    task: Task
    started: Any
    tries: int = 1


class Farm:
    """Workers that draw shards. Made by :func:`on`."""

    def __init__(self, engine: Engine, threads: int, program: str | None) -> None:
        self._engine = engine
        self._threads = threads
        self._program = program

    def run(
        self,
        job: Job,
        shards: Literal["by cost"] | int = BY_COST,
        retries: int = 3,
        progress: Callable[[Progress], None] | None = show,
    ) -> Report:
        """Draws ``job`` in shards and joins them into ``job.out``.

        ``shards``: ``"by cost"``, cut by the times of a small raster, four for each worker; or their number, of equally many frames.
        ``retries``: how often a shard is tried before it is set aside, and the rest goes on. ``progress`` hears every two seconds how far the
        run is; the default writes a line to a terminal.

        The shards lie in ``OUT-farm``. The same call goes on there: what is drawn is kept. Raises InputError for a fault of the job and
        FarmError where the command refuses to draw or to join.
        """
        if not isinstance(job, Job):
            raise refused("farm.run", f"no job: {_asked.shown(job)}", found=_asked.shown(job), expected="what farm.replay returns")
        if isinstance(shards, str) and shards != BY_COST:
            raise refused(job.scenario, f"shards {shards!r}", found=shards, expected='"by cost" or a whole number from 1 on')
        if not isinstance(shards, str):
            shards = _asked.counted(job.scenario, "shards", shards, least=1)
        retries = _asked.counted(job.scenario, "retries", retries, least=1)
        if progress is not None and not callable(progress):
            raise refused(job.scenario, f"`progress` is {progress!r}", found=repr(progress), expected="a function, or None")
        begun = time.monotonic()
        settled = plan(job, shards, max(1, self._engine.workers()), self._program)
        try:
            set_aside, tries = self._draw(job, settled, retries, progress)
        except BaseException:
            self._engine.stop()
            raise
        if not set_aside:
            _join(job, settled)
        frames = _program.status(settled.program, settled.farm).get("frames")
        return Report(
            out=job.out,
            folder=str(settled.farm),
            engine=self._engine.name,
            by=settled.by,
            shards=settled.shards,
            frames=None if frames is None else frames[1] - frames[0],
            tries=tries,
            set_aside=tuple(set_aside),
            seconds=time.monotonic() - begun,
        )

    def _draw(self, job: Job, settled: Plan, retries: int, progress: Callable[[Progress], None] | None) -> tuple[list[SetAside], int]:
        """Has every shard drawn; those that were set aside, and the number of all tries."""
        tasks = [self._task(job, settled, number) for number in range(1, settled.shards + 1)]
        for task in tasks:
            _note(task).unlink(missing_ok=True)
        open_shards = [_Shard(task, self._engine.start(task)) for task in tasks]
        set_aside: list[SetAside] = []
        tries, told = len(tasks), time.monotonic()
        manned = told
        while open_shards:
            time.sleep(_LOOK_S)
            for shard in [shard for shard in open_shards if self._engine.is_ready(shard.started)]:
                outcome = self._outcome(shard)
                if outcome["usage"]:
                    # What no worker can do has not begun: the folder is free for another number of shards.
                    settled.forget()
                    raise refused(job.scenario, outcome["why"])
                if outcome["done"]:
                    open_shards.remove(shard)
                elif shard.tries < retries:
                    shard.started, shard.tries, tries = self._engine.start(shard.task), shard.tries + 1, tries + 1
                else:
                    open_shards.remove(shard)
                    set_aside.append(_set_aside(shard, outcome["why"], settled.program))
            now = time.monotonic()
            if open_shards and now - told < _TELL_S:
                continue
            told = now
            manned = now if self._engine.workers() else manned
            if open_shards and now - manned > _ALONE_S:
                raise FarmError(f"{self._engine.name} has had no worker for {_ALONE_S:.0f} s; start workers and run the job again: what is drawn is kept")
            if progress is not None:
                progress(_how_far(settled, len(set_aside)))
        return sorted(set_aside, key=lambda one: int(one.shard.split("/")[0])), tries

    def _outcome(self, shard: _Shard) -> Outcome:
        try:
            return self._engine.outcome(shard.started)
        except Exception as error:  # Every engine has errors of its own for a worker that is lost.
            return Outcome(done=False, usage=False, why=f"{self._engine.name}: {type(error).__name__}: {_first_line(error)}", host="")

    def _task(self, job: Job, settled: Plan, number: int) -> Task:
        return Task(
            program=self._program,
            version=settled.version,
            words=job.words,
            shard=f"{number}/{settled.shards}",
            costs=settled.costs,
            folder=str(settled.folder(Path(job.out).name, number)),
            farm=str(settled.farm),
            inputs=settled.inputs,
            threads=self._threads,
        )

    def __repr__(self) -> str:
        return f"<lunoid.farm.Farm of {self._engine.workers()} workers by {self._engine.name}>"


def _first_line(error: Exception) -> str:
    return (str(error).strip().splitlines() or [""])[0]


def _note(task: Task) -> Path:
    """The note of a shard that was set aside, for ``lunoid farm status``."""
    return Path(task["folder"] + ".failed.json")


def _set_aside(shard: _Shard, why: str, program: str) -> SetAside:
    command = _worker.line(shard.task, program)
    note = {"schema": "lunoid.farm.failed/1", "tries": shard.tries, "why": why, "command": command}
    try:
        _note(shard.task).write_text(json.dumps(note, indent=2) + "\n")
    except OSError:
        # Where the disk is full the report says it all the same.
        pass
    return SetAside(shard.task["shard"], shard.tries, why, command)


def _how_far(settled: Plan, set_aside: int) -> Progress:
    run = _program.status(settled.program, settled.farm)
    done = sum(shard["state"] == "done" for shard in run.get("shards", []))
    return Progress(done, settled.shards, set_aside, run.get("done", 0), run.get("left_s"))


def _join(job: Job, settled: Plan) -> None:
    folders = [str(settled.folder(Path(job.out).name, number)) for number in range(1, settled.shards + 1)]
    page = [] if job.has_page else ["--no-page"]
    words = [settled.program, "merge", *folders, "--out", job.out, *page, "--quiet", "--no-progress"]
    _program.call(words, _worker.tree(settled.farm), _worker.shadows(settled.farm))
