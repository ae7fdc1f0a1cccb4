// Sweeps that were not recorded: the program computes them on a click, and the frame's hash says whether they belong to the run.

import { Lunoid, SocketHome } from "./lunoid.js";

const machine = new Lunoid(new SocketHome());
const box = document.createElement("div");
box.className = "live";
box.setAttribute("role", "group");
box.setAttribute("aria-label", "Computed sweep");
document.getElementById("look-text").after(box);

/** What is asked of the program once: how samples run, the signals to show, and the hash of each frame. */
let known = null;
/** The newest place that is wanted; one before it is not computed. */
let wanted = null;
let isBusy = false;

document.addEventListener("sweep", ({ detail: { frame, sweep, isRecorded } }) => {
  box.replaceChildren();
  wanted = sweep === null || isRecorded ? null : { frame, sweep };
  if (wanted && !isBusy) work();
});

async function work() {
  isBusy = true;
  while (wanted) {
    const place = wanted;
    say(`Frame ${place.frame} is drawn once more.`);
    const show = await computed(place).catch((error) => () => say(error.message));
    if (wanted === place) {
      wanted = null;
      show();
    }
  }
  isBusy = false;
}

/** What shows the sweep at `place`, or says why it is not shown. */
async function computed({ frame, sweep }) {
  known ??= asked();
  known.catch(() => (known = null));
  const { sampleUs, patterns, hashes } = await known;
  const { hash } = await machine.frame(frame, { planes: [] });
  const expected = hashes.get(frame);
  if (hash !== expected) return () => refuse(frame, hash, expected);
  const traces = await machine.probe(patterns, [sweep, sweep + 1], { frame });
  return () => show(frame, sweep, sampleUs, traces);
}

async function asked() {
  const get = (name) => fetch(name).then((reply) => reply.json());
  const [{ signals: patterns }, record] = await Promise.all([get("live.json"), get("run.json")]);
  const { sample_us: sampleUs } = await machine.open();
  return { sampleUs, patterns, hashes: new Map(record.frames.map(({ frame, pixels_blake3: hash }) => [frame, hash])) };
}

function show(frame, sweep, sampleUs, traces) {
  const signals = traces.signals.filter(({ name, axis }) => axis !== "display" && name !== traces.place);
  say(`Computed now. The frame was drawn once more, and its pixels have the hash that the run has.`);
  const told = (names) => ({ ...traces, signals: signals.filter(({ name }) => names.includes(name)) });
  pageScope.fill(box, { frame, sweep, sampleUs, signals, told });
}

function refuse(frame, hash, expected) {
  const words = `Frame ${frame} has the hash ${hash} now, and ${expected} in the run: the scenario, a file that it names or the program is another one. ` +
    "The sweep is not shown.";
  say(words);
  // What is opened next is read anew.
  known = null;
}

function say(text) {
  const words = document.createElement("p");
  words.setAttribute("role", "status");
  words.textContent = text;
  box.replaceChildren(words);
}
