"""Error against run time."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False)
class Study:
    """A finished study: one row an error of a rung of a ladder."""

    csv: str
    """The table of ``error.csv``."""

    @property
    def rows(self) -> list[dict[str, str]]:
        """The rows as dictionaries of text."""
        return list(csv.DictReader(io.StringIO(self.csv)))

    @property
    def frame(self) -> Any:
        """The table as ``pandas.DataFrame``. Needs pandas; ``rows`` needs nothing."""
        import pandas

        return pandas.read_csv(io.StringIO(self.csv))

    def __repr__(self) -> str:
        rows = self.rows
        ladders = list(dict.fromkeys(row["ladder"] for row in rows))
        return f"<lunoid.Study of {len(rows)} rows: {', '.join(ladders)}>"
