"""How a pixel came about."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Explanation:
    """A pixel explained, as ``lunoid explain`` does."""

    cause: str
    """The most telling reason: a late word that the pixel still shows, or the first of ``because``."""
    because: tuple[str, ...]
    """All reasons, most telling first."""
    text: str
    """What the command prints."""
    document: dict[str, Any]
    """The document of ``lunoid explain --json``."""

    def __str__(self) -> str:
        return self.text
