// Pointer, wheel and keys on the scope: one finger moves and points, two fingers or the wheel zoom.

/** How far a pointer goes before it moves the trace in place of pointing (CSS pixels). */
const STILL = 3;

export class ScopeHand {
  #canvas;
  #scope;
  /** Pointers that are down, by their number: where each is across the page. */
  #down = new Map();
  #hasMoved = false;

  /** `scope` has `isReady`, `last`, `cursor`, `sample`, `point`, `hover`, `slide` and `scale`. */
  constructor(canvas, scope) {
    this.#canvas = canvas;
    this.#scope = scope;
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointerleave", () => this.#scope.isReady() && this.#scope.hover(null));
    canvas.addEventListener("pointercancel", ({ pointerId }) => this.#down.delete(pointerId));
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Where a place of the page lies across the canvas, from 0 to 1. */
  #share(clientX) {
    const { left, width } = this.#canvas.getBoundingClientRect();
    return Math.max(0, Math.min(1, (clientX - left) / width));
  }

  #wheel(event) {
    if (!this.#scope.isReady()) return;
    event.preventDefault();
    if (event.shiftKey) this.#scope.slide(Math.sign(event.deltaY) * 0.1);
    else this.#scope.scale(event.deltaY > 0 ? 1.25 : 0.8, this.#share(event.clientX));
  }

  #press(event) {
    if (this.#down.size === 0) this.#hasMoved = false;
    this.#down.set(event.pointerId, event.clientX);
    // A pointer that a script makes cannot be held.
    if (event.isTrusted) this.#canvas.setPointerCapture(event.pointerId);
  }

  #move(event) {
    if (!this.#scope.isReady()) return;
    const before = this.#down.get(event.pointerId);
    if (before === undefined) return this.#scope.hover(this.#scope.sample(this.#share(event.clientX)));
    const by = event.clientX - before;
    if (this.#down.size === 1 && !this.#hasMoved && Math.abs(by) < STILL) return;
    this.#hasMoved = true;
    if (this.#down.size === 2) this.#pinch(event, before);
    else if (this.#down.size === 1) this.#scope.slide(-by / this.#canvas.getBoundingClientRect().width);
    this.#down.set(event.pointerId, event.clientX);
  }

  /** Two fingers: what lies between them grows as they part. */
  #pinch(event, before) {
    const other = [...this.#down].find(([number]) => number !== event.pointerId)[1];
    const [was, is] = [Math.abs(before - other), Math.abs(event.clientX - other)];
    if (was > STILL && is > STILL) this.#scope.scale(was / is, this.#share((event.clientX + other) / 2));
  }

  #release(event) {
    const isLast = this.#down.delete(event.pointerId) && this.#down.size === 0;
    if (!isLast || this.#hasMoved || !this.#scope.isReady()) return;
    this.#scope.point(this.#scope.sample(this.#share(event.clientX)), Number(event.shiftKey));
  }

  #key(event) {
    if (!this.#scope.isReady()) return;
    const which = Number(event.shiftKey);
    const at = this.#scope.cursor(which);
    const to = { ArrowLeft: (at ?? 1) - 1, ArrowRight: (at ?? -1) + 1, PageUp: (at ?? 0) - 20, PageDown: (at ?? 0) + 20 }[event.key];
    if (to !== undefined) this.#scope.point(Math.max(0, Math.min(this.#scope.last(), Math.round(to))), which);
    else if (event.key === "+") this.#scope.scale(0.8, 0.5);
    else if (event.key === "-") this.#scope.scale(1.25, 0.5);
    else return;
    event.preventDefault();
  }
}
