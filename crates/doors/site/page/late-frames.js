// Late frames of a lane: the missed deadlines of one frame after another are asked for until all are known or the reader stops it.

export class LateFrames {
  #model;
  #runs = 0;

  constructor(model) {
    this.#model = model;
  }

  stop() {
    this.#runs += 1;
  }

  /** Looks at all frames of the lane that is looked at. `hear` is told how many are done, and how many of them are late. */
  async find(hear) {
    const run = (this.#runs += 1);
    const { lane, frames, drives } = this.#model;
    let late = 0;
    for (let frame = 0; frame < frames && run === this.#runs; frame += 1) {
      if (drives.isLate(lane, frame) === undefined) drives.note(lane, frame, await this.#isLate(lane, frame));
      late += Number(drives.isLate(lane, frame));
      hear(frame + 1, late);
    }
  }

  async #isLate(lane, frame) {
    const driven = this.#model.drives.list[lane]?.frames[frame];
    const which = driven ? { frame, pose: driven.pose } : { frame };
    const { missed } = await this.#model.beside((machine) => machine.timing(which));
    return missed > 0;
  }
}
