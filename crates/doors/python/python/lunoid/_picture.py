"""A picture: shows itself in a notebook, and is an array."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _asked, _native
from ._errors import refused
from ._pose import Pose


class Picture:
    """A drawn frame: 8 bits a code, grey or red, green and blue.

    ``numpy.asarray(picture)`` is a view of its memory, lines by columns from the top left, and cannot be written to.

    >>> import lunoid, numpy
    >>> picture = lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100).frame(0)
    >>> numpy.shares_memory(numpy.asarray(picture), picture.codes)
    True
    """

    def __init__(self, native: _native.Picture) -> None:
        self._native = native
        self.codes: NDArray[np.uint8] = native.codes
        """Codes of the display, 0 to 255."""
        self.codes.flags.writeable = False

    @property
    def frame(self) -> int:
        """Number of the frame, counted at the update rate."""
        return self._native.frame

    @property
    def pose(self) -> Pose:
        """Where the vehicle was."""
        return Pose._of(self._native.pose)

    @property
    def shape(self) -> tuple[int, ...]:
        """Lines and columns, and 3 behind them for a picture in colour."""
        return self.codes.shape

    @property
    def hash(self) -> str:
        """BLAKE3 of the pixels, as ``run.json`` has it for the frame."""
        return self._native.hash()

    def light(self, plane: str | None = None) -> NDArray[np.float32]:
        """Linear light (1 is the full sun on a white plane, by the model of the scene): ``intensity``, or ``red``, ``green``, ``blue``.

        The first plane that the picture was made of if none is named. The array is a copy.
        """
        planes = dict(self._native.light())
        if plane is None:
            return next(iter(planes.values()))
        return planes[_asked.word("picture", "plane", plane, tuple(planes))]

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the picture as PNG."""
        place = _asked.path("picture", "path", path)
        try:
            Path(place).write_bytes(self._native.png())
        except OSError as error:
            raise refused(place, f"cannot write: {error.strerror}", expected="a file in a folder that is there") from error

    def _repr_png_(self) -> bytes:
        return self._native.png()

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        if dtype is not None and np.dtype(dtype) != self.codes.dtype:
            if copy is False:
                raise ValueError(f"codes are {self.codes.dtype}, not {dtype}: this takes a copy")
            return self.codes.astype(dtype)
        return self.codes.copy() if copy else self.codes

    def __repr__(self) -> str:
        lines, columns = self.shape[:2]
        kind = "colour" if len(self.shape) == 3 else "grey"
        return f"<lunoid.Picture frame {self.frame}, {columns} x {lines}, {kind}>"
