// Living figures of the books: a still picture until a reader presses Run, then a machine that follows the figure's sliders.

import { KINDS } from "./figure-kinds.js";
import { PLACES, first, given, other } from "./figure-scenes.js";
import { Here } from "./here.js";
import { written } from "./link.js";
import { Lunoid } from "./lunoid.js";
import { ViewModel } from "./view-model.js";

const DRAWS = "The machine draws.";

const made = (name, properties, ...children) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
};

class Figure {
  #element;
  #runs;
  #machines = [];
  #models = [];
  #stage = made("div", { className: "stage" });
  #state = made("p", { className: "state" });
  #button = made("button", { type: "button", textContent: "Run" });

  constructor(element) {
    this.#element = element;
    this.#runs = JSON.parse(element.dataset.runs);
    this.#state.setAttribute("role", "status");
    this.#button.addEventListener("click", () => (this.#machines.length ? this.#stop() : this.#start()));
    element.querySelector("figcaption").before(this.#stage, made("p", { className: "controls" }, this.#button), this.#state);
  }

  #say(text) {
    this.#state.textContent = text;
  }

  #hear({ phase, bytes, reason }) {
    if (phase === "loading") this.#say(`Loading the machine: ${(bytes / 1e6).toFixed(1)} MB.`);
    if (phase === "compiled") this.#say(DRAWS);
    if (phase === "ended") this.#say(`The machine ended and was started again: ${reason}`);
  }

  #start() {
    const views = [first(this.#runs), ...(this.#runs.against ? [other(this.#runs)] : [])];
    const still = this.#element.querySelector("img");
    const canvas = made("canvas", { width: 1, height: 1, className: this.#runs.kind });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", still.alt);
    if (this.#runs.kind === "wave") canvas.tabIndex = 0;
    this.#stage.replaceChildren(canvas, ...this.#sliders());
    this.#button.textContent = "Stop";
    this.#say(DRAWS);
    this.#machines = views.map(() => new Lunoid(new Here({ hear: (told) => this.#hear(told) })));
    this.#models = this.#machines.map((machine) => new ViewModel(machine, given));
    KINDS[this.#runs.kind](canvas, this.#models, this.#runs, (text) => this.#say(text));
    const busy = new Set();
    this.#models.forEach((model, at) => {
      const machine = this.#machines[at];
      model.addEventListener("busy", ({ detail }) => {
        // A figure that was stopped while its module came has a worker nevertheless.
        if (!this.#models.includes(model)) return machine.close();
        busy[detail ? "add" : "delete"](model);
        this.#element.dataset.state = busy.size ? "busy" : "runs";
        if (!busy.size && this.#state.textContent === DRAWS) this.#say("");
      });
      model.addEventListener("fault", ({ detail }) => this.#say(detail.message));
      model.show(views[at]);
    });
  }

  /** Ends the machines; the still stands again. */
  #stop() {
    this.#machines.forEach((machine) => machine.close());
    [this.#machines, this.#models] = [[], []];
    this.#stage.replaceChildren();
    delete this.#element.dataset.state;
    this.#button.textContent = "Run";
    this.#say("");
  }

  #sliders() {
    const sliders = (this.#runs.vary ?? []).map(({ key, label = key, from, to, step, value, unit = "" }) => {
      const says = made("output", { textContent: `${value} ${unit}` });
      const range = made("input", { type: "range", min: from, max: to, step, value });
      range.addEventListener("input", () => {
        says.textContent = `${range.value} ${unit}`;
        this.#move(key, Number(range.value));
      });
      return made("label", {}, made("span", { textContent: label }), range, says);
    });
    const link = made("a", { textContent: "Open in the instrument", href: this.#address });
    link.addEventListener("click", () => { link.href = this.#address; });
    return [...sliders, made("p", {}, link)];
  }

  get #address() {
    const { sweep, ...view } = this.#models[0]?.view ?? first(this.#runs);
    const isWave = this.#runs.kind === "wave";
    return new URL(`instrument.html${written({ ...view, wires: view.wires || undefined, ...(isWave ? { sweep } : {}) })}`, import.meta.url).href;
  }

  #move(key, value) {
    if (PLACES.includes(key)) this.#models.forEach((model) => model.show({ [key]: value }));
    else this.#models[0].show({ set: { ...this.#models[0].view.set, [key]: value } });
  }
}

document.querySelectorAll("figure.living").forEach((element) => new Figure(element));
