// A drive of a thousand frames in the page, with six faults switched under way, drawn anew by the command: node thousand.mjs LUNOID SITE FOLDER

import { execFileSync } from "node:child_process";
import { mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { Chromium } from "./chromium.mjs";
import { serve } from "./server.mjs";

const [lunoid, site, folder] = process.argv.slice(2);
const SCENARIO = "scenarios/first-light.toml";
const FRAMES = 1000;
/** Faults by the frame from which they are there; each takes the place of the one before, and the last frames have none. */
const FAULTS = { 120: "tear", 260: "quilt", 390: "slide", 540: "mirror", 680: "stale", 810: "clip", 930: null };

const faults = [];
function expect(is, what) {
  console.log(`${is ? "ok  " : "FAIL"} ${what}`);
  if (!is) faults.push(what);
}

/** Drives in the page; answers the hashes of the frames as they were seen, and the files of the record. */
function driven(browser, files) {
  return browser.run(
    `const [scenario, files, count, faults] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const machine = new lunoid.Lunoid();
     await machine.open(scenario, { files: await contents(files), set: { "scenario.raster.sweeps": 160, "scenario.raster.samples_per_sweep": 400 } });
     const seen = [];
     for (let frame = 0; frame < count; frame += 1) {
       if (frame in faults) await machine.set(undefined, { overlays: faults[frame] === null ? [] : [faults[frame]] });
       const { pose } = await machine.ahead({ metres: 0.1, turn_deg: frame % 200 < 100 ? 0.5 : -0.5 });
       seen.push((await machine.step(pose)).hash);
     }
     const { planes } = await machine.record("thousand");
     machine.close();
     return { seen, files: Object.fromEntries(Object.entries(planes).map(([name, { values }]) => [name, new TextDecoder().decode(values)])) };`,
    SCENARIO,
    files,
    FRAMES,
    FAULTS,
  );
}

/** The hashes of the frames, each stretch of the record drawn by the command with the words that the record has for it. */
async function replayed(place, { stretches }) {
  const hashes = [];
  for (const { frames: [from, end], replay } of stretches) {
    const run = join(place, `run-${from}`);
    const words = replay.slice(1).map((word) => (word === "scenario.toml" ? join(place, word) : word));
    execFileSync(lunoid, [...words, "--out", run], { stdio: "ignore" });
    const { frames } = JSON.parse(await readFile(join(run, "run.json"), "utf8"));
    hashes.push(...frames.filter(({ frame }) => frame >= from && frame < end).map(({ pixels_blake3 }) => pixels_blake3));
  }
  return hashes;
}

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
const host = await serve(site, "/");
const browser = await Chromium.open();
try {
  await browser.go(`${host.address}gallery.html`);
  const rows = JSON.parse(await readFile(join(site, "scenarios.json"), "utf8")).scenarios;
  const { seen, files } = await driven(browser, rows.find(({ scenario }) => scenario === SCENARIO).files);
  for (const [name, text] of Object.entries(files)) await writeFile(join(folder, name), text);
  const record = JSON.parse(files["record.json"]);
  expect(seen.length === FRAMES && new Set(seen).size > FRAMES / 2, `${seen.length} frames are driven, ${new Set(seen).size} pictures among them`);
  expect(record.stretches.length === Object.keys(FAULTS).length + 1, `the record has ${record.stretches.length} stretches of equal settings`);
  const again = await replayed(folder, record);
  const wrong = again.filter((hash, frame) => hash !== seen[frame]).length;
  expect(again.length === FRAMES && wrong === 0, `the command draws ${again.length} frames anew: ${wrong} of them are others`);
} finally {
  await browser.close();
  host.close();
}
process.exit(faults.length ? 1 : 0);
