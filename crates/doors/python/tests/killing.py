"""A run whose worker is killed while it draws a shard."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path

from lunoid import farm


def content(folder: Path) -> dict[str, bytes]:
    """Every file below a folder but the wall times."""
    files = [path for path in folder.rglob("*") if path.is_file() and path.name != "performance.json"]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def run_with_a_kill(workers: farm.Farm, job: farm.Job, folder: Path, with_child: bool) -> tuple[farm.Report, list[int]]:
    """Draws `job` in two shards, whose folders lie in `folder`, and kills the worker of one, `with_child` or without: with the command that
    draws for it. The report, and the numbers of the processes that were killed."""
    came: list[farm.Report | BaseException] = []

    def run() -> None:
        try:
            came.append(workers.run(job, shards=2, progress=None))
        except BaseException as error:  # noqa: BLE001
            came.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    victims = _kill_one(folder, lambda: not thread.is_alive(), with_child)
    thread.join()
    if isinstance(came[0], BaseException):
        raise came[0]
    return came[0], victims


def _kill_one(folder: Path, has_ended: Callable[[], bool], with_child: bool) -> list[int]:
    while not has_ended():
        for journal in folder.glob("*-shard-*/frames.journal"):
            try:
                holder = int((journal.parent / ".lunoid.lock").read_text())
                # A shard is in its middle once a frame of it is on the disk.
                if journal.read_text().count("\n") < 2:
                    continue
                stat = Path(f"/proc/{holder}/stat").read_text()
                parent = int(stat.rsplit(")", 1)[1].split()[1])
                # Plain processes are children of this one, and have no worker above them.
                victims = [holder] if parent == os.getpid() else [parent, holder] if with_child else [parent]
                for process in victims:
                    os.kill(process, signal.SIGKILL)
                return victims
            except (OSError, ValueError):
                continue
        time.sleep(0.001)
    return []
