// The scope: analog traces in panels by unit, digital lanes below them, a reference behind, one cursor.

const LEFT = 88;
const TOP = 14;
const LANE = 22;
const AXIS = 34;
const COLOURS = ["#0b6fc2", "#c2480b", "#0b8a4b", "#8a3fc2", "#a67c00", "#00838f", "#ad1457", "#5d4037"];
const MOST = { analog: 8, digital: 16 };

export class Scope {
  #canvas;
  #say;
  #traces = null;
  #reference = null;
  #window = [0, 1];
  #cursor = null;
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

  whole() {
    this.#window = [0, 1];
    this.#draw();
  }

  /** What runs across: "sample" for sweep time, "place" for range. */
  along(across) {
    this.#across = across;
    this.whole();
  }

  /** Sets the cursor on a sample. */
  point(sample) {
    this.#cursor = sample;
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
    if (this.#drag && !this.#drag.moved && this.#traces) this.point(this.#sample(event));
    this.#drag = null;
  }

  #key(event) {
    if (!this.#traces) return;
    const last = this.#traces.planes.places.values.length - 1;
    const step = event.shiftKey ? 10 : 1;
    const to = { ArrowLeft: (this.#cursor ?? 0) - step, ArrowRight: (this.#cursor ?? -1) + step }[event.key];
    if (to !== undefined) this.point(Math.max(0, Math.min(last, to)));
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
    const panels = [...Map.groupBy(analog, (row) => row.unit)];
    const room = canvas.height - TOP - AXIS - digital.length * LANE;
    const height = panels.length ? room / panels.length : 0;
    const colour = new Map(analog.map(({ name }, at) => [name, COLOURS[at % COLOURS.length]]));
    panels.forEach(([unit, rows], at) => this.#panel(context, unit, rows, colour, TOP + at * height, height - 12));
    digital.forEach((row, at) => this.#lane(context, row, TOP + room + at * LANE));
    this.#axis(context, canvas.height - AXIS + 8);
    this.#drawCursor(context, canvas.height - AXIS);
    this.#tell();
  }

  #ink = "#000";

  /** Lowest and highest finite value of the rows, the reference included. */
  #extent(rows) {
    let [low, high] = [Infinity, -Infinity];
    for (const traces of [this.#traces, this.#reference]) {
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
    rows.forEach(({ name }, at) => {
      context.globalAlpha = 0.35;
      if (this.#reference?.planes[name]) this.#curve(context, this.#reference.planes[name].values, y, this.#ink);
      context.globalAlpha = 1;
      this.#curve(context, this.#traces.planes[name].values, y, colour.get(name));
      context.fillStyle = colour.get(name);
      context.fillText(name, LEFT + 6 + at * 130, top + 12);
    });
  }

  /** A column of the canvas keeps its lowest and its highest value, so no peak is lost. */
  #curve(context, values, y, colour) {
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    let [column, low, high, pen] = [null, 0, 0, false];
    const put = () => {
      if (column === null) return;
      if (!pen) context.moveTo(column, y(low));
      pen = true;
      context.lineTo(column, y(low));
      context.lineTo(column, y(high));
    };
    values.forEach((value, sample) => {
      const x = Math.round(this.#x(sample));
      if (x < LEFT - 1 || x > this.#canvas.width - 7) return;
      if (!Number.isFinite(value)) {
        put();
        [column, pen] = [null, false];
      } else if (x === column) {
        [low, high] = [Math.min(low, value), Math.max(high, value)];
      } else {
        put();
        [column, low, high] = [x, value, value];
      }
    });
    put();
    context.stroke();
    context.lineWidth = 1;
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

  #drawCursor(context, bottom) {
    if (this.#cursor === null) return;
    const x = this.#x(this.#cursor);
    context.strokeStyle = this.#ink;
    context.setLineDash([4, 3]);
    context.beginPath();
    context.moveTo(x, TOP);
    context.lineTo(x, bottom);
    context.stroke();
    context.setLineDash([]);
  }

  #tell() {
    if (this.#cursor === null) return;
    const sample = Math.max(0, Math.min(this.#traces.planes.places.values.length - 1, Math.round(this.#cursor)));
    const value = ({ name, unit }) => {
      const values = this.#traces.planes[name].values;
      if (this.#traces.planes[`times:${name}`]) return null;
      const before = this.#reference?.planes[name]?.values[sample];
      const change = before === undefined ? "" : ` (reference ${short(before)})`;
      return `${name} ${short(values[sample])}${unit === "1" ? "" : ` ${unit}`}${change}`;
    };
    const told = this.#traces.signals.map(value).filter(Boolean);
    const place = short(this.#traces.planes.places.values[sample]);
    this.#say(`Sample ${sample}, ${this.#traces.place} ${place}: ${told.join(", ")}`);
  }
}

/** A number in five digits. */
function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "none";
}
