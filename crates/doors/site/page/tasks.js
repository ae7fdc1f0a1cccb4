// Tasks of the lessons: the machine itself tells whether an answer is right.

import { first, given } from "./figure-scenes.js";
import { Here } from "./here.js";
import { Lunoid } from "./lunoid.js";

/** What is taken of a wire in one sweep. */
const TAKES = {
  largest: (values) => values.reduce((most, value) => Math.max(most, value), -Infinity),
  smallest: (values) => values.reduce((least, value) => Math.min(least, value), Infinity),
  rises: (values) => values.reduce((count, value, at) => count + Number(at > 0 && value > 0.5 && values[at - 1] <= 0.5), 0),
};

/** How each kind of task judges an answer; `measured` measures with a value of the key of the task. A verdict is right or not, with the reason. */
const JUDGES = {
  /** The answer is the number that is measured. */
  async value({ within = 0, unit = "" }, answer, measured) {
    const is = await measured();
    if (Math.abs(is - answer) <= within) return { right: true, says: `Right: the machine has ${short(is)} ${unit}.` };
    return { right: false, says: `Not so: the machine has ${answer < is ? "more" : "less"} than ${answer} ${unit}.` };
  },

  /** The answer is the last value of the key with which nothing is measured. */
  async largest({ step, unit = "", says }, answer, measured) {
    const steps = Math.round(answer / step);
    if (Math.abs(steps * step - answer) > 1e-9) return { right: false, says: `Expected a multiple of ${step} ${unit}.` };
    const [here, further] = [await measured(answer), await measured(answer + step)];
    const at = (value, count) => `with ${value} ${unit} ${count} ${says}`;
    if (here > 0) return { right: false, says: `Too much: ${at(answer, here)}.` };
    if (further === 0) return { right: false, says: `It can be more: ${at(answer + step, "none of the")} either.` };
    return { right: true, says: `Right: ${at(answer, "none of the")}, ${at(answer + step, further)}.` };
  },
};

/** A number in five digits. */
function short(value) {
  return String(Number(value.toPrecision(5)));
}

class Task {
  #element;
  #task;
  #machine = null;
  #answer = Object.assign(document.createElement("input"), { inputMode: "decimal", autocomplete: "off", ariaLabel: "Answer" });
  #button = Object.assign(document.createElement("button"), { textContent: "Check" });
  #verdict = document.createElement("p");

  constructor(element) {
    this.#element = element;
    this.#task = JSON.parse(element.dataset.task);
    this.#verdict.setAttribute("role", "status");
    const form = document.createElement("form");
    form.append(this.#answer, this.#task.unit ?? "", this.#button);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#check();
    });
    element.append(form, this.#verdict);
  }

  #say(state, text) {
    this.#element.dataset.state = state;
    this.#verdict.textContent = text;
  }

  async #check() {
    const text = this.#answer.value.trim().replace(",", ".");
    if (text === "" || !Number.isFinite(Number(text))) return this.#say("wrong", `Found "${this.#answer.value}", expected a number.`);
    this.#button.disabled = true;
    this.#say("busy", "The machine looks.");
    const measured = (value) => this.#measured(value);
    const { right, says } = await JUDGES[this.#task.asks](this.#task, Number(text), measured).catch((error) => ({ right: false, says: error.message }));
    this.#say(right ? "right" : "wrong", says);
    this.#button.disabled = false;
  }

  /** What the machine has, with `value` for the key of the task. */
  async #measured(value) {
    const { key, measure } = this.#task;
    const { scenario, machine, faults, set, frame, sweep } = first(this.#task);
    const wishes = { machine: machine ?? undefined, overlays: faults, set: key ? { ...set, [key]: value } : set };
    if (this.#machine) {
      await this.#machine.set(wishes.set);
    } else {
      this.#machine = new Lunoid(new Here());
      await this.#machine.open(scenario, { ...wishes, files: await given(scenario) });
    }
    if (measure.events) return (await this.#machine.events({ frame, sweeps: sweep, ...measure.events })).events.length;
    const { planes } = await this.#machine.probe([measure.wire], sweep, { frame });
    return TAKES[measure.take](planes[measure.wire].values);
  }
}

document.querySelectorAll(".task").forEach((element) => new Task(element));
