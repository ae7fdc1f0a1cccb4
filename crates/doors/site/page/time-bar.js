// The bar of time: the path and every drive as a lane, with late frames, switched settings and the reader's marks. A click goes there.

import { PATH } from "./drives.js";

const LANE = 26;
const TOP = 6;
/** Room for the name of a lane. */
const LEFT = 64;
const COLOURS = { late: "#d32f2f", inTime: "#0b8a4b", switched: "#e08a00", mark: "#0b6fc2" };

export class TimeBar {
  #canvas;
  #model;
  #list;

  /** `canvas` shows the lanes, and `list` gets a button for each mark. */
  constructor(canvas, list, model) {
    [this.#canvas, this.#list, this.#model] = [canvas, list, model];
    canvas.addEventListener("click", (event) => this.#click(event));
    canvas.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#draw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#draw());
  }

  /** Shows what the drives and the cursor are now. */
  show() {
    const { drives, lane, view, frames } = this.#model;
    const canvas = this.#canvas;
    canvas.style.height = `${2 * TOP + LANE * (drives.list.length + 1)}px`;
    canvas.setAttribute("aria-valuemin", 0);
    canvas.setAttribute("aria-valuemax", frames - 1);
    canvas.setAttribute("aria-valuenow", view.frame);
    canvas.setAttribute("aria-valuetext", `${name(lane)}, frame ${view.frame}, ${this.#seconds(view.frame)} s`);
    this.#draw();
    this.#listMarks();
  }

  get #lanes() {
    return [PATH, ...this.#model.drives.list.keys()];
  }

  #frames(lane) {
    return this.#model.drives.frames(lane, this.#model.facts.frames);
  }

  get #most() {
    return Math.max(2, ...this.#lanes.map((lane) => this.#frames(lane)));
  }

  #seconds(frame) {
    return (frame / this.#model.facts.update_hz).toFixed(2);
  }

  /** Where a frame lies across the canvas. */
  #x(frame) {
    return LEFT + (frame / (this.#most - 1)) * (this.#canvas.width - LEFT - TOP);
  }

  #click(event) {
    if (!this.#model.facts) return;
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    const x = ((event.clientX - left) / width) * this.#canvas.width;
    const y = ((event.clientY - top) / height) * this.#canvas.height;
    const lane = this.#lanes[Math.max(0, Math.min(this.#lanes.length - 1, Math.floor((y - TOP) / LANE)))];
    const frame = Math.round(((x - LEFT) / (this.#canvas.width - LEFT - TOP)) * (this.#most - 1));
    this.#model.look(lane, Math.max(0, Math.min(this.#frames(lane) - 1, frame)));
  }

  #key(event) {
    const { lane, view, frames, facts } = this.#model;
    if (!facts) return;
    const to = { ArrowLeft: view.frame - 1, ArrowRight: view.frame + 1, PageUp: view.frame + 10, PageDown: view.frame - 10, Home: 0, End: frames - 1 }[event.key];
    const other = { ArrowUp: lane - 1, ArrowDown: lane + 1 }[event.key];
    if (to !== undefined) this.#model.look(lane, Math.max(0, Math.min(frames - 1, to)));
    else if (this.#lanes.includes(other)) this.#model.look(other, Math.min(this.#frames(other) - 1, view.frame));
    else if (other === undefined) return;
    event.preventDefault();
  }

  #draw() {
    const { facts, lane, view } = this.#model;
    const canvas = this.#canvas;
    canvas.width = Math.max(200, canvas.clientWidth);
    canvas.height = Math.max(LANE, canvas.clientHeight);
    if (!facts) return;
    const context = canvas.getContext("2d");
    context.font = "12px system-ui, sans-serif";
    const ink = getComputedStyle(canvas).color;
    this.#lanes.forEach((own, row) => this.#lane(context, own, TOP + row * LANE, ink));
    const x = this.#x(view.frame);
    const top = TOP + this.#lanes.indexOf(lane) * LANE;
    context.fillStyle = ink;
    context.fillRect(x - 1.5, top - 2, 3, LANE - 2);
  }

  #lane(context, lane, top, ink) {
    const frames = this.#frames(lane);
    const { drives } = this.#model;
    const [middle, width] = [top + 8, Math.max(2, this.#x(1) - this.#x(0))];
    context.globalAlpha = 0.25;
    context.fillStyle = ink;
    context.fillRect(this.#x(0), middle - 3, this.#x(frames - 1) - this.#x(0), 6);
    context.globalAlpha = 1;
    for (let frame = 0; frame < frames; frame += 1) {
      const isLate = drives.isLate(lane, frame);
      if (isLate === undefined) continue;
      context.fillStyle = isLate ? COLOURS.late : COLOURS.inTime;
      context.fillRect(this.#x(frame) - width / 2, middle - 3, width, 6);
    }
    const drive = drives.list[lane];
    if (drive && drive.from !== PATH) stroke(context, this.#x(drive.since), top - LANE * (lane - drive.from) + 8, middle, ink);
    for (const { frame } of drives.switched(lane)) triangle(context, this.#x(frame), middle + 4, COLOURS.switched);
    for (const mark of drives.marks.filter((mark) => mark.lane === lane)) triangle(context, this.#x(mark.frame), middle + 4, COLOURS.mark);
    context.fillStyle = ink;
    context.fillText(name(lane), TOP, middle + 4);
  }

  /** A button for each mark: switched settings and the reader's own, in the order of lanes and frames. */
  #listMarks() {
    const { drives } = this.#model;
    const rows = this.#lanes.flatMap((lane) => {
      const own = drives.marks.filter((mark) => mark.lane === lane);
      return [...drives.switched(lane), ...own].map(({ frame, text }) => ({ lane, frame, text })).sort((a, b) => a.frame - b.frame);
    });
    const button = ({ lane, frame, text }) => {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: `${name(lane)}, ${this.#seconds(frame)} s: ${text}` });
      made.addEventListener("click", () => this.#model.look(lane, frame));
      return made;
    };
    this.#list.replaceChildren(...rows.map((row) => {
      const item = document.createElement("li");
      item.append(button(row));
      return item;
    }));
  }
}

/** Name of a lane for people. */
export function name(lane) {
  return lane === PATH ? "path" : `drive ${lane + 1}`;
}

function stroke(context, x, from, to, colour) {
  context.strokeStyle = colour;
  context.beginPath();
  context.moveTo(x, from);
  context.lineTo(x, to);
  context.stroke();
}

function triangle(context, x, top, colour) {
  context.fillStyle = colour;
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x - 5, top + 8);
  context.lineTo(x + 5, top + 8);
  context.fill();
}
