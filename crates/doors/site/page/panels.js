// What stands beside a picture: explanation, waveforms, wires of the diagram and events, asked for one after another.

import { knownWires } from "./known.js";

export class Panels {
  #model;
  #machine;
  #tell;
  /** The pixel of a picture that is explained, as text that can be compared; null where none is. */
  #told = null;
  /** The wires whose waveforms stand. */
  #wires = "";

  /** `tell` is called with the name and the detail of an event of `model`. */
  constructor(model, machine, tell) {
    [this.#model, this.#machine, this.#tell] = [model, machine, tell];
  }

  /**
   * Fills the panels beside the picture `drawn`, and stops where `isNewest` says that something newer is wished for. `refused` is told parts of
   * the view that the machine does not know.
   */
  async fill(drawn, isNewest, refused) {
    const { facts, trigger, view } = this.#model;
    await this.#explain(drawn);
    if (!isNewest()) return;
    if (facts.samples === 0) return this.#noSweep();
    if (trigger.isDue && !(await this.#triggered())) return;
    if (!isNewest()) return;
    await this.#traces(refused);
    if (!isNewest()) return;
    const { diagram, which } = this.#model;
    if (diagram.length > 0) this.#tell("wires", await this.#machine.probe(diagram, view.sweep, which));
    if (!isNewest()) return;
    const none = () => ({ events: [] });
    const { sweep } = view;
    const answer = await this.#machine.events({ ...this.#model.which, sweeps: sweep }).catch(none);
    this.#tell("events", { ...answer, sweep });
  }

  /** A generator without sweeps: nothing of another machine is left standing. */
  #noSweep() {
    this.#tell("traces", null);
    this.#tell("events", { events: [], sweep: null });
  }

  async #explain(drawn) {
    const { view } = this.#model;
    const { column, line } = view;
    const key = column === null || line === null ? null : JSON.stringify([drawn, column, line]);
    if (key === this.#told) return;
    if (key === null) {
      this.#told = null;
      return this.#tell("explained", null);
    }
    const told = await this.#machine.explain(column, line, this.#model.which).catch((error) => {
      [view.column, view.line] = [null, null];
      throw error;
    });
    this.#told = key;
    view.sweep = sweepOf(told.document) ?? view.sweep;
    this.#tell("explained", told);
  }

  /** Waveforms of the wires; of those alone that the machine knows, where it does not know all. */
  async #traces(refused) {
    const { view, which } = this.#model;
    const probe = (names) => (names.length > 0 ? this.#machine.probe(names, view.sweep, which) : null);
    const names = view.wires.split(",").map((word) => word.trim()).filter(Boolean);
    const answer = await Promise.resolve(probe(names)).catch(async () => {
      const found = await knownWires(names, probe);
      if (found.refused.length > 0) refused(found.refused);
      view.wires = found.known.join(",") || this.#wires;
      return probe(view.wires.split(",").filter(Boolean));
    });
    this.#wires = view.wires;
    this.#tell("traces", answer);
  }

  /** Looks for the condition in the frame that stands; whether the panels are to show what they have now. */
  async #triggered() {
    const { trigger, view, lane, which } = this.#model;
    const place = trigger.chosen(lane, view.frame) ?? (await this.#machine.trigger(trigger.on, which)).places[0] ?? null;
    const shows = trigger.found(place);
    if (place) Object.assign(view, { sweep: place.sweep, sample: place.instant });
    this.#tell("triggered", place);
    if (place) this.#tell("cursor", place.instant);
    return shows;
  }
}

/** The sweep that drew a pixel, where its generator has sweeps. */
function sweepOf(document) {
  return document?.place?.drawn_with ?? null;
}
