"""Closed loops: memory, what is saved, what is closed."""

from __future__ import annotations

import pytest

import lunoid


@pytest.mark.parametrize("machine", ["ideal", "pra-overloaded"])
def test_what_was_driven_is_a_scenario(scene, tmp_path, machine: str) -> None:
    drive = lunoid.open(scene, machine=machine)
    hashes = []
    with drive.loop() as loop:
        pose = drive.pose(0)
        for step in range(7):
            seen = loop.look(pose)
            assert seen.frame == step == round(seen.pose.time_s * drive.update_hz)
            hashes.append(seen.hash)
            pose = loop.ahead(pose.turned(7.5 * step), metres=0.3)
        loop.save(tmp_path / "driven")
    again = lunoid.open(tmp_path / "driven/scenario.toml", machine=machine)
    assert again.frames == 7
    assert [again.frame(frame).hash for frame in range(7)] == hashes


def test_memory_is_asked_for(scene) -> None:
    drive = lunoid.open(scene, machine="pra-overloaded")
    assert drive.remembers_frames
    with pytest.raises(lunoid.InputError, match="frames before their own") as error:
        drive.look(drive.pose(0))
    assert error.value.help == "look in a loop, which keeps what was driven"


def test_a_free_look_needs_no_loop(drive: lunoid.Drive) -> None:
    pose = drive.pose(2)
    assert drive.look(pose).frame == 2
    assert drive.look(pose.turned(20)).hash != drive.look(pose).hash


def test_closed_is_closed(drive: lunoid.Drive) -> None:
    loop = drive.loop()
    drive.close()
    assert loop.look(lunoid.Pose((100, 200, 9))).frame == 0
    loop.close()
    for call in (lambda: drive.frame(0), lambda: loop.frames, lambda: drive.loop()):
        with pytest.raises(lunoid.InputError, match="closed"):
            call()
