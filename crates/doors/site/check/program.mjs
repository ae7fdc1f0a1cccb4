// The page of a program in headless Chromium: node program.mjs LUNOID NATIVE FOLDER
// LUNOID is the command, NATIVE the file of crates/doors/browser/examples/native.rs on cases.json, FOLDER a folder for what is driven.

import { execFileSync, spawn } from "node:child_process";
import { readFile, rm } from "node:fs/promises";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { Chromium } from "./chromium.mjs";
import { drawn, hash, open, text, until } from "./instrument.mjs";

const [lunoid, nativeFile, folder] = process.argv.slice(2);
const [healed, torn] = JSON.parse(await readFile(nativeFile, "utf8"));
const SCENARIO = "scenarios/first-light.toml";
const faults = [];

function expect(is, what) {
  console.log(`${is ? "ok  " : "FAIL"} ${what}`);
  if (!is) faults.push(what);
}

/** A program that serves its page: its address, and how to end it. */
async function program(...words) {
  const child = spawn(lunoid, ["drive", SCENARIO, "--no-open", ...words], { stdio: ["ignore", "pipe", "inherit"] });
  const address = await new Promise((resolve, reject) => {
    child.on("exit", (code) => reject(new Error(`${lunoid} drive ended with ${code}`)));
    createInterface({ input: child.stdout }).once("line", resolve);
  });
  return { address, end: () => child.kill("SIGKILL") };
}

async function pictures(browser, { origin }) {
  await browser.go(`${origin}/instrument.html#frame=60`);
  await drawn(browser);
  expect((await hash(browser)) === healed.hash, `the program draws the healed mountain: ${await text(browser, "state")}`);
  await browser.go("about:blank");
  await browser.go(`${origin}/instrument.html#frame=60&set=loader.access_ns%3A90&column=500&line=200`);
  await drawn(browser);
  expect((await hash(browser)) === torn.hash, "a setting of the page reaches the program");
  expect((await text(browser, "pixel")).includes("late word: tg.green"), `a pixel tells its cause: ${await text(browser, "pixel")}`);
  const asked = await browser.run(`return performance.getEntriesByType("resource").map(({ name }) => name);`);
  expect(asked.every((name) => name.startsWith(origin) && !name.endsWith(".wasm")), "the page loads from its program alone, and no module");
}

/** Frames driven from the page's own buttons, recorded, and drawn again by the command. */
async function driven(browser, { origin }) {
  await browser.go("about:blank");
  await browser.go(`${origin}/instrument.html#frame=0`);
  await drawn(browser);
  const seen = await browser.run(`
    const seen = [];
    const tube = document.getElementById("tube");
    const says = document.getElementById("driven");
    document.getElementById("drive").click();
    while (!/^[5-9] frames|^\\d\\d/.test(says.textContent)) await new Promise((resolve) => setTimeout(resolve, 5));
    document.getElementById("drive").click();
    await new Promise((resolve) => setTimeout(resolve, 1000));
    document.getElementById("record").click();
    await new Promise((resolve) => setTimeout(resolve, 1000));
    return { hash: tube.dataset.hash, says: document.getElementById("state").textContent, driven: says.textContent };`);
  const place = join(folder, "record", "driven");
  expect(seen.says.includes(place), `the page says where the record lies: ${seen.says}`);
  const run = join(folder, "replayed");
  await rm(run, { recursive: true, force: true });
  execFileSync(lunoid, ["replay", join(place, "scenario.toml"), "--out", run], { stdio: "ignore" });
  const { frames } = JSON.parse(await readFile(join(run, "run.json"), "utf8"));
  expect(frames.length >= 5 && `${frames.length} frames driven` === seen.driven, `as many frames are drawn again: ${frames.length}`);
  expect(frames.at(-1).pixels_blake3 === seen.hash, "the last frame on the screen is that of the replay");
}

