"""A closed loop: a pose in, a picture out."""

from __future__ import annotations

from os import PathLike
from types import TracebackType

from . import _asked, _native
from ._errors import refused
from ._picture import Picture
from ._pose import Pose


class Loop:
    """A drive that grows with each pose: one frame a look, frame n at n over the update rate.

    Machines with memory between frames remember what the loop has driven. Several threads may share a loop: one looks at a time.

    >>> import lunoid
    >>> drive = lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100)
    >>> with drive.loop() as loop:
    ...     pose = loop.ahead(drive.pose(0), metres=0.2)
    ...     loop.look(pose).frame, loop.frames
    (0, 1)
    """

    def __init__(self, native: _native.Loop, file: str) -> None:
        self._native: _native.Loop | None = native
        self._file = file
        self._process = _asked.process()

    def _open(self) -> _native.Loop:
        _asked.same_process(self._file, "loop", self._process)
        if self._native is None:
            raise refused(self._file, "the loop is closed", help="begin another by drive.loop()")
        return self._native

    @property
    def frames(self) -> int:
        """Number of frames that have been driven."""
        return self._open().frames()

    def look(self, pose: Pose) -> Picture:
        """Drives the next frame to ``pose`` and draws it. Time and yoke of the pose are the loop's own.

        Raises InputError if the pose cannot be driven or drawn; nothing is driven then.
        """
        return Picture(self._open().look(Pose._told(self._file, "pose", pose)))

    def ahead(self, pose: Pose, metres: float) -> Pose:
        """The vehicle ``metres`` further along its heading, standing on the ground; level in the air where the scenario's path states heights."""
        numbers = Pose._told(self._file, "pose", pose)
        return Pose._of(self._open().ahead(numbers, _asked.real(self._file, "metres", metres)))

    def save(self, folder: str | PathLike[str]) -> None:
        """Writes what was driven into the new folder ``folder``: ``scenario.toml``, ``driven.csv`` and the files that the scenario names.

        ``lunoid replay FOLDER/scenario.toml`` with the settings of the drive draws the same pixels.
        """
        self._open().save(_asked.path(self._file, "folder", folder))

    def close(self) -> None:
        """Ends the loop and frees what it remembers."""
        self._native = None

    def __enter__(self) -> Loop:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
