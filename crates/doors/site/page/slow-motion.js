// Slow motion: the picture builds up sweep by sweep, forwards or backwards, and the cursor goes with it.

/** Sweeps a second up to which the instant within the sweep is followed, too. */
const SLOW = 10;
/** Pictures that are kept, so that the one before need not be drawn again. */
const KEPT = 3;

export class SlowMotion extends EventTarget {
  #model;
  #tube;
  /** Number of the newest wish. */
  #newest = 0;
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
  drawn({ planes, frame }) {
    const key = this.#key(frame);
    this.#pictures.delete(key);
    this.#pictures.set(key, planes.picture);
    if (this.#pictures.size > KEPT) this.#pictures.delete(this.#pictures.keys().next().value);
    this.#completes = planes.sweep?.values ?? null;
    return this.#isOn && this.#completes ? this.#build : null;
  }

  /** Runs on with so many sweeps a second, or back where they are below 0, until something else is wished for. */
  async run(rate) {
    const wish = this.#wish(Math.sign(rate));
    let isOn = await this.#begin(rate, wish);
    for (let last = performance.now(); isOn; ) {
      await new Promise(requestAnimationFrame);
      const now = performance.now();
      // A page that was hidden does not leap.
      isOn = await this.#go((rate * Math.min(250, now - last)) / 1000, Math.abs(rate) <= SLOW, wish);
      last = now;
    }
  }

  /** Stands still. */
  stop() {
    this.#wish(0);
  }

  /** Goes by whole sweeps, and stands. */
  async step(by) {
    const wish = this.#wish(0);
    if (await this.#begin(by, wish)) await this.#go(Math.floor(this.#written) + by - this.#written, false, wish);
  }

  /** Shows whole pictures again. */
  leave() {
    this.stop();
    this.#end();
  }

  get #sweeps() {
    return this.#model.facts.sweeps;
  }

  #key(frame) {
    return `${this.#model.lane}:${frame}`;
  }

  #wish(way) {
    this.dispatchEvent(new CustomEvent("moved", { detail: way }));
    return (this.#newest += 1);
  }

  #end() {
    this.#isOn = false;
    this.#model.planes = undefined;
    this.#tube.built(null);
  }

  /** Begins with the frame that stands: dark forwards, whole backwards. Answers whether the wish is still the newest and can be built up. */
  async #begin(way, wish) {
    if (this.#sweeps === 0) throw new Error(`${this.#model.facts.drawn_by} has no sweeps; expected a hardware model`);
    if (this.#isOn && this.#completes) return true;
    this.#isOn = true;
    return this.#enter(this.#model.view.frame, way > 0 ? 0 : this.#sweeps, wish);
  }

  /** Goes by so many sweeps, for a wish that is still the newest; answers whether it is. */
  async #go(by, followsInstant, wish) {
    if (wish !== this.#newest) return false;
    const was = Math.floor(this.#written);
    let next = this.#written + by;
    if (next > this.#sweeps || next < 0) {
      const { frames, view } = this.#model;
      next = by > 0 ? 0 : this.#sweeps;
      if (!(await this.#enter((view.frame + Math.sign(by) + frames) % frames, next, wish))) return false;
    }
    this.#written = next;
    this.#follow(was, followsInstant);
    return true;
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

  /** Goes to a frame of the lane, of which so many sweeps are written. Answers whether the wish is still the newest and can be built up. */
  async #enter(frame, written, wish) {
    const before = this.#pictures.get(this.#key(frame - 1));
    [this.#before, this.#written, this.#completes] = [before ?? null, written, null];
    this.#model.planes = ["picture", "sweep"];
    const settled = this.#model.settled();
    this.#model.look(this.#model.lane, frame);
    await settled;
    // A newer wish enters its own frame, or has left.
    if (wish !== this.#newest) return false;
    // A picture that stood already was not drawn again.
    this.#completes ??= this.#model.standing?.sweep?.values ?? null;
    // What cannot be built up has told its fault.
    if (!this.#completes) {
      this.#end();
      return false;
    }
    this.#tube.built(this.#build);
    if (before || frame === 0) return true;
    this.#before = await this.#model.picture(frame - 1);
    if (wish !== this.#newest) return false;
    this.#tube.built(this.#build);
    return true;
  }

  /** How far the picture is built up. */
  get #build() {
    return { sweep: Math.floor(this.#written), completes: this.#completes, before: this.#before };
  }
}
