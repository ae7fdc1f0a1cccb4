// The scope: analog traces in panels by unit, digital lanes below them, what was before behind, two cursors; or one wire over another.

import { curve } from "./curve.js";
import { ScopeHand } from "./scope-hand.js";
import { short, told } from "./scope-values.js";
import { over } from "./scope-xy.js";

const LEFT = 88;
const TOP = 14;
const LANE = 22;
const AXIS = 34;
const COLOURS = ["#0b6fc2", "#c2480b", "#0b8a4b", "#8a3fc2", "#a67c00", "#00838f", "#ad1457", "#5d4037"];
const MARK = "#d32f2f";
const MOST = { analog: 8, digital: 16, behind: 24 };

export class Scope {
  #canvas;
  #say;
  #traces = null;
  #reference = null;
  #persists = false;
  #behind = [];
  #window = [0, 1];
  #cursors = [null, null];
  #across = "sample";
  /** The instant of the trigger (samples), where one was found. */
  #trigger = null;

  /** `say` is told the values at the cursors, in words; `pick` the sample that the reader puts cursor A or B on. */
  constructor(canvas, say, pick = () => {}) {
    this.#canvas = canvas;
    this.#say = say;
    new ScopeHand(canvas, {
      isReady: () => this.#traces !== null,
      last: () => this.#last,
      cursor: (which) => this.#cursors[which],
      sample: (x) => this.#sample(x),
      point: (sample, which) => {
        this.point(sample, which);
        pick(sample, which);
      },
      slide: (by) => this.#slide(by),
      scale: (factor, at) => this.#scale(factor, at),
    });
    new ResizeObserver(() => this.#draw()).observe(canvas);
    // Axes and names have the colour of the text.
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#draw());
  }

  /** Shows waveforms of one sweep. The instant `trigger` (samples) gets a mark, which stays at its place of the canvas from sweep to sweep. */
  show(traces, trigger = null) {
    if (traces === null) return this.#clear();
    if (this.#persists && this.#traces) this.#behind = [...this.#behind, this.#traces].slice(-MOST.behind);
    const before = this.#traces && this.#trigger !== null ? this.#share(this.#trigger) : null;
    [this.#traces, this.#trigger] = [traces, trigger];
    this.#canvas.dataset.sweep = traces.sweeps[0];
    this.#canvas.dataset.trigger = trigger ?? "";
    const by = before === null || trigger === null ? 0 : this.#share(trigger) - before;
    this.#slide(by / (this.#window[1] - this.#window[0]));
  }

  /** Shows nothing; a reference stays for what comes. */
  #clear() {
    [this.#traces, this.#trigger, this.#behind] = [null, null, []];
    this.#canvas.dataset.sweep = "";
    this.#canvas.dataset.trigger = "";
    this.#canvas.getContext("2d").clearRect(0, 0, this.#canvas.width, this.#canvas.height);
    this.#say("No wire of a sweep is shown.");
  }

  /** Lays what is shown now behind what comes, or takes it away. */
  keep() {
    this.#reference = this.#reference ? null : this.#traces;
    this.#draw();
    return this.#reference !== null;
  }

  /** Leaves what was shown behind what comes, or takes it away. */
  persist(persists) {
    this.#persists = persists;
    this.#behind = [];
    this.#draw();
  }

  whole() {
    this.#window = [0, 1];
    this.#draw();
  }

  /** What runs across: "sample" for sweep time, "place" for range, "xy" for the first wire. */
  along(across) {
    this.#across = across;
    this.whole();
  }

  /** Sets cursor A or B, 0 or 1, on a sample. */
  point(sample, which = 0) {
    this.#cursors[which] = sample;
    this.#draw();
  }

  /** Where a sample lies across the whole sweep, from 0 to 1. */
  #share(sample) {
    const places = this.#traces.planes.places.values;
    const last = places.length - 1;
    if (this.#across === "sample") return sample / last;
    const at = Math.max(0, Math.min(last - 1, Math.floor(sample)));
    const place = places[at] + (places[at + 1] - places[at]) * (sample - at);
    return (place - places[0]) / (places[last] - places[0]);
  }

  #x(sample) {
    const [from, to] = this.#window;
    return LEFT + ((this.#share(sample) - from) / (to - from)) * (this.#canvas.width - LEFT - 8);
  }

  get #last() {
    return this.#traces.planes.places.values.length - 1;
  }

  /** The sample nearest to a column of the canvas. */
  #sample(x) {
    let [low, high] = [0, this.#last];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.#x(middle) <= x) low = middle;
      else high = middle;
    }
    return x - this.#x(low) < this.#x(high) - x ? low : high;
  }

  #slide(by) {
    const [from, to] = this.#window;
    const moved = Math.max(-from, Math.min(1 - to, by * (to - from)));
    this.#window = [from + moved, to + moved];
    this.#draw();
  }

  #scale(factor, at) {
    const [from, to] = this.#window;
    const middle = from + at * (to - from);
    const width = Math.max(0.002, Math.min(1, (to - from) * factor));
    const start = Math.max(0, Math.min(1 - width, middle - at * width));
    this.#window = [start, start + width];
    this.#draw();
  }

