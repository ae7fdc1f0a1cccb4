"""Runs on many workers: the joined folder is that of one machine, whatever becomes of the workers."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import SCENE
from killing import content, run_with_a_kill

import lunoid
from lunoid import farm
from lunoid.farm import _worker

PROGRAM = os.environ.get("LUNOID", "lunoid")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with `scene.toml`, from which everything is called."""
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(SCENE.replace("frames = 4", "frames = 12"))
    return tmp_path


@pytest.fixture
def whole(place: Path) -> dict[str, bytes]:
    """The run of one machine."""
    subprocess.run([PROGRAM, "replay", "scene.toml", "--truth", "range,label", "--out", "whole", "--quiet"], check=True)
    return content(place / "whole")


def job(**options: object) -> farm.Job:
    return farm.replay("scene.toml", truth=["range", "label"], out="joined", **options)  # type: ignore[arg-type]


def status(folder: str = "joined-farm") -> dict:
    ended = subprocess.run([PROGRAM, "farm", "status", folder, "--json"], capture_output=True, check=False)
    return json.loads(ended.stdout)["runs"][0]


def test_a_farm_goes_on_after_a_job_that_no_worker_can_do(place: Path, whole: dict[str, bytes]) -> None:
    workers = farm.on(None, workers=2)
    with pytest.raises(lunoid.InputError, match="13"):
        workers.run(job(), shards=13, progress=None)
    assert workers.run(job(), shards=2, progress=None).complete
    assert content(place / "joined") == whole


@pytest.mark.parametrize("shards", [1, 2, 7, "by cost"])
def test_joined_shards_are_the_run_of_one_machine(whole, shards) -> None:
    heard: list[farm.Progress] = []
    report = farm.on(None, workers=2).run(job(), shards=shards, progress=heard.append)
    assert report.complete and report.frames == 12
    assert (heard[-1].shards, heard[-1].of, heard[-1].frames) == (report.shards, report.shards, 12)
    assert report.shards == (8 if shards == "by cost" else shards) == report.tries
    assert content(Path("joined")) == whole
    # The same job again has nothing to do.
    before = {path: path.stat().st_mtime_ns for path in Path("joined").rglob("*") if path.is_file()}
    again = farm.on(None, workers=1).run(job(), shards=shards)
    assert again.shards == report.shards
    assert content(Path("joined")) == whole and before.keys() == {path for path in Path("joined").rglob("*") if path.is_file()}


