// Turns at the machine: one thing is done at a time, the newest wish is drawn, and none is queued.

export class Turns {
  #draw;
  #hear;
  #newest = 0;
  #runs = false;

  /** `draw` draws the wish of a number, and answers whether it is to be drawn anew. `hear` is told whether the machine is busy. */
  constructor(draw, hear) {
    [this.#draw, this.#hear] = [draw, hear];
  }

  /** Number of the newest wish. */
  get newest() {
    return this.#newest;
  }

  /** There is a newer wish. */
  wish() {
    this.#newest += 1;
    this.#run();
  }

  /** Answers what `once` does with the machine to itself, after `settled` has; what is wished for meanwhile is drawn behind it. */
  async alone(once, settled) {
    while (this.#runs) await settled();
    this.#runs = true;
    const at = this.#newest;
    this.#hear(true);
    try {
      return await once();
    } finally {
      this.#runs = false;
      if (at === this.#newest) this.#hear(false);
      else this.#run();
    }
  }

  async #run() {
    if (this.#runs) return;
    this.#runs = true;
    this.#hear(true);
    for (let at = -1; at !== this.#newest; ) {
      at = this.#newest;
      if (await this.#draw(at)) this.#newest += 1;
    }
    this.#runs = false;
    this.#hear(false);
  }
}
