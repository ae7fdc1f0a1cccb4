"""An opened scenario."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from types import TracebackType
from typing import Any, Literal

from . import _asked, _native
from ._errors import refused
from ._explanation import Explanation
from ._loop import Loop
from ._picture import Picture
from ._pose import Pose
from ._study import Study
from ._toml import value as _toml_value
from ._truth import Truth
from ._waves import Waves

_Path = str | PathLike[str]

_ECONOMIES = ("normal", "bounded", "lossless", "everything", "preview")


@dataclass(frozen=True)
class Omission:
    """Something that was left out when the machine was made ready."""

    block: str
    """Block it belongs to."""
    what: str
    """What was left out."""
    why: str
    """Why it cannot touch the picture, or by how little."""
    weight: str
    """``lossless``, ``not modelled``, or the most levels of 255 by which a pixel changes."""


def open(
    scenario: _Path,
    *,
    machine: str | None = None,
    overlays: Sequence[_Path] = (),
    set: Mapping[str, Any] | None = None,
    channel: str | None = None,
    bank: _Path | None = None,
    sweeps: int | None = None,
    samples: int | None = None,
    scalar: Literal["f32", "f64"] | None = None,
    economy: Literal["normal", "bounded", "lossless", "everything", "preview"] = "normal",
    shadow_cache: _Path | None = None,
    threads: int = 0,
) -> Drive:
    """Opens a scenario and makes its ground, with the defaults of the command.

    ``machine``: hardware model by name or path, or a generator such as ``exact``; the scenario's own if left out.
    ``overlays``: files of differences over the model. ``set``: single keys and values over everything else, as
    ``{"loader.access_ns": 90, "scenario.frames": 500}``. ``channel``: view of the scenario to look through. ``bank``: ground from this
    file. ``sweeps`` (1 to 8192), ``samples`` (2 to 65536): raster of the signals. ``scalar``: type of the analog signals.
    ``economy``: what may be left out. ``shadow_cache``: folder in which shadow boundaries are kept. ``threads``: how many draw, as many
    as there are processors if 0; results do not depend on them.

    Raises InputError with all faults of files and settings.
    """
    file = _asked.path("open", "scenario", scenario)
    native = _native.Drive(
        file,
        machine=None if machine is None else _asked.word(file, "machine", machine),
        overlays=[_asked.path(file, "overlays", overlay) for overlay in _asked.listed(file, "overlays", overlays)],
        set=[(key, _toml_value(key, value)) for key, value in _asked.keyed(file, "set", set)],
        channel=None if channel is None else _asked.word(file, "channel", channel),
        bank=None if bank is None else _asked.path(file, "bank", bank),
        sweeps=None if sweeps is None else _asked.counted(file, "sweeps", sweeps),
        samples=None if samples is None else _asked.counted(file, "samples", samples),
        scalar=None if scalar is None else _asked.word(file, "scalar", scalar, ("f32", "f64")),
        economy=_asked.word(file, "economy", economy, _ECONOMIES),
        shadow_cache=None if shadow_cache is None else _asked.path(file, "shadow_cache", shadow_cache),
        threads=_asked.counted(file, "threads", threads),
    )
    return Drive(native)


class Drive:
    """A scenario on its ground, with the machine that draws it. Made by :func:`open`; several threads may share it.

    >>> import lunoid
    >>> with lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100) as drive:
    ...     drive.frames, drive.update_hz
    (90, 15.0)
    """

    def __init__(self, native: _native.Drive) -> None:
        self._native: _native.Drive | None = native
        self._facts = native.facts()
        self._process = _asked.process()

    def _open(self) -> _native.Drive:
        _asked.same_process(self.file, "drive", self._process)
        if self._native is None:
            raise refused(self.file, "the drive is closed", help="open the scenario again")
        return self._native

    @property
    def file(self) -> str:
        """File of the scenario."""
        return str(self._facts["file"])

    @property
    def title(self) -> str:
        """Title of the scenario."""
        return str(self._facts["title"])

    @property
    def machine(self) -> str:
        """Hardware model or generator that draws."""
        return str(self._facts["drawn_by"])

    @property
    def frames(self) -> int:
        """Number of frames of the scenario, counted at the update rate."""
        return int(self._facts["frames"])

    @property
    def update_hz(self) -> float:
        """Pictures computed a second (Hz)."""
        return float(self._facts["update_hz"])

    @property
    def raster(self) -> dict[str, int]:
        """``columns`` and ``lines`` of the picture, ``sweeps`` of a frame, ``samples`` of a sweep; 0 where there are none."""
        return {name: int(self._facts[name]) for name in ("columns", "lines", "sweeps", "samples")}

    @property
    def remembers_frames(self) -> bool:
        """Whether a picture shows something of frames before its own."""
        return bool(self._facts["remembers_frames"])

    @property
    def omissions(self) -> tuple[Omission, ...]:
        """What was left out, and why."""
        return tuple(Omission(*fields) for fields in self._facts["omissions"])

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is odd about the files, in words."""
        return tuple(self._facts["remarks"])

    def pose(self, frame: int) -> Pose:
        """Where the vehicle is in frame ``frame`` of the path."""
        return Pose._of(self._open().pose(self._counted("frame", frame)))

    def frame(self, frame: int) -> Picture:
        """Draws frame ``frame`` of the path: the pixels of ``lunoid replay``."""
        return Picture(self._open().frame(self._counted("frame", frame)))

    def look(self, pose: Pose, frame: int | None = None) -> Picture:
        """Draws what is seen from ``pose``, as frame ``frame``; the frame of its time if left out.

        Raises InputError for a machine with memory between frames: a loop has what was driven.
        """
        numbers = Pose._told(self.file, "pose", pose)
        number = self._frame_of(pose.time_s) if frame is None else self._counted("frame", frame)
        return Picture(self._open().look(number, numbers))

    def truth(self, frame: int, *names: str) -> Truth:
        """What each pixel of frame ``frame`` shows: ``range``, ``height``, ``distance`` (m), ``normal``, ``reflectivity``, ``shadow``,
        ``label``; all of them if none is named."""
        wanted = [_asked.word(self.file, "names", name) for name in names]
        number = self._counted("frame", frame)
        planes, error = self._open().truth(number, ",".join(wanted) if wanted else "all")
        return Truth(number, planes, error)

    def probe(self, *signals: str, frame: int = 0, sweep: int | range = 0) -> Waves:
        """Signals that match any of ``signals``, with ``*`` for any run of characters, in a sweep or a range of sweeps of a frame."""
        patterns = [_asked.word(self.file, "signals", signal) for signal in signals]
        if not isinstance(sweep, range):
            first = _asked.counted(self.file, "sweep", sweep, most=_asked.MOST - 1)
            sweep = range(first, first + 1)
        if sweep.step != 1:
            raise refused(self.file, f"sweeps {_asked.shown(sweep)}", found=_asked.shown(sweep), expected="a range of step 1")
        both = (self._counted("sweep", sweep.start), _asked.counted(self.file, "end of sweeps", sweep.stop))
        return Waves(self._open().probe(patterns or ["*"], self._counted("frame", frame), both))

    def explain(self, frame: int, column: int, line: int) -> Explanation:
        """How pixel (``column``, ``line``), from 0 at the top left, of frame ``frame`` came about."""
        pixel = (self._counted("column", column), self._counted("line", line))
        cause, because, text, document = self._open().explain(self._counted("frame", frame), pixel)
        return Explanation(cause, tuple(because), text, json.loads(document))

    def loop(self) -> Loop:
        """A closed loop from frame 0: a pose in, a picture out."""
        return Loop(self._open().closed_loop(), self.file)

    def study(self, kind: Literal["error"] = "error", *, only: Sequence[str] = ()) -> Study:
        """Error against run time about the middle frame: the ladders called ``only``, or all ladders of settings. Takes minutes; Ctrl-C ends it
        after the ladder."""
        _asked.word(self.file, "kind", kind, ("error",))
        ladders = [_asked.word(self.file, "only", name) for name in _asked.listed(self.file, "only", only)]
        return Study(self._open().study(ladders))

    def close(self) -> None:
        """Frees ground and tables. Pictures, truth and loops stay."""
        self._native = None

    def _counted(self, name: str, value: object) -> int:
        return _asked.counted(self.file, name, value)

    def _frame_of(self, time_s: float) -> int:
        """Number of the frame at a time (s)."""
        last = _asked.MOST / self.update_hz
        if not 0.0 <= time_s <= last:
            raise refused(self.file, f"a pose whose `time_s` is {time_s!r}", found=repr(time_s), expected=f"0 to {last:.9g}", help="or state the frame")
        return round(time_s * self.update_hz)

    def __enter__(self) -> Drive:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __str__(self) -> str:
        raster = self.raster
        signals = f", {raster['sweeps']} lines of {raster['samples']} samples" if raster["sweeps"] else ""
        lines = [
            f"{self.title} ({self.file}), drawn by {self.machine}",
            f"  {self.frames} frames at {self.update_hz:g} Hz, {raster['columns']} x {raster['lines']} pixels{signals}",
        ]
        lines += [f"  left out: {o.block}: {o.what} ({o.weight}: {o.why})" for o in self.omissions]
        lines += [f"  remark: {remark}" for remark in self.remarks]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<lunoid.Drive {self.file} by {self.machine}>"
