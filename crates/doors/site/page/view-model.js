// What is looked at, and the machine that shows it. One cursor for all panels; the newest wish is drawn, and none is queued.

import { Drives, PATH } from "./drives.js";
import { LoopKeeper } from "./loop-keeper.js";
import { Opening } from "./opening.js";
import { Trigger } from "./trigger.js";

/** Most that the report lets the vehicle do (section 3): 16 km/h, and 30 degrees a second here (chosen). */
export const MOST = { kmh: 16, turn: 30 };

/**
 * Events: `opened` (facts), `picture` (seen), `traces` (null without wires), `events`, `wires` (traces of the diagram), `explained` (null without
 * a pixel), `cursor` (sample), `triggered` (place or null), `driven` (frames), `fault` (error), `busy` (boolean).
 */
export class ViewModel extends EventTarget {
  #machine;
  #opening;
  #keeper;
  #at = 0;
  #shown = {};
  #runs = false;
  /** What the picture, and the explanation, that stand were made of. */
  #drawn = null;
  #told = null;

  /** `machine` answers requests; `given` finds the files of a shipped scenario by its name. */
  constructor(machine, given) {
    super();
    this.#machine = machine;
    this.#opening = new Opening(machine, given);
    this.view = { scenario: null, machine: null, faults: [], set: {}, frame: 0, sweep: 0, sample: null, column: null, line: null, wires: "" };
    /** The lane that is looked at: the path of the scenario, or a drive. `view.frame` counts in it. */
    this.lane = PATH;
    this.drives = new Drives();
    this.trigger = new Trigger();
    /** Planes of the pictures; the picture alone where it is undefined. */
    this.planes = undefined;
    /** Wires of the block diagram; none while nobody looks at it. */
    this.diagram = [];
    this.facts = null;
    this.#keeper = new LoopKeeper(machine, this.drives, { now: () => this.#opening.wishes, restored: (wishes) => this.#opening.restored(wishes) });
  }

  /** Whether a driven frame is looked at, in place of one of the path. */
  get isDriven() {
    return this.lane !== PATH;
  }

  /** Number of frames of the lane that is looked at. */
  get frames() {
    return this.drives.frames(this.lane, this.facts?.frames ?? 1);
  }

  /** The frame of the picture that stands, as requests name it. */
  get which() {
    return this.whichOf(this.lane, this.view.frame);
  }

