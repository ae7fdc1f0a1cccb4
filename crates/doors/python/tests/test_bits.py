"""The package has the bits of the record that `tests/pictures` keeps of every shipped scenario."""

from __future__ import annotations

import json

import blake3
import numpy as np
import pytest
from conftest import ROOT

import lunoid

KEPT = json.loads((ROOT / "tests/pictures/hashes.json").read_text())


@pytest.mark.parametrize(
    ("scenario", "machine", "frame"),
    [("first-light", "ideal", 45), ("first-light", "pra-nominal", 0), ("full-drive", "ideal", 0), ("first-light", "exact", 0)],
)
def test_frames_have_the_kept_hashes(scenario: str, machine: str, frame: int) -> None:
    # The record has the machines at their finest.
    picture = lunoid.open(f"scenarios/{scenario}.toml", machine=machine, economy="bounded").frame(frame)
    hasher = blake3.blake3(picture.light("intensity").astype("<f4").tobytes())
    assert hasher.hexdigest()[:32] == KEPT[f"{scenario}, {machine}, frame {frame}"]


def test_the_default_has_the_kept_hashes_of_the_default() -> None:
    picture = lunoid.open("scenarios/full-drive.toml", machine="ideal").frame(60)
    hasher = blake3.blake3(picture.light("intensity").astype("<f4").tobytes())
    assert hasher.hexdigest()[:32] == KEPT["full-drive, normal, frame 60"]


def test_threads_change_no_bit(scene) -> None:
    one, five = (lunoid.open(scene, machine="pra-nominal", threads=count).frame(3) for count in (1, 5))
    assert one.hash == five.hash
    assert np.array_equal(one, five)