/** Pictures a second in the page, every panel closed, against `lunoid replay` of the same frames. */
async function rates(browser, { origin }) {
  await browser.go("about:blank");
  await browser.go(`${origin}/instrument.html#frame=0&wires=`);
  await drawn(browser);
  const [frames, milliseconds] = await browser.run(`
    const machine = new lunoid.Lunoid(new lunoid.SocketHome());
    const { frames } = await machine.open(values[0]);
    await machine.frame(0);
    const begun = performance.now();
    for (let frame = 0; frame < frames; frame += 1) await machine.frame(frame);
    const milliseconds = performance.now() - begun;
    machine.close();
    return [frames, milliseconds];`, SCENARIO);
  const run = join(folder, "rate");
  await rm(run, { recursive: true, force: true });
  const begun = performance.now();
  execFileSync(lunoid, ["replay", SCENARIO, "--out", run], { stdio: "ignore" });
  const replayed = performance.now() - begun;
  console.log(`     ${frames} frames through the socket: ${(milliseconds / frames).toFixed(1)} ms each; replay: ${(replayed / frames).toFixed(1)} ms each`);
}

async function strangers({ address, origin }) {
  const other = await Chromium.open();
  await other.go(address);
  const said = await other.ask("GET", "/source");
  expect(said.includes("used by another browser"), "another browser is refused though it has the address");
  await other.go(`${origin}/instrument.html`);
  expect((await other.ask("GET", "/source")).includes("not admitted"), "a browser without a token is refused");
  await other.close();
}

/** A page more than the program serves is told so, and comes in when another is closed. */
async function full(browser, { origin }) {
  await open(browser, { address: `${origin}/` }, "#frame=0");
  await browser.run(`
    window.more = Array.from({ length: 7 }, () => new lunoid.Lunoid(new lunoid.SocketHome()));
    await Promise.all(window.more.map((machine) => machine.hello()));`);
  const said = await browser.run(`
    const ninth = new lunoid.Lunoid(new lunoid.SocketHome());
    const said = await ninth.hello().then(() => "", (error) => error.message);
    window.more.forEach((machine) => machine.close());
    for (let turn = 0; turn < 100; turn += 1) {
      const again = await ninth.hello().then(() => true, () => false);
      if (again) return [said, true];
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return [said, false];`);
  expect(said[0].includes("8 pages are open") && said[1], `the ninth page is told that eight are open, and comes in when one is closed: ${said}`);
  await browser.console();
}

/** What the page offers is what a program does. */
async function offers(browser, { origin }) {
  await open(browser, { address: `${origin}/` }, "#frame=0");
  const shown = await browser.run(`return getComputedStyle(document.getElementById("own-files")).display;`);
  expect(shown === "none", `files are not offered, since the program takes none: ${shown}`);
}

/** The program is killed while the page plays: the page stops and says so, and the number of the frame is that of the picture. */
async function ended(browser, served) {
  await open(browser, { address: `${served.origin}/` }, "#frame=3");
  await browser.run(`document.getElementById("play").click();`);
  await until(browser, `document.getElementById("frame-says").textContent > "frame 5"`);
  served.end();
  expect(await until(browser, `document.getElementById("play").getAttribute("aria-pressed") === "false"`), "playing stops when the program is killed");
  await drawn(browser);
  const before = await text(browser, "frame-says");
  await browser.run(`document.getElementById("on").click();`);
  await drawn(browser);
  const [said, after] = [await text(browser, "state"), await text(browser, "frame-says")];
  expect(said.includes("the program has ended"), `the page says that its program has ended: ${said}`);
  expect(before === after, `the frame stays that of the picture: ${before}, ${after}`);
}

await rm(join(folder, "record"), { recursive: true, force: true });
const served = await program("--record", join(folder, "record"));
served.origin = new URL(served.address).origin;
const browser = await Chromium.open();
try {
  await browser.go(served.address);
  await drawn(browser);
  expect((await browser.run("return location.pathname;")) === "/instrument.html", "the address opens the instrument");
  await pictures(browser, served);
  await driven(browser, served);
  await rates(browser, served);
  await strangers(served);
  const console = await browser.console();
  expect(console.length === 0, `the console is empty: ${JSON.stringify(console)}`);
  await offers(browser, served);
  await full(browser, served);
  await ended(browser, served);
} finally {
  await browser.close();
  served.end();
}
if (faults.length) {
  console.error(`${faults.length} faults`);
  process.exit(1);
}
