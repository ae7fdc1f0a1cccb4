// The books of a site as a reader uses them: node books.mjs SITE RECORD [chromium|firefox|--write-stills]
// Links, search, widths, and every living figure against its still. With --write-stills the stills are made instead, in docs/pictures/living.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { Chromium } from "./chromium.mjs";
import { Firefox } from "./firefox.mjs";
import { links, pages } from "./links.mjs";
import { serve } from "./server.mjs";
import { tasks } from "./tasks.mjs";

const [site, recordFile, which = "chromium"] = process.argv.slice(2);
const writes = which === "--write-stills";
const PATH = "/some/where/";
const ROOT = new URL("../../../../", import.meta.url).pathname;
const STILLS = join(ROOT, "docs/pictures/living");
const WAVES = join(ROOT, "crates/doors/site/books/figures.json");
const FIGURES = 16;
const shots = join(dirname(site), `books-${which}`);
const waves = writes ? {} : JSON.parse(await readFile(WAVES, "utf8"));
const record = { figures: [] };
const faults = [];

function expect(is, what) {
  console.log(`${is ? "ok  " : "FAIL"} ${what}`);
  if (!is) faults.push(what);
}

/** Functions for a page: one figure's state, waited for; its canvas as bytes; its still as bytes. */
const HELP = `
  const figure = document.querySelectorAll("figure.living")[values[0]];
  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  const settled = async () => {
    for (let turn = 0; turn < 3000; turn += 1) {
      await pause(40);
      if (figure.dataset.state === "runs") return;
    }
    throw new Error("the figure still draws after two minutes");
  };
  const hex = async (parts) => {
    const bytes = new Uint8Array(await new Blob(parts).arrayBuffer());
    return [...new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  };
  const hash = (planes) => hex(Object.keys(planes).sort().map((name) => planes[name].values));
  const drawn = async (image) => {
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext("2d").drawImage(image, 0, 0);
    return hex([canvas.getContext("2d").getImageData(0, 0, image.width, image.height).data]);
  };`;

/** Runs figure `at` of the page that is open. */
function run(browser, at) {
  return browser.script(
    `${HELP}
     const begun = performance.now();
     let planes = null;
     figure.addEventListener("shown", ({ detail }) => { planes = detail; });
     figure.scrollIntoView();
     figure.querySelector("button").click();
     await settled();
     const milliseconds = performance.now() - begun;
     const says = figure.querySelector(".state").textContent;
     if (!planes) return { says };
     const canvas = figure.querySelector("canvas");
     const still = figure.querySelector("img");
     const whole = new OffscreenCanvas(canvas.width, canvas.height);
     const context = whole.getContext("2d");
     context.fillStyle = "#fff";
     context.fillRect(0, 0, canvas.width, canvas.height);
     context.drawImage(canvas, 0, 0);
     const reader = new FileReader();
     reader.readAsDataURL(await whole.convertToBlob());
     await new Promise((resolve) => { reader.onload = resolve; });
     const result = {
       milliseconds, says, kind: JSON.parse(figure.dataset.runs).kind, values: await hash(planes), canvas: await drawn(canvas),
       still: await drawn(still), isHidden: getComputedStyle(still).display === "none", png: reader.result.split(",")[1], sliders: [],
     };
     for (const slider of figure.querySelectorAll("input")) {
       const was = slider.value;
       slider.value = Math.abs(slider.max - was) > Math.abs(slider.min - was) ? slider.max : slider.min;
       slider.dispatchEvent(new Event("input"));
       await settled();
       result.sliders.push({ to: slider.value, says: figure.querySelector(".state").textContent, values: await hash(planes) });
       slider.value = was;
       slider.dispatchEvent(new Event("input"));
       await settled();
     }
     result.again = await hash(planes);
     figure.querySelector("button").click();
     result.isBack = getComputedStyle(still).display !== "none" && !figure.querySelector("canvas");
     return result;`,
    at,
  );
}

async function figure(browser, page, { at, src, caption }) {
  const name = basename(src, ".png");
  const found = await run(browser, at);
  if (found.values === undefined) return expect(false, `${name} of ${page}: ${found.says}`);
  const isWave = found.kind === "wave";
  if (writes) {
    await writeFile(join(STILLS, `${name}.png`), Buffer.from(found.png, "base64"));
    if (isWave) waves[name] = found.values;
  } else if (isWave) {
    expect(waves[name] === found.values, `${name} of ${page}: the waves are those of the still`);
  } else {
    expect(found.canvas === found.still, `${name} of ${page}: the picture is the still, pixel by pixel`);
  }
  expect(found.isHidden && found.isBack, `${name}: the still goes and comes again`);
  expect(found.again === found.values, `${name}: sliders moved back bring the first state back`);
  for (const { to, says, values } of found.sliders) expect(values !== found.values, `${name}: a slider at ${to} changes what is seen: ${says}`);
  expect(found.sliders.length > 0 && caption.length > 40, `${name} has a slider and a caption`);
  record.figures.push({ name, page, kind: found.kind, milliseconds: Math.round(found.milliseconds) });
}

