// A gamepad: the stick drives, a button lets go or plays, the shoulders step.

/** Share of a stick's way that counts as rest. */
const REST = 0.15;
/** Buttons of the standard layout by what they do. */
const BUTTONS = { play: 0, heal: 1, back: 4, on: 5 };

export class Gamepads {
  #steer;
  #press;
  #runs = false;
  #isHeld = false;
  #down = new Set();

  /** `steer` is told the turn and the speed, from -1 to 1 each, and whether the stick is off its rest; `press` the name of a button of `BUTTONS`. */
  constructor(steer, press) {
    [this.#steer, this.#press] = [steer, press];
    addEventListener("gamepadconnected", () => this.#run());
  }

  async #run() {
    if (this.#runs) return;
    this.#runs = true;
    for (let pad = first(); pad; pad = first()) {
      this.#stick(pad);
      this.#buttons(pad);
      await new Promise(requestAnimationFrame);
    }
    this.#runs = false;
    if (this.#isHeld) this.#steer(0, 0, false);
    this.#isHeld = false;
  }

  #stick({ axes: [turn, speed] }) {
    const free = [turn, -speed].map((share) => (Math.abs(share) < REST ? 0 : share));
    const isHeld = free.some((share) => share !== 0);
    if (isHeld || this.#isHeld) this.#steer(...free, isHeld);
    this.#isHeld = isHeld;
  }

  #buttons({ buttons }) {
    for (const [name, number] of Object.entries(BUTTONS)) {
      const isDown = buttons[number]?.pressed ?? false;
      if (isDown && !this.#down.has(name)) this.#press(name);
      if (isDown) this.#down.add(name);
      else this.#down.delete(name);
    }
  }
}

function first() {
  return [...navigator.getGamepads()].find((pad) => pad?.connected);
}
