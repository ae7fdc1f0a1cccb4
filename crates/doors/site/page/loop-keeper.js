// The loop of the machine, kept in step with the drives of the page: what is left is saved, what is gone back to is restored.

import { PATH } from "./drives.js";

export class LoopKeeper {
  #machine;
  #drives;
  #settings;
  /** The drive that the loop has, and how many of its frames. */
  #lane = PATH;
  #frames = 0;

  /** `settings.now` answers the settings of the machine; `settings.restored` is told those that a restored loop brings back. */
  constructor(machine, drives, settings) {
    this.#machine = machine;
    this.#drives = drives;
    this.#settings = settings;
  }

  /** The machine was opened anew: its loop is empty. */
  clear() {
    this.#lane = PATH;
    this.#frames = 0;
  }

  /** Whether a frame of a drive is the last that the loop has driven. */
  isLast(lane, frame) {
    return lane === this.#lane && frame === this.#frames - 1;
  }

  /** The loop has driven a frame further: `{ pose, hash, wishes }`. */
  driven(frame) {
    if (this.#lane === PATH) this.#lane = this.#drives.begin();
    this.#drives.add(this.#lane, frame);
    this.#frames += 1;
    return [this.#lane, this.#frames - 1];
  }

  /** The loop has drawn a frame once more that its drive has already. */
  redrawn() {
    this.#frames += 1;
  }

  /** An empty loop, for a drive that begins on the path. What was driven is kept. */
  async leave() {
    await this.#save();
    await this.#cut(0);
    this.#lane = PATH;
  }

  /**
   * A loop whose last frame is `frame` of a drive, so that driving goes on from there. Where the drive goes further, a branch begins with the next
   * frame.
   */
  async goOn(lane, frame) {
    await this.hold(lane, frame + 1);
    if (frame + 1 < this.#drives.list[lane].frames.length) this.#lane = this.#drives.begin(lane, frame + 1);
  }

  /** A loop with the first `frames` of a drive. */
  async hold(lane, frames) {
    if (lane === this.#lane && frames === this.#frames) return;
    await this.#save();
    const drive = this.#drives.list[lane];
    if (lane !== this.#lane || frames > this.#frames) {
      await this.#machine.restore(drive.saved.state);
      this.#settings.restored(drive.saved.wishes);
      [this.#lane, this.#frames] = [lane, drive.frames.length];
    }
    await this.#cut(frames);
  }

  async #cut(frames) {
    if (frames === this.#frames) return;
    await this.#machine.restore(await this.#machine.state({ frames }));
    this.#frames = frames;
  }

  /** Saves the drive of the loop, if the loop has all of it. */
  async #save() {
    const drive = this.#drives.list[this.#lane];
    if (drive && drive.saved === null && this.#frames === drive.frames.length) {
      drive.saved = { state: await this.#machine.state(), wishes: this.#settings.now() };
    }
  }
}
