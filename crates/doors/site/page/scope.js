// The scope: analog traces in panels by unit, digital lanes below them, what was before behind, two cursors; or one wire over another.

import { curve, trace } from "./curve.js";

const LEFT = 88;
const TOP = 14;
const LANE = 22;
const AXIS = 34;
const COLOURS = ["#0b6fc2", "#c2480b", "#0b8a4b", "#8a3fc2", "#a67c00", "#00838f", "#ad1457", "#5d4037"];
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
  #drag = null;

  /** `say` is told the values at the cursor, in words. */
  constructor(canvas, say) {
    this.#canvas = canvas;
    this.#say = say;
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#draw()).observe(canvas);
  }

  /** Shows waveforms of one sweep. */
  show(traces) {
    if (this.#persists && this.#traces) this.#behind = [...this.#behind, this.#traces].slice(-MOST.behind);
    this.#traces = traces;
    this.#canvas.dataset.sweep = traces.sweeps[0];
    this.#draw();
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

  /** The sample nearest to a pixel of the page. */
  #sample(event) {
    const { left, width } = this.#canvas.getBoundingClientRect();
    const x = ((event.clientX - left) / width) * this.#canvas.width;
    const last = this.#traces.planes.places.values.length - 1;
    let [low, high] = [0, last];
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

  #wheel(event) {
    if (!this.#traces) return;
    event.preventDefault();
    const { left, width } = this.#canvas.getBoundingClientRect();
    if (event.shiftKey) this.#slide(Math.sign(event.deltaY) * 0.1);
    else this.#scale(event.deltaY > 0 ? 1.25 : 0.8, Math.max(0, Math.min(1, (event.clientX - left) / width)));
  }

  #press(event) {
    this.#drag = { x: event.clientX, moved: false };
    this.#canvas.setPointerCapture(event.pointerId);
  }

  #move(event) {
    if (!this.#drag || !this.#traces) return;
    const by = event.clientX - this.#drag.x;
    if (Math.abs(by) < 3 && !this.#drag.moved) return;
    this.#drag = { x: event.clientX, moved: true };
    this.#slide(-by / this.#canvas.getBoundingClientRect().width);
  }

  #release(event) {
    if (this.#drag && !this.#drag.moved && this.#traces) this.point(this.#sample(event), Number(event.shiftKey));
    this.#drag = null;
  }

  #key(event) {
    if (!this.#traces) return;
    const last = this.#traces.planes.places.values.length - 1;
    const which = Number(event.shiftKey);
    const at = this.#cursors[which];
    const to = { ArrowLeft: (at ?? 1) - 1, ArrowRight: (at ?? -1) + 1, PageUp: (at ?? 0) - 20, PageDown: (at ?? 0) + 20 }[event.key];
    if (to !== undefined) this.point(Math.max(0, Math.min(last, to)), which);
    else if (event.key === "+") this.#scale(0.8, 0.5);
    else if (event.key === "-") this.#scale(1.25, 0.5);
    else return;
    event.preventDefault();
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
    if (this.#across === "xy" && analog.length > 1) return this.#over(context, analog);
    const panels = [...Map.groupBy(analog, (row) => row.unit)];
    const room = canvas.height - TOP - AXIS - digital.length * LANE;
    const height = panels.length ? room / panels.length : 0;
    const colour = new Map(analog.map(({ name }, at) => [name, COLOURS[at % COLOURS.length]]));
    panels.forEach(([unit, rows], at) => this.#panel(context, unit, rows, colour, TOP + at * height, height - 12));
    digital.forEach((row, at) => this.#lane(context, row, TOP + room + at * LANE));
    this.#axis(context, canvas.height - AXIS + 8);
    this.#drawCursors(context, canvas.height - AXIS);
    this.#tell();
  }

  #ink = "#000";

  /** What stands behind: the reference, and what persists. */
  get #before() {
    return this.#reference ? [...this.#behind, this.#reference] : this.#behind;
  }

  /** The first wire across, the second up. */
  #over(context, [across, up]) {
    const [width, height] = [this.#canvas.width - LEFT - 8, this.#canvas.height - TOP - AXIS];
    const [[left, right], [low, high]] = [this.#extent([across]), this.#extent([up])];
    const place = {
      x: (value) => LEFT + ((value - left) / (right - left)) * width,
      y: (value) => TOP + height - ((value - low) / (high - low)) * height,
    };
    const drawn = ({ planes }, colour) => {
      if (planes[across.name] && planes[up.name]) trace(context, planes[across.name].values, planes[up.name].values, { ...place, colour });
    };
    context.globalAlpha = 0.35;
    this.#before.forEach((traces) => drawn(traces, this.#ink));
    context.globalAlpha = 1;
    drawn(this.#traces, COLOURS[0]);
    context.fillStyle = this.#ink;
    context.strokeStyle = this.#ink;
    this.#cursors.forEach((sample, which) => {
      if (sample === null) return;
      const [x, y] = [place.x(this.#traces.planes[across.name].values[sample]), place.y(this.#traces.planes[up.name].values[sample])];
      context.strokeRect(x - 4, y - 4, 8, 8);
      context.fillText("AB"[which], x + 7, y - 5);
    });
    context.textAlign = "right";
    context.fillText(short(high), LEFT - 4, TOP + 10);
    context.fillText(short(low), LEFT - 4, TOP + height);
    context.textAlign = "center";
    context.fillText(`${short(left)} to ${short(right)}: ${across.name}; up: ${up.name}`, LEFT + width / 2, TOP + height + 22);
    this.#tell();
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

  /** The values of a sample, with its place; of a signal that is told when it changes, none. */
  #values(sample) {
    const analog = this.#traces.signals.filter(({ name }) => !this.#traces.planes[`times:${name}`]);
    const value = ({ name, unit }) => ({ name, unit: unit === "1" ? "" : ` ${unit}`, value: this.#traces.planes[name].values[sample] });
    return [{ name: this.#traces.place, unit: "", value: this.#traces.planes.places.values[sample] }, ...analog.map(value)];
  }

  /** Says the values at both cursors, their difference, and what the reference has at A. */
  #tell() {
    const last = this.#traces.planes.places.values.length - 1;
    const [a, b] = this.#cursors.map((sample) => (sample === null ? null : Math.max(0, Math.min(last, Math.round(sample)))));
    const at = (sample) => this.#values(sample).map(({ name, unit, value }) => `${name} ${short(value)}${unit}`).join(", ");
    const told = [];
    if (a !== null) told.push(`A, sample ${a}: ${at(a)}.`);
    if (a !== null && this.#reference) {
      const behind = this.#values(a).filter(({ name }) => this.#reference.planes[name]);
      told.push(`Reference: ${behind.map(({ name, unit }) => `${name} ${short(this.#reference.planes[name].values[a])}${unit}`).join(", ")}.`);
    }
    if (b !== null) told.push(`B, sample ${b}: ${at(b)}.`);
    if (a !== null && b !== null) {
      const before = this.#values(a);
      told.push(`B less A, ${b - a} samples: ${this.#values(b).map(({ name, unit, value }, row) => `${name} ${short(value - before[row].value)}${unit}`).join(", ")}.`);
    }
    if (told.length) this.#say(told.join(" "));
  }
}

/** A number in five digits. */
function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "none";
}
