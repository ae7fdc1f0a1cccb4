"""A run of `lunoid replay --truth all`, read with NumPy alone: python3 read_run.py FOLDER"""
import json
import pathlib
import sys
import zlib

import numpy


def picture(path):
    """The codes of a PNG file in grey or colour: lines, columns, channels."""
    data, at, packed, form = path.read_bytes(), 8, b"", b""
    while at < len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        packed += data[at + 8:at + 8 + size] if kind == b"IDAT" else b""
        form, at = form or data[at + 8:at + 8 + size], at + 12 + size
    columns, lines = (int.from_bytes(form[k:k + 4], "big") for k in (0, 4))
    channels, deep = 3 if form[9] == 2 else 1, form[8] // 8
    step, length, raw, out = channels * deep, columns * channels * deep, zlib.decompress(packed), []
    last = bytes(length + step)
    for kind, *line in (raw[k:k + length + 1] for k in range(0, len(raw), length + 1)):
        line = bytearray(step) + bytes(line)
        for k in range(step, len(line) if kind else 0):
            a, b, c = line[k - step], last[k], last[k - step]
            paeth = min((a, b, c), key=lambda code: abs(a + b - c - code)) if kind == 4 else 0
            line[k] = (line[k] + (0, a, b, (a + b) // 2, paeth)[kind]) % 256
        out.append(line[step:])
        last = line
    return numpy.frombuffer(b"".join(out), f">u{deep}").reshape(lines, columns, channels)


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    for pose in json.loads((folder / "truth/poses.json").read_text())["frames"]:
        name = f"frame-{pose['frame']:06}"
        truth = dict(numpy.load(folder / f"truth/{name}.npz"))
        light = truth["reflectivity"] * (truth["shadow"] == 0)
        planes = [f"{name}{list(plane.shape)}" for name, plane in truth.items()]
        codes = picture(folder / f"frames/{name}.png")
        print(name, codes.shape, codes.mean(), pose["eye_m"], light.mean(), *planes)
