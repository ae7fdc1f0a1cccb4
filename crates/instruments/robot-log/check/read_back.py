"""Reads a robot log and OpenEXR files of a run back by independent readers: read_back.py RUN LOG RECORD.

RUN is a run folder with all ground truth and its OpenEXR files. Every comparison is with the files of that folder.
"""

from __future__ import annotations

import csv
import json
import platform
import subprocess
import sys
from collections import Counter
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

import numpy as np
import OpenEXR
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from rerun.chunk import McapReader

LUNOID_RADIUS_M = 1_737_400.0
TOOLS = ["mcap", "mcap-protobuf-support", "rerun-sdk", "OpenEXR", "numpy"]
SCHEMAS = {
    "/camera/image": "foxglove.CompressedImage",
    "/camera/depth": "foxglove.RawImage",
    "/camera/labels": "foxglove.RawImage",
    "/camera/calibration": "foxglove.CameraCalibration",
    "/tf": "foxglove.FrameTransforms",
    "/path": "foxglove.PosesInFrame",
    "/late_words": "foxglove.Log",
}
# Columns into which Rerun's importer turns each topic.
COLUMNS = {
    "/camera/image": "EncodedImage:blob",
    "/camera/depth": "Image:buffer",
    "/camera/labels": "Image:buffer",
    "/camera/calibration": "Pinhole:image_from_camera",
    "/tf": "Transform3D:quaternion",
    "/path": "InstancePoses3D:translations",
    "/late_words": "TextLog:text",
}


def expect(held: bool, what: object) -> None:
    if not held:
        sys.exit(f"does not hold: {what}")


