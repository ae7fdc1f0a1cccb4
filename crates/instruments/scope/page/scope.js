// The scope: analog traces in panels by unit, digital lanes below them, what was before behind, two cursors; or one wire over another.

import { curve, firstAt } from "./curve.js";
import { ScopeHand } from "./scope-hand.js";
import { lane } from "./scope-lane.js";
import { placeTicks, sampleTicks } from "./scope-ticks.js";
import { short, told } from "./scope-values.js";
import { over } from "./scope-xy.js";

const LEFT = 88;
const TOP = 14;
const LANE = 22;
const AXIS = 34;
/** Least height of a panel, and of the whole (CSS pixels); least samples across. */
const LEAST = { panel: 84, whole: 320, samples: 2 };
/** From one name of a panel to the next, across and down. */
const NAME = [12, 14];
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
  /** The sample under the pointer; null where it is elsewhere. */
  #pointer = null;
  #across = "sample";
  /** The instant of the trigger (samples), where one was found. */
  #trigger = null;
  /** Size in CSS pixels. */
  #width = 0;
  #height = 0;
  /** From one sample to the next (µs); 0 where it is not known. */
  sampleUs = 0;

  /** `say` is told the values at the cursors (see `told` in scope-values.js); `pick` the sample that the reader puts cursor A or B on. */
  constructor(canvas, say, pick = () => {}) {
    this.#canvas = canvas;
    this.#say = say;
    new ScopeHand(canvas, {
      isReady: () => this.#traces !== null,
      last: () => this.#last,
      cursor: (which) => this.#cursors[which],
      sample: (share) => this.#sample(share * this.#width),
      point: (sample, which) => {
        this.point(sample, which);
        pick(sample, which);
      },
      hover: (sample) => this.#hover(sample),
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
    this.#canvas.style.height = "";
    this.#say({ lead: "No wire of a sweep is shown.", heads: [], rows: [] });
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

  #hover(sample) {
    if (sample === this.#pointer) return;
    this.#pointer = sample;
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
    return LEFT + ((this.#share(sample) - from) / (to - from)) * (this.#width - LEFT - 8);
  }

  get #last() {
    return this.#traces.planes.places.values.length - 1;
  }

  /** The sample nearest to a place across the canvas. */
  #sample(x) {
    const high = Math.max(1, Math.min(this.#last, firstAt(x, (sample) => this.#x(sample), this.#last)));
    return x - this.#x(high - 1) < this.#x(high) - x ? high - 1 : high;
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
    const width = Math.max(LEAST.samples / this.#last, Math.min(1, (to - from) * factor));
    const start = Math.max(0, Math.min(1 - width, middle - at * width));
    this.#window = [start, start + width];
    this.#draw();
  }

  #draw() {
    const [analog, digital] = this.#shown();
    const panels = [...Map.groupBy(analog, (row) => row.unit)];
    const context = this.#clean(TOP + AXIS + panels.length * LEAST.panel + digital.length * LANE);
    if (!this.#traces) return;
    if (this.#across === "xy") return this.#drawOver(context, analog);
    const room = this.#height - TOP - AXIS - digital.length * LANE;
    const height = panels.length ? room / panels.length : 0;
    const colour = new Map(analog.map(({ name }, at) => [name, COLOURS[at % COLOURS.length]]));
    panels.forEach(([unit, rows], at) => this.#panel(context, unit, rows, colour, TOP + at * height, height - 12));
    digital.forEach((row, at) => this.#lane(context, row, TOP + room + at * LANE));
    this.#axis(context, this.#height - AXIS + 8);
    this.#drawTrigger(context, this.#height - AXIS);
    this.#drawCursors(context, this.#height - AXIS);
    this.#tell();
  }

  /** The rows of the wires that are shown: analog ones, and digital ones. */
  #shown() {
    const signals = this.#traces?.signals ?? [];
    const analog = signals.filter((row) => row.kind === "analog").slice(0, MOST.analog);
    return [analog, signals.filter((row) => row.kind !== "analog").slice(0, MOST.digital)];
  }

  /** An empty canvas, high enough for what is shown; it is drawn on in CSS pixels, however large these are on the screen. */
  #clean(needed) {
    const canvas = this.#canvas;
    canvas.style.height = needed > LEAST.whole ? `${needed}px` : "";
    const ratio = globalThis.devicePixelRatio || 1;
    [this.#width, this.#height] = [Math.max(200, canvas.clientWidth), Math.max(120, canvas.clientHeight)];
    canvas.width = Math.round(this.#width * ratio);
    canvas.height = Math.round(this.#height * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    context.font = "12px system-ui, sans-serif";
    this.#ink = getComputedStyle(canvas).color;
    this.#paper = getComputedStyle(document.documentElement).backgroundColor;
    return context;
  }

  /** The second analog wire over the first. */
  #drawOver(context, analog) {
    if (analog.length < 2) {
      const lead = "X-Y draws the second analog wire over the first: name two.";
      context.fillStyle = this.#ink;
      context.textAlign = "center";
      context.fillText(lead, this.#width / 2, this.#height / 2, this.#width);
      return this.#say({ lead, heads: [], rows: [] });
    }
    const box = { left: LEFT, top: TOP, width: this.#width - LEFT - 8, height: this.#height - TOP - AXIS };
    const extents = [this.#extent([analog[0]]), this.#extent([analog[1]])];
    over(context, { wires: analog, box, extents, traces: this.#traces, before: this.#before, cursors: this.#cursors, ink: this.#ink, colour: COLOURS[0] });
    this.#tell();
  }

  /** Colours of text and page. */
  #ink = "#000";
  #paper = "#fff";

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
    context.strokeRect(LEFT, top, this.#width - LEFT - 8, height);
    if (low < 0 && high > 0) context.strokeRect(LEFT, y(0), this.#width - LEFT - 8, 0);
    context.globalAlpha = 1;
    context.fillStyle = this.#ink;
    const end = unit === "1" ? "" : ` ${unit}`;
    context.textAlign = "right";
    context.fillText(`${short(high)}${end}`, LEFT - 4, top + 10, LEFT - 8);
    context.fillText(`${short(low)}${end}`, LEFT - 4, top + height, LEFT - 8);
    context.textAlign = "left";
    const way = { x: (sample) => this.#x(sample), y, bounds: [LEFT, this.#width - 8] };
    let [across, down] = [LEFT + 6, top + 12];
    for (const { name } of rows) {
      context.globalAlpha = 0.35;
      for (const { planes } of this.#before) {
        if (planes[name]) curve(context, planes[name].values, { ...way, colour: this.#ink });
      }
      context.globalAlpha = 1;
      curve(context, this.#traces.planes[name].values, { ...way, colour: colour.get(name) });
    }
    for (const { name } of rows) {
      const wide = context.measureText(name).width;
      if (across > LEFT + 6 && across + wide > this.#width - 8) [across, down] = [LEFT + 6, down + NAME[1]];
      context.fillStyle = colour.get(name);
      this.#haloed(context, name, across, down);
      across += wide + NAME[0];
    }
  }

  /** Text that can be read on curves. */
  #haloed(context, text, x, y) {
    context.strokeStyle = this.#paper;
    context.lineWidth = 4;
    context.lineJoin = "round";
    context.strokeText(text, x, y);
    context.lineWidth = 1;
    context.fillText(text, x, y);
  }

  #lane(context, { name, kind }, top) {
    context.fillStyle = this.#ink;
    context.textAlign = "left";
    context.fillText(name, 2, top + LANE - 8, LEFT - 6);
    const { planes } = this.#traces;
    const wire = { kind, values: planes[name].values, times: planes[`times:${name}`]?.values };
    lane(context, wire, { left: LEFT, top, width: this.#width - LEFT - 8, height: LANE }, (at) => this.#x(at), this.#ink);
  }

  #axis(context, top) {
    const { planes, place } = this.#traces;
    const x = (sample) => this.#x(sample);
    const isTime = this.#across === "sample";
    const [from, to] = this.#window.map((share) => share * this.#last);
    const ticks = isTime ? sampleTicks(from, to, x) : placeTicks(planes.places.values, x, LEFT + 8, this.#width - LEFT - 24);
    context.fillStyle = this.#ink;
    context.textAlign = "center";
    for (const [at, text] of ticks) context.fillText(text, at, top + 8);
    const each = this.sampleUs ? `, ${short(this.sampleUs)} µs each` : "";
    context.fillText(isTime ? `sample from the start of the sweep${each}` : place, (LEFT + this.#width) / 2, top + 22, this.#width - LEFT - 8);
    this.#canvas.dataset.ticks = ticks.map(([, text]) => text).join(" ");
  }

  /** The mark of the trigger: a line in its colour, with a T beside it. */
  #drawTrigger(context, bottom) {
    this.#canvas.dataset.mark = "";
    if (this.#trigger === null) return;
    const x = this.#x(this.#trigger);
    this.#canvas.dataset.mark = x;
    if (this.#isOutside(x)) return;
    context.strokeStyle = context.fillStyle = MARK;
    context.textAlign = "right";
    context.beginPath();
    context.moveTo(x, TOP);
    context.lineTo(x, bottom);
    context.stroke();
    context.fillText("T", x - 3, TOP + 10);
  }

  #isOutside(x) {
    return x < LEFT - 1 || x > this.#width - 7;
  }

  #drawCursors(context, bottom) {
    if (this.#under !== null) {
      context.globalAlpha = 0.4;
      context.fillStyle = this.#ink;
      context.fillRect(this.#x(this.#under), TOP, 1, bottom - TOP);
      context.globalAlpha = 1;
    }
    context.fillStyle = this.#ink;
    context.textAlign = "center";
    this.#cursors.forEach((sample, which) => {
      if (sample === null) return;
      const x = this.#x(sample);
      if (this.#isOutside(x)) return;
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

  /** The sample under the pointer, of the sweep that is shown; X-Y has none. */
  get #under() {
    return this.#pointer === null || this.#across === "xy" ? null : Math.min(this.#pointer, this.#last);
  }

  /** Says the values at the cursors and at the trigger, and how many wires have no room. */
  #tell() {
    const { signals } = this.#traces;
    const [analog, digital] = this.#shown();
    const over = signals.length - analog.length - digital.length;
    const notes = over > 0 ? [`${signals.length - over} of ${signals.length} wires are shown: at most ${MOST.analog} analog and ${MOST.digital} digital ones.`] : [];
    const { sampleUs } = this;
    this.#say(told({ traces: this.#traces, analog, reference: this.#reference, cursors: this.#cursors, pointer: this.#under, trigger: this.#trigger, sampleUs, notes }));
  }
}
