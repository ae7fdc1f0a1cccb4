"""A data set of `lunoid dataset`, read with NumPy alone: python3 load_numpy.py FOLDER [SPLIT]"""
import json
import pathlib
import sys

import numpy


class Samples:
    """The samples of a split: each is its line of the manifest, and its arrays by name."""

    def __init__(self, folder, split="train"):
        self.folder = pathlib.Path(folder)
        lines = (self.folder / "manifest.jsonl").read_text().splitlines()
        self.rows = [row for row in map(json.loads, lines) if row["split"] == split]

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, index):
        row = self.rows[index]
        with numpy.load(self.folder / row["file"]) as arrays:
            return row, dict(arrays)


if __name__ == "__main__":
    for row, arrays in Samples(*sys.argv[1:]):
        print(row["sample"], row["fault"], *(f"{name}{list(array.shape)}" for name, array in arrays.items()))