def program(folder: Path, script: str) -> str:
    """A command that does `script` before it is lunoid."""
    path = folder / "lunoid-of-a-test"
    path.write_text(f"#!/bin/sh\nreal={shutil.which(PROGRAM)}\n{script}\nexec \"$real\" \"$@\"\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


IS_SHARD_2 = 'case "$*" in *"--shard 2/4"*) '


def test_a_worker_that_is_killed_is_replaced(place, whole) -> None:
    # The first try of shard 2 draws a part, and is killed.
    script = IS_SHARD_2 + f'if [ ! -e {place}/killed ]; then touch {place}/killed; "$real" "$@" & sleep 0.02; kill -9 $!; kill -9 $$; fi;; esac'
    report = farm.on(None, workers=2, program=program(place, script)).run(job(), shards=4)
    assert (report.complete, report.tries) == (True, 5)
    assert content(Path("joined")) == whole


def test_a_shard_that_always_fails_is_set_aside_and_its_command_makes_it(place, whole) -> None:
    script = IS_SHARD_2 + f'if [ -e {place}/full ]; then echo "error: no space left" >&2; exit 4; fi;; esac'
    (place / "full").touch()
    report = farm.on(None, workers=2, program=program(place, script)).run(job(), shards=4)
    assert not report.complete and not Path("joined").exists()
    (missing,) = report.set_aside
    assert (missing.shard, missing.tries) == ("2/4", 3)
    assert missing.why.endswith("no space left") and "this makes it" in str(report)
    states = [shard["state"] for shard in status()["shards"]]
    assert states == ["done", "failed", "done", "done"]
    (place / "full").unlink()
    subprocess.run(missing.command, shell=True, check=True, capture_output=True, cwd="/")
    assert [shard["state"] for shard in status()["shards"]] == ["done"] * 4
    report = farm.on(None, workers=2, program=program(place, script)).run(job(), shards=4)
    assert report.complete and content(Path("joined")) == whole
    assert not list(Path("joined-farm").glob("*.failed.json"))


def test_a_full_disk_is_said_and_the_rest_goes_on_later(place, whole) -> None:
    # A limit on the size of files is what the system has for a disk that is full.
    script = f'case "$*" in *"--shard"*"/4"*) if [ -e {place}/full ]; then trap "" XFSZ; ulimit -f 0; fi;; esac'
    (place / "full").touch()
    report = farm.on(None, workers=2, program=program(place, script)).run(job(), shards=4, retries=1)
    assert len(report.set_aside) == 4 and all(one.why for one in report.set_aside), str(report)
    (place / "full").unlink()
    assert farm.on(None, workers=2, program=program(place, script)).run(job(), shards=4).complete
    assert content(Path("joined")) == whole


def test_two_workers_on_one_shard_draw_it_once(place) -> None:
    # Shards that take longer than the command waits for a lock.
    slow = job(sweeps=600, samples=600)
    subprocess.run([PROGRAM, "replay", *slow.words, "--out", "whole", "--quiet"], check=True)

    class Twice:
        """Gives every task to two workers, and waits for both."""

        name = "twice"

        def workers(self) -> int:
            return 2

        def start(self, task):
            outcomes: list = []
            threads = [threading.Thread(target=lambda: outcomes.append(_worker.draw(task))) for _ in range(2)]
            for thread in threads:
                thread.start()
            return threads, outcomes

        def is_ready(self, started) -> bool:
            return not any(thread.is_alive() for thread in started[0])

        def outcome(self, started):
            assert [outcome["done"] for outcome in started[1]] == [True, True], started[1]
            return started[1][0]

        def stop(self) -> None:
            pass

    report = farm.on(Twice()).run(slow, shards=2)
    assert report.complete and content(Path("joined")) == content(Path("whole"))


def test_a_worker_with_another_program_or_file_refuses_by_name(place) -> None:
    script = f'if [ -e {place}/other ] && [ "$1" = --version ]; then echo "lunoid 9.9.9"; exit; fi'
    named = program(place, script)

    class Changed:
        """Changes something between the plan and the worker."""

        name = "changed"

        def __init__(self, change: Callable[[], object]) -> None:
            self.change = change

        def workers(self) -> int:
            return 1

        def start(self, task):
            self.change()
            return _worker.draw(task)

        def is_ready(self, started) -> bool:
            return True

        def outcome(self, started):
            return started

        def stop(self) -> None:
            pass

    report = farm.on(Changed((place / "other").touch), program=named).run(job(), shards=1, retries=1)
    assert "found lunoid 9.9.9, expected lunoid 0.1.0" in report.set_aside[0].why
    (place / "other").unlink()
    change = lambda: (place / "joined-farm/inputs/scene.toml").write_text("x")  # noqa: E731
    report = farm.on(Changed(change), program=named).run(job(), shards=1, retries=1)
    assert "joined-farm/inputs/scene.toml: found " in report.set_aside[0].why


def test_an_engine_without_workers_is_not_waited_for_without_end(place, monkeypatch: pytest.MonkeyPatch) -> None:
    class Empty:
        """Takes tasks, and has nobody who does them."""

        name = "empty"

        def workers(self) -> int:
            return 0

        def start(self, task):
            return task

        def is_ready(self, started) -> bool:
            return False

        def outcome(self, started):
            raise AssertionError("nothing is ready")

        def stop(self) -> None:
            self.stopped = True

    engine = Empty()
    monkeypatch.setattr("lunoid.farm._run._ALONE_S", 1.0)
    with pytest.raises(farm.FarmError, match="empty has had no worker for 1 s; start workers"):
        farm.on(engine).run(job(), shards=2)
    assert engine.stopped


def test_two_programs_that_begin_at_once_lose_nothing(place, whole) -> None:
    script = "import sys; from lunoid import farm; farm.on(None, workers=1).run(farm.replay('scene.toml', truth=['range', 'label'], out='joined'), shards=2)"
    both = [subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True) for _ in range(2)]
    said = [process.communicate()[1] for process in both]
    assert 0 in [process.returncode for process in both], said
    for process, text in zip(both, said):
        assert process.returncode == 0 or "is drawing into this folder" in text, text
    assert content(Path("joined")) == whole


