"""Arrays without a copy, pictures that show themselves, truth with its bound, signals with units."""

from __future__ import annotations

import io

import matplotlib
import numpy as np
import pytest
import xarray
from PIL import Image

import lunoid

matplotlib.use("Agg")


def test_a_picture_is_a_view(drive: lunoid.Drive) -> None:
    picture = drive.frame(1)
    view = np.asarray(picture)
    assert np.shares_memory(view, picture.codes) and view.dtype == np.uint8
    assert view.shape == (drive.raster["lines"], drive.raster["columns"]) == picture.shape
    with pytest.raises(ValueError):
        view[0, 0] = 1
    copy = np.array(picture, dtype=np.float32)
    assert not np.shares_memory(copy, view) and np.array_equal(copy, view)
    with pytest.raises(ValueError):
        picture.__array__(np.dtype(np.float32), copy=False)


def test_arrays_outlive_what_they_came_from(drive: lunoid.Drive) -> None:
    view = np.asarray(drive.frame(1))
    kept = view.copy()
    truth = drive.truth(1, "range")["range"]
    far = truth.copy()
    drive.close()
    [bytearray(1 << 20) for _ in range(20)]
    assert np.array_equal(view, kept) and np.array_equal(truth, far)


def test_a_picture_shows_itself(drive: lunoid.Drive, tmp_path) -> None:
    picture = drive.frame(2)
    shown = Image.open(io.BytesIO(picture._repr_png_()))
    assert np.array_equal(np.asarray(shown), picture)
    picture.save(tmp_path / "two.png")
    assert np.array_equal(np.asarray(Image.open(tmp_path / "two.png")), picture)


def test_rows_run_down_and_columns_to_the_right(drive: lunoid.Drive) -> None:
    """Sky is above the ground: a plane turned round would have it beside."""
    label = drive.truth(0, "label")["label"]
    sky = label == drive.truth(0, "label").codes["label"].index("sky")
    assert sky[0].all() and not sky[-1].any()
    near = drive.truth(0, "range")["range"]
    assert np.isinf(near[sky]).all() and np.isfinite(near[~sky]).all()
    columns = [drive.explain(0, column, label.shape[0] - 1).document["place"]["between_sweeps"] for column in (2, 30)]
    assert columns[0] < columns[1]


def test_colour_has_three_codes(scene) -> None:
    picture = lunoid.open("scenarios/colours.toml", machine="exact", sweeps=64).frame(0)
    assert picture.shape[2] == 3
    assert [picture.light(name).shape for name in ("red", "green", "blue")] == [picture.shape[:2]] * 3
    with pytest.raises(lunoid.InputError):
        picture.light("intensity")


def test_truth_has_units_codes_and_bounds(drive: lunoid.Drive) -> None:
    truth = drive.truth(1)
    assert list(truth) == ["range", "height", "normal", "reflectivity", "shadow", "label", "distance"]
    assert truth["normal"].shape == (*drive.frame(1).shape, 3)
    assert truth.unit["distance"] == "m" and truth.bound["label"] == 0 < truth.bound["range"] < 1e-6
    ground = truth["label"] == 1
    assert np.allclose(np.linalg.norm(truth["normal"][ground], axis=1), 1, atol=1e-6)
    assert (truth["distance"][ground] >= truth["range"][ground] * (1 - 1e-6)).all()


def test_signals_have_axes(drive: lunoid.Drive) -> None:
    waves = drive.probe("mu.height", "sm.write", "sweep.fold.x", frame=1, sweep=range(10, 14))
    height, written, folds = waves["mu.height"], waves["sm.write"], waves["sweep.fold.x"]
    assert (height.unit, height.values.shape, height.place_unit) == ("m", (4, 80), "m")
    assert written.values.shape[0] == 4 and written.place[0, 1] == 1
    assert folds.axis == "changes" and folds.values.shape == folds.place.shape
    one = drive.probe("mu.height", frame=1, sweep=11)["mu.height"]
    assert np.array_equal(one.values, height.values[1]) and (np.diff(one.place) > 0).all()
    array = one.xarray
    assert isinstance(array, xarray.DataArray)
    assert (array.dims, array.attrs["units"], array.range.attrs["units"]) == (("range",), "m", "m")
    assert height.xarray.dims == ("sweep", "sample") and written.xarray.dims == ("sweep", "line")
    assert one.plot() is not None and len(height.plot()) == 4


def test_a_study_is_a_table(scene) -> None:
    study = lunoid.open(scene).study("error", only=["samples"])
    assert set(study.frame.ladder) == {"samples"} and len(study.rows) == len(study.frame) > 5
