"""How far a run is."""

from __future__ import annotations

import sys
from dataclasses import dataclass


@dataclass(frozen=True)
class Progress:
    """How far a run is, as ``lunoid farm status`` says."""

    shards: int
    """Shards that are done."""
    of: int
    """All shards."""
    set_aside: int
    """Shards that were set aside."""
    frames: int
    """Frames that are done."""
    left_s: float | None
    """Time left (s), where the rate is known."""

    def __str__(self) -> str:
        aside = f", {self.set_aside} set aside" if self.set_aside else ""
        left = "" if self.left_s is None else f", {self.left_s:.0f} s left"
        return f"{self.shards} of {self.of} shards{aside}, {self.frames} frames{left}"


def show(progress: Progress) -> None:
    """Writes a line to standard error, over the line before where that is a terminal."""
    if sys.stderr.isatty():
        sys.stderr.write(f"\r{progress}\x1b[K" + ("\n" if progress.shards + progress.set_aside == progress.of else ""))
        sys.stderr.flush()
