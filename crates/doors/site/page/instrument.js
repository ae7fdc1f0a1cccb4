// The instrument: tube, scope, fault board and time over one view model. The page knows nothing of where the machine runs.

import { FIRST, HAS_BOOKS, Here, TAKES_FILES } from "./here.js";
import { Lunoid } from "./lunoid.js";
import { showEvents } from "./events-table.js";
import { diagramPanel } from "./diagram-panel.js";
import { DrivePad } from "./drive-pad.js";
import { MOST } from "./driving.js";
import { effectsPanel } from "./effects-panel.js";
import { showFaults, showNumbers } from "./fault-board.js";
import { bound, fill, keepingFocus, noteTyping } from "./fields.js";
import { Gamepads } from "./gamepad.js";
import { inShort, inWords } from "./in-words.js";
import { read, setting, written } from "./link.js";
import { Scope } from "./scope.js";
import { contents, scenarios } from "./shipped.js";
import { showValues } from "./scope-values.js";
import { SlowMotion } from "./slow-motion.js";
import { name } from "./time-bar.js";
import { timePanel } from "./time-panel.js";
import { triggerPanel } from "./trigger-panel.js";
import { Tube } from "./tube.js";
import { ViewModel } from "./view-model.js";

/** Most bytes of files that are read at a time. */
const MOST_BYTES = 256 * 2 ** 20;
/** The machines that ship, and none for that of the scenario. */
const MACHINES = [
  "", "ideal", "modern-analog", "pra-nominal", "pra-parts", "pra-wires", "pra-frugal", "pra-overloaded",
  "exact", "sampled", "smooth-faces", "lod-mesh", "lunsim", "panels",
];

const at = (id) => document.getElementById(id);
const say = (text) => { at("state").textContent = text; };

const own = new Map();
const rows = await scenarios();
const START = { scenario: rows[0].scenario, wires: "", ...FIRST };
const machine = new Lunoid(new Here({ hear }));
const model = new ViewModel(machine, given);
const tube = new Tube(at("tube"), (column, line) => model.show({ column, line }));
const scope = new Scope(at("scope"), (told) => showValues(at("values"), at("value-rows"), told), (sample, which) => { if (which === 0) model.point(sample); });
const slow = new SlowMotion(model, tube);
let [shipped, parameters] = [[], []];
let goes = null;

function hear({ phase, bytes, reason }) {
  if (phase === "loading") say(`Loading the machine: ${(bytes / 1e6).toFixed(1)} MB.`);
  if (phase === "ended") say(`The machine ended: ${reason}. It is started again.`);
}

/** The files of a scenario: the page's own, and those that were opened. */
async function given(scenario) {
  const row = rows.find((row) => row.scenario === scenario);
  const shipped = row ? await contents(row.files) : {};
  return { ...shipped, ...Object.fromEntries(own) };
}

function option(value, text = value) {
  return Object.assign(document.createElement("option"), { value, textContent: text });
}

function fillMenus() {
  at("scenario").replaceChildren(...rows.map(({ scenario }) => option(scenario, scenario.replace(/^scenarios\/|\.toml$/g, ""))));
  at("machine").replaceChildren(...MACHINES.map((name) => option(name, name || "the scenario's own")));
}

/** Takes up what the address says; what is not known is listed. */
function follow() {
  const { view, unknown } = read(location.hash);
  const isEmpty = location.hash.length < 2;
  const wanted = isEmpty ? START : { ...START, frame: 0, set: {}, column: null, line: null, ...view };
  at("refused").replaceChildren(...unknown.map((part) => leftOut(part, "no part of a link")));
  if (!rows.some(({ scenario }) => scenario === wanted.scenario)) {
    at("refused").append(leftOut(`scenario=${wanted.scenario}`, "no scenario of this page"));
    wanted.scenario = START.scenario;
  }
  model.follow({ machine: null, ...wanted });
}

/** A part of a link that is left out, and why. */
function leftOut(part, why) {
  return Object.assign(document.createElement("li"), { textContent: `${part}: ${why}` });
}

/** Makes fields and address say what is looked at. */
function agree() {
  const { view, facts } = model;
  at("scenario").value = view.scenario;
  at("machine").value = view.machine ?? "";
  at("frame").max = model.frames - 1;
  at("frame").value = view.frame;
  fill(at("sweep"), view.sweep);
  fill(at("wires"), view.wires);
  at("frame-says").textContent = model.isDriven ? `${name(model.lane)}, frame ${view.frame} of ${model.frames}` : `frame ${view.frame} of ${facts.frames}`;
  tube.mark(view.column, view.line);
  // A link carries no drive.
  at("link").href = written(model.isDriven ? { ...view, frame: null } : view);
}

