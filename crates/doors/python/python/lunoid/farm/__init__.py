"""Runs on many workers: shards drawn by plain processes, Dask or Ray, and joined into the run of one machine, byte for byte.

The command draws and joins: ``lunoid replay --shard``, ``lunoid merge``, ``lunoid farm status``. This package starts them where an engine
has workers. All workers see one folder, in which the shards lie.

>>> import tempfile
>>> from lunoid import farm
>>> out = tempfile.mkdtemp() + "/drive"
>>> job = farm.replay("scenarios/first-light.toml", frames=range(4), sweeps=24, samples=40, page=False, out=out)
>>> report = farm.on(None, workers=2).run(job, shards=2)
>>> report.shards, report.frames, report.complete
(2, 4, True)
"""

from ._engines import Engine
from ._job import Job, replay
from ._program import FarmError
from ._progress import Progress
from ._report import Report, SetAside
from ._run import Farm, on

__all__ = ["Engine", "Farm", "FarmError", "Job", "Progress", "Report", "SetAside", "on", "replay"]
