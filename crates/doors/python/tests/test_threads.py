"""The interpreter is released, Ctrl-C is obeyed, nothing grows."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from conftest import ROOT

import lunoid


def test_the_interpreter_runs_while_a_frame_is_drawn() -> None:
    drive = lunoid.open("scenarios/first-light.toml", machine="exact", threads=1)
    gaps, done = [], threading.Event()

    def beat() -> None:
        last = time.perf_counter()
        while not done.is_set():
            time.sleep(0.002)
            now = time.perf_counter()
            gaps.append(now - last)
            last = now

    thread = threading.Thread(target=beat)
    thread.start()
    begin = time.perf_counter()
    drive.truth(0)
    took = time.perf_counter() - begin
    done.set()
    thread.join()
    assert max(gaps) < 0.5 * took, f"a gap of {max(gaps):.3f} s in a call of {took:.3f} s"


def test_several_drives_in_several_threads(scene: Path) -> None:
    machines = ["ideal", "pra-nominal", "exact", "pra-overloaded"]

    def drawn(machine: str) -> list[str]:
        drive = lunoid.open(scene, machine=machine, threads=1)
        return [drive.frame(frame).hash for frame in range(4)]

    alone = [drawn(machine) for machine in machines]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(drawn, machines)) == alone
        shared = lunoid.open(scene)
        assert list(pool.map(lambda frame: shared.frame(frame).hash, range(4))) == alone[0]


STUDY = """
import signal
import lunoid
# A shell starts what runs in the background to ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)
drive = lunoid.open("scenarios/first-light.toml", sweeps=60, samples=100)
print("begins", flush=True)
try:
    drive.study("error")
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_ends_a_study() -> None:
    process = subprocess.Popen([sys.executable, "-c", STUDY], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "begins\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    try:
        assert process.communicate(timeout=120)[0] == "interrupted\n"
    finally:
        process.kill()


def test_a_drive_does_not_outlive_a_fork(scene: Path) -> None:
    drive = lunoid.open(scene)
    loop = drive.loop()
    told, tell = os.pipe()
    child = os.fork()
    if child == 0:
        said = []
        for call in (lambda: drive.frame(0), lambda: loop.look(None)):  # type: ignore[arg-type]
            try:
                call()
            except lunoid.InputError as error:
                said.append(str(error))
        os.write(tell, "\n".join(said).encode())
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0
    drive_said, loop_said = os.read(told, 4096).decode().split("\n")
    assert f"this drive belongs to process {os.getpid()}, and this is process {child}" in drive_said
    assert "this loop belongs" in loop_said
    assert drive.frame(0).frame == 0


def resident() -> int:
    """Bytes of this process in memory."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


CALLS = 1_000_000


def test_a_million_calls_leak_nothing(scene: Path) -> None:
    small = {"scenario.raster.columns": 8, "scenario.raster.lines": 8}
    drive = lunoid.open(scene, threads=1, sweeps=8, samples=16, set=small)
    pose = drive.pose(0)

    def calls(count: int) -> None:
        for number in range(count):
            match number % 5:
                case 0:
                    drive.frame(number % 4).light()
                case 1:
                    drive.truth(number % 4, "range", "label")
                case 2:
                    drive.probe("mu.height", "dpp.*", frame=1, sweep=number % 8)
                case 3:
                    drive.look(pose)._repr_png_()
                case _:
                    try:
                        drive.frame(4)
                    except lunoid.InputError:
                        pass

    calls(CALLS // 100)
    before = resident()
    calls(CALLS)
    grown = resident() - before
    # Two bytes a call.
    assert grown < 2_000_000, f"{grown} bytes after {CALLS} calls"
