// The site in a browser without a window against the native program: node check.mjs SITE NATIVE RECORD [chromium|firefox]
// SITE is the folder, NATIVE the file of crates/doors/browser/examples/native.rs on cases.json, RECORD the record to write.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { Chromium } from "./chromium.mjs";
import { Firefox } from "./firefox.mjs";
import { instrument } from "./instrument.mjs";
import { keyboard } from "./keyboard.mjs";
import { panels } from "./panels.mjs";
import { refused } from "./refused.mjs";
import { scope } from "./scope.mjs";
import { serve } from "./server.mjs";
import { vectors } from "./vectors.mjs";

const [site, nativeFile, recordFile, which = "chromium"] = process.argv.slice(2);
const Chosen = { chromium: Chromium, firefox: Firefox }[which];
const PATH = "/some/path/below/";
const native = JSON.parse(await readFile(nativeFile, "utf8"));
const rows = JSON.parse(await readFile(join(site, "scenarios.json"), "utf8")).scenarios;
const wasm = await readFile(join(site, "lunoid.wasm"));
const faults = [];
const record = {};

function expect(is, what) {
  console.log(`${is ? "ok  " : "FAIL"} ${what}`);
  if (!is) faults.push(what);
}

function moduleAlone() {
  const imports = WebAssembly.Module.imports(new WebAssembly.Module(wasm));
  expect(imports.length === 0, `the module imports nothing: ${JSON.stringify(imports.slice(0, 3))}`);
  record.module = { bytes: wasm.length, vectors: vectors(wasm), gzip_bytes: gzipSync(wasm, { level: 9 }).length, brotli_bytes: brotliCompressSync(wasm).length };
  const { fixed, relaxed } = vectors(wasm);
  expect(fixed > 0 && relaxed === 0, `of ${fixed + relaxed} vector instructions ${relaxed} are relaxed`);
  // (func (param v128 v128 v128) (result v128) local.get 0 1 2 f64x2.relaxed_madd): the reader must see it.
  const fused = [0, 97, 115, 109, 1, 0, 0, 0, 1, 8, 1, 96, 3, 123, 123, 123, 1, 123, 3, 2, 1, 0, 10, 13, 1, 11, 0, 32, 0, 32, 1, 32, 2, 253, 135, 2, 11];
  expect(vectors(new Uint8Array(fused)).relaxed === 1, "a fused multiplication is seen where there is one");
  const { brotli_bytes: brotli, gzip_bytes: gzip } = record.module;
  expect(brotli <= 2e6, `the module has ${brotli} bytes compressed by brotli, at most 2 MB`);
  // Hosts that know gzip alone send more.
  expect(gzip <= 2.85e6, `the module has ${gzip} bytes compressed by gzip, at most 2.85 MB`);
}

async function firstPage(browser, host) {
  const begun = Date.now();
  await browser.go(host.address);
  const seen = {};
  while (Object.keys(seen).length < 2 && Date.now() - begun < 60_000) {
    const { view, hash } = await browser.run(`return { ...document.getElementById("tube").dataset };`);
    if (view && !seen[view]) seen[view] = { hash, milliseconds: Date.now() - begun };
  }
  record.first_page = seen;
  const [healed, torn] = native;
  expect(seen.torn?.hash === torn.hash, "the first page shows the torn mountain of the native program");
  expect(seen.healed?.hash === healed.hash, "the first page shows the healed mountain of the native program");
  const last = Math.max(seen.torn?.milliseconds ?? Infinity, seen.healed?.milliseconds ?? Infinity);
  expect(last <= 10_000, `both stand after ${last} ms, at most 10 s`);
}

/** Pixels on the canvas of the first page that are not those of the machine's picture. */
async function canvas(browser) {
  const wrong = await browser.run(
    `const [rows] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     document.getElementById("pause").click();
     const tube = document.getElementById("tube");
     const row = rows[tube.dataset.view === "torn" ? 1 : 0];
     const machine = new lunoid.Lunoid();
     await machine.open(row.scenario, { files: await contents([row.scenario]), set: row.set });
     const { shape: [lines, columns], values: codes } = (await machine.frame(row.frame)).planes.picture;
     machine.close();
     const { data } = tube.getContext("2d").getImageData(0, 0, tube.width, tube.height);
     if (tube.width !== columns || tube.height !== lines) return -1;
     return codes.reduce((wrong, code, pixel) => wrong + (data[4 * pixel] !== code || data[4 * pixel + 3] !== 255), 0);`,
    native.slice(0, 2),
  );
  expect(wrong === 0, `every pixel on the canvas is the machine's: ${wrong} are not`);
}

