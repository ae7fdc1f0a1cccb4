"""How fast a farm is: frames a second of two workers beside one process of two threads, the cost of joining, and how evenly shards by cost end.
The record is docs/trust/farm-rates.json. The computer must have nothing else to do.

python crates/doors/python/rates.py LUNOID RECORD
"""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import Future
from contextlib import ExitStack
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from kills import workers_of

from lunoid import farm
from lunoid.farm._engines import Processes
from lunoid.farm._worker import Outcome, Task, draw

DRAWING_S = 300.0
"""Time that one process draws, and each engine (s)."""
ROUNDS = 3
"""Rounds in which one process and the engines take turns: a computer that slows down slows all of them."""
LEAST = {"processes": 0.97, "Dask": 0.92, "Ray": 0.85}
JOINING = 0.01
LAST = 0.08
TENFOLD = 10.0


def repeated(place: Path, missions: int) -> Path:
    """The nominal drive, there and back so often."""
    text = Path("scenarios/nominal-drive.toml").read_text()
    ends = ["x_m = 4500, y_m = 4500, heading_deg = 4", "x_m = 4512, y_m = 4501, heading_deg = 9"]
    keyframes = ",\n".join(f"  {{ t_s = {3 * number}, {ends[number % 2]} }}" for number in range(missions + 1))
    text, frames = re.subn(r"(?m)^frames = 90$", f"frames = {90 * missions}", text)
    text, path = re.subn(r"(?s)keyframes = \[\n.*?\n\]", f"keyframes = [\n{keyframes},\n]", text)
    assert frames == path == 1, "scenarios/nominal-drive.toml has another form"
    return _written(place / f"nominal-drive-{missions}.toml", text)


def uneven(place: Path) -> Path:
    """A look from the sky down to the ground, by `exact`: frames of sky take a tenth of those of ground, or less."""
    text = Path("scenarios/first-light.toml").read_text()
    text, path = re.subn(
        r"(?s)keyframes = \[\n.*?\n\]",
        "keyframes = [\n"
        "  { t_s = 0, x_m = 2467, y_m = 2954, z_m = 300, heading_deg = 310, pitch_deg = 60, roll_deg = 0 },\n"
        "  { t_s = 8, x_m = 2485, y_m = 2939, z_m = 300, heading_deg = 310, pitch_deg = -20, roll_deg = 0 },\n]",
        text,
    )
    assert path == 1, "scenarios/first-light.toml has another form"
    return _written(place / "from-the-sky-down.toml", re.sub(r"(?m)^(frames|duration_s) = .*$", "frames = 120", text))


def _written(path: Path, text: str) -> Path:
    path.write_text(text.replace("../docs/", f"{Path.cwd()}/docs/"))
    return path


def alone(program: str, scenario: Path, out: Path) -> float:
    """Wall time of one process of two threads (s)."""
    begun = time.monotonic()
    subprocess.run([program, "replay", str(scenario), "--jobs", "2", "--no-page", "--quiet", "--no-progress", "--out", str(out)], check=True)
    return time.monotonic() - begun


def joined_again(program: str, folder: Path, out: Path) -> tuple[float, int]:
    """Wall time of `lunoid merge` over the shards of a farm (s), and its peak memory (bytes)."""
    shards = sorted(str(path) for path in folder.glob("*-shard-*-of-*") if path.is_dir())
    begun = time.monotonic()
    process = subprocess.Popen([program, "merge", *shards, "--out", str(out), "--no-page", "--quiet", "--no-progress"])
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit("lunoid merge failed")
    return time.monotonic() - begun, usage.ru_maxrss * 1024


