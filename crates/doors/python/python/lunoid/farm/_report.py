"""What came of a run."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SetAside:
    """A shard that failed as often as it was to be tried."""

    shard: str
    """Number of the shard and of all shards, as ``3/7``."""
    tries: int
    """How often the shard was tried."""
    why: str
    """What the last try said."""
    command: str
    """Line of a shell that draws the shard."""


@dataclass(frozen=True)
class Report:
    """A run that has ended: joined, or with what is missing."""

    out: str
    """Folder of the joined run."""
    folder: str
    """Folder of the shards."""
    engine: str
    """Name of the engine."""
    by: str
    """Law of the shards: ``cost`` or ``count``."""
    shards: int
    """Number of shards."""
    frames: int | None
    """Number of frames of the run; None where no shard came so far as to say it."""
    tries: int
    """Tries of all shards; more than shards where workers were lost."""
    set_aside: tuple[SetAside, ...]
    """Shards that are missing; the run is joined only if there are none."""
    seconds: float
    """Wall time of the whole run (s)."""

    @property
    def complete(self) -> bool:
        """Whether the joined run is there."""
        return not self.set_aside

    def __str__(self) -> str:
        again = f", {self.tries - self.shards} tried again" if self.tries > self.shards else ""
        drawn = f"{self.shards} shards by {self.by}{again}, by {self.engine}, in {self.seconds:.1f} s"
        if self.complete:
            return f"{self.out}: {self.frames} frames of {drawn}"
        lines = [f"{self.out}: not joined, {len(self.set_aside)} of its shards are missing; {drawn}"]
        for one in self.set_aside:
            lines += [f"  shard {one.shard} failed {one.tries} times: {one.why}", "  this makes it:", f"    {one.command}"]
        lines.append("  then run the same job again: what is there is kept")
        return "\n".join(lines)