async function opened({ detail: facts }) {
  at("sweep").max = Math.max(0, facts.sweeps - 1);
  scope.sampleUs = facts.sample_us;
  at("driven").textContent = facts.driven > 0 ? `${facts.driven} frames driven` : "";
  at("record").disabled = facts.driven === 0;
  document.querySelector("main").inert = false;
  const [told, board] = await Promise.all([model.parameters(), model.faults()]);
  [parameters, shipped] = [told.parameters, board.faults];
  boards();
}

/** Makes the fault board say what is set. */
function boards() {
  keepingFocus(at("faults"), () => showFaults(at("faults"), shipped, model.view.faults, (faults) => model.show({ faults })));
  keepingFocus(at("numbers"), numbers);
}

/** Two wires to begin with, where nothing says which: height and deflection, or the first analog ones. */
async function firstWires() {
  const { signals } = await model.beside((machine) => machine.signals());
  const names = signals.filter(({ kind }) => kind === "analog").map(({ name }) => name);
  const usual = ["mu.height", "sweep.x"].filter((name) => names.includes(name));
  const wires = (usual.length === 2 ? usual : names.slice(0, 2)).join(",");
  if (model.view.wires === "" && wires) model.show({ wires });
}

function numbers() {
  const change = (key, text) => {
    const { [key]: _, ...rest } = model.view.set;
    model.show({ set: text === null ? rest : { ...rest, [key]: setting(text) } });
  };
  showNumbers(at("numbers"), parameters, model.view.set, at("find").value.trim(), change);
}

/** Puts a wire on the scope, as the last one. */
function wire(name) {
  const wires = model.view.wires.split(",").map((word) => word.trim()).filter((word) => word && word !== name);
  model.show({ wires: [...wires, name].join(",") });
}

/** Steps the frame, and comes round at the ends. */
function turn(by) {
  slow.leave();
  model.look(model.lane, (model.view.frame + by + model.frames) % model.frames);
}

/** Ends playing and driving. */
function stop() {
  goes = null;
  for (const button of [at("play"), at("drive")]) button.setAttribute("aria-pressed", "false");
}

/** Turn and speed from pad or stick, from -1 to 1 each; driving goes on while it is held. */
function steer(turn, speed, isHeld) {
  at("turn").value = Math.round(turn * MOST.turn);
  at("speed").value = Math.round(speed * MOST.kmh);
  if ((goes === at("drive")) !== isHeld) at("drive").click();
}

/** Plays or drives for as long as the button is pressed; each picture is shown before the next is asked for. */
function repeat(button, once) {
  button.addEventListener("click", async () => {
    const was = goes;
    stop();
    if (was === button) return;
    slow.leave();
    goes = button;
    button.setAttribute("aria-pressed", "true");
    button.dataset.runs = true;
    while (goes === button) {
      await once().catch((error) => { failed(error); stop(); });
      await new Promise(requestAnimationFrame);
    }
    button.dataset.runs = false;
  });
}

function failed(error) {
  say(inWords(error));
  at("state").dataset.fault = error.name;
}

async function record() {
  const { folder, planes } = await model.record();
  if (folder) return say(`What was driven lies in ${folder}.`);
  for (const { name, values } of Object.values(planes)) {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(new Blob([values])), download: name.split("/").at(-1) });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

/** Opens files of the reader: a scenario among them is shown, and finds the others beside it. */
async function take(files) {
  const bytes = [...files].reduce((sum, { size }) => sum + size, 0);
  if (!TAKES_FILES) throw new Error("the program draws the scenario that it was started with, and takes no other files");
  if (bytes > MOST_BYTES) throw new Error(`${[...files].map(({ name }) => name).join(", ")}: ${bytes} bytes; expected at most ${MOST_BYTES}`);
  for (const file of files) own.set(`scenarios/${file.name}`, new Uint8Array(await file.arrayBuffer()));
  const scenario = [...files].find(({ name }) => name.endsWith(".toml"));
  if (!scenario) throw new Error("no scenario among the files; expected one whose name ends in .toml");
  const name = `scenarios/${scenario.name}`;
  if (!rows.some((row) => row.scenario === name)) rows.push({ scenario: name, files: [] });
  fillMenus();
  model.show({ scenario: name, set: {}, faults: [], frame: 0, column: null, line: null });
}

