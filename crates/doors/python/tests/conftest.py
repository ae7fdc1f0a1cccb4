"""Scenes of the tests. All tests run from the root of the repository."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import lunoid

ROOT = Path(__file__).resolve().parents[4]
os.chdir(ROOT)

SCENE = """
format = 1
title = "A bump ahead"
shows = "Nothing but a test."
frames = 4
[landscape.generated]
seed = 3
extent_m = [400, 400]
region_size_m = 50
[landscape.generated.undulation]
rms_height_m = 2
hurst = 0.9
longest_m = 300
shortest_m = 160
waves = 20
[sun]
azimuth_deg = 100
elevation_deg = 15
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 108, y_m = 205 }]
[raster]
sweeps = 40
samples_per_sweep = 80
update_hz = 10
refresh_hz = 30
[range]
programme = "geometric"
start_m = 2
end_m = 300
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """File of a scene that is drawn in a few milliseconds."""
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


@pytest.fixture
def drive(scene: Path) -> lunoid.Drive:
    """The scene, opened."""
    return lunoid.open(scene)
