// The gallery: every shipped scenario and every fault, drawn when they come into view, one after another.

import { HAS_BOOKS, Here } from "./here.js";
import { Lunoid } from "./lunoid.js";
import { written } from "./link.js";
import { show } from "./picture.js";
import { contents, scenarios } from "./shipped.js";

/** Size of a picture here. */
const SMALL = { "scenario.raster.columns": 320, "scenario.raster.lines": 184 };

/** Longest that a picture may take here (ms). */
const MOST = 20_000;

const rows = await scenarios();
/** The scenario on which faults are shown, and its frame. */
const FAULTY = { scenario: (rows.find(({ name }) => name === "first-light") ?? rows[0]).scenario, frame: 60 };
const machine = new Lunoid(new Here());
/** What came into view and is still to be drawn. */
const waiting = [];
let draws = false;

function card(list, view, title, text) {
  const canvas = Object.assign(document.createElement("canvas"), { width: 16, height: 9 });
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", title);
  const link = Object.assign(document.createElement("a"), { href: `instrument.html${written({ set: {}, ...view })}` });
  link.append(canvas, title);
  const item = document.createElement("li");
  item.append(link, Object.assign(document.createElement("p"), { textContent: text }));
  document.getElementById(list).append(item);
  const seen = new IntersectionObserver(([entry]) => {
    if (!entry.isIntersecting) return;
    seen.disconnect();
    waiting.push({ canvas, view, item });
    run();
  });
  seen.observe(item);
}

async function run() {
  if (draws) return;
  draws = true;
  while (waiting.length) {
    const { canvas, view, item } = waiting.shift();
    await draw(canvas, view).catch((error) => item.append(Object.assign(document.createElement("p"), { textContent: told(error) })));
  }
  draws = false;
}

function told(error) {
  return error.name === "TimeoutError" ? `Takes longer than ${MOST / 1000} s in this browser.` : error.message;
}

async function draw(canvas, { scenario, faults, frame }) {
  const { files } = rows.find((row) => row.scenario === scenario);
  const signal = AbortSignal.timeout(MOST);
  await machine.open(scenario, { files: await contents(files), overlays: faults, set: SMALL, signal });
  const { hash, planes } = await machine.frame(frame, { signal });
  show(canvas, planes.picture);
  canvas.dataset.hash = hash;
}

document.getElementById("books").hidden = !HAS_BOOKS;
for (const { scenario, title, shows, frames } of rows) {
  card("scenarios", { scenario, faults: [], frame: Math.floor(frames / 2) }, title, shows);
}
await machine.open(FAULTY.scenario, { files: await contents(rows.find((row) => row.scenario === FAULTY.scenario).files) });
for (const { name, proves } of (await machine.faults()).faults) {
  card("faults", { ...FAULTY, faults: [name] }, name, proves);
}
