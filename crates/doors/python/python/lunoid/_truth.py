"""What each pixel shows, by closed form."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray


class Truth(Mapping[str, NDArray[Any]]):
    """Planes of truth by their names, lines by columns from the top left; taken at the centres of pixels.

    Infinity stands for the range and the distance of the sky. ``label`` and ``shadow`` are codes.

    >>> import lunoid
    >>> truth = lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100).truth(0, "range", "label")
    >>> truth.unit["range"], truth.bound["range"], truth.codes["label"][:2]
    ('m', 6e-08, ('sky', 'terrain'))
    """

    def __init__(self, frame: int, planes: list[tuple[str, str, NDArray[Any], list[str], float]], error: list[str]) -> None:
        self.frame = frame
        """Number of the frame, counted at the update rate."""
        self._arrays = {name: array for name, _, array, _, _ in planes}
        self.unit = {name: unit for name, unit, _, _, _ in planes}
        """Unit of each plane; ``1`` for plain numbers and codes."""
        self.codes = {name: tuple(codes) for name, _, _, codes, _ in planes if codes}
        """Words of the codes of a plane, by their number."""
        self.bound = {name: bound for name, _, _, _, bound in planes}
        """Largest error of a value of each plane, as a share of the value; 0 for codes."""
        self.error = tuple(error)
        """How wrong the numbers may be, in words."""
        for array in self._arrays.values():
            array.flags.writeable = False

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"<lunoid.Truth frame {self.frame}: {', '.join(self._arrays)}>"