def test_a_folder_has_one_job(place) -> None:
    farm.on(None, workers=2).run(job(), shards=2)
    with pytest.raises(lunoid.InputError, match="3 shards; expected the 2 shards"):
        farm.on(None, workers=2).run(job(), shards=3)
    with pytest.raises(lunoid.InputError, match="another job: `by` differs"):
        farm.on(None, workers=2).run(job())
    with pytest.raises(lunoid.InputError, match="another job: `words` differs"):
        farm.on(None, workers=2).run(job(machine="pra-nominal"), shards=2)
    Path("scene.toml").write_text(Path("scene.toml").read_text() + "# changed\n")
    with pytest.raises(lunoid.InputError, match="another job: `inputs` differs"):
        farm.on(None, workers=2).run(job(), shards=2)


def test_faults_are_told_of_once_before_any_worker_starts(place) -> None:
    with pytest.raises(lunoid.InputError, match="gone.toml") as gone:
        farm.on(None).run(farm.replay("gone.toml", out="joined"), shards=2)
    assert gone.value.file == "gone.toml"
    Path("odd.toml").write_text(Path("scene.toml").read_text().replace("seed = 3", "seed = -3"))
    with pytest.raises(lunoid.InputError, match="seed") as odd:
        farm.on(None).run(farm.replay("odd.toml", out="joined"), shards=2)
    assert odd.value.file == "odd.toml" and odd.value.line
    with pytest.raises(lunoid.InputError, match="the run has 12 frames, expected at most as many shards"):
        farm.on(None, workers=2).run(job(), shards=13)
    with pytest.raises(lunoid.InputError, match=r"frames range\(3, 3\)"):
        job(frames=range(3, 3))
    for wrong in (0, -1, "by size", 2.5):
        with pytest.raises(lunoid.InputError, match="shards "):
            farm.on(None).run(job(), shards=wrong)  # type: ignore[arg-type]
    with pytest.raises(lunoid.InputError, match="folder of the shards cannot be made"):
        farm.on(None).run(farm.replay("scene.toml", out="/proc/none/joined"), shards=2)
    with pytest.raises(lunoid.InputError, match="no job"):
        farm.on(None).run("scene.toml")  # type: ignore[arg-type]
    for odd in (dict(truth=[""]), dict(page="no"), dict(refresh=1), dict(machine="--help"), dict(machine="a\0b")):
        with pytest.raises(lunoid.InputError):
            farm.replay("scene.toml", out="joined", **odd)  # type: ignore[arg-type]
    with pytest.raises(lunoid.InputError, match="`out` is ''"):
        farm.replay("scene.toml", out="")
    with pytest.raises(lunoid.InputError, match="-help"):
        farm.on(None).run(farm.replay("--help", out="joined"), shards=2)
    with pytest.raises(lunoid.InputError, match="`progress` is 5"):
        farm.on(None).run(job(), shards=2, progress=5)  # type: ignore[arg-type]
    Path("stands").write_text("x")
    with pytest.raises(lunoid.InputError, match="something else stands"):
        farm.on(None).run(farm.replay("scene.toml", out="stands"), shards=2)
    with pytest.raises(lunoid.InputError, match="no such program"):
        farm.on(None, program="no-such-lunoid").run(job(), shards=2)


def test_an_engine_that_is_not_there_is_one_message(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, module, package in (("ray", "ray", "ray"), ("dask", "distributed", r"dask\[distributed\]")):
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(lunoid.InputError, match=f"{package} is not installed.*pip install"):
            farm.on(name)
    with pytest.raises(lunoid.InputError, match="no engine: 'slurm'"):
        farm.on("slurm")


def test_no_file_is_unpickled() -> None:
    sources = Path(farm.__file__).parent.glob("*.py")
    assert not [path for path in sources if "pickle" in path.read_text() or "marshal" in path.read_text()]


@pytest.mark.parametrize("with_child", [True, False])
def test_dask_and_a_worker_killed(place, whole, with_child) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            drawn_with_a_kill(farm.on(client), whole, with_child)
            # A result that is held would be worked out again when its worker is lost.
            assert not client.futures


@pytest.mark.parametrize("with_child", [True, False])
def test_ray_and_a_worker_killed(place, whole, with_child) -> None:
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        drawn_with_a_kill(farm.on(ray), whole, with_child)
    finally:
        ray.shutdown()


def drawn_with_a_kill(workers: farm.Farm, whole: dict[str, bytes], with_child: bool) -> None:
    report, victims = run_with_a_kill(workers, job(), Path("joined-farm").absolute(), with_child)
    assert len(victims) == (2 if with_child else 1), "no worker was killed in time"
    assert report.complete, str(report)
    assert content(Path("joined")) == whole
