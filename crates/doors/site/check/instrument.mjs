// The instrument as a reader uses it: links, pixels, faults, driving, files, widths.

import { writeFile } from "node:fs/promises";
import { join } from "node:path";

const LATE = "#scenario=scenarios%2Ffirst-light.toml&set=loader.access_ns%3A90&frame=60&colour=red";

/** Waits until the page has drawn what it was asked for. */
export async function drawn(browser) {
  for (let turn = 0; turn < 600; turn += 1) {
    if (await browser.run(`return document.body.dataset.busy === "false" && document.getElementById("state").textContent !== "The machine draws.";`)) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error("the page still draws after a minute");
}

/** Opens the instrument anew at a fragment, and waits until it stands. */
export async function open(browser, host, fragment) {
  await browser.go("about:blank");
  await browser.go(`${host.address}instrument.html${fragment}`);
  await drawn(browser);
}

export const hash = (browser) => browser.run(`return document.getElementById("tube").dataset.hash;`);
export const text = (browser, id) => browser.run(`return document.getElementById(values[0]).textContent;`, id);

/** Sets a field as a reader does, and waits. */
async function put(browser, id, value) {
  await browser.run(`const field = document.getElementById(values[0]); field.value = values[1]; field.dispatchEvent(new Event("change", { bubbles: true }));`, id, value);
  await drawn(browser);
}

async function press(browser, id) {
  await browser.run(`document.getElementById(values[0]).click();`, id);
  await drawn(browser);
}

export async function instrument(browser, host, native, expect, folder) {
  const [healed, torn] = native;
  await open(browser, host, LATE);
  expect((await hash(browser)) === torn.hash, "a link opens the torn mountain");
  expect((await text(browser, "refused")).includes("colour=red"), "what a link asks for and nobody knows is listed");
  await put(browser, "zoom", "1");
  await browser.run(`
    const tube = document.getElementById("tube");
    const { left, top, width, height } = tube.getBoundingClientRect();
    tube.dispatchEvent(new MouseEvent("click", { clientX: left + 500.5 / 1000 * width, clientY: top + 200.5 / 575 * height }));`);
  await drawn(browser);
  const cause = await text(browser, "pixel");
  expect(cause.includes("Column 500, line 200: late word: tg.green, corner 237, 116, 41 ns"), `a click tells the late word: ${cause}`);
  const scope = await browser.run(`return document.getElementById("scope").dataset.sweep;`);
  expect(scope === "500", `the sweep of the pixel is on the scope: ${scope}`);
  const [late, head] = [await text(browser, "late"), await text(browser, "events-head")];
  expect(/^\d+ events, [1-9]\d* of them late/.test(late) && head === "Digital events of sweep 500: ", `late events are counted: ${head}${late}`);
  const link = await browser.run(`return document.getElementById("link").href;`);
  await press(browser, "heal");
  expect((await hash(browser)) === healed.hash, "with everything taken back the mountain is healed");
  await open(browser, host, new URL(link).hash);
  expect((await hash(browser)) === torn.hash && (await text(browser, "pixel")).includes("tg.green"), "the page's link brings picture and pixel back");
  await browser.run(`document.querySelector('#faults input[value="tear"]').click();`);
  await drawn(browser);
  expect((await hash(browser)) !== healed.hash, "a fault of the board shows");
  await press(browser, "heal");
  await put(browser, "sweep", "440");
  const unchosen = await text(browser, "pixel");
  expect(unchosen.startsWith("Click a pixel") && (await text(browser, "explained")) === "", `with no pixel chosen none is explained: ${unchosen}`);
  await put(browser, "machine", "exact");
  const standing = await browser.run(`return { sweep: document.getElementById("scope").dataset.sweep, late: document.getElementById("late").textContent };`);
  expect(standing.sweep === "" && standing.late === "", `a machine without sweeps leaves no waveform and no event: ${JSON.stringify(standing)}`);
  await put(browser, "machine", "");
  await put(browser, "wires", "mu.*,sc.gate,tg.red.hold");
  expect((await hash(browser)) === healed.hash, "the page goes on after that");
  await driven(browser, expect);
  await ownFile(browser, expect);
  await widths(browser, expect, folder);
}

async function driven(browser, expect) {
  const found = await browser.run(`
    document.getElementById("drive").click();
    while (!/^([3-9]|\\d\\d) frames/.test(document.getElementById("driven").textContent)) await new Promise((resolve) => setTimeout(resolve, 50));
    document.getElementById("drive").click();
    return { says: document.getElementById("frame-says").textContent, saves: !document.getElementById("record").disabled };`);
  await drawn(browser);
  expect(found.saves, `what was driven can be saved: ${JSON.stringify(found)}`);
}

async function ownFile(browser, expect) {
  const say = await browser.run(`
    const text = await (await fetch("scenarios/first-light.toml")).text();
    const transfer = new DataTransfer();
    transfer.items.add(new File([text.replace("First light", "A file of mine")], "mine.toml"));
    const field = document.getElementById("files");
    field.files = transfer.files;
    field.dispatchEvent(new Event("change"));
    await new Promise((resolve) => setTimeout(resolve, 500));
    return 1;`);
  await drawn(browser);
  expect(say === 1 && (await text(browser, "state")).includes("A file of mine"), `a file of the reader is opened: ${await text(browser, "state")}`);
}

/** Nothing sticks out at any width, light or dark; every control has a name. */
async function widths(browser, expect, folder) {
  for (const width of [360, 1400]) {
    for (const scheme of ["light", "dark"]) {
      await browser.emulate(width, scheme);
      const out = await browser.run(`return document.documentElement.scrollWidth - document.documentElement.clientWidth;`);
      expect(out <= 0, `${width} pixels, ${scheme}: nothing sticks out (${out})`);
      await writeFile(join(folder, `instrument-${width}-${scheme}.png`), await browser.screenshot());
    }
  }
  const nameless = await browser.run(`
    const fields = [...document.querySelectorAll("button, input, select, canvas")];
    return fields.filter((field) => !(field.labels?.length || field.getAttribute("aria-label") || field.textContent.trim())).map((field) => field.id || field.outerHTML);`);
  expect(nameless.length === 0, `every control has a name: ${nameless}`);
}

/** Waits until `body`, a condition in the page, holds; answers whether it came to. */
async function until(browser, body, seconds = 60) {
  for (let turn = 0; turn < 10 * seconds; turn += 1) {
    if (await browser.run(`return Boolean(${body});`)) return true;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  return false;
}

/** Clicks a place of an element, in shares of its width and height. */
async function click(browser, id, across, down) {
  await browser.run(
    `const [id, across, down] = values;
     const element = document.getElementById(id);
     const { left, top, width, height } = element.getBoundingClientRect();
     element.dispatchEvent(new MouseEvent("click", { clientX: left + across * width, clientY: top + down * height, bubbles: true }));`,
    id,
    across,
    down,
  );
  await drawn(browser);
}

export { click, press, put, until };
