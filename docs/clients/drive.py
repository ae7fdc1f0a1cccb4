"""A closed loop with lunoid, in plain Python: drive ahead, look, decide, drive on.

python3 docs/clients/drive.py STEPS lunoid serve scenarios/first-light.toml --record runs/driven
"""
import json
import struct
import subprocess
import sys

MAGIC = b"lunoid.1"


class Machine:
    """A `lunoid serve` of its own, over a pipe."""

    def __init__(self, command):
        self.asked = 0
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, do, planes={}, **keys):
        """The answer to a request, and its planes by name: shape, type and bytes. Planes of the request are bytes by name."""
        self.asked += 1
        if planes:
            keys["planes"] = [{"name": name, "dtype": "u8", "shape": [len(data)]} for name, data in planes.items()]
        header, data = json.dumps({"id": self.asked, "do": do, **keys}).encode(), b"".join(planes.values())
        self.process.stdin.write(MAGIC + struct.pack("<QQ", len(header), len(data)) + header + data)
        self.process.stdin.flush()
        prefix = self.process.stdout.read(24)
        if len(prefix) < 24:
            raise SystemExit("lunoid serve has ended")
        length, _ = struct.unpack("<QQ", prefix[8:])
        reply = json.loads(self.process.stdout.read(length))
        sizes = {"u8": 1, "u16": 2, "u32": 4, "i32": 4, "f32": 4, "f64": 8}
        planes = {}
        for plane in reply.get("planes", []):
            count = sizes[plane["dtype"]]
            for axis in plane["shape"]:
                count *= axis
            planes[plane["name"]] = (plane["shape"], plane["dtype"], self.process.stdout.read(count))
        if "error" in reply:
            raise SystemExit("\n".join("; ".join(filter(None, map(problem.get, ("title", "help")))) for problem in reply["error"]["problems"]))
        return reply["ok"], planes


def main():
    steps, command = int(sys.argv[1]), sys.argv[2:]
    machine = Machine(command)
    seen, _ = machine.ask("frame", frame=0)
    pose = seen["pose"]
    for _ in range(steps):
        seen, planes = machine.ask("step", pose=pose)
        _, _, picture = planes["picture"]
        print(seen["hash"], sum(picture) / len(picture))
        # Your controller here.
        pose = machine.ask("ahead", pose=pose, metres=0.5, turn_deg=0.5)[0]["pose"]
    print(machine.ask("record")[0])


if __name__ == "__main__":
    main()
