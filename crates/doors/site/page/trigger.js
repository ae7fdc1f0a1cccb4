// The trigger of the scope: what is waited for, in the language of `lunoid trigger`, and what happens where it comes.

/** What a trigger does: `automatic` shows the sweep of the cursor where nothing comes, `normal` waits, `single` waits once. */
export const MODES = ["automatic", "normal", "single"];

export class Trigger {
  /** The condition; nothing is waited for where it is empty. */
  on = "";
  mode = "automatic";
  /** The place that was found in the frame that stands; null where none was. */
  place = null;
  #isArmed = false;
  #isOver = false;
  #chosen = null;

  /** Waits for a condition from now on. */
  wait(on, mode) {
    [this.on, this.mode, this.#isOver] = [on.trim(), mode, false];
    this.arm();
  }

  /** Another frame stands. */
  arm() {
    this.#isArmed = true;
  }

  /** The reader has chosen a place of this frame. */
  yields() {
    this.#isArmed = false;
    this.place = null;
  }

  /** A place that was found already, which is to be shown when its frame stands. */
  choose(lane, frame, place) {
    this.#chosen = { lane, frame, place };
    this.#isOver = false;
    this.arm();
  }

  /** The place that was chosen for a frame of a lane; it is chosen once. */
  chosen(lane, frame) {
    const chosen = this.#chosen;
    this.#chosen = null;
    return chosen && chosen.lane === lane && chosen.frame === frame ? chosen.place : null;
  }

  /** Whether the frame that stands is to be searched. */
  get isDue() {
    return this.on !== "" && this.#isArmed && !this.#isOver;
  }

  /** Takes what was found, a place or null; answers whether a sweep is to be shown. */
  found(place) {
    this.place = place;
    this.#isArmed = false;
    this.#isOver = this.mode === "single" && place !== null;
    return place !== null || this.mode === "automatic";
  }
}