  #draw() {
    const canvas = this.#canvas;
    const ratio = globalThis.devicePixelRatio || 1;
    canvas.width = Math.max(200, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(120, Math.round(canvas.clientHeight * ratio));
    const context = canvas.getContext("2d");
    context.font = "12px system-ui, sans-serif";
    this.#ink = getComputedStyle(canvas).color;
    if (!this.#traces) return;
    const analog = this.#traces.signals.filter((row) => row.kind === "analog").slice(0, MOST.analog);
    const digital = this.#traces.signals.filter((row) => row.kind !== "analog").slice(0, MOST.digital);
    if (this.#across === "xy" && analog.length > 1) {
      const box = { left: LEFT, top: TOP, width: canvas.width - LEFT - 8, height: canvas.height - TOP - AXIS };
      const extents = [this.#extent([analog[0]]), this.#extent([analog[1]])];
      over(context, { wires: analog, box, extents, traces: this.#traces, before: this.#before, cursors: this.#cursors, ink: this.#ink, colour: COLOURS[0] });
      return this.#tell();
    }
    const panels = [...Map.groupBy(analog, (row) => row.unit)];
    const room = canvas.height - TOP - AXIS - digital.length * LANE;
    const height = panels.length ? room / panels.length : 0;
    const colour = new Map(analog.map(({ name }, at) => [name, COLOURS[at % COLOURS.length]]));
    panels.forEach(([unit, rows], at) => this.#panel(context, unit, rows, colour, TOP + at * height, height - 12));
    digital.forEach((row, at) => this.#lane(context, row, TOP + room + at * LANE));
    this.#axis(context, canvas.height - AXIS + 8);
    this.#drawTrigger(context, canvas.height - AXIS);
    this.#drawCursors(context, canvas.height - AXIS);
    this.#tell();
  }

  #ink = "#000";

  /** What stands behind: the reference, and what persists. */
  get #before() {
    return this.#reference ? [...this.#behind, this.#reference] : this.#behind;
  }

  /** Lowest and highest finite value of the rows, with what stands behind. */
  #extent(rows) {
    let [low, high] = [Infinity, -Infinity];
    for (const traces of [this.#traces, ...this.#before]) {
      for (const { name } of rows) {
        for (const value of traces?.planes[name]?.values ?? []) {
          if (value < low) low = value;
          if (value > high) high = value;
        }
      }
    }
    if (low > high) return [0, 1];
    return low === high ? [low - 0.5, high + 0.5] : [low, high];
  }

  #panel(context, unit, rows, colour, top, height) {
    const [low, high] = this.#extent(rows);
    const y = (value) => top + height - ((value - low) / (high - low)) * height;
    context.strokeStyle = this.#ink;
    context.globalAlpha = 0.25;
    context.strokeRect(LEFT, top, this.#canvas.width - LEFT - 8, height);
    if (low < 0 && high > 0) context.strokeRect(LEFT, y(0), this.#canvas.width - LEFT - 8, 0);
    context.globalAlpha = 1;
    context.fillStyle = this.#ink;
    const end = unit === "1" ? "" : ` ${unit}`;
    context.textAlign = "right";
    context.fillText(`${short(high)}${end}`, LEFT - 4, top + 10);
    context.fillText(`${short(low)}${end}`, LEFT - 4, top + height);
    context.textAlign = "left";
    const way = { x: (sample) => this.#x(sample), y, bounds: [LEFT, this.#canvas.width - 8] };
    rows.forEach(({ name }, at) => {
      context.globalAlpha = 0.35;
      for (const { planes } of this.#before) {
        if (planes[name]) curve(context, planes[name].values, { ...way, colour: this.#ink });
      }
      context.globalAlpha = 1;
      curve(context, this.#traces.planes[name].values, { ...way, colour: colour.get(name) });
      context.fillStyle = colour.get(name);
      context.fillText(name, LEFT + 6 + at * 130, top + 12);
    });
  }

  /** A gate as levels; what changes at instants as strokes there. */
  #lane(context, { name, kind }, top) {
    const { values } = this.#traces.planes[name];
    const times = this.#traces.planes[`times:${name}`]?.values;
    context.fillStyle = this.#ink;
    context.textAlign = "left";
    context.strokeStyle = this.#ink;
    context.beginPath();
    const level = (value) => top + LANE - 6 - (value > 0.5 ? LANE - 10 : 0);
    values.forEach((value, at) => {
      const x = this.#x(times ? times[at] : at);
      if (x < LEFT || x > this.#canvas.width - 8) return;
      if (times && kind !== "gate") {
        context.moveTo(x, top + 4);
        context.lineTo(x, top + LANE - 6);
      } else if (at === 0) {
        context.moveTo(x, level(value));
      } else {
        context.lineTo(x, level(values[at - 1]));
        context.lineTo(x, level(value));
      }
    });
    context.stroke();
    context.fillText(name, 2, top + LANE - 8);
  }

  #axis(context, top) {
    const places = this.#traces.planes.places.values;
    context.fillStyle = this.#ink;
    context.textAlign = "center";
    for (let tick = 0; tick <= 6; tick += 1) {
      const x = LEFT + (tick / 6) * (this.#canvas.width - LEFT - 24) + 8;
      let sample = 0;
      while (sample < places.length - 1 && this.#x(sample) < x) sample += 1;
      context.fillText(this.#across === "sample" ? String(sample) : short(places[sample]), x, top + 8);
    }
    const says = this.#across === "sample" ? "sample" : this.#traces.place;
    context.fillText(says, (LEFT + this.#canvas.width) / 2, top + 22);
  }

  /** The mark of the trigger: a line in its colour, with a T beside it. */
  #drawTrigger(context, bottom) {
    this.#canvas.dataset.mark = "";
    if (this.#trigger === null) return;
    const x = this.#x(this.#trigger);
    this.#canvas.dataset.mark = x;
    context.strokeStyle = context.fillStyle = MARK;
    context.textAlign = "right";
    context.beginPath();
    context.moveTo(x, TOP);
    context.lineTo(x, bottom);
    context.stroke();
    context.fillText("T", x - 3, TOP + 10);
  }

  #drawCursors(context, bottom) {
    context.fillStyle = this.#ink;
    context.textAlign = "center";
    this.#cursors.forEach((sample, which) => {
      if (sample === null) return;
      const x = this.#x(sample);
      context.strokeStyle = this.#ink;
      context.setLineDash(which === 0 ? [4, 3] : [1, 3]);
      context.beginPath();
      context.moveTo(x, TOP);
      context.lineTo(x, bottom);
      context.stroke();
      context.setLineDash([]);
      context.fillText("AB"[which], x, TOP - 2);
    });
  }

  /** Says the values at the cursors and at the trigger. */
  #tell() {
    this.#say(told({ traces: this.#traces, reference: this.#reference, cursors: this.#cursors, trigger: this.#trigger }));
  }
}
