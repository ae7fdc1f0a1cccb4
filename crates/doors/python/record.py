"""The record of a run of `.ci/doors`: when, by what, and what held."""

from __future__ import annotations

import json
import platform
import subprocess
import sys
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path
from xml.etree import ElementTree

TOOLS = ["maturin", "numpy", "pytest", "mypy", "matplotlib", "xarray", "pandas", "nbclient"]


def main(log: str, wheel: str, out: str) -> None:
    suites = ElementTree.parse(Path(log) / "tests.xml").getroot().iter("testsuite")
    counts = [{key: int(suite.get(key, 0)) for key in ("tests", "failures", "errors", "skipped")} for suite in suites]
    total = {key: sum(count[key] for count in counts) for key in counts[0]}
    if total["failures"] or total["errors"] or total["skipped"]:
        sys.exit(f"tests: {total}; expected none that failed or was skipped")
    commit = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
    record = {
        "schema": "lunoid.doors/1",
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%d"),
        "commit": commit,
        "python": platform.python_version(),
        "system": platform.system(),
        "wheel": {"file": Path(wheel).name, "bytes": Path(wheel).stat().st_size},
        "tests": total["tests"],
        "other_pythons": Path(log, "pythons.txt").read_text().split(),
        "notebooks": sorted(path.stem for path in Path("docs/notebooks").glob("*.ipynb")),
        "frame_against_native": json.loads((Path(log) / "speed.json").read_text()),
        "tools": {name: version(name) for name in TOOLS},
        "not_run": "other versions of Python than those named",
    }
    Path(out).write_text(json.dumps(record, indent=2) + "\n")
    print(Path(out).read_text())


main(*sys.argv[1:])
