// What was driven: drives side by side, each with its frames, and where one branched from another. It knows nothing of a machine.

/** The lane of the scenario's own path. */
export const PATH = -1;

export class Drives {
  /** Drives in the order in which they began. */
  list = [];
  /** Marks that the reader set: `{ lane, frame, text }`. */
  marks = [];
  /** Frames with late words by lane: sets of numbers, and how many frames were looked at. */
  #late = new Map();

  clear() {
    this.list = [];
    this.marks = [];
    this.#late.clear();
  }

  /** Begins a drive: with the first `frames` of the drive `from`, or with none. Answers its lane. */
  begin(from = PATH, frames = 0) {
    const kept = from === PATH ? [] : this.list[from].frames.slice(0, frames);
    this.list.push({ from, since: kept.length, frames: kept, saved: null });
    return this.list.length - 1;
  }

  /** Adds a frame to a drive: `{ pose, hash, wishes }`. What was saved of it is out of date. */
  add(lane, frame) {
    this.list[lane].frames.push(frame);
    this.list[lane].saved = null;
  }

  /** Number of frames of a lane; that of the path is `frames`. */
  frames(lane, frames) {
    return lane === PATH ? frames : this.list[lane].frames.length;
  }

  /** Notes whether a frame has late words. */
  note(lane, frame, isLate) {
    if (!this.#late.has(lane)) this.#late.set(lane, new Map());
    this.#late.get(lane).set(frame, isLate);
  }

  /** What is known of late words in a frame: true, false, or undefined where nobody has looked. */
  isLate(lane, frame) {
    return this.#late.get(lane)?.get(frame);
  }

  /** Forgets which frames of the path are late: other settings have others. */
  forgetPath() {
    this.#late.delete(PATH);
  }

  /** Frames in which the settings changed under way, with what changed in words. */
  switched(lane) {
    if (lane === PATH) return [];
    const { frames } = this.list[lane];
    const rows = frames.map(({ wishes }, frame) => ({ frame, text: frame > 0 ? difference(frames[frame - 1].wishes, wishes) : "" }));
    return rows.filter(({ text }) => text);
  }
}

/** What `after` has and `before` has not, and the other way round, in words. */
export function difference(before, after) {
  const on = after.faults.filter((name) => !before.faults.includes(name)).map((name) => `${name} on`);
  const off = before.faults.filter((name) => !after.faults.includes(name)).map((name) => `${name} off`);
  const set = Object.entries(after.set).filter(([key, value]) => before.set[key] !== value).map(([key, value]) => `${key} = ${value}`);
  const back = Object.keys(before.set).filter((key) => !(key in after.set)).map((key) => `${key} taken back`);
  const machine = before.machine === after.machine ? [] : [`machine ${after.machine ?? "of the scenario"}`];
  return [...machine, ...on, ...off, ...set, ...back].join(", ");
}