/** All figures of a page: nothing of the module is there before one runs. */
async function living(browser, host, page) {
  await browser.go(host.address + page);
  const list = await browser.script(`
    return [...document.querySelectorAll("figure.living")].map((figure, at) => ({
      at, src: figure.querySelector("img").src, caption: figure.querySelector("figcaption").textContent.trim(), buttons: figure.querySelectorAll("button").length,
    }));`);
  const loaded = () => host.asked.filter((name) => name.endsWith(".wasm")).length;
  const before = loaded();
  for (const row of list) {
    if (row.at === 0) expect(before === loaded(), `${page} loads no module before a figure runs`);
    await figure(browser, page, row);
  }
}

/** On paper the still stands, though the figure runs; and without scripts, since it is in the page itself. */
async function onPaper(browser, host, page) {
  await browser.go(host.address + page);
  await browser.script(`${HELP} figure.querySelector("button").click(); await settled();`, 0);
  await browser.media("print");
  const seen = await browser.script(`${HELP} return ["img", "canvas", "button", "input"].filter((name) => figure.querySelector(name).checkVisibility());`, 0);
  await browser.media("screen");
  expect(seen.join() === "img", `on paper a figure that runs shows its still alone: ${seen}`);
}

/** Every page at two widths, and those with figures in the dark as well: nothing sticks out. Those with figures are kept as pictures. */
async function widths(browser, host, list, kept) {
  await mkdir(shots, { recursive: true });
  for (const width of [360, 1400]) {
    for (const scheme of ["light", "dark"]) {
      await browser.emulate(width, scheme);
      for (const page of scheme === "light" ? list : kept) {
        await browser.go(host.address + page);
        const out = await browser.script(`
          document.querySelector("figure.living")?.scrollIntoView({ behavior: "instant" });
          return document.documentElement.scrollWidth - document.documentElement.clientWidth;`);
        if (out > 0) expect(false, `${page} at ${width} pixels, ${scheme}: ${out} pixels stick out`);
        if (kept.has(page)) await writeFile(join(shots, `${page.replaceAll("/", "-")}-${width}-${scheme}.png`), await browser.screenshot());
      }
    }
  }
}

/** The search of the books, by their own field. */
async function search(browser, host) {
  await browser.go(`${host.address}book/index.html`);
  const told = await browser.script(`
    const field = document.getElementById("mkdocs-search-query");
    const results = document.getElementById("mkdocs-search-results");
    for (let turn = 0; turn < 200 && !results.querySelector("a"); turn += 1) {
      field.value = "late word";
      field.dispatchEvent(new KeyboardEvent("keyup"));
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    return [...results.querySelectorAll("a")].map(({ href }) => href);`);
  record.found = told.length;
  expect(told.some((address) => address.includes("/book/trigger-and-trace.html")), `the search finds the late word: ${told.slice(0, 3)}`);
  const status = await browser.script(`return (await fetch(values[0])).status;`, told[0] ?? "");
  expect(status === 200, "what the search finds is there");
}

const told = await links(site);
Object.assign(record, { pages: told.pages, links: told.links });
expect(told.faults.length === 0, `${told.links} links of ${told.pages} pages live: ${told.faults.slice(0, 5).join("; ")}`);
const host = await serve(site, PATH);
const browser = await (which === "firefox" ? Firefox : Chromium).open();
const list = (await pages(site)).filter((page) => page.startsWith("book/"));
const texts = await Promise.all(list.map((page) => readFile(join(site, page), "utf8")));
const stills = texts.map((text) => [...text.matchAll(/<figure class="living"[^>]*>\s*<p><img /g)].length).reduce((sum, count) => sum + count);
const withFigures = list.filter((_, at) => texts[at].includes('<figure class="living"'));
try {
  await browser.emulate(1100, "light");
  for (const page of withFigures) await living(browser, host, page);
  // WebDriver BiDi shows no page as on paper.
  if (browser.media) await onPaper(browser, host, "book/lessons/occlusion.html");
  expect(record.figures.length >= FIGURES, `${record.figures.length} figures run`);
  expect(stills === record.figures.length, "every figure has its still in the page itself");
  if (!writes) {
    await tasks(browser, host, list.filter((_, at) => texts[at].includes('<section class="task"')), expect, record);
    await search(browser, host);
    await widths(browser, host, list, new Set([...withFigures, "book/index.html"]));
  }
  const said = (await browser.console()).filter(({ level }) => level !== "INFO");
  expect(said.length === 0, `the console is empty: ${JSON.stringify(said.slice(0, 3))}`);
  expect(host.asked.every((name) => name.startsWith(PATH)), "nothing is asked for outside the folder");
} finally {
  await browser.close();
  host.close();
}
if (writes) await writeFile(WAVES, `${JSON.stringify(waves, null, 2)}\n`);
else await writeFile(recordFile, `${JSON.stringify({ [which === "firefox" ? "firefox_books" : "books"]: record }, null, 2)}\n`);
console.log(`${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
