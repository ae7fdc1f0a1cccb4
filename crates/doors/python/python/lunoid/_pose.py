"""Where the eye is and how the vehicle's camera looks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from . import _asked
from ._errors import refused

_Numbers = tuple[float, float, float, float, float, float, float, float]


@dataclass(frozen=True)
class Pose:
    """One instant of the vehicle. Angles are those of path files; a loop works out time and yoke itself.

    >>> import lunoid
    >>> lunoid.Pose((100.0, 200.0, 3.5), heading_deg=45.0).turned(10.0).heading_deg
    55.0
    """

    eye_m: tuple[float, float, float]
    """Eye: north, east, height above the tangent plane of the area (m)."""
    heading_deg: float = 0.0
    """Clockwise from north (degrees)."""
    pitch_deg: float = 0.0
    """Nose up (degrees)."""
    roll_deg: float = 0.0
    """Starboard down (degrees)."""
    time_s: float = 0.0
    """Time since the start of the mission (s)."""
    yoke_deg: float = 0.0
    """Angle by which the deflection yoke turns the picture (degrees)."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "eye_m", _three(self.eye_m))
        for name in ("heading_deg", "pitch_deg", "roll_deg", "time_s", "yoke_deg"):
            object.__setattr__(self, name, _asked.real("pose", name, getattr(self, name)))

    @property
    def x_m(self) -> float:
        """Eye, north (m)."""
        return self.eye_m[0]

    @property
    def y_m(self) -> float:
        """Eye, east (m)."""
        return self.eye_m[1]

    @property
    def z_m(self) -> float:
        """Eye, height above the tangent plane of the area (m)."""
        return self.eye_m[2]

    def turned(self, degrees: float) -> Pose:
        """The same pose turned clockwise by ``degrees``."""
        return replace(self, heading_deg=self.heading_deg + _asked.real("pose", "degrees", degrees))

    def _numbers(self) -> _Numbers:
        return (self.time_s, *self.eye_m, self.heading_deg, self.pitch_deg, self.roll_deg, self.yoke_deg)

    @staticmethod
    def _told(file: str, name: str, pose: object) -> _Numbers:
        """The numbers of what is to be a pose."""
        if not isinstance(pose, Pose):
            raise refused(file, f"`{name}` is {_asked.shown(pose)}", found=_asked.shown(pose), expected="a lunoid.Pose")
        return pose._numbers()

    @classmethod
    def _of(cls, numbers: _Numbers) -> Pose:
        time, x, y, z, heading, pitch, roll, yoke = numbers
        return cls((x, y, z), heading, pitch, roll, time, yoke)


def _three(value: Sequence[float]) -> tuple[float, float, float]:
    found = _asked.listed("pose", "eye_m", value)
    if len(found) != 3:
        expected = "three numbers: north, east, up (m)"
        raise refused("pose", f"`eye_m` is {_asked.shown(value)}", found=_asked.shown(value), expected=expected)
    x, y, z = found
    return (_asked.real("pose", "x_m", x), _asked.real("pose", "y_m", y), _asked.real("pose", "z_m", z))