/** The pictures of the cases, in the page; each frame is drawn twice, and the second time counts. */
async function pictures(browser) {
  record.pictures = [];
  for (const row of native) {
    const { files } = rows.find((other) => other.scenario === row.scenario);
    const found = await browser.run(
      `const [row, files] = values;
       const { contents } = await import(new URL("shipped.js", document.baseURI));
       let memory = 0;
       const machine = new lunoid.Lunoid(new lunoid.WorkerHome({ hear: (told) => { memory = told.memory ?? memory; } }));
       await machine.hello();
       const begun = performance.now();
       await machine.open(row.scenario, { files: await contents(files), machine: row.machine ?? undefined, set: row.set });
       const opened = performance.now();
       const first = await machine.frame(row.frame);
       const drawn = performance.now();
       const second = await machine.frame(row.frame);
       const end = performance.now();
       machine.close();
       return { hash: first.hash, again: second.hash, open_ms: opened - begun, first_ms: drawn - opened, frame_ms: end - drawn, memory };`,
      row,
      files,
    );
    const name = `${row.scenario} ${row.machine ?? ""} ${JSON.stringify(row.set)} frame ${row.frame}`;
    expect(found.hash === row.hash && found.again === row.hash, `${name}: the page's picture is the native one`);
    record.pictures.push({ ...row, page: found });
  }
  const hashes = new Set(native.map((row) => row.hash));
  expect(hashes.size === native.length, "no two cases have one picture, so a wrong frame would be seen");
}

/** Files and requests that must be refused, by a worker that lives on. */
async function refusals(browser) {
  const { files } = rows.find((row) => row.scenario === native[0].scenario);
  const found = await browser.run(
    `const [row, files] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const given = await contents(files);
     const ended = [];
     const machine = new lunoid.Lunoid(new lunoid.WorkerHome({ hear: (told) => { if (told.phase === "ended") ended.push(told.reason); } }));
     const text = new TextDecoder().decode(given[row.scenario]);
     const bad = {
       empty: "", rubbish: new Uint8Array([0xff, 0, 0xfe, 1]), cut: text.slice(0, 700),
       key: text.replace("duration_s", "duration_z"), deep: "a = " + "[".repeat(5000), huge: text.replace("region_size_m = 16", "region_size_m = 1e-9"),
       outside: text.replace("[vehicle]", '[vehicle]\\nfile = "../../etc/passwd"'), endless: text.replace("duration_s = 6", "duration_s = 1e300"),
       version: text.replace("format = 1", "format = 99"),
     };
     const told = {};
     await machine.open(row.scenario, { files: given });
     for (const [name, content] of Object.entries(bad)) {
       told[name] = await machine.open("scenarios/" + name + ".toml", { files: { ["scenarios/" + name + ".toml"]: content } })
         .then(() => null, (error) => ({ kind: error.name, problems: error.problems, message: error.message }));
     }
     for (const [name, ask] of Object.entries({
       missing: () => machine.open("scenarios/no-such.toml"),
       outOfTheStore: () => machine.open("scenarios/x.toml", { files: { "../x.toml": "format = 1" } }),
       word: () => machine.request({ do: "fly" }),
       frame: () => machine.frame(1e9),
       setting: () => machine.set({ "loader.no_such": 1 }),
     })) told[name] = await ask().then(() => null, (error) => ({ kind: error.name, problems: error.problems, message: error.message }));
     const after = await machine.frame(row.frame);
     machine.close();
     return { told, ended, after: after.hash };`,
    native[0],
    files,
  );
  for (const [name, told] of Object.entries(found.told)) {
    const first = told?.problems?.[0];
    expect(told?.kind === "LunoidError" && first?.file && first?.title, `${name} is refused: ${told?.message?.split("\n")[0]}`);
  }
  expect(found.told.key.problems[0].line > 0 && found.told.key.problems[0].expected !== null, "a fault carries its line and what was expected");
  expect(found.ended.length === 0, "no refusal ends the worker");
  expect(found.after === native[0].hash, "after all refusals the worker draws as before");
}

/** A panic and a cancelled request: a new worker has the same state. */
async function endings(browser) {
  const { files } = rows.find((row) => row.scenario === native[0].scenario);
  const found = await browser.run(
    `const [row, files] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const told = [];
     const home = new lunoid.WorkerHome({ hear: ({ phase }) => told.push(phase) });
     const machine = new lunoid.Lunoid(home);
     await machine.open(row.scenario, { files: await contents(files) });
     const { pose } = await machine.frame(row.frame);
     await machine.step(pose);
     const next = (await machine.ahead({ metres: 1 })).pose;
     await machine.step(next);
     const before = new TextDecoder().decode((await machine.state()).values);
     const panic = await home.fail().then(() => null, (error) => ({ name: error.name, message: error.message }));
     const after = new TextDecoder().decode((await machine.state()).values);
     const begun = performance.now();
     const stop = new AbortController();
     setTimeout(() => stop.abort(), 10);
     const cancelled = await machine.step(next, { signal: stop.signal }).then(() => null, (error) => error.name);
     const waited = performance.now() - begun;
     const then = new TextDecoder().decode((await machine.state()).values);
     const seen = await machine.frame(row.frame);
     machine.close();
     return { panic, same: before === after, still: before === then, cancelled, waited, hash: seen.hash, told, before: before.length };`,
    native[0],
    files,
  );
  record.endings = { recovery_ms: found.waited };
  expect(found.panic?.name === "EndedError" && found.panic.message.includes("this panic was asked for"), `a panic tells its message: ${found.panic?.message}`);
  expect(found.told.includes("ended"), "the page is told of the end");
  expect(found.same && found.before > 500, "after a panic a new worker has the same state");
  expect(found.cancelled === "AbortError" && found.still, "a cancelled step has driven nothing");
  expect(found.hash === native[0].hash, "the new worker draws the same picture");
}