def turned(quaternion: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Vectors turned by a quaternion x, y, z, w."""
    axis, w = quaternion[:3], quaternion[3]
    twice = 2 * np.cross(axis, vectors)
    return vectors + w * twice + np.cross(axis, twice)


def places(depth: np.ndarray, k: np.ndarray, links: list[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Places in the site (m) of pixels with their depth (m)."""
    line, column = np.indices(depth.shape)
    ray = np.stack([(column - k[2]) / k[0], (line - k[5]) / k[4], np.ones(depth.shape)], axis=-1)
    place = ray * depth[..., None]
    for translation, rotation in reversed(links):
        place = turned(rotation, place) + translation
    return place


def by_mcap(run: Path, log: Path) -> tuple[dict, dict]:
    """Reads the log by the package `mcap`. Returns what it found, and the bytes that Rerun must find too."""
    record = json.loads((run / "run.json").read_text())
    messages: dict[str, list] = {topic: [] for topic in SCHEMAS}
    with log.open("rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            expect(schema.name == SCHEMAS[channel.topic], (channel.topic, schema.name))
            messages[channel.topic].append((message.log_time, decoded))
        about = next(reader.iter_metadata()).metadata
    expect(about["run_fingerprint"] == record["fingerprint"], about)
    frames = record["frames"]
    for topic in ("/camera/image", "/camera/depth", "/camera/labels", "/camera/calibration", "/tf"):
        times = [time for time, _ in messages[topic]]
        expect(times == [round(frame["time_s"] * 1e9) for frame in frames], (topic, times))
    raw: dict[str, list] = {topic: [] for topic in SCHEMAS}
    largest = Counter()
    for index, frame in enumerate(frames):
        of = {topic: messages[topic][index][1] for topic in SCHEMAS if topic not in ("/path", "/late_words")}
        truth = np.load(run / "truth" / f"frame-{frame['frame']:06}.npz")
        image, depth_image, labels = of["/camera/image"], of["/camera/depth"], of["/camera/labels"]
        expect(image.data == (run / frame["files"][0]["file"]).read_bytes(), "the picture is the run's PNG")
        expect((depth_image.encoding, labels.encoding) == ("32FC1", "8UC1"), depth_image.encoding)
        shape = (depth_image.height, depth_image.width)
        depth = np.frombuffer(depth_image.data, "<f4").reshape(shape).astype(float)
        codes = np.frombuffer(labels.data, np.uint8).reshape(shape)
        expect(np.array_equal(codes, truth["label"]), "labels are the truth's")
        sky = ~np.isfinite(truth["distance"])
        expect(np.array_equal(np.isposinf(depth), sky) and sky.any() and not sky.all(), "sky has infinite depth")
        links = [
            (np.array([t.translation.x, t.translation.y, t.translation.z]),
             np.array([t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w]))
            for t in of["/tf"].transforms
        ]
        place = places(np.where(sky, 1.0, depth), np.array(of["/camera/calibration"].K), links)
        across = np.hypot(*(place - links[0][0])[..., :2].transpose(2, 0, 1))[~sky]
        height = place[..., 2][~sky] + across**2 / (2 * LUNOID_RADIUS_M)
        largest["range"] = max(largest["range"], np.abs(across / truth["range"][~sky] - 1).max())
        largest["height"] = max(largest["height"], np.abs(height - truth["height"][~sky]).max())
        raw["/camera/image"].append(image.data)
        raw["/camera/depth"].append(depth_image.data)
        raw["/camera/labels"].append(labels.data)
        raw["/camera/calibration"].append(list(of["/camera/calibration"].K))
        raw["/tf"] += [list(rotation) for _, rotation in links]
    expect(largest["range"] < 1e-6 and largest["height"] < 1e-2, largest)
    with (run / "poses.csv").open() as file:
        eyes = [[float(row[key]) for key in ("y_m", "x_m", "z_m")] for row in csv.DictReader(file)]
    path = messages["/path"][0][1].poses
    expect(np.allclose([[p.position.x, p.position.y, p.position.z] for p in path], eyes, atol=1e-9), "path")
    raw["/path"].append(eyes)
    raw["/late_words"] = [decoded.message for _, decoded in messages["/late_words"]]
    late = sum(frame["counts"]["late_words"] for frame in frames)
    expect(late > 0 and len(raw["/late_words"]) > 0, "the run has late words, and the log tells them")
    found = {
        "messages": {topic: len(list_) for topic, list_ in messages.items()},
        "largest_error": {"range_share": float(largest["range"]), "height_m": float(largest["height"])},
        "late_words_of_the_run": late,
    }
    return found, raw


def by_rerun(log: Path, raw: dict) -> dict:
    """Reads the log by Rerun's importer and compares with what the package `mcap` found."""
    timed: dict[str, list] = {topic: [] for topic in COLUMNS}
    for chunk in McapReader(log).stream():
        topic, batch = str(chunk.entity_path), chunk.to_record_batch()
        name = COLUMNS.get(topic)
        if name in batch.schema.names:
            times = batch.column("message_log_time").cast("int64").to_pylist()
            timed[topic] += zip(times, batch.column(name).to_pylist())
    rows = {topic: [row for _, row in sorted(list_, key=lambda pair: pair[0])] for topic, list_ in timed.items()}
    for topic in ("/camera/image", "/camera/depth", "/camera/labels"):
        found = [bytes(row[0]) for row in rows[topic]]
        expect(found == [bytes(data) for data in raw[topic]], f"{topic} in Rerun")
    quaternions = np.array([quaternion for row in rows["/tf"] for quaternion in row])
    expect(np.allclose(quaternions, raw["/tf"], atol=1e-6), "quaternions x, y, z, w in Rerun")
    columns_first = [np.array(k).reshape(3, 3).T.ravel() for k in raw["/camera/calibration"]]
    found = np.array([row[0] for row in rows["/camera/calibration"]])
    expect(np.allclose(found, columns_first, rtol=1e-6), "the camera matrix in Rerun")
    expect(np.allclose(rows["/path"][0], raw["/path"][0], rtol=1e-6), "the path in Rerun")
    expect([row[0] for row in rows["/late_words"]] == raw["/late_words"], "late words in Rerun")
    return {topic: {"column": COLUMNS[topic], "rows": len(list_)} for topic, list_ in rows.items()}


def by_openexr(run: Path) -> dict:
    """Reads the OpenEXR files by the library of the format and compares with the truth."""
    files = sorted((run / "exr").glob("*.exr"))
    expect(len(files) > 0, "there are OpenEXR files")
    names: list[str] = []
    for file in files:
        truth = np.load(run / "truth" / (file.stem + ".npz"))
        with OpenEXR.File(str(file), separate_channels=True) as picture:
            layers = {name: channel.pixels for name, channel in picture.channels().items()}
            about = json.loads(picture.header()["lunoid"])
        names = sorted(layers)
        expect(file.stem == f"frame-{about['frame']:06}", about["frame"])
        for name in ("range", "height", "reflectivity", "shadow", "label", "distance"):
            expect(np.array_equal(layers[name], truth[name]), f"{file.name}: {name}")
        for axis, part in (("X", 1), ("Y", 0), ("Z", 2)):
            expect(np.array_equal(layers[f"normal.{axis}"], truth["normal"][..., part]), f"normal.{axis}")
        expect(np.array_equal(np.isposinf(layers["depth.Z"]), ~np.isfinite(truth["distance"])), "infinity stays")
        light = layers["Y"]
        expect(light.dtype == np.float32 and 0 <= light.min() < light.max() <= about["white"] * (1 + 1e-6), "light")
    return {"files": len(files), "layers": names}


def main(run: str, log: str, out: str) -> None:
    found, raw = by_mcap(Path(run), Path(log))
    commit = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
    record = {
        "schema": "lunoid.logs/1",
        "command": ".ci/logs",
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%d"),
        "commit": commit,
        "python": platform.python_version(),
        "system": platform.system(),
        "mcap": found,
        "rerun": by_rerun(Path(log), raw),
        "openexr": by_openexr(Path(run)),
        "tools": {name: version(name) for name in TOOLS},
        "not_run": "the viewers of Foxglove and Rerun: what they show was not looked at",
    }
    Path(out).write_text(json.dumps(record, indent=2) + "\n")
    print(Path(out).read_text())


main(*sys.argv[1:])
