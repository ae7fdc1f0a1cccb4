// What is looked at, and the machine that shows it. One cursor for all panels; the newest wish is drawn, and none is queued.

/** Most that the report lets the vehicle do (section 3): 16 km/h, and 30 degrees a second here (chosen). */
export const MOST = { kmh: 16, turn: 30 };

/**
 * Events: `opened` (facts), `picture` (seen), `traces`, `events`, `explained`, `driven` (frames), `fault` (error), `busy` (boolean).
 */
export class ViewModel extends EventTarget {
  #machine;
  #given;
  #at = 0;
  #shown = {};
  #runs = false;
  #opened = null;

  /** `machine` answers requests; `given` finds the files of a shipped scenario by its name. */
  constructor(machine, given) {
    super();
    this.#machine = machine;
    this.#given = given;
    this.view = { scenario: null, machine: null, faults: [], set: {}, frame: 0, sweep: 0, column: null, line: null, wires: "" };
    /** Whether the last driven frame is looked at, in place of one of the path. */
    this.isDriven = false;
    this.facts = null;
  }

  /** Looks at something else. */
  show(changes) {
    if ("frame" in changes) this.isDriven = false;
    Object.assign(this.view, changes);
    this.#at += 1;
    this.#run();
  }

  /** Drives one frame further; answers when it is drawn. */
  async drive(kmh, turn) {
    const bound = (value, most) => Math.max(-most, Math.min(most, Number(value) || 0));
    const step = 1 / this.facts.update_hz;
    const way = { metres: (bound(kmh, MOST.kmh) / 3.6) * step, turn_deg: bound(turn, MOST.turn) * step };
    const from = this.isDriven ? {} : { pose: this.#shown.pose };
    const { pose } = await this.#machine.ahead({ ...way, ...from });
    const seen = await this.#machine.step(pose);
    this.isDriven = true;
    this.facts.driven += 1;
    this.#tell("driven", this.facts.driven);
    this.#draw(seen);
    await this.#panels(this.#at);
  }

  /** The files of what was driven. */
  record() {
    return this.#machine.record("driven");
  }

  parameters() {
    return this.#machine.parameters();
  }

  faults() {
    return this.#machine.faults();
  }

  blocks() {
    return this.#machine.blocks();
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  async #run() {
    if (this.#runs) return;
    this.#runs = true;
    this.#tell("busy", true);
    for (let at = -1; at !== this.#at; ) {
      at = this.#at;
      await this.#refresh(at).catch((error) => this.#tell("fault", error));
    }
    this.#runs = false;
    this.#tell("busy", false);
  }

  /** Opens, draws and looks, and stops where something newer is wished for. */
  async #refresh(at) {
    await this.#open();
    if (at !== this.#at) return;
    if (!this.isDriven) {
      this.view.frame = Math.min(this.view.frame, this.facts.frames - 1);
      this.#draw(await this.#machine.frame(this.view.frame));
    }
    await this.#panels(at);
  }

  async #open() {
    const { scenario, machine, faults, set } = this.view;
    const wishes = { machine: machine || null, overlays: faults, set };
    const wanted = JSON.stringify([scenario, wishes]);
    if (wanted === this.#opened?.wanted) return;
    const isSame = this.#opened?.scenario === scenario;
    const taken = Object.keys(this.#opened?.set ?? {}).filter((key) => !(key in set));
    const changed = { ...Object.fromEntries(taken.map((key) => [key, null])), ...set };
    this.facts = isSame
      ? await this.#machine.set(changed, { machine: wishes.machine, overlays: faults })
      : await this.#machine.open(scenario, { ...wishes, files: await this.#given(scenario) });
    if (!isSame) this.isDriven = false;
    this.#opened = { wanted, scenario, set: { ...set } };
    this.view.sweep = Math.min(this.view.sweep, Math.max(0, this.facts.sweeps - 1));
    this.#tell("opened", this.facts);
  }

  #draw(seen) {
    this.#shown = seen;
    this.#tell("picture", seen);
  }

  /** What is meant by now: a frame of the path, or the last one driven. */
  get #which() {
    return this.isDriven ? {} : { frame: this.view.frame };
  }

  async #panels(at) {
    const { column, line } = this.view;
    if (column !== null && line !== null) {
      const told = await this.#machine.explain(column, line, this.#which);
      this.view.sweep = sweepOf(told.document) ?? this.view.sweep;
      this.#tell("explained", told);
    }
    if (at !== this.#at || this.facts.samples === 0) return;
    const wires = this.view.wires.split(",").map((word) => word.trim()).filter(Boolean);
    if (wires.length === 0) return;
    this.#tell("traces", await this.#machine.probe(wires, this.view.sweep, this.#which));
    if (at !== this.#at) return;
    const none = () => ({ events: [] });
    this.#tell("events", await this.#machine.events({ ...this.#which, sweeps: this.view.sweep }).catch(none));
  }
}

/** The sweep that drew a pixel, where its generator has sweeps. */
function sweepOf(document) {
  return document?.place?.drawn_with ?? null;
}
