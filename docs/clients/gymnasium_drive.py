"""The vehicle as an environment of Gymnasium: an action drives it one frame further, and the picture comes back.

python3 docs/clients/gymnasium_drive.py lunoid serve scenarios/first-light.toml
runs Gymnasium's own checker over it, and then an episode.
"""
import sys

import gymnasium
import numpy

from drive import Machine

# Most that the report lets the vehicle do a second (section 3: 16 km/h), and 30 degrees (chosen).
MOST_METRES, MOST_DEGREES = 16 / 3.6, 30.0


class Drive(gymnasium.Env):
    """Observation: the picture (lines, columns). Action: share of most speed and most turn, each in -1..1. Reward: metres driven."""

    metadata = {"render_modes": ["rgb_array"]}

    def __init__(self, command, steps=100, render_mode=None):
        self.render_mode, self.steps = render_mode, steps
        self.machine = Machine(command)
        opened = self.machine.ask("hello")[0]["opened"]
        self.second = 1 / opened["update_hz"]
        self.metadata = {**self.metadata, "render_fps": opened["update_hz"]}
        self.start, self.begun = self.machine.ask("state")[1]["state"][2], self.machine.ask("frame", frame=0)[0]["pose"]
        shape = (opened["lines"], opened["columns"])
        self.observation_space = gymnasium.spaces.Box(0, 255, shape, numpy.uint8)
        self.action_space = gymnasium.spaces.Box(-1, 1, (2,), numpy.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.machine.ask("restore", planes={"state": self.start})
        self.pose, self.driven = self.begun, 0
        return self._seen(), {"pose": dict(self.pose)}

    def step(self, action):
        speed, turn = (float(share) for share in action)
        metres = speed * MOST_METRES * self.second
        way = {"metres": metres, "turn_deg": turn * MOST_DEGREES * self.second}
        self.pose = self.machine.ask("ahead", pose=self.pose, **way)[0]["pose"]
        self.driven += 1
        return self._seen(), metres, False, self.driven >= self.steps, {"pose": dict(self.pose)}

    def render(self):
        return numpy.repeat(self.picture[:, :, None], 3, axis=2)

    def close(self):
        self.machine.process.stdin.close()
        self.machine.process.wait()

    def _seen(self):
        shape, _, picture = self.machine.ask("step", pose=self.pose)[1]["picture"]
        self.picture = numpy.frombuffer(picture, numpy.uint8).reshape(shape)
        return self.picture


gymnasium.register(id="lunoid/Drive-v0", entry_point=Drive)


def main():
    from gymnasium.utils.env_checker import check_env

    checked = gymnasium.make("lunoid/Drive-v0", command=sys.argv[1:], render_mode="rgb_array")
    check_env(checked.unwrapped)
    checked.close()
    drive = gymnasium.make("lunoid/Drive-v0", command=sys.argv[1:], steps=10)
    drive.reset(seed=1)
    ended, metres = False, 0.0
    while not ended:
        _, reward, _, ended, seen = drive.step(numpy.array([0.5, 0.1], numpy.float32))
        metres += reward
    print(f"{metres:.3f} m driven to {seen['pose']}")
    drive.close()


if __name__ == "__main__":
    main()