model.addEventListener("opened", opened);
model.addEventListener("picture", ({ detail }) => {
  tube.show(detail.planes.picture, detail.hash, slow.drawn(detail));
  tube.mark(model.view.column, model.view.line);
  tube.zoom(at("zoom").value);
});
model.addEventListener("explained", ({ detail }) => {
  tube.mark(model.view.column, model.view.line);
  if (detail === null) {
    at("pixel").textContent = "Click a pixel to have it explained.";
    at("explained").textContent = "";
    return;
  }
  const { cause, text, document: told } = detail;
  at("pixel").textContent = `Column ${model.view.column}, line ${model.view.line}: ${cause}.`;
  at("explained").textContent = text;
  if (told.ground) model.point(told.ground.sample);
});
model.addEventListener("cursor", ({ detail }) => scope.point(detail));
model.addEventListener("traces", ({ detail }) => scope.show(detail, model.trigger.place?.instant ?? null));
model.addEventListener("events", ({ detail }) => {
  const { lead, late } = showEvents(at("events"), detail, model.facts, effect);
  at("events-head").textContent = lead;
  at("late").textContent = late;
});
model.addEventListener("driven", ({ detail }) => {
  at("driven").textContent = `${detail} frames driven`;
  at("record").disabled = false;
  agree();
});
model.addEventListener("fault", ({ detail }) => {
  failed(detail);
  stop();
  boards();
});
model.addEventListener("refused", ({ detail }) => {
  at("refused").append(...detail.map(({ part, error }) => leftOut(part, inShort(error))));
  boards();
});
model.addEventListener("busy", ({ detail }) => {
  document.body.dataset.busy = detail;
  if (detail) return say("The machine draws.");
  if (model.facts) agree();
  if (!at("state").dataset.fault && model.facts) say(`${model.facts.title}, drawn by ${model.facts.drawn_by}.`);
  else if (at("state").dataset.fault) delete at("state").dataset.fault;
});

const effect = effectsPanel(at, model, tube, { failed });
triggerPanel(at, model, { stop, failed });
timePanel(at, model, slow, { stop, failed });
diagramPanel(at, model, { scope: wire, failed });
new DrivePad(at("pad"), steer);
new Gamepads(steer, (name) => at(name).click());

at("books").hidden = !HAS_BOOKS;
at("own-files").hidden = !TAKES_FILES;
fillMenus();
at("scenario").addEventListener("change", ({ target }) => { at("refused").replaceChildren(); model.show({ scenario: target.value, set: {}, faults: [], frame: 0, column: null, line: null }); });
at("machine").addEventListener("change", ({ target }) => { at("refused").replaceChildren(); model.choose(target.value || null); });
at("files").addEventListener("change", ({ target }) => take(target.files).catch(failed));
at("frame").addEventListener("input", ({ target }) => { slow.leave(); model.look(model.lane, Number(target.value)); });
at("back").addEventListener("click", () => turn(-1));
at("on").addEventListener("click", () => turn(1));
for (const field of document.querySelectorAll("input[type=number]")) field.addEventListener("change", () => bound(field));
for (const id of ["wires", "sweep"]) noteTyping(at(id));
at("zoom").addEventListener("change", ({ target }) => tube.zoom(target.value));
at("wires").addEventListener("change", ({ target }) => model.show({ wires: target.value }));
at("sweep").addEventListener("change", ({ target }) => model.show({ sweep: Number(target.value), column: null, line: null }));
at("across").addEventListener("change", ({ target }) => scope.along(target.value));
at("keep").addEventListener("click", ({ target }) => { target.textContent = scope.keep() ? "Drop the reference" : "Keep as reference"; });
at("persist").addEventListener("change", ({ target }) => scope.persist(target.checked));
at("whole").addEventListener("click", () => scope.whole());
at("find").addEventListener("input", numbers);
at("heal").addEventListener("click", () => model.show({ set: {}, faults: [] }));
at("record").addEventListener("click", () => record().catch(failed));
at("tube").addEventListener("keydown", ({ key }) => {
  const by = { w: ["speed", 1], s: ["speed", -1], a: ["turn", -2], d: ["turn", 2] }[key.toLowerCase()];
  if (!by) return;
  at(by[0]).value = Number(at(by[0]).value) + by[1];
  bound(at(by[0]));
});
repeat(at("play"), () => { const done = model.settled(); turn(1); return done; });
repeat(at("drive"), async () => { if (!(await model.drive(at("speed").value, at("turn").value))) stop(); });
if (FIRST.wires === undefined) model.addEventListener("opened", () => firstWires().catch(failed), { once: true });
addEventListener("hashchange", follow);
document.body.addEventListener("dragover", (event) => event.preventDefault());
document.body.addEventListener("drop", (event) => { event.preventDefault(); take(event.dataTransfer.files).catch(failed); });
follow();