/** What the page waits for while the worker draws: the longest time between two turns of the page. */
async function responsiveness(browser) {
  const { files } = rows.find((row) => row.scenario === native[0].scenario);
  const longest = await browser.run(
    `const [row, files] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const machine = new lunoid.Lunoid();
     await machine.open(row.scenario, { files: await contents(files) });
     let longest = 0, last = performance.now(), goes = true;
     const turn = () => { const now = performance.now(); longest = Math.max(longest, now - last); last = now; if (goes) setTimeout(turn, 0); };
     turn();
     await machine.frame(row.frame);
     goes = false;
     machine.close();
     return longest;`,
    native[0],
    files,
  );
  record.longest_block_ms = longest;
  // A shared computer may stop the page for longer; the figure stands in the record.
  expect(longest < 250, `the page is blocked for ${longest.toFixed(0)} ms at most while a frame is drawn`);
}

/** Times that are told and not held: a wire against a frame, and two workers against one. */
async function times(browser) {
  const { files } = rows.find((row) => row.scenario === native[0].scenario);
  record.times = await browser.run(
    `const [row, files] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const given = await contents(files);
     const machines = [new lunoid.Lunoid(), new lunoid.Lunoid()];
     await Promise.all(machines.map((machine) => machine.open(row.scenario, { files: given })));
     await Promise.all(machines.map((machine) => machine.frame(row.frame)));
     const frames = Array.from({ length: 16 }, (_, place) => row.frame + place);
     const drawn = async (of) => {
       const begun = performance.now();
       const hashes = await Promise.all(frames.map(async (frame, place) => (await of[place % of.length].frame(frame)).hash));
       return { milliseconds: performance.now() - begun, hashes };
     };
     const wire = async () => {
       const begun = performance.now();
       await machines[0].probe(["mu.height"], 500, { frame: row.frame });
       return performance.now() - begun;
     };
     const wires = [];
     for (let turn = 0; turn < 7; turn += 1) wires.push(await wire());
     const one = await drawn(machines.slice(0, 1));
     const two = await drawn(machines);
     machines.forEach((machine) => machine.close());
     return {
       frame_ms: one.milliseconds / frames.length,
       wire_of_a_sweep_ms: wires.sort((a, b) => a - b)[3],
       two_workers_over_one: two.milliseconds / one.milliseconds,
       same: one.hashes.join() === two.hashes.join(),
     };`,
    native[0],
    files,
  );
  expect(record.times.same, "two workers draw what one draws");
}

/** The policy of the page: another origin is refused before anything is sent. */
async function policy(browser) {
  const other = await serve(site, "/");
  const refused = await browser.run(`return fetch(values[0]).then(() => null, (error) => error.name);`, other.address);
  other.close();
  expect(refused === "TypeError" && other.asked.length === 0, "the page cannot ask another origin");
}

moduleAlone();
const host = await serve(site, PATH);
const browser = await Chosen.open();
record.browser = `${Chosen.name} ${browser.version}`;
const pictured = join(dirname(site), which);
await mkdir(pictured, { recursive: true });
try {
  await firstPage(browser, host);
  await canvas(browser);
  await pictures(browser);
  await refusals(browser);
  await endings(browser);
  await responsiveness(browser);
  await times(browser);
  await instrument(browser, host, native, expect, pictured);
  await panels(browser, host, native, expect);
  await refused(browser, host, native, expect);
  await scope(browser, host, native, expect);
  await keyboard(browser, host, native, expect);
  const messages = await browser.console();
  expect(messages.length === 0, `the console is empty: ${JSON.stringify(messages.slice(0, 3))}`);
  const elsewhere = host.asked.filter((name) => !name.startsWith(PATH));
  expect(elsewhere.length === 0, `nothing is asked for outside the folder: ${elsewhere}`);
  await policy(browser);
} finally {
  await browser.close();
  host.close();
}
record.faults = faults;
const { module: _, pictures: drawnPictures, ...rest } = record;
const kept = which === "firefox" ? { firefox: { ...rest, pictures: drawnPictures.length } } : record;
if (recordFile) await writeFile(recordFile, `${JSON.stringify(kept, null, 2)}\n`);
console.log(JSON.stringify({ ...record, pictures: record.pictures.length }, null, 1));
process.exit(faults.length ? 1 : 0);
