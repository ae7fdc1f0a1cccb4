"""Runs notebooks from the root of the repository; the first cell that fails ends it."""

from __future__ import annotations

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient


def main(names: list[str]) -> None:
    for name in names:
        notebook = nbformat.read(name, as_version=4)
        NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": "."}}).execute()
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        told = "".join(output["text"] for output in outputs if output["output_type"] == "stream")
        print(f"{Path(name).stem}: {told.strip().splitlines()[-1] if told.strip() else 'no text'}")


main(sys.argv[1:])