def engines_beside_one(program: str, place: Path) -> dict[str, Any]:
    trial = repeated(place, 1)
    missions = math.ceil(1.1 * DRAWING_S / ROUNDS / alone(program, trial, place / "trial"))
    scenario = repeated(place, missions)
    frames = 90 * missions
    walls: dict[str, list[float]] = {"one process": [], **{name: [] for name in LEAST}}
    joinings: list[float] = []
    with ExitStack() as stack:
        import distributed
        import ray

        cluster = stack.enter_context(distributed.LocalCluster(n_workers=0, dashboard_address=None))
        stack.enter_context(workers_of(cluster.scheduler_address))
        client = stack.enter_context(distributed.Client(cluster))
        client.wait_for_workers(2)
        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
        stack.callback(ray.shutdown)
        engines = {"processes": farm.on(None, workers=2), "Dask": farm.on(client), "Ray": farm.on(ray)}
        for turn in range(ROUNDS):
            walls["one process"].append(alone(program, scenario, place / "alone"))
            shutil.rmtree(place / "alone")
            for name, workers in engines.items():
                out = place / name
                begun = time.monotonic()
                report = workers.run(farm.replay(str(scenario), out=out, page=False), shards=2, progress=None)
                walls[name].append(time.monotonic() - begun)
                if not report.complete:
                    sys.exit(str(report))
                again = joined_again(program, Path(f"{out}-farm"), place / "again")
                joinings.append(again[0])
                peak = again[1]
                for folder in (out, Path(f"{out}-farm"), place / "again"):
                    shutil.rmtree(folder)
                print(f"round {turn}: {name} {walls[name][-1]:.1f} s, one process {walls['one process'][-1]:.1f} s", file=sys.stderr, flush=True)
        small = farm.replay(str(repeated(place, max(1, missions // 10))), out=place / "small", page=False)
        engines["processes"].run(small, shards=2, progress=None)
        of_a_tenth = joined_again(program, place / "small-farm", place / "again")[1]
    drawn = sum(walls["one process"])
    rates = {name: round(drawn / sum(walls[name]), 4) for name in LEAST}
    return {
        "scenario": f"nominal-drive, there and back {missions} times, {frames} frames, pra-nominal",
        "rounds": ROUNDS,
        "drawing_s": round(drawn, 1),
        "frames_per_s_of_one_process": round(ROUNDS * frames / drawn, 3),
        "share_of_its_frames_per_s": rates,
        "at_least": LEAST,
        "joining_as_a_share_of_drawing": round(sum(joinings) / len(joinings) / (drawn / ROUNDS), 5),
        "joining_at_most": JOINING,
        "peak_memory_of_joining_bytes": {"a tenth of the frames": of_a_tenth, "all": peak},
    }


class Timed(Processes):
    """Plain processes that note when each of them ends its last shard."""

    def __init__(self) -> None:
        super().__init__(2)
        self.begun = math.inf
        self.ends: dict[int, float] = {}

    def start(self, task: Task) -> Future[Outcome]:
        self.begun = min(self.begun, time.monotonic())
        return self._pool.submit(self._timed, task)

    def _timed(self, task: Task) -> Outcome:
        import threading

        outcome = draw(task, self._hold)
        self.ends[threading.get_ident()] = time.monotonic() - self.begun
        return outcome


def evenly(place: Path) -> dict[str, Any]:
    engine = Timed()
    scenario, out = uneven(place), place / "even"
    report = farm.on(engine).run(farm.replay(str(scenario), machine="exact", out=out, page=False), progress=None)
    if not report.complete:
        sys.exit(str(report))
    times: list[float] = []
    for path in Path(f"{out}-farm").glob("*-shard-*-of-*/performance.json"):
        times += [seconds for _, seconds in json.loads(path.read_text())["frames_s"]]
    mean = sum(engine.ends.values()) / len(engine.ends)
    return {
        "scenario": "first-light by exact, from the sky down to the ground",
        "frames": len(times),
        "slowest_frame_over_fastest": round(max(times) / min(times), 1),
        "shards": report.shards,
        "workers_s": sorted(round(end, 2) for end in engine.ends.values()),
        "last_worker_after_the_mean": round(max(engine.ends.values()) / mean - 1.0, 4),
        "at_most": LAST,
    }


def main(program: str, out: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        cost = evenly(place)
        print(json.dumps(cost), file=sys.stderr, flush=True)
        engines = engines_beside_one(program, place)
    record = {
        "schema": "lunoid.farm-rates/1",
        "command": ".ci/farm rates",
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%d"),
        "commit": subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip(),
        "engines": engines,
        "by_cost": cost,
        "not_run": "a cluster of several computers",
    }
    Path(out).write_text(json.dumps(record, indent=2) + "\n")
    print(Path(out).read_text())
    held = (
        all(engines["share_of_its_frames_per_s"][name] >= least for name, least in LEAST.items())
        and engines["joining_as_a_share_of_drawing"] <= JOINING
        and cost["slowest_frame_over_fastest"] >= TENFOLD
        and cost["last_worker_after_the_mean"] <= LAST
    )
    if not held:
        sys.exit("a figure does not hold")


# Workers of Dask import this file.
if __name__ == "__main__":
    main(*sys.argv[1:])
