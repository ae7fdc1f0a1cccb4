// Slow motion: the picture builds up sweep by sweep, forwards or backwards, and the cursor goes with it.

/** Sweeps a second up to which the instant within the sweep is followed, too. */
const SLOW = 10;
/** Pictures that are kept, so that the one before need not be drawn again. */
const KEPT = 3;

export class SlowMotion extends EventTarget {
  #model;
  #tube;
  #run = 0;
  #pictures = new Map();
  /** Sweeps of the frame that are written; the part of one is the part of the sweep that runs. */
  #written = 0;
  #isOn = false;
  /** The picture that stood before the frame, and the sweep that completes each pixel of the frame. */
  #before = null;
  #completes = null;

  /** Event: `moved`, with the way: 1, -1, or 0 for standing. */
  constructor(model, tube) {
    super();
    this.#model = model;
    this.#tube = tube;
    model.addEventListener("opened", () => this.#pictures.clear());
  }

  /** Takes a picture that the model has drawn; how far it is to be built up, or null for all of it. */
  drawn(planes) {
    const key = this.#key(this.#model.view.frame);
    this.#pictures.delete(key);
    this.#pictures.set(key, planes.picture);
    if (this.#pictures.size > KEPT) this.#pictures.delete(this.#pictures.keys().next().value);
    this.#completes = planes.sweep?.values ?? null;
    return this.#isOn && this.#completes ? this.#build : null;
  }

  /** Runs on with so many sweeps a second, or back where they are below 0, until something else is wished for. */
  async run(rate) {
    const run = this.#wish(Math.sign(rate));
    await this.#begin(rate);
    for (let last = performance.now(); run === this.#run && this.#isOn; ) {
      await new Promise(requestAnimationFrame);
      const now = performance.now();
      // A page that was hidden does not leap.
      if (run === this.#run) await this.#go((rate * Math.min(250, now - last)) / 1000, Math.abs(rate) <= SLOW);
      last = now;
    }
  }

  /** Stands still. */
  stop() {
    this.#wish(0);
  }

  /** Goes by whole sweeps, and stands. */
  async step(by) {
    this.stop();
    await this.#begin(by);
    if (this.#isOn) await this.#go(Math.floor(this.#written) + by - this.#written, false);
  }

  /** Shows whole pictures again. */
  leave() {
    this.stop();
    this.#isOn = false;
    this.#model.planes = undefined;
    this.#tube.built(null);
  }

  get #sweeps() {
    return this.#model.facts.sweeps;
  }

  #key(frame) {
    return `${this.#model.lane}:${frame}`;
  }

  #wish(way) {
    this.dispatchEvent(new CustomEvent("moved", { detail: way }));
    return (this.#run += 1);
  }

  /** Begins with the frame that stands: dark forwards, whole backwards. */
  async #begin(way) {
    if (this.#isOn) return;
    if (this.#sweeps === 0) throw new Error(`${this.#model.facts.drawn_by} has no sweeps; expected a hardware model`);
    this.#isOn = true;
    await this.#enter(this.#model.view.frame, way > 0 ? 0 : this.#sweeps);
  }

  async #go(by, followsInstant) {
    const was = Math.floor(this.#written);
    let next = this.#written + by;
    if (next > this.#sweeps || next < 0) {
      const { frames, view } = this.#model;
      next = by > 0 ? 0 : this.#sweeps;
      await this.#enter((view.frame + Math.sign(by) + frames) % frames, next);
      if (!this.#isOn) return;
    }
    this.#written = next;
    this.#follow(was, followsInstant);
  }

  /** The tube and the cursor at the sweep that is written now. */
  #follow(was, followsInstant) {
    const sweep = Math.floor(this.#written);
    this.#tube.reach(sweep);
    const { facts, view } = this.#model;
    const written = Math.min(sweep, this.#sweeps - 1);
    if (sweep !== was && written !== view.sweep) this.#model.show({ sweep: written, column: null, line: null });
    if (followsInstant) this.#model.point((this.#written - sweep) * (facts.samples - 1));
  }

  /** Goes to a frame of the lane, of which so many sweeps are written. */
  async #enter(frame, written) {
    const before = this.#pictures.get(this.#key(frame - 1));
    [this.#before, this.#written, this.#completes] = [before ?? null, written, null];
    this.#model.planes = ["picture", "sweep"];
    const settled = this.#model.settled();
    this.#model.look(this.#model.lane, frame);
    await settled;
    // What cannot be built up has told its fault.
    if (!this.#completes) return this.leave();
    if (before || frame === 0) return;
    this.#before = await this.#model.picture(frame - 1);
    this.#tube.built(this.#build);
  }

  /** How far the picture is built up. */
  get #build() {
    return { sweep: Math.floor(this.#written), completes: this.#completes, before: this.#before };
  }
}
