"""Viewshed of a square grid by xarray-spatial: times of some calls after one that compiles.

    viewshed.py HEIGHTS.npy ROW COLUMN HEIGHT SPACING TURNS VISIBLE.npy

HEIGHTS are metres, row by row. The observer stands HEIGHT metres above the post of a row and a column. VISIBLE gets a byte for each post.
It prints one line of JSON: version, seconds (a list).
"""

import json
import sys
import time

import numpy as np
import xarray as xr
import xrspatial

path, row, column, height, spacing, turns, out = sys.argv[1:]
heights = np.load(path)
places = [float(spacing) * np.arange(count, dtype=float) for count in heights.shape]
ground = xr.DataArray(heights, dims=["y", "x"], coords={"y": places[0], "x": places[1]})
observer = dict(x=places[1][int(column)], y=places[0][int(row)], observer_elev=float(height))

seconds = []
for turn in range(int(turns) + 1):
    begin = time.perf_counter()
    seen = xrspatial.viewshed(ground, **observer)
    if turn > 0:
        seconds.append(time.perf_counter() - begin)
np.save(out, (seen.values >= 0).astype(np.uint8))
print(json.dumps({"version": xrspatial.__version__, "seconds": seconds}))
