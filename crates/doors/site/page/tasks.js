// Tasks of the lessons: the machine itself tells whether an answer is right.

import { first, given } from "./figure-scenes.js";
import { Here } from "./here.js";
import { Lunoid } from "./lunoid.js";

/** Counts the places of `values` where `is` holds for a value and the one before. */
const count = (values, is) => values.reduce((sum, value, at) => sum + Number(at > 0 && is(values[at - 1], value)), 0);

/** What is taken of a wire in one sweep. */
const TAKES = {
  largest: (values) => values.reduce((most, value) => Math.max(most, value), -Infinity),
  changes: (values) => count(values, (before, value) => value !== before),
  rises: (values) => count(values, (before, value) => before <= 0.5 && value > 0.5),
};

/** How each kind of task judges an answer; `measured` measures with a value for the key of the task. */
const JUDGES = {
  /** The answer is the number that is measured. */
  async value({ within = 0, unit }, answer, measured) {
    const is = await measured();
    const told = (number) => [short(number), unit].filter(Boolean).join(" ");
    if (Math.abs(is - answer) <= within) return { right: true, says: `Right: the machine has ${told(is)}.` };
    return { right: false, says: `Not so: what the machine has is ${answer < is ? "above" : "below"} ${told(answer)}.` };
  },

  /** The answer is the largest value of the key with which nothing is measured. */
  largest: (task, answer, measured) => bound(task, answer, measured, task.step),

  /** The answer is the smallest such value. */
  smallest: (task, answer, measured) => bound(task, answer, measured, -task.step),
};

/** Whether nothing is measured with `answer`, and something one step beyond it. */
async function bound({ step, unit = "", says }, answer, measured, further) {
  if (Math.abs(answer / step - Math.round(answer / step)) > 1e-9) return { right: false, says: `Found ${answer}, expected a multiple of ${step} ${unit}.` };
  const at = (value, number) => `with ${value} ${unit} the number of ${says} is ${number}`;
  const here = await measured(answer);
  if (here > 0) return { right: false, says: `Not so: ${at(answer, here)}.` };
  const beyond = await measured(answer + further);
  if (beyond === 0) return { right: false, says: `Not yet at the end: ${at(answer + further, 0)} as well.` };
  return { right: true, says: `Right: ${at(answer, 0)}, and ${at(answer + further, beyond)}.` };
}

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
    if (!this.#machine) {
      this.#machine = new Lunoid(new Here());
      await this.#machine.open(scenario, { machine: machine ?? undefined, overlays: faults, set, files: await given(scenario) });
    }
    if (key) await this.#machine.set({ [key]: value });
    if (measure.events) return (await this.#machine.events({ frame, sweeps: sweep, ...measure.events })).events.length;
    const { planes } = await this.#machine.probe([measure.wire], sweep, { frame });
    return TAKES[measure.take](planes[measure.wire].values);
  }
}

document.querySelectorAll(".task").forEach((element) => new Task(element));