  /** A frame of a lane, as requests name it. */
  whichOf(lane, frame) {
    if (lane === PATH) return { frame };
    if (this.#keeper.isLast(lane, frame)) return {};
    return { frame, pose: this.drives.list[lane].frames[frame].pose };
  }

  /** Looks at something else. A place of the cursor that the reader chose stands above the trigger. */
  show(changes) {
    if ("sweep" in changes || "column" in changes) this.trigger.yields();
    if ("sweep" in changes && !("sample" in changes)) this.view.sample = null;
    Object.assign(this.view, changes);
    this.#wish();
  }

  /** Looks at a frame of a lane, with the settings that it was driven with. */
  look(lane, frame) {
    this.lane = lane;
    const wishes = lane === PATH ? {} : this.drives.list[lane].frames[frame].wishes;
    this.show({ frame, ...wishes });
  }

  /** Looks at a place of a frame where a condition is met. */
  lookAtPlace(lane, frame, place) {
    this.trigger.choose(lane, frame, place);
    this.look(lane, frame);
  }

  /** Wires whose values somebody shows beside the scope. */
  watch(wires) {
    const isSame = wires.join() === this.diagram.join();
    this.diagram = wires;
    if (!isSame && this.facts) this.#wish();
  }

  /** Puts the cursor on an instant of the sweep (samples). */
  point(sample) {
    this.view.sample = sample;
    this.#tell("cursor", sample);
  }

  /** Waits for a condition; see `Trigger`. */
  wait(on, mode) {
    this.trigger.wait(on, mode);
    this.#wish();
  }

  /** Answers when the picture of the newest wish stands. */
  settled() {
    return new Promise((resolve) => {
      const hear = ({ detail: isBusy }) => {
        if (isBusy) return;
        this.removeEventListener("busy", hear);
        resolve();
      };
      this.addEventListener("busy", hear);
    });
  }

  /** Asks the machine about the frame that is looked at: `ask` is called with the machine, and the frame as requests name it. */
  beside(ask) {
    return ask(this.#machine, this.which);
  }

  /** The picture of another frame of the lane, beside what is looked at; null where no look can draw it. */
  async picture(frame) {
    const seen = this.isDriven && this.facts.remembers_frames ? null : await this.#seen(frame, ["picture"]);
    return seen && seen.planes.picture;
  }

  /** The picture that stands without faults and settings of the reader: from the same pose, at the same time. */
  async healthy() {
    while (this.#runs) await this.settled();
    const { pose } = this.#shown;
    this.#runs = true;
    this.#tell("busy", true);
    try {
      await this.#opening.heal(this.#wishes);
      return await (this.isDriven ? this.#machine.look(pose, { frame: this.view.frame }) : this.#machine.frame(this.view.frame));
    } finally {
      this.#runs = false;
      // The picture that stands is the one that was asked for; its machine comes back with the next wish.
      this.#wish();
    }
  }

  /** Drives one frame further from where the reader looks; answers when it is drawn. */
  async drive(kmh, turn) {
    const bound = (value, most) => Math.max(-most, Math.min(most, Number(value) || 0));
    const step = 1 / this.facts.update_hz;
    const way = { metres: (bound(kmh, MOST.kmh) / 3.6) * step, turn_deg: bound(turn, MOST.turn) * step };
    const { pose: from } = this.#shown;
    await (this.isDriven ? this.#keeper.goOn(this.lane, this.view.frame) : this.#keeper.leave());
    await this.#open();
    const { pose } = await this.#machine.ahead({ ...way, pose: from });
    const { wishes } = this.#opening;
    const seen = await this.#machine.step(pose, { planes: this.planes });
    [this.lane, this.view.frame] = this.#keeper.driven({ pose: seen.pose, hash: seen.hash, wishes });
    this.facts.driven = this.frames;
    this.#draw(seen);
    this.#tell("driven", this.frames);
    await this.#panels(this.#at);
  }

  /** The files of the drive that is looked at. */
  async record() {
    if (this.isDriven) await this.#keeper.hold(this.lane, this.frames);
    return this.#machine.record("driven");
  }

  parameters() {
    return this.#machine.parameters();
  }

  faults() {
    return this.#machine.faults();
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  get #wishes() {
    const { machine, faults, set } = this.view;
    return { machine, faults: [...faults], set: { ...set } };
  }

  #wish() {
    this.#at += 1;
    this.#run();
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
    this.view.frame = Math.min(this.view.frame, this.frames - 1);
    if (this.#key !== this.#drawn) this.#draw(await this.#picture());
    await this.#panels(at);
  }

  /** What the picture of now is made of. */
  get #key() {
    return JSON.stringify([this.#opening.key, this.lane, this.view.frame, this.planes]);
  }

  /** The picture of the frame that is looked at. A driven frame that no look can draw is driven once more. */
  async #picture() {
    const { frame } = this.view;
    if (!this.isDriven || !this.facts.remembers_frames) return this.#seen(frame, this.planes);
    await this.#keeper.hold(this.lane, frame);
    await this.#open();
    const { pose } = this.drives.list[this.lane].frames[frame];
    const seen = await this.#machine.step(pose, { planes: this.planes });
    this.#keeper.redrawn();
    return seen;
  }

  /** A frame of the lane, by a look where it was driven. */
  #seen(frame, planes) {
    if (!this.isDriven) return this.#machine.frame(frame, { planes });
    return this.#machine.look(this.drives.list[this.lane].frames[frame].pose, { frame, planes });
  }

  async #open() {
    const opened = await this.#opening.open(this.view.scenario, this.#wishes);
    if (opened === null) return;
    if (opened.isOther) this.#begin();
    this.facts = { ...opened.facts, driven: this.isDriven ? this.frames : 0 };
    this.drives.forgetPath();
    this.view.sweep = Math.min(this.view.sweep, Math.max(0, this.facts.sweeps - 1));
    this.#tell("opened", this.facts);
  }

  /** Another scenario: nothing was driven on it. */
  #begin() {
    this.lane = PATH;
    this.drives.clear();
    this.#keeper.clear();
  }

  #draw(seen) {
    this.#drawn = this.#key;
    this.#shown = seen;
    this.trigger.arm();
    this.#tell("picture", seen);
  }

  async #panels(at) {
    await this.#explain();
    if (at !== this.#at) return;
    if (this.facts.samples === 0) return this.#noSweep();
    if (this.trigger.isDue && !(await this.#triggered())) return;
    if (at !== this.#at) return;
    const { wires, sweep } = this.view;
    const names = wires.split(",").map((word) => word.trim()).filter(Boolean);
    this.#tell("traces", names.length > 0 ? await this.#machine.probe(names, sweep, this.which) : null);
    if (at !== this.#at) return;
    if (this.diagram.length > 0) this.#tell("wires", await this.#machine.probe(this.diagram, sweep, this.which));
    if (at !== this.#at) return;
    const none = () => ({ events: [] });
    this.#tell("events", await this.#machine.events({ ...this.which, sweeps: sweep }).catch(none));
  }

  /** A generator without sweeps: nothing of another machine is left standing. */
  #noSweep() {
    this.#tell("traces", null);
    this.#tell("events", { events: [] });
  }

  async #explain() {
    const { column, line } = this.view;
    const key = column === null || line === null ? null : JSON.stringify([this.#drawn, column, line]);
    if (key === this.#told) return;
    if (key === null) {
      this.#told = null;
      return this.#tell("explained", null);
    }
    const told = await this.#machine.explain(column, line, this.which);
    this.#told = key;
    this.view.sweep = sweepOf(told.document) ?? this.view.sweep;
    this.#tell("explained", told);
  }

  /** Looks for the condition in the frame that stands; whether the panels are to show what they have now. */
  async #triggered() {
    const place = this.trigger.chosen(this.lane, this.view.frame) ?? (await this.#machine.trigger(this.trigger.on, this.which)).places[0] ?? null;
    const shows = this.trigger.found(place);
    if (place) Object.assign(this.view, { sweep: place.sweep, sample: place.instant });
    this.#tell("triggered", place);
    if (place) this.#tell("cursor", place.instant);
    return shows;
  }
}

/** The sweep that drew a pixel, where its generator has sweeps. */
function sweepOf(document) {
  return document?.place?.drawn_with ?? null;
}
