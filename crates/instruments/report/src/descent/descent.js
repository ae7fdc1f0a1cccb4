"use strict";
// What the page holds: curves frame by frame, and shots, the frames that have pictures.
const data = JSON.parse(document.getElementById("data").textContent);
const { first, times, raster, ways, shots } = data;
const at = (id) => document.getElementById(id);
const canvases = [...document.querySelectorAll("[data-way]")];
const COLOURS = ["#b4231a", "#1d4f91", "#2f7d32", "#8a5a00"];
// A pop below this is rounding (m).
const LEAST_POP = 1e-9;
const known = new Map();
let shot = 0, mark = null, waiting = null;

const metres = (value) => value === 0 ? "0 m" : Math.abs(value) < 1e-3 ? `${value.toExponential(1)} m` : `${value.toFixed(3)} m`;
const indexOf = (frame) => frame - first;
const nearest = (frame) => shots.reduce((best, it, number) =>
  Math.abs(it.frame - frame) < Math.abs(shots[best].frame - frame) ? number : best, 0);

// Scripts beside the page hand places over.
globalThis.places = (key, list) => { known.set(key, list); if (waiting) waiting(); };
const load = (way, number) => new Promise((resolve) => {
  const key = `${ways[way].name}-${shots[number].frame}`;
  if (known.has(key)) { resolve(known.get(key)); return; }
  const script = document.createElement("script");
  script.src = shots[number].files[way][1];
  script.onload = () => resolve(known.get(key) ?? []);
  script.onerror = () => resolve([]);
  document.head.append(script);
});

// The place of the grid nearest to a pixel.
const near = (list, pixel) => {
  const closest = (grid, at) => grid.reduce((best, it, number) => Math.abs(it - at) < Math.abs(grid[best] - at) ? number : best, 0);
  const column = closest(data.columns, pixel[0]), line = closest(data.lines, pixel[1]);
  return { place: list[line * data.columns.length + column], pixel: [data.columns[column], data.lines[line]] };
};

const draw = async (number) => {
  const next = Math.max(0, Math.min(shots.length - 1, number));
  // A place belongs to the picture in which it was clicked.
  if (next !== shot) {
    mark = null;
    at("place").textContent = "Click on the ground for its place.";
  }
  shot = next;
  const { frame, files, changes } = shots[shot];
  at("shot").value = shot;
  at("now").textContent = `frame ${frame}, ${times[indexOf(frame)].toFixed(2)} s, picture ${shot + 1} of ${shots.length}`;
  for (const [way, { name, off, pops }] of ways.entries()) {
    const here = indexOf(frame), told = document.querySelector(`[data-told="${CSS.escape(name)}"]`);
    const parts = [off[here] === null ? "no ground on the axis" : `${metres(off[here])} off the finest ground`];
    if (pops[here] > LEAST_POP) parts.push(`pops by ${metres(pops[here])}`);
    told.textContent = parts.join("; ");
    const image = new Image();
    image.onload = () => { if (shots[shot].frame === frame) paint(way, image); };
    image.src = files[way][0];
  }
  at("changed").textContent = changes.length === 0 ? "None in this frame."
    : changes.slice(0, 40).map((it) => `${it.tile}: level ${it.from} to ${it.to}, ${it.distance_m.toFixed(1)} m away`).join("\n")
      + (changes.length > 40 ? `\nand ${changes.length - 40} more` : "");
  at("changed").style.whiteSpace = "pre-wrap";
  curves();
  for (const [number, button] of [...document.querySelectorAll(".jumps button")].entries())
    button.setAttribute("aria-pressed", String(jumps[number].frame === frame));
};

// The box (left, top, right, bottom; pixels) around the places of a picture that a rule holds for; none where it holds for none.
const bounds = (list, holds) => {
  const half = (data.columns[1] - data.columns[0]) / 2;
  let box = null;
  list.forEach((place, number) => {
    if (!place || !holds(place)) return;
    const column = data.columns[number % data.columns.length], line = data.lines[Math.floor(number / data.columns.length)];
    box ??= [column, line, column, line];
    box = [Math.min(box[0], column), Math.min(box[1], line), Math.max(box[2], column), Math.max(box[3], line)];
  });
  return box && [box[0] - half, box[1] - half, box[2] + half, box[3] + half];
};

// A picture with the tiles that changed, and the place that was clicked.
const paint = async (way, image) => {
  const canvas = canvases[way], context = canvas.getContext("2d"), painted = shot;
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  const { changes } = shots[painted];
  if (changes.length > 0) {
    const list = await load(way, painted);
    if (painted !== shot) return;
    context.strokeStyle = "#ffb000"; context.lineWidth = Math.max(1.5, raster[0] / 300);
    for (const { borders_m: [south, west, top, right] } of changes) {
      const box = bounds(list, ([north, east]) => north >= south && north < top && east >= west && east < right);
      if (box) context.strokeRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
    }
  }
  if (mark) {
    context.strokeStyle = "#ff3b30"; context.lineWidth = Math.max(1, raster[0] / 350);
    context.beginPath(); context.arc(mark[0] + .5, mark[1] + .5, raster[0] / 70, 0, 7); context.stroke();
  }
};

