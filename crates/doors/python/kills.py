"""Workers killed in mid-shard, so often by each engine; the joined folder must be that of one machine. The record is docs/trust/farm.json."""

from __future__ import annotations

import json
import platform
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import contextmanager
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path
from typing import Any, Iterator

sys.path.insert(0, str(Path(__file__).parent / "tests"))

from killing import content, run_with_a_kill

from lunoid import farm

SCENARIO = "scenarios/first-light.toml"
FRAMES = range(24)
SMALL = {"scenario.raster.columns": 60, "scenario.raster.lines": 40}
OPTIONS: dict[str, Any] = {"frames": FRAMES, "sweeps": 60, "samples": 80, "set": SMALL, "machine": "pra-nominal", "truth": ["range", "label"]}


@contextmanager
def workers_of(scheduler: str) -> Iterator[None]:
    """Two workers of a Dask scheduler without nannies: whoever ends is started again here, as a cluster does it. A nanny was seen to end
    a worker that nobody had killed, and to start none."""
    command = [sys.executable, "-m", "distributed.cli.dask_worker", scheduler, "--no-nanny", "--nthreads", "1", "--no-dashboard"]
    over = threading.Event()

    def hold() -> None:
        while not over.is_set():
            with tempfile.TemporaryDirectory() as own:
                worker = subprocess.Popen([*command, "--local-directory", own], stderr=subprocess.DEVNULL)
                while worker.poll() is None and not over.wait(0.05):
                    pass
                worker.kill()
                worker.wait()

    holders = [threading.Thread(target=hold) for _ in range(2)]
    for holder in holders:
        holder.start()
    try:
        yield
    finally:
        over.set()
        for holder in holders:
            holder.join()


@contextmanager
def engine(name: str) -> Iterator[Any]:
    """An engine with two workers."""
    if name == "processes":
        yield farm.on(None, workers=2)
    elif name == "Dask":
        import distributed

        with (
            distributed.LocalCluster(n_workers=0, dashboard_address=None) as cluster,
            workers_of(cluster.scheduler_address),
            distributed.Client(cluster) as client,
        ):
            client.wait_for_workers(2)
            yield farm.on(client)
    else:
        import ray

        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
        yield farm.on(ray)
        ray.shutdown()


def main(program: str, kills: int, names: list[str], out: str) -> None:
    record: dict[str, Any] = {
        "schema": "lunoid.farm-kills/1",
        "command": ".ci/farm",
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%d"),
        "commit": subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip(),
        "python": platform.python_version(),
        "scenario": SCENARIO,
        "options": {**OPTIONS, "frames": [FRAMES.start, FRAMES.stop]},
        "workers": 2,
        "shards": 2,
        "engines": [],
    }
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        whole = drawn_whole(program, place)
        for name in names:
            record["engines"].append({})
            for counts in one_engine(name, kills, place, whole):
                # A record that is cut short has what was counted so far.
                record["engines"][-1] = counts
                Path(out).write_text(json.dumps(record, indent=2) + "\n")
    print(Path(out).read_text())


def drawn_whole(program: str, place: Path) -> dict[str, bytes]:
    job = farm.replay(SCENARIO, out=place / "whole", **OPTIONS)
    subprocess.run([program, "replay", *job.words, "--out", job.out, "--quiet"], check=True)
    return content(place / "whole")


def one_engine(name: str, kills: int, place: Path, whole: dict[str, bytes]) -> Iterator[dict[str, Any]]:
    """Runs until `kills` workers were killed; the counts after each run."""
    package = {"Dask": "distributed", "Ray": "ray"}.get(name)
    counts = {"runs": 0, "workers_killed": 0, "with_its_command": 0, "tries": 0, "equal": 0}
    begun = time.monotonic()
    with engine(name) as workers:
        while counts["workers_killed"] < kills:
            joined = place / "joined"
            with_child = counts["runs"] % 2 == 0
            report, victims = run_with_a_kill(workers, farm.replay(SCENARIO, out=joined, **OPTIONS), Path(f"{joined}-farm"), with_child)
            if not report.complete:
                sys.exit(str(report))
            if content(joined) != whole:
                sys.exit(f"{name}, run {counts['runs']}: the joined folder is not that of one machine")
            counts["runs"] += 1
            counts["workers_killed"] += bool(victims)
            counts["with_its_command"] += len(victims) > 1 or name == "processes" and bool(victims)
            counts["tries"] += report.tries
            counts["equal"] += 1
            shutil.rmtree(joined)
            shutil.rmtree(f"{joined}-farm")
            print(f"{name}: {counts['workers_killed']} killed in {counts['runs']} runs", file=sys.stderr)
            yield {"engine": name, "version": version(package) if package else None, **counts, "seconds": round(time.monotonic() - begun)}


# Workers of Dask import this file.
if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3].split(","), sys.argv[4])
