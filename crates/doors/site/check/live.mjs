// The page of a run in headless Chromium, while it is drawn and afterwards: node live.mjs LUNOID FOLDER
// LUNOID is the command, FOLDER a folder for the runs and for pictures of the pages.

import { spawn } from "node:child_process";
import { mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { Chromium } from "./chromium.mjs";

const [lunoid, folder] = process.argv.slice(2);
const SCENARIO = "scenarios/first-light.toml";
const SMALL = ["--sweeps", "200", "--samples", "400"];
const faults = [];

function expect(is, what) {
  console.log(`${is ? "ok  " : "FAIL"} ${what}`);
  if (!is) faults.push(what);
}

/** A run that serves its page: its address, and how to end it. */
async function run(scenario, frames, out) {
  const words = ["replay", scenario, "--frames", frames, ...SMALL, "--out", out, "--live", "--no-open", "--no-progress", "--fresh"];
  const child = spawn(lunoid, words, { stdio: ["ignore", "ignore", "pipe"] });
  const said = [];
  const address = await new Promise((resolve, reject) => {
    child.on("exit", (code) => reject(new Error(`${lunoid} replay ended with ${code}: ${said.join("\n")}`)));
    createInterface({ input: child.stderr }).on("line", (line) => {
      said.push(line);
      if (line.startsWith("live: http")) resolve(line.slice("live: ".length));
    });
  });
  const end = () => new Promise((resolve) => {
    child.removeAllListeners("exit");
    child.on("exit", resolve);
    child.kill("SIGINT");
  });
  return { address, end };
}

/** Waits in the page until `condition`, a body of a function, returns something. */
function until(browser, condition) {
  return browser.script(`
    for (let turn = 0; turn < 6000; turn++) {
      const found = (() => { ${condition} })();
      if (found) return found;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    throw new Error("waited in vain: " + document.body.innerText.slice(0, 400));`);
}

/** Clicks the middle of the picture, and waits until the page says what came of it. */
function clicked(browser) {
  return browser.script(`
    const screen = document.getElementById("screen");
    screen.scrollIntoView();
    const box = screen.getBoundingClientRect();
    const place = { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, bubbles: true };
    screen.dispatchEvent(new PointerEvent("pointermove", place));
    screen.dispatchEvent(new MouseEvent("click", place));
    const says = () => document.querySelector("#look .live [role=status]")?.textContent ?? "";
    for (let turn = 0; turn < 6000 && !/^Computed|not shown/.test(says()); turn++) await new Promise((resolve) => setTimeout(resolve, 20));
    const canvas = document.querySelector("#look .live canvas");
    const codes = canvas ? canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data : [];
    const wires = [...document.querySelectorAll("#look .live option")].map((option) => option.textContent);
    return { says: says(), colours: new Set(codes).size, wires, title: document.getElementById("look-title").textContent };`);
}

/** Pictures of the page at two widths, light and dark, for whoever looks. */
async function photographed(browser, name) {
  for (const width of [360, 1280]) {
    for (const scheme of ["light", "dark"]) {
      await browser.emulate(width, scheme);
      await writeFile(join(folder, `${name}-${width}-${scheme}.png`), await browser.screenshot());
    }
  }
}

async function followed(browser) {
  const { address, end } = await run(SCENARIO, "40..70", join(folder, "followed"));
  await browser.go(address);
  await until(browser, `return document.getElementById("frame")?.dataset.picture;`);
  await photographed(browser, "drawn");
  const first = await browser.script(`return [location.pathname, document.getElementById("frame").naturalWidth, document.getElementById("said").textContent];`);
  expect(first[0] === "/live.html" && first[1] > 0, `a picture stands while the run is drawn: ${first}`);
  await until(browser, `return location.pathname === "/index.html" && document.getElementById("look-text");`);
  expect(true, "the page of the run takes its place");
  const { says, colours, wires, title } = await clicked(browser);
  expect(says.startsWith("Computed now.") && title.startsWith("Sweep "), `a click computes a sweep: ${title}: ${says}`);
  expect(colours > 10 && wires.includes("mu.height"), `its waveforms are drawn: ${wires}`);
  await photographed(browser, "computed");
  const page = await readFile(join(folder, "followed", "index.html"), "utf8");
  expect(!page.includes("live-sweep.js"), "the folder has its own page");
  const asked = await browser.script(`return performance.getEntriesByType("resource").map(({ name }) => name);`);
  const { origin } = new URL(address);
  expect(asked.every((name) => name.startsWith(origin) || name.startsWith("data:")), "the page loads from its program alone");
  expect((await end()) === 0, "Ctrl-C ends the command");
  const log = await browser.console();
  expect(log.length === 0, `the console is empty: ${log.map(({ message }) => message)}`);
}

/** A scenario that has changed since the run. */
async function changed(browser) {
  const scenario = join(folder, "changed.toml");
  const text = await readFile(SCENARIO, "utf8");
  await writeFile(scenario, text);
  const { address, end } = await run(scenario, "60..61", join(folder, "changed"));
  await browser.go(address);
  await until(browser, `return location.pathname === "/index.html" && document.getElementById("look-text");`);
  await writeFile(scenario, text.replace(/elevation_deg = \d+/, "elevation_deg = 47"));
  const { says, wires } = await clicked(browser);
  expect(says.includes("has the hash") && says.endsWith("The sweep is not shown.") && wires.length === 0, `another frame is not shown: ${says}`);
  await end();
}

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
const browser = await Chromium.open();
try {
  await followed(browser);
  await changed(browser);
} finally {
  await browser.close();
}
if (faults.length) process.exit(1);
