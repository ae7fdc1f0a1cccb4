"""A long loop for every machine: driven by a client, recorded, drawn again by `lunoid replay`, compared hash by hash. Then the time of a look
through TCP beside that of the same picture in the program, of which the example `ratio` has written a line each.

python3 crates/doors/loop-server/check/thousand.py LUNOID STEPS RATIOS RECORD
"""
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile

CLIENT = "docs/clients/drive.py"
SMALL = "--sweeps 60 --samples 120 --set scenario.raster.columns=60 --set scenario.raster.lines=40".split()
PLAIN = SMALL[4:]
# A look may take so many times what the picture takes in the program: alone, and with four planes.
AT_MOST = [1.15, 1.3]
# All hardware models that ship.
MODELS = sorted(path.stem for path in pathlib.Path("hardware-models").glob("*.toml"))
# The scenario of each machine. A guest has no sweeps and samples of its own.
MACHINES = [
    *[(name, "scenarios/first-light.toml", SMALL) for name in MODELS],
    *[(name, "scenarios/first-light.toml", PLAIN) for name in ("exact", "lod-mesh", "smooth-faces")],
    ("lunsim", "scenarios/lunsim-roving.toml", [*PLAIN, "--set", "lunsim.restrictions=false"]),
    ("sampled", "scenarios/night-landing.toml", PLAIN),
    ("panels", "scenarios/photo-drape.toml", PLAIN),
]


def driven(lunoid, steps, machine, scenario, small, folder):
    """Hashes that the client has seen, and those that the command draws."""
    how = [scenario, "--machine", machine, *small]
    client = [sys.executable, CLIENT, str(steps), lunoid, "serve", *how, "--record", str(folder / "driven")]
    said = subprocess.run(client, check=True, capture_output=True, text=True).stdout
    seen = [line.split()[0] for line in said.splitlines() if len(line.split()[0]) == 64]
    run = folder / "run"
    path = str(folder / "driven" / "drive" / "scenario.toml")
    replay = [lunoid, "replay", path, "--machine", machine, *small, "--out", str(run)]
    subprocess.run(replay, check=True, capture_output=True)
    frames = json.loads((run / "run.json").read_text())["frames"]
    return seen, [frame["pixels_blake3"] for frame in frames]


def main():
    lunoid, steps, ratios, to = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
    rows = []
    for machine, scenario, small in MACHINES:
        with tempfile.TemporaryDirectory() as folder:
            try:
                seen, drawn = driven(lunoid, steps, machine, scenario, small, pathlib.Path(folder))
            except subprocess.CalledProcessError as failed:
                raise SystemExit(f"{machine}: {failed.stdout}{failed.stderr}") from failed
        equal = sum(one == other for one, other in zip(seen, drawn))
        row = {"machine": machine, "scenario": scenario, "steps": len(seen), "drawn": len(drawn), "equal": equal, "different_pictures": len(set(seen))}
        print(json.dumps(row), flush=True)
        rows.append(row)
        if not len(seen) == len(drawn) == equal == steps:
            raise SystemExit(f"{machine}: the replay is another one")
    looks = [json.loads(line) for line in pathlib.Path(ratios).read_text().splitlines()]
    looks = [{**look, "at_most": most} for look, most in zip(looks, AT_MOST, strict=True)]
    commit = subprocess.run(["git", "rev-parse", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()
    record = {
        "schema": "lunoid.loop.record/1",
        "command": ".ci/loop",
        "date": datetime.date.today().isoformat(),
        "commit": commit,
        "steps": steps,
        "machines": rows,
        "looks": looks,
    }
    pathlib.Path(to).write_text(json.dumps(record, indent=2) + "\n")
    if any(look["ratio"] > look["at_most"] for look in looks):
        raise SystemExit(f"a look takes too long: {looks}")


if __name__ == "__main__":
    main()
