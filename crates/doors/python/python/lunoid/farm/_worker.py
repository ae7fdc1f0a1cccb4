"""What a worker does: one shard, drawn by the command of that worker."""

from __future__ import annotations

import shlex
import socket
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypedDict

from .._errors import InputError
from . import _inputs, _program

_PATIENCE_S = 0.5
"""Time after which a worker looks again whether another one still draws its shard (s)."""

_USAGE = 2
"""Exit code of a command line that no worker can do."""

Hold = Callable[["subprocess.Popen[str]"], None]


class Task(TypedDict):
    """One shard, in plain values: an engine carries it to a worker."""

    program: str | None
    version: str
    words: list[str]
    shard: str
    costs: str | None
    folder: str
    farm: str
    inputs: dict[str, str]
    threads: int


class Outcome(TypedDict):
    """What became of a task."""

    done: bool
    usage: bool
    why: str
    host: str


def tree(farm: Path) -> Path:
    """Folder of the inputs."""
    return farm / "inputs"


def shadows(farm: Path) -> Path:
    """Folder of the shadow boundaries."""
    return farm / "shadows"


def command(task: Task, program: str) -> list[str]:
    """The command that draws the shard."""
    by = ["--costs", task["costs"]] if task["costs"] else []
    threads = ["--jobs", str(task["threads"])]
    return [program, "replay", *task["words"], "--shard", task["shard"], *by, "--out", task["folder"], *threads]


def line(task: Task, program: str) -> str:
    """The same as a line of a shell."""
    farm = Path(task["farm"])
    words = shlex.join([f"LUNOID_SHADOW_CACHE={shadows(farm)}", *command(task, program)])
    return f"cd {shlex.quote(str(tree(farm)))} && {words}"


def draw(task: Task, hold: Hold = lambda process: None) -> Outcome:
    """Draws the shard of ``task``. ``hold`` is given each process that is started.

    A worker with another version of the program or of a file refuses. While another process draws the shard, the worker waits.
    """
    host = socket.gethostname()
    farm = Path(task["farm"])
    try:
        program = _program.find(task["program"])
        found = _program.version(program)
    except (InputError, _program.FarmError) as error:
        return _refusal(host, str(error))
    if found != task["version"]:
        return _refusal(host, f"{program}: found {found}, expected {task['version']}; install that version there")
    if faults := _inputs.faults(task["inputs"], tree(farm)):
        return _refusal(host, "; ".join(faults))
    while True:
        while _is_drawn_elsewhere(program, task):
            time.sleep(_PATIENCE_S)
        code, why = _run([*command(task, program), "--quiet", "--no-progress"], farm, hold)
        if code == 0:
            return Outcome(done=True, usage=False, why="", host=host)
        if not _is_drawn_elsewhere(program, task):
            return Outcome(done=False, usage=code == _USAGE, why=f"worker {host}: {why}", host=host)


def _refusal(host: str, why: str) -> Outcome:
    return Outcome(done=False, usage=False, why=f"worker {host}: {why}", host=host)


def _run(words: list[str], farm: Path, hold: Hold) -> tuple[int, str]:
    variables = _program.environment(shadows(farm))
    with subprocess.Popen(words, cwd=tree(farm), env=variables, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        hold(process)
        said = process.communicate()[1]
    code = process.returncode
    ended = f"the command was ended by signal {-code}" if code < 0 else f"the command ended with code {code}"
    return code, _program.said(said) or ended


def _is_drawn_elsewhere(program: str, task: Task) -> bool:
    shards = _program.status(program, Path(task["farm"])).get("shards", [])
    return any(shard["shard"] == task["shard"] and shard["state"] == "running" for shard in shards)
