// The block diagram: blocks, their ways, the values of the wires at the cursor, and the registers. Drawn from what the machine tells.

import { SHEET, SIZE, places, valuesOf, way } from "./diagram-plan.js";
import { short, valueAt } from "./scope-values.js";

const SVG = "http://www.w3.org/2000/svg";
const COLOURS = ["yellow", "green", "black", "red"];
const TERRAIN = "terrain-generator";
const REGISTERS = ["hold", "xfirst", "yfirst"];
/** Side of the mark of a register, and the way from one to the next. */
const MARK = [10, 13];

export class Diagram {
  #svg;
  #choose;
  #signals = new Map();
  #labels = new Map();
  #marks = new Map();
  #traces = null;

  /** `choose.wire` is called with the name of a wire that was chosen, `choose.block` with a block. */
  constructor(svg, choose) {
    [this.#svg, this.#choose] = [svg, choose];
    svg.setAttribute("viewBox", `0 0 ${SHEET.join(" ")}`);
  }

  /** Wires whose values the drawing shows: those of the ways and of the registers that the machine has. */
  get wires() {
    return [...this.#labels.keys(), ...this.#marks.keys()].filter((name) => this.#signals.get(name)?.is_wired);
  }

  /** Draws the blocks of a machine with the rows of its signals. */
  show(blocks, signals) {
    this.#signals = new Map(signals.map((row) => [row.name, row]));
    this.#labels.clear();
    this.#marks.clear();
    this.#traces = null;
    const place = places(blocks.map(({ name }) => name));
    const links = blocks.flatMap((block) => block.links.map((link) => ({ ...link, from: block.name, isPale: block.left_out })));
    const known = links.filter(({ to }) => place.has(to));
    this.#svg.replaceChildren(
      ...known.map((link) => this.#line(link, place)),
      ...blocks.map((block) => this.#block(block, place.get(block.name))),
      ...(place.has(TERRAIN) ? this.#registers(place.get(TERRAIN)) : []),
      ...blocks.flatMap((block) => this.#values(block, place.get(block.name))),
    );
  }

  /** Takes waveforms of the sweep of the cursor. */
  take(traces) {
    this.#traces = traces;
  }

  /** Shows the values at an instant of the sweep (samples). */
  at(instant) {
    if (!this.#traces) return;
    for (const [name, label] of this.#labels) this.#write(name, label, this.#value(name, instant));
    for (const [name, mark] of this.#marks) {
      const corner = this.#value(name, instant);
      mark.classList.toggle("loaded", corner !== null);
      mark.firstElementChild.textContent = `${name}: ${corner === null ? "empty" : `corner ${corner}`}`;
    }
  }

  /** The value of a wire; of one down the display, that of the line where the beam is. */
  #value(name, instant) {
    if (!this.#traces.planes[name] || this.#traces.left_out.includes(name)) return null;
    const { axis } = this.#traces.signals.find((row) => row.name === name);
    if (axis !== "display") return valueAt(this.#traces, name, instant);
    const line = this.#traces.planes["dpp.y"] ? valueAt(this.#traces, "dpp.y", instant) : null;
    return line === null ? null : (this.#traces.planes[name].values[Math.round(line)] ?? null);
  }

  #write(name, label, value) {
    const { unit } = this.#signals.get(name);
    const text = value === null ? "–" : `${short(value)}${unit === "1" ? "" : ` ${unit}`}`;
    label.lastElementChild.textContent = `${name} ${text}`;
    label.setAttribute("aria-label", `${name}: ${value === null ? "no value" : text}. Put on the scope.`);
  }

  #line({ from, to, carries, isPale }, place) {
    const points = way(from, to, place).map((point) => point.join(",")).join(" ");
    const line = made("polyline", { points, class: isPale ? "way left-out" : "way" });
    line.append(titled(`${from} to ${to}: ${carries}`));
    return line;
  }

  #block(block, [x, y]) {
    const { name, left_out: isLeftOut, parts } = block;
    const group = made("g", { class: isLeftOut ? "block left-out" : "block", transform: `translate(${x} ${y})` });
    const [width, height] = SIZE;
    group.append(made("rect", { width, height: name === TERRAIN ? height + REGISTERS.length * MARK[1] + 10 : height, rx: 4 }));
    const words = name.split("-");
    const rows = words.length > 2 ? [`${words.slice(0, 2).join(" ")} `, words.slice(2).join(" ")] : [words.join(" ")];
    rows.forEach((row, at) => group.append(texted(row, width / 2, height / 2 + 4 + (at - (rows.length - 1) / 2) * 15, "middle")));
    button(group, `${words.join(" ")}${isLeftOut ? ", left out" : ""}. ${parts.join("; ")}`, () => this.#choose.block(block));
    return group;
  }

  /** A mark for each register of each colour; it is full in the colour that is loaded. */
  #registers([x, y]) {
    const [side, step] = MARK;
    const marks = COLOURS.flatMap((colour, column) => REGISTERS.map((register, row) => {
      const at = { x: x + 58 + column * (step + 5), y: y + 44 + row * step, width: side, height: side };
      const mark = made("rect", { class: `register ${colour}`, ...at });
      mark.append(titled(""));
      this.#marks.set(`tg.${colour}.${register}`, mark);
      return mark;
    }));
    return [...marks, ...REGISTERS.map((register, row) => texted(register, x + 52, y + 53 + row * step, "end"))];
  }

  /** The wires that leave a block, each once, with their values. */
  #values({ name: block, links }, place) {
    const names = [...new Set(links.flatMap(({ signals }) => signals))].filter((name) => this.#signals.has(name));
    const [x, y] = valuesOf(block, place);
    return names.map((name, row) => {
      const label = made("g", { class: "wire" });
      label.append(texted(name, x, y + row * 15, "start"));
      this.#labels.set(name, label);
      button(label, `${name}. Put on the scope.`, () => this.#choose.wire(name));
      return label;
    });
  }
}

function made(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

function texted(text, x, y, anchor) {
  const element = made("text", { x, y, "text-anchor": anchor });
  element.textContent = text;
  return element;
}

function titled(text) {
  const element = made("title", {});
  element.textContent = text;
  return element;
}

/** Makes a part of the drawing a button for pointer, keyboard and screen reader. */
function button(element, label, press) {
  element.setAttribute("role", "button");
  element.setAttribute("tabindex", "0");
  element.setAttribute("aria-label", label);
  element.addEventListener("click", press);
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    press();
  });
}
