"""Signals of some sweeps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Wave:
    """One signal of one or several sweeps.

    >>> import lunoid
    >>> drive = lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100)
    >>> drive.probe("mu.height", sweep=50)["mu.height"].unit
    'm'
    """

    name: str
    """Dotted name of the wire, block first."""
    unit: str
    """Unit of the values."""
    axis: str
    """``ground``: a value a sample; ``display``: a value a line; ``changes``: a value whenever there is a new one."""
    meaning: str
    """What the signal stands for."""
    values: NDArray[np.float64]
    """Values: of one sweep along its axis, of several sweeps by sweeps first; of ``changes`` all in a row."""
    place: NDArray[np.float64]
    """Where each value stands: ground range (m), display line, or time (samples of the sweep)."""
    place_unit: str
    """Unit of the places."""
    sweeps: range
    """Sweeps that were recorded."""

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.values, dtype=dtype, copy=copy)

    @property
    def xarray(self) -> Any:
        """The same as ``xarray.DataArray`` with ``range`` (m) as a coordinate. Needs xarray."""
        import xarray

        along = {"ground": "range", "display": "line", "changes": "time"}[self.axis]
        attributes = {"units": self.unit, "long_name": self.name, "description": self.meaning}
        if self.values.ndim == 1:
            coordinates: dict[str, Any] = {along: (along, self.place, {"units": self.place_unit})}
            return xarray.DataArray(self.values, dims=[along], coords=coordinates, name=self.name, attrs=attributes)
        inner = "sample" if along == "range" else along
        dims = ["sweep", inner]
        coordinates = {"sweep": list(self.sweeps), along: (dims, self.place, {"units": self.place_unit})}
        if along == inner:
            coordinates[along] = (inner, self.place[0], {"units": self.place_unit})
        return xarray.DataArray(self.values, dims=dims, coords=coordinates, name=self.name, attrs=attributes)

    def plot(self, **options: Any) -> Any:
        """Draws the signal over its place: by xarray where it is installed, by matplotlib alone where not."""
        if self.values.ndim == 1:
            try:
                return self.xarray.plot(**options)
            except ModuleNotFoundError as missing:
                if missing.name != "xarray":
                    raise
        import matplotlib.pyplot as plt

        lines = plt.plot(self.place.T, self.values.T, **options)
        plt.xlabel(f"{'range' if self.axis == 'ground' else self.axis} ({self.place_unit})")
        plt.ylabel(f"{self.name} ({self.unit})")
        return lines


class Waves(Mapping[str, Wave]):
    """Signals by their names, in the order of the signal table."""

    def __init__(self, document: dict[str, Any]) -> None:
        self.sweeps = range(*document["sweeps"])
        """Sweeps that were recorded."""
        self.left_out: tuple[str, ...] = tuple(document["left_out"])
        """Signals without a wire in this machine: 0 throughout."""
        places = document["places"].reshape(len(self.sweeps), -1)
        self._waves = {fields["name"]: self._wave(fields, places) for fields in document["signals"]}

    def _wave(self, fields: dict[str, Any], places: NDArray[np.float64]) -> Wave:
        values, counts, axis = fields["values"], fields["counts"], fields["axis"]
        if axis == "changes":
            place, unit = fields["times"], "samples"
        else:
            values = values.reshape(len(self.sweeps), -1)
            lines = np.broadcast_to(np.arange(counts[0], dtype=np.float64), values.shape)
            place, unit = (places, "m") if axis == "ground" else (lines, "lines")
            if len(self.sweeps) == 1:
                values, place = values[0], place[0]
        return Wave(fields["name"], fields["unit"], axis, fields["meaning"], values, place, unit, self.sweeps)

    def __getitem__(self, name: str) -> Wave:
        return self._waves[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._waves)

    def __len__(self) -> int:
        return len(self._waves)

    def __repr__(self) -> str:
        return f"<lunoid.Waves sweeps {self.sweeps.start}..{self.sweeps.stop}: {', '.join(self._waves)}>"
