"""Bad input: one exception, with its fields."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lunoid


def test_three_faults_are_one_error(scene) -> None:
    text = scene.read_text().replace("seed = 3", "seed = -3").replace("start_m = 2", 'start_m = "two"')
    scene.write_text(text.replace("elevation_deg = 15", "elevation_deg = 15\nstray = 1"))
    with pytest.raises(lunoid.InputError) as error:
        lunoid.open(scene)
    faults = error.value.faults
    lines = scene.read_text().splitlines()
    assert [lines[fault.line - 1] for fault in faults] == ["seed = -3", "stray = 1", 'start_m = "two"']
    assert error.value.file == str(scene) and error.value.line == faults[0].line and error.value.expected
    assert all(word in str(error.value) for word in ("seed", "stray", "start_m"))


ENDLESS: list[object] = []
ENDLESS.append(ENDLESS)


@pytest.mark.parametrize(
    "call",
    [
        lambda drive: drive.frame(4),
        lambda drive: drive.frame(-1),
        lambda drive: drive.truth(0, "depth"),
        lambda drive: drive.probe("zz"),
        lambda drive: drive.probe("tg.*", sweep=40),
        lambda drive: drive.probe("tg.*", sweep=range(0, 10, 2)),
        lambda drive: drive.explain(0, 40, 0),
        lambda drive: drive.study("speed"),
        lambda drive: drive.study(only=["nothing"]),
        lambda drive: drive.look(lunoid.Pose((100, 200, -500))),
        lambda drive: drive.look(lunoid.Pose((100, 200, 5), heading_deg=math.nan)),
        lambda drive: lunoid.Pose(np.zeros((3, 3))),
        lambda drive: lunoid.Pose((1, 2)),
        lambda drive: lunoid.Pose(("a", 2, 3)),
        lambda drive: drive.loop().look(lunoid.Pose((1e30, 0, 0))),
        lambda drive: lunoid.open("no/such.toml"),
        lambda drive: lunoid.open(drive.file, machine="no-such-machine"),
        lambda drive: lunoid.open(drive.file, set={"loader.nothing": 1}),
        lambda drive: lunoid.open(drive.file, set={"loader.access_ns": object()}),
        lambda drive: drive.look(lunoid.Pose((100, 200, 5), yoke_deg=30)),
        lambda drive: drive.look(lunoid.Pose((100, 200, 5), time_s=1e300)),
        lambda drive: drive.look(None),
        lambda drive: drive.look(drive.pose(0), frame=1.5),
        lambda drive: drive.frame("a"),
        lambda drive: drive.frame(True),
        lambda drive: drive.truth(0, 5),
        lambda drive: drive.probe(5),
        lambda drive: drive.probe("tg.*", sweep="a"),
        lambda drive: drive.explain(0, None, 0),
        lambda drive: drive.study(only="parts"),
        lambda drive: drive.loop().look(5),
        lambda drive: drive.loop().ahead(drive.pose(0), metres="far"),
        lambda drive: drive.loop().save(5),
        lambda drive: lunoid.open(5),
        lambda drive: lunoid.open(drive.file, machine=5),
        lambda drive: lunoid.open(drive.file, set=["a=1"]),
        lambda drive: lunoid.open(drive.file, overlays="a.toml"),
        lambda drive: lunoid.open(drive.file, sweeps=2**40),
        lambda drive: lunoid.open(drive.file, threads=-1),
        lambda drive: lunoid.open(drive.file, economy="all"),
        lambda drive: lunoid.open("\ud800.toml"),
        lambda drive: lunoid.open(drive.file, machine="a\0b"),
        lambda drive: lunoid.open(drive.file, sweeps=10**5000),
        lambda drive: lunoid.open(drive.file, set={"loader.access_ns": 10**5000}),
        lambda drive: lunoid.open(drive.file, set={"loader.access_ns": 2**63}),
        lambda drive: lunoid.open(drive.file, set={"scenario.title": "\ud800"}),
        lambda drive: lunoid.open(drive.file, set={"scenario.title": ENDLESS}),
        lambda drive: lunoid.Pose("123"),
        lambda drive: lunoid.Pose({3, 1, 2}),
        lambda drive: lunoid.Pose(("1", "2", "3")),
        lambda drive: lunoid.Pose((True, 2, 3)),
        lambda drive: lunoid.Pose((np.complex128(1 + 5j), 2, 3)),
        lambda drive: lunoid.Pose((10**5000, 2, 3)),
        lambda drive: drive.loop().ahead(drive.pose(0), metres=True),
        lambda drive: drive.truth(0, "range", "pose"),
        lambda drive: drive.probe("tg.*", sweep=2**32 - 1),
        lambda drive: drive.study(np.array([1, 2])),
        lambda drive: drive.frame(0).light("nope"),
        lambda drive: drive.frame(0).light([]),
        lambda drive: drive.frame(0).save("/nope/x.png"),
        lambda drive: drive.frame(0).save(5),
    ],
)
def test_what_cannot_be_is_an_input_error(drive: lunoid.Drive, call) -> None:
    with pytest.raises(lunoid.InputError) as error:
        call(drive)
    assert error.value.faults and str(error.value) and len(str(error.value)) < 2000


def test_settings_are_values(scene) -> None:
    plain = lunoid.open(scene, machine="pra-nominal")
    late = lunoid.open(scene, machine="pra-nominal", set={"sweep.dac_bits": 4, "scenario.frames": 9})
    assert late.frames == 9 and late.frame(1).hash != plain.frame(1).hash
    assert late.explain(2, 20, 20).document["frame"] == 2
    turned = lunoid.open(scene, set={"scenario.sun.azimuth_deg": np.float64(90.0), "sampled.overload": "late"})
    assert turned.frame(0).hash != lunoid.open(scene).frame(0).hash


def test_texts_and_arrays_are_those_of_the_file(scene) -> None:
    title = "🚀 é \"quoted\""
    assert lunoid.open(scene, set={"scenario.title": title}).title == title
    ends = np.array([3.0, 250.0])
    settings = {"scenario.range.start_m": ends[0], "scenario.landscape.generated.extent_m": np.array([400, 400])}
    by_arrays = lunoid.open(scene, set=settings).frame(0).hash
    assert by_arrays == lunoid.open(scene, set={"scenario.range.start_m": 3.0}).frame(0).hash


def test_numbers_of_numpy_are_numbers() -> None:
    plain = lunoid.Pose((1.0, 2.0, 3.0), heading_deg=4.0)
    assert lunoid.Pose(np.array([1, 2, 3]), heading_deg=np.float32(4)) == plain
    assert lunoid.Pose(iter([1, 2, 3]), heading_deg=np.array(4.0)) == plain  # type: ignore[arg-type]
