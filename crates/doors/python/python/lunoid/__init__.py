"""The image generator lunoid from Python.

A scenario is opened with a machine and settings over it, as the command opens it. Frames, truth, signals and explanations
have the defaults and the bits of the command.

>>> import lunoid
>>> drive = lunoid.open("scenarios/first-light.toml", sweeps=100, samples=100)
>>> drive.frame(0).shape
(57, 100)
"""

from ._drive import Drive, Omission, open
from ._errors import Fault, InputError
from ._explanation import Explanation
from ._loop import Loop
from ._picture import Picture
from ._pose import Pose
from ._study import Study
from ._truth import Truth
from ._waves import Wave, Waves

__all__ = [
    "Drive",
    "Explanation",
    "Fault",
    "InputError",
    "Loop",
    "Omission",
    "Picture",
    "Pose",
    "Study",
    "Truth",
    "Wave",
    "Waves",
    "open",
]