const tell = async (way, pixel) => {
  const list = await load(way, shot);
  const { place, pixel: found } = near(list, pixel);
  mark = place ? found : null;
  const text = !place ? "No ground there."
    : `${place[0].toFixed(2)} m north, ${place[1].toFixed(2)} m east (pixel ${found[0]}, ${found[1]} of ${ways[way].name})\n`
      + (place.length > 2
        ? `lunoid terrain add FILE --id mine --crater ${place[2].toFixed(7)},${place[3].toFixed(7)},RADIUS_M --wall-percent 4 --depth-percent 20`
        : "This ground has no longitude and latitude; a ground of lunoid terrain has them, and is added to by them.");
  at("place").textContent = text;
  draw(shot);
};

for (const [way, canvas] of canvases.entries()) {
  const pixel = (event) => {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.left) * raster[0] / box.width, (event.clientY - box.top) * raster[1] / box.height];
  };
  canvas.addEventListener("click", (event) => tell(way, pixel(event)));
  canvas.addEventListener("keydown", (event) => {
    if (event.key === "Enter" || event.key === " ") { event.preventDefault(); tell(way, [raster[0] / 2, raster[1] / 2]); }
  });
}

// Curves: what ways are off the finest ground above, pops below.
const curves = () => {
  const canvas = at("curves"), context = canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
  const [width, height, left, gap] = [canvas.width, canvas.height, 90, 30];
  const ink = style.getPropertyValue("--ink").trim(), soft = style.getPropertyValue("--soft").trim();
  context.clearRect(0, 0, width, height);
  context.font = "15px sans-serif"; context.textBaseline = "middle";
  const x = (index) => left + (width - left - 20) * (times.length > 1 ? index / (times.length - 1) : .5);
  const panel = (top, bottom, key, label, least) => {
    const values = ways.flatMap((way) => way[key].filter((value) => value !== null));
    const low = Math.min(least, ...values), high = Math.max(1e-6, ...values);
    const y = (value) => bottom - (bottom - top) * (value - low) / (high - low);
    context.strokeStyle = soft; context.lineWidth = 1;
    context.strokeRect(left, top, width - left - 20, bottom - top);
    context.fillStyle = ink; context.textAlign = "right";
    context.fillText(metres(high), left - 8, top + 6); context.fillText(metres(low), left - 8, bottom - 6);
    context.textAlign = "left"; context.fillText(label, left + 8, top + 14);
    ways.forEach((way, number) => {
      context.strokeStyle = COLOURS[number % COLOURS.length]; context.lineWidth = 2; context.beginPath();
      let pen = false;
      way[key].forEach((value, index) => {
        if (value === null) { pen = false; return; }
        if (pen) context.lineTo(x(index), y(value)); else context.moveTo(x(index), y(value));
        pen = true;
      });
      context.stroke();
    });
  };
  const half = (height - gap) / 2;
  panel(10, half, "off", "off the finest ground", 0);
  panel(half + gap, height - 10, "pops", "pop", 0);
  context.strokeStyle = ink; context.setLineDash([5, 4]); context.beginPath();
  const now = x(indexOf(shots[shot].frame));
  context.moveTo(now, 10); context.lineTo(now, height - 10); context.stroke(); context.setLineDash([]);
  context.fillStyle = soft;
  for (const it of shots) context.fillRect(x(indexOf(it.frame)) - 1, height - 8, 2, 6);
};
at("curves").addEventListener("click", (event) => {
  const box = at("curves").getBoundingClientRect(), scaled = (event.clientX - box.left) * 1200 / box.width;
  const index = Math.round((scaled - 90) / (1200 - 110) * (times.length - 1));
  // A jump beside the click is what is meant.
  const jump = jumps.find((it) => Math.abs(indexOf(it.frame) - index) <= times.length / 100);
  draw(nearest(jump ? jump.frame : index + first));
});
at("curves").addEventListener("keydown", (event) => {
  const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (step) { event.preventDefault(); draw(shot + step); }
});

const jumps = ways.flatMap((way) => way.pops.map((pop, index) => ({ way: way.name, pop, frame: first + index })))
  .filter(({ pop, frame }) => pop > LEAST_POP && shots.some((it) => it.frame === frame))
  .sort((a, b) => b.pop - a.pop);
for (const { way, pop, frame } of jumps) {
  const item = document.createElement("li"), button = document.createElement("button");
  button.type = "button";
  const { changes } = shots[nearest(frame)];
  button.textContent = `frame ${frame}: ${way} pops by ${metres(pop)}; ${changes.length} ${changes.length === 1 ? "tile takes" : "tiles take"} another level`;
  button.addEventListener("click", () => { draw(nearest(frame)); at("pictures").scrollIntoView(); });
  item.append(button); at("jumps").append(item);
}
at("no-jumps").hidden = jumps.length > 0;
ways.forEach((way, number) => {
  const entry = document.createElement("span"), line = document.createElement("i");
  line.style.background = COLOURS[number % COLOURS.length];
  entry.append(line, way.name); at("legend").append(entry);
});
at("shot").addEventListener("input", (event) => draw(Number(event.target.value)));
at("before").addEventListener("click", () => draw(shot - 1));
at("after").addEventListener("click", () => draw(shot + 1));
draw(jumps.length > 0 ? nearest(jumps[0].frame) : 0);
