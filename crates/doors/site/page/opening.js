// What the machine has opened, and with which settings: it is asked for no more than changes.

export class Opening {
  #machine;
  #given;
  #set = {};
  /** The scenario that is opened; null where none is. */
  scenario = null;
  /** What is opened, as text that can be compared; null where nothing is. */
  key = null;
  /** The wishes that the next request finds: those that were sent last. */
  wishes = null;

  /** `machine` answers requests; `given` finds the files of a shipped scenario by its name. */
  constructor(machine, given) {
    [this.#machine, this.#given] = [machine, given];
  }

  /** Opens a scenario with wishes `{ machine, faults, set }`. Answers its facts, and whether it is another scenario; null if all stands already. */
  async open(scenario, wishes) {
    const asked = keyOf(scenario, wishes);
    if (asked === this.key) return null;
    const isOther = scenario !== this.scenario;
    const over = { machine: wishes.machine || null, overlays: wishes.faults };
    const files = isOther ? await this.#given(scenario) : {};
    const before = this.wishes;
    this.wishes = wishes;
    try {
      const facts = isOther
        ? await this.#machine.open(scenario, { ...over, set: wishes.set, files })
        : await this.#machine.set({ ...this.#back(wishes.set), ...wishes.set }, over);
      this.#note(scenario, wishes);
      return { facts, isOther };
    } catch (error) {
      this.wishes = before;
      throw error;
    }
  }

  /** Takes faults and settings of the reader back; the next opening brings them again. */
  async heal(wishes) {
    await this.#machine.set(this.#back({}), { machine: wishes.machine || null, overlays: [] });
    this.restored({ machine: wishes.machine, faults: [], set: {} });
  }

  /** The machine has other settings than those that were asked for last. */
  restored(wishes) {
    this.#note(this.scenario, wishes);
  }

  #note(scenario, wishes) {
    this.key = keyOf(scenario, wishes);
    this.wishes = wishes;
    this.scenario = scenario;
    this.#set = { ...wishes.set };
  }

  /** The settings that are to be taken back for those of `set`. */
  #back(set) {
    const taken = Object.keys(this.#set).filter((key) => !(key in set));
    return Object.fromEntries(taken.map((key) => [key, null]));
  }
}

function keyOf(scenario, { machine, faults, set }) {
  return JSON.stringify([scenario, machine || null, faults, set]);
}
