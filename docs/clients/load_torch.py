"""A data set of `lunoid dataset` for PyTorch, with pictures of 0..1 and channels first: python3 load_torch.py FOLDER [SPLIT]"""
import sys

import torch
from torch.utils.data import DataLoader, Dataset

from load_numpy import Samples


class Frames(Dataset):
    """The samples of a split: a picture, its planes by name, and its number."""

    def __init__(self, folder, split="train"):
        self.samples = Samples(folder, split)

    def __len__(self):
        return len(self.samples)

    def __getitem__(self, index):
        row, arrays = self.samples[index]
        picture = torch.from_numpy(arrays.pop("picture")).float() / 255
        picture = picture.permute(2, 0, 1) if picture.ndim == 3 else picture[None]
        return picture, {name: torch.from_numpy(array) for name, array in arrays.items()}, row["sample"]


if __name__ == "__main__":
    for pictures, planes, numbers in DataLoader(Frames(*sys.argv[1:]), batch_size=4):
        print(numbers.tolist(), list(pictures.shape), *(f"{name}{list(plane.shape)}" for name, plane in planes.items()))
