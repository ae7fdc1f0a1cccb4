"""What is to be drawn: a replay, in the words of the command."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any, Literal

from .. import _asked
from .._errors import refused
from .._toml import value as _toml_value

_Path = str | PathLike[str]

_ECONOMIES = ("bounded", "lossless", "everything", "preview")

_TRIAL_RASTER = ("--sweeps", "24", "--samples", "40")


@dataclass(frozen=True)
class Job:
    """A replay that workers share. Made by :func:`replay`."""

    scenario: str
    """File of the scenario, from the folder of the caller on."""
    stage: tuple[str, ...]
    """Options of the command that choose scenario, machine and ground."""
    raster: tuple[str, ...]
    """Options of the command that state the raster of the signals."""
    pictures: tuple[str, ...]
    """Options of the command that state what becomes of a frame."""
    frames: tuple[str, ...]
    """Option of the command that states the frames; empty for all."""
    files: tuple[str, ...]
    """Files that the options name."""
    out: str
    """Folder of the joined run."""

    @property
    def words(self) -> list[str]:
        """Words of the whole run, behind ``lunoid replay``."""
        return [self.scenario, *self.stage, *self.raster, *self.pictures, *self.frames]

    @property
    def costs(self) -> list[str]:
        """Words of the same run with a small raster, whose times say where the shards are cut."""
        return [self.scenario, *self.stage, *_TRIAL_RASTER, *self.frames, "--no-page"]

    @property
    def has_page(self) -> bool:
        """Whether the joined run has a page."""
        return "--no-page" not in self.pictures


def replay(
    scenario: _Path,
    *,
    frames: range | None = None,
    truth: Sequence[str] = (),
    out: _Path,
    machine: str | None = None,
    overlays: Sequence[_Path] = (),
    set: Mapping[str, Any] | None = None,
    channel: str | None = None,
    bank: _Path | None = None,
    sweeps: int | None = None,
    samples: int | None = None,
    scalar: Literal["f32", "f64"] | None = None,
    economy: Literal["bounded", "lossless", "everything", "preview"] = "bounded",
    depth: Literal[8, 16] = 8,
    refresh: bool = False,
    apng: bool = False,
    page: bool = True,
) -> Job:
    """A replay of ``scenario`` into the folder ``out``, with the options of ``lunoid replay`` and of :func:`lunoid.open`.

    ``frames``: numbers of frames, counted at the update rate; all if left out. ``truth``: kinds of ground truth, as ``range`` and
    ``label``. ``depth``: bits of a pixel. ``refresh``: one picture for each showing of the display. ``apng``: an animated PNG as well.

    >>> from lunoid import farm
    >>> job = farm.replay("scenarios/first-light.toml", frames=range(4), truth=["range"], out="data/first-light")
    >>> " ".join(job.words)
    'scenarios/first-light.toml --truth range --frames 0..4'
    """
    name = _asked.path("farm.replay", "scenario", scenario)
    # A word that begins with a hyphen is an option to the command.
    name = f"./{name}" if name.startswith("-") else name
    if frames is not None and not (isinstance(frames, range) and frames.step == 1 and 0 <= frames.start < frames.stop):
        raise refused(name, f"frames {_asked.shown(frames)}", found=_asked.shown(frames), expected="a range of step 1 from 0 on, as range(0, 120)")
    laid = [_asked.path(name, "overlays", file) for file in _asked.listed(name, "overlays", overlays)]
    ground = None if bank is None else _asked.path(name, "bank", bank)
    stage: list[str] = []
    stage += _option("--machine", None if machine is None else _named(name, "machine", machine))
    for file in laid:
        stage += _option("--overlay", file)
    for key, found in _asked.keyed(name, "set", set):
        stage += _option("--set", f"{key}={_toml_value(key, found)}")
    stage += _option("--channel", None if channel is None else _named(name, "channel", channel)) + _option("--bank", ground)
    stage += [] if _asked.word(name, "economy", economy, _ECONOMIES) == "bounded" else [f"--{economy}"]
    raster = _option("--sweeps", None if sweeps is None else _asked.counted(name, "sweeps", sweeps))
    raster += _option("--samples", None if samples is None else _asked.counted(name, "samples", samples))
    raster += _option("--scalar", None if scalar is None else _asked.word(name, "scalar", scalar, ("f32", "f64")))
    pictures = [] if _asked.counted(name, "depth", depth) == 8 else _option("--depth", depth)
    planes = [_asked.word(name, "truth", plane) for plane in _asked.listed(name, "truth", truth)]
    pictures += _option("--truth", ",".join(planes) or None)
    flags = {
        "--refresh": _asked.flag(name, "refresh", refresh),
        "--apng": _asked.flag(name, "apng", apng),
        "--no-page": not _asked.flag(name, "page", page),
    }
    pictures += [flag for flag, is_given in flags.items() if is_given]
    span = [] if frames is None else _option("--frames", f"{frames.start}..{frames.stop}")
    named = (*laid, *([] if ground is None else [ground]))
    folder = os.path.abspath(_asked.path(name, "out", out))
    return Job(name, tuple(stage), tuple(raster), tuple(pictures), tuple(span), named, folder)


def _named(file: str, name: str, value: object) -> str:
    word = _asked.word(file, name, value)
    if word.startswith("-"):
        raise refused(file, f"`{name}` is {word!r}", found=word, expected="a name")
    return word


def _option(name: str, value: object) -> list[str]:
    return [] if value is None else [name, str(value)]
