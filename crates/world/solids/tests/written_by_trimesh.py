"""Shapes of trimesh in every format, with their volumes: written_by_trimesh.py FOLDER"""

import json
import pathlib
import sys

import trimesh

folder = pathlib.Path(sys.argv[1])
shapes = {
    "box": trimesh.creation.box((1, 2, 3)),
    "ball": trimesh.creation.icosphere(1),
    "cone": trimesh.creation.cone(0.5, 2, sections=12),
    "pipe": trimesh.creation.annulus(0.5, 1.0, 2.0, sections=10),
    "ring": trimesh.creation.torus(1.0, 0.3, major_sections=12, minor_sections=8),
}
listed = []
for name, mesh in shapes.items():
    size = sorted(mesh.extents)
    files = {f"{name}.{ending}": mesh.export(file_type=ending) for ending in ("obj", "stl", "ply", "glb")}
    files[f"{name}-text.stl"] = mesh.export(file_type="stl_ascii")
    files[f"{name}-text.ply"] = mesh.export(file_type="ply", encoding="ascii")
    for file, content in mesh.export(file_type="gltf").items():
        (folder / name).mkdir(exist_ok=True)
        (folder / name / file).write_bytes(content)
    listed.append([f"{name}/model.gltf", mesh.volume, size])
    for file, content in files.items():
        (folder / file).write_bytes(content if isinstance(content, bytes) else content.encode())
        listed.append([file, mesh.volume, size])
(folder / "list.json").write_text(json.dumps(listed))
