// What is looked at, and the machine that shows it. One cursor for all panels; the newest wish is drawn, and none is queued.

import { Drives, PATH } from "./drives.js";
import { way } from "./driving.js";
import { bounded, openKnown } from "./known.js";
import { LoopKeeper } from "./loop-keeper.js";
import { Opening } from "./opening.js";
import { Panels } from "./panels.js";
import { Trigger } from "./trigger.js";
import { Turns } from "./turns.js";

/**
 * Events: `opened` (facts), `picture` (seen, with its lane), `traces` (null without wires), `events` (with their sweep), `wires` (traces of the
 * diagram), `explained` (null without a pixel), `cursor` (sample), `triggered` (place or null), `driven` (frames), `fault` (error), `refused`
 * (parts that are left out, each with its error), `busy` (boolean). What the machine refuses is taken back: the view says what stands.
 */
export class ViewModel extends EventTarget {
  #machine;
  #opening;
  #keeper;
  #panels;
  #turns;
  #looks = 0;
  /** Whether the view is that of a link, of which only a part may be known. */
  #isLink = false;
  /** Whether the reader has chosen another machine, which may not have all that is set. */
  #isOther = false;
  /** The picture that stands, what it was made of, and its lane and frame. */
  #shown = {};
  #drawn = null;
  #stands = null;

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
    this.#turns = new Turns((at) => this.#attempt(at), (isBusy) => this.#hear(isBusy));
    this.#panels = new Panels(this, machine, (name, detail) => this.#tell(name, detail));
  }

  /** The planes of the picture that stands, if it is the one that is looked at. */
  get standing() {
    return this.#key === this.#drawn ? this.#shown.planes : null;
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

  /** Looks at what a link asks for, as far as the machine knows it. */
  follow(view) {
    this.#isLink = true;
    this.lane = PATH;
    this.show(view);
  }

  /** Draws by another machine, with those settings that it has. */
  choose(machine) {
    this.#isOther = true;
    this.show({ machine, faults: [] });
  }

  /** Looks at a frame of a lane, with the settings that it was driven with. */
  look(lane, frame) {
    this.#looks += 1;
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
  healthy() {
    return this.#alone(async () => {
      const { pose } = this.#shown;
      // The picture that stands is the one that was asked for; its machine comes back with the next wish.
      this.#turns.wish();
      await this.#opening.heal(this.#wishes);
      return this.isDriven ? this.#machine.look(pose, { frame: this.view.frame }) : this.#machine.frame(this.view.frame);
    });
  }

  /** Drives one frame further from where the reader looks. Answers when it is drawn: whether the reader still looks at the drive. */
  drive(kmh, turn) {
    return this.#alone(async () => {
      const [at, looks] = [this.#turns.newest, this.#looks];
      const { pose: from } = this.#shown;
      await (this.isDriven ? this.#keeper.goOn(this.lane, this.view.frame) : this.#keeper.leave());
      await this.#open();
      const { pose } = await this.#machine.ahead({ ...way(kmh, turn, 1 / this.facts.update_hz), pose: from });
      const { wishes } = this.#opening;
      const seen = await this.#machine.step(pose, { planes: this.planes });
      const [lane, frame] = this.#keeper.driven({ pose: seen.pose, hash: seen.hash, wishes });
      // Who looks elsewhere meanwhile is not called back.
      const isLooking = looks === this.#looks;
      if (isLooking) [this.lane, this.view.frame] = [lane, frame];
      this.facts.driven = this.drives.frames(lane, 0);
      if (isLooking) this.#draw(seen, this.#key);
      this.#tell("driven", this.facts.driven);
      if (isLooking) await this.#fill(at);
      return isLooking;
    });
  }

  /** The files of the drive that is looked at. */
  record() {
    return this.#alone(async () => {
      if (this.isDriven) await this.#keeper.hold(this.lane, this.frames);
      return this.#machine.record("driven");
    });
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
    this.#turns.wish();
  }

  #alone(once) {
    return this.#turns.alone(once, () => this.settled());
  }

  /** Draws the wish `at`, and tells its fault. Answers whether something was taken back, so that it is to be shown anew. */
  async #attempt(at) {
    const before = JSON.stringify([this.lane, this.view]);
    try {
      await this.#refresh(at);
    } catch (error) {
      this.#tell("fault", error);
      return JSON.stringify([this.lane, this.view]) !== before;
    }
    return false;
  }

  /** The machine is busy, or has drawn the newest wish. */
  #hear(isBusy) {
    if (!isBusy) [this.#isLink, this.#isOther] = [false, false];
    this.#tell("busy", isBusy);
  }

  /** Opens, draws and looks, and stops where something newer is wished for. */
  async #refresh(at) {
    await this.#open();
    if (at !== this.#turns.newest) return;
    const { known, refused } = bounded(this.view, this.frames, this.facts);
    Object.assign(this.view, known);
    if (this.#isLink && refused.length > 0) this.#tell("refused", refused);
    if (this.#key !== this.#drawn || this.#isAstray) await this.#picture();
    if (at === this.#turns.newest) await this.#fill(at);
  }

  /** Fills the panels. Wires that are not there are left out of a link, and a fault of the reader's. */
  #fill(at) {
    const refused = (wires) => (this.#isLink ? this.#tell("refused", wires) : this.#tell("fault", wires[0].error));
    return this.#panels.fill(this.#drawn, () => at === this.#turns.newest, refused);
  }

  /** Whether the loop has gone on from a frame that the machine can tell of in its loop alone. */
  get #isAstray() {
    return this.isDriven && this.facts.remembers_frames && !this.#keeper.isLast(this.lane, this.view.frame);
  }

  /** What the picture of now is made of. */
  get #key() {
    return JSON.stringify([this.#opening.key, this.lane, this.view.frame, this.planes]);
  }

  /** Draws the frame that is looked at. Where it is refused, the view goes back to the picture that stands. */
  async #picture() {
    const looked = [this.lane, this.view.frame];
    const key = this.#key;
    const seen = await this.#looked().catch((error) => {
      if (this.#stands && looked.join() === [this.lane, this.view.frame].join()) ({ lane: this.lane, frame: this.view.frame } = this.#stands);
      throw error;
    });
    this.#draw(seen, key, ...looked);
  }

  /** The picture of the frame that is looked at. A driven frame that no look can draw is driven once more. */
  async #looked() {
    const { frame } = this.view;
    if (!this.isDriven || !this.facts.remembers_frames) return this.#seen(frame, this.planes);
    const { lane } = this;
    await this.#keeper.hold(lane, frame);
    await this.#open();
    const { pose } = this.drives.list[lane].frames[frame];
    const seen = await this.#machine.step(pose, { planes: this.planes });
    this.#keeper.redrawn();
    return seen;
  }

  /** A frame of the lane, by a look where it was driven. */
  #seen(frame, planes) {
    if (!this.isDriven) return this.#machine.frame(frame, { planes });
    return this.#machine.look(this.drives.list[this.lane].frames[frame].pose, { frame, planes });
  }

  /** Opens what the view asks for. Where it is refused, the view goes back to what is opened; of a link, what is known stands. */
  async #open() {
    const { scenario } = this.view;
    const wishes = this.#wishes;
    const opened = await this.#opening.open(scenario, wishes).catch((error) => {
      if (this.#isLink || this.#isOther) return this.#known(scenario, wishes);
      this.#back(scenario, wishes);
      throw error;
    });
    if (opened === null) return;
    if (opened.isOther) this.#begin();
    this.facts = { ...opened.facts, driven: this.isDriven ? this.frames : 0 };
    this.drives.forgetPath();
    this.#tell("opened", this.facts);
  }

  /** Opens what the machine knows of `asked`. A machine that cannot draw the scenario at all goes back to the one before. */
  async #known(scenario, asked) {
    const before = { ...this.#opening.wishes };
    const { opened, wishes, refused } = await openKnown(this.#opening, scenario, asked);
    const none = this.#isLink ? null : refused.find(({ part }) => part.startsWith("machine="));
    if (isSame(asked, this.#wishes)) Object.assign(this.view, none ? before : wishes);
    if (none) throw none.error;
    if (refused.length > 0) this.#tell("refused", refused);
    return opened;
  }

  /** The view says again what is opened, if the reader has not wished for something else meanwhile. */
  #back(scenario, wishes) {
    const { scenario: opened, wishes: stand } = this.#opening;
    const isNewest = isSame([scenario, wishes], [this.view.scenario, this.#wishes]);
    if (opened !== null && isNewest) Object.assign(this.view, { scenario: opened, ...stand });
  }

  /** Another scenario: nothing was driven on it. */
  #begin() {
    this.lane = PATH;
    this.drives.clear();
    this.#keeper.clear();
  }

  #draw(seen, key, lane = this.lane, frame = this.view.frame) {
    this.#drawn = key;
    this.#shown = seen;
    this.#stands = { lane, frame };
    this.trigger.arm();
    this.#tell("picture", { ...seen, lane, frame });
  }
}

function isSame(one, other) {
  return JSON.stringify(one) === JSON.stringify(other);
}
