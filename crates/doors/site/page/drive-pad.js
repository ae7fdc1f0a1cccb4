// The pad: a finger, a mouse or the arrow keys on it drive. Up is ahead, and to the side is a turn.

/** Share of the pad that one press of a key goes. */
const STEP = 0.25;

export class DrivePad {
  #pad;
  #knob;
  #steer;
  #pointer = null;
  #at = [0, 0];

  /** `steer` is told the turn and the speed, from -1 to 1 each, and whether the pad is held. */
  constructor(pad, steer) {
    [this.#pad, this.#steer] = [pad, steer];
    this.#knob = pad.firstElementChild;
    pad.addEventListener("pointerdown", (event) => this.#press(event));
    pad.addEventListener("pointermove", (event) => this.#move(event));
    for (const name of ["pointerup", "pointercancel"]) pad.addEventListener(name, (event) => this.#release(event));
    pad.addEventListener("keydown", (event) => this.#key(event));
    pad.addEventListener("blur", () => this.#leave());
  }

  #press(event) {
    if (this.#pointer !== null) return;
    this.#pointer = event.pointerId;
    // A pointer that a script makes cannot be held.
    if (event.isTrusted) this.#pad.setPointerCapture(event.pointerId);
    this.#move(event);
  }

  #move(event) {
    if (event.pointerId !== this.#pointer) return;
    const { left, top, width, height } = this.#pad.getBoundingClientRect();
    const share = [(event.clientX - left) / width, (event.clientY - top) / height].map((part) => Math.max(-1, Math.min(1, 2 * part - 1)));
    this.#set([share[0], -share[1]], true);
  }

  #release(event) {
    if (event.pointerId === this.#pointer) this.#leave();
  }

  #leave() {
    this.#pointer = null;
    this.#set([0, 0], false);
  }

  #key(event) {
    const way = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, STEP], ArrowDown: [0, -STEP] }[event.key];
    if (way) this.#set(this.#at.map((at, axis) => Math.max(-1, Math.min(1, at + way[axis]))), true);
    else if (event.key === "Escape" || event.key === " ") this.#leave();
    else return;
    event.preventDefault();
  }

  #set([turn, speed], isHeld) {
    this.#at = [turn, speed];
    this.#knob.style.transform = `translate(${50 * turn}%, ${-50 * speed}%)`;
    this.#steer(turn, speed, isHeld);
  }
}
