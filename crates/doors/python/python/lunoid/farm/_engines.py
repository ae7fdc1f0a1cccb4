"""Engines: who has workers, and how a task comes to one."""

from __future__ import annotations

import importlib
import os
import subprocess
from concurrent.futures import Future, ThreadPoolExecutor
from types import ModuleType
from typing import Any, Protocol

from .._errors import refused
from ._worker import Outcome, Task, draw


class Engine(Protocol):
    """What takes tasks to workers. Dask, Ray and plain processes are at hand; any other that has these may be given."""

    name: str
    """Name of the engine, as a report says it."""

    def workers(self) -> int:
        """Number of tasks that run at once; 0 while no worker is there."""

    def start(self, task: Task) -> Any:
        """Begins a task, and returns what stands for it."""

    def is_ready(self, started: Any) -> bool:
        """Whether a task has ended, well or not."""

    def outcome(self, started: Any) -> Outcome:
        """What became of a task that has ended. Raises whatever the engine has for a worker that is lost."""

    def stop(self) -> None:
        """Ends all tasks: nobody waits for them any more. Others may be started afterwards."""


class Processes:
    """Plain processes of this computer, one a task."""

    def __init__(self, workers: int) -> None:
        self.name = "processes"
        self._workers = workers
        self._pool = self._new_pool()
        self._running: list[subprocess.Popen[str]] = []

    def _new_pool(self) -> ThreadPoolExecutor:
        return ThreadPoolExecutor(self._workers, thread_name_prefix="lunoid-farm")

    def workers(self) -> int:
        return self._workers

    def start(self, task: Task) -> Future[Outcome]:
        return self._pool.submit(draw, task, self._hold)

    def _hold(self, process: subprocess.Popen[str]) -> None:
        self._running = [other for other in self._running if other.poll() is None] + [process]

    def is_ready(self, started: Future[Outcome]) -> bool:
        return started.done()

    def outcome(self, started: Future[Outcome]) -> Outcome:
        return started.result()

    def stop(self) -> None:
        self._pool.shutdown(wait=False, cancel_futures=True)
        for process in self._running:
            process.terminate()
        # The next run of the same farm begins with threads of its own.
        self._pool = self._new_pool()


class Dask:
    """Workers of a ``dask.distributed.Client``."""

    def __init__(self, client: Any) -> None:
        self.name = "Dask"
        self._client = client
        self._started: list[Any] = []

    def workers(self) -> int:
        return int(sum(self._client.nthreads().values()))

    def start(self, task: Task) -> Any:
        started = self._client.submit(draw, task, pure=False, retries=0)
        self._started.append(started)
        return started

    def is_ready(self, started: Any) -> bool:
        return bool(started.done())

    def outcome(self, started: Any) -> Outcome:
        self._started.remove(started)
        try:
            outcome: Outcome = started.result()
        finally:
            # A result that is still held is worked out again when the worker that has it is lost.
            started.release()
        return outcome

    def stop(self) -> None:
        self._client.cancel(self._started)
        self._started = []


class Ray:
    """Workers of a Ray that the module ``ray`` is connected to."""

    def __init__(self, ray: ModuleType) -> None:
        self.name = "Ray"
        self._ray = ray
        # A lost worker is told of at once: who is tried again is counted in one place.
        self._draw = ray.remote(max_retries=0, num_cpus=1)(draw)
        self._started: list[Any] = []

    def workers(self) -> int:
        return int(self._ray.cluster_resources().get("CPU", 0))

    def start(self, task: Task) -> Any:
        started = self._draw.remote(task)
        self._started.append(started)
        return started

    def is_ready(self, started: Any) -> bool:
        return bool(self._ray.wait([started], timeout=0)[0])

    def outcome(self, started: Any) -> Outcome:
        self._started.remove(started)
        outcome: Outcome = self._ray.get(started)
        return outcome

    def stop(self) -> None:
        for started in self._started:
            self._ray.cancel(started, force=True)
        self._started = []


def choose(engine: Any, workers: int | None) -> Engine:
    """The engine that ``engine`` stands for."""
    if engine is None:
        return Processes(workers or os.cpu_count() or 1)
    if workers is not None:
        raise refused("farm.on", f"workers={workers}", found=workers, expected="none: a client knows its own workers")
    kind = engine if isinstance(engine, ModuleType) else type(engine)
    home = (getattr(kind, "__module__", None) or kind.__name__).split(".")[0]
    match engine if isinstance(engine, str) else None:
        case "ray":
            return Ray(_started(_installed("ray", "ray")))
        case "dask":
            return Dask(_installed("distributed", "dask[distributed]").Client())
        case _ if home == "ray":
            return Ray(_started(_installed("ray", "ray")))
        case _ if home == "distributed":
            return Dask(engine)
        case _ if all(hasattr(engine, name) for name in ("name", "workers", "start", "is_ready", "outcome", "stop")):
            chosen: Engine = engine
            return chosen
    expected = 'None for processes, a dask.distributed.Client, the module ray or what ray.init returned, or "dask" or "ray"'
    raise refused("farm.on", f"no engine: {engine!r}", found=repr(engine), expected=expected)


def _installed(module: str, package: str) -> ModuleType:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        help = f"install it: pip install '{package}'"
        raise refused("farm.on", f"{package} is not installed", found="no module " + module, expected=package, help=help) from error


def _started(ray: ModuleType) -> ModuleType:
    if not ray.is_initialized():
        ray.init()
    return ray
