// The scope with many wires, far in and X-Y; the origin of its times; and panels of a machine that has nothing for them.

import { open, put, text, until } from "./instrument.mjs";

const TORN = "#scenario=scenarios%2Ffirst-light.toml&set=loader.access_ns%3A90&frame=60&sweep=500";

export async function scope(browser, host, native, expect) {
  await open(browser, host, `${TORN}&wires=tg.height`);
  await crowded(browser, expect);
  await far(browser, expect);
  await origin(browser, expect);
  await sharp(browser, expect);
  await empty(browser, expect);
}

const size = (browser) => browser.run(`const { clientWidth, clientHeight } = document.getElementById("scope"); return [clientWidth, clientHeight];`);
const key = (browser, name, isShift = false) => browser.run(`document.getElementById("scope").dispatchEvent(new KeyboardEvent("keydown", { key: values[0], shiftKey: values[1], bubbles: true }));`, name, isShift);

/** More wires than there is room for: every panel keeps its height, and the page says how many it shows. */
async function crowded(browser, expect) {
  const [, before] = await size(browser);
  await put(browser, "wires", "tg.*,mu.*,sc.*,dpp.*,sweep.*");
  const [, after] = await size(browser);
  expect(after >= before && after > 16 * 22 + 84, `the scope grows with its wires: ${before}, ${after} pixels`);
  await key(browser, "PageDown");
  await key(browser, "PageDown", true);
  const said = await text(browser, "values");
  const rows = await browser.run(`return document.querySelectorAll("#value-rows tbody tr").length;`);
  expect(/^24 of \d+ wires are shown: at most 8 analog and 16 digital ones\. Cursor A at sample \d+/.test(said) && said.length < 240, `the words stay short: ${said}`);
  expect(rows === 9, `a row for each analog wire and one for the place: ${rows}`);
}

/** As far in as it goes: ticks are whole samples, each once, and the curve reaches both edges. */
async function far(browser, expect) {
  await put(browser, "wires", "mu.height,sc.gate");
  const ticks = () => browser.run(`return document.getElementById("scope").dataset.ticks.split(" ").map(Number);`);
  const whole = await ticks();
  expect(whole[0] === 0 && whole.length >= 3 && whole.length <= 7, `ticks over the whole sweep: ${whole}`);
  for (let turn = 0; turn < 60; turn += 1) await key(browser, "+");
  const near = await ticks();
  expect(near.length >= 1 && near.length <= 7 && near.every((tick, at) => Number.isInteger(tick) && (at === 0 || tick === near[at - 1] + 1)), `ticks far in are samples, each once: ${near}`);
  const edges = await browser.run(`
    const canvas = document.getElementById("scope");
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const isBlue = (x) => { for (let y = 16; y < canvas.height - 60; y += 1) { const [red, green, blue, alpha] = copy.getImageData(x, y, 1, 1).data; if (alpha > 99 && blue > 150 && red < 90) return true; } return false; };
    return [92, canvas.width >> 1, canvas.width - 12].map(isBlue);`);
  expect(edges.every(Boolean), `the curve goes from edge to edge between two samples: ${edges}`);
  await put(browser, "across", "xy");
  const one = await text(browser, "values");
  expect(one.startsWith("X-Y draws the second analog wire over the first"), `X-Y with one wire says what it needs: ${one}`);
  await put(browser, "across", "sample");
}

/** A load of the table is at the instant at which the wire of its register changes on the scope. */
async function origin(browser, expect) {
  await put(browser, "wires", "tg.red.yfirst");
  const apart = await browser.run(`
    const { contents } = await import(new URL("shipped.js", document.baseURI));
    const machine = new lunoid.Lunoid();
    await machine.open("scenarios/first-light.toml", { files: await contents(["scenarios/first-light.toml"]), set: { "loader.access_ns": 90 } });
    const { planes } = await machine.probe(["tg.red.yfirst"], 500, { frame: 60 });
    machine.close();
    const times = [...planes["times:tg.red.yfirst"].values];
    const rows = [...document.querySelectorAll("#events tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent));
    const loads = rows.filter(([, , , event, what]) => event === "load" && what.startsWith("red, y-first"));
    return loads.map(([time, sample]) => Math.min(...times.map((at) => Math.abs(at - Number(sample)))));`);
  expect(apart.length > 3 && apart.every((samples) => samples < 0.1), `events and wires have one origin: loads lie ${Math.max(...apart).toFixed(2)} samples from a change of their register at most, of ${apart.length}`);
}

/** On a screen with more dots a pixel, places and heights are the same. */
async function sharp(browser, expect) {
  await put(browser, "trigger-on", "rising tg.height 12");
  const mark = () => browser.run(`return Number(document.getElementById("scope").dataset.mark);`);
  const before = [await mark(), ...(await size(browser))];
  const after = await browser.run(`
    Object.defineProperty(globalThis, "devicePixelRatio", { value: 3, configurable: true });
    const canvas = document.getElementById("scope");
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "+", bubbles: true }));
    document.getElementById("whole").click();
    const found = [Number(canvas.dataset.mark), canvas.clientWidth, canvas.clientHeight, canvas.width / canvas.clientWidth];
    delete globalThis.devicePixelRatio;
    return found;`);
  expect(after.slice(0, 3).join() === before.join() && Math.abs(after[3] - 3) < 0.01, `zoomed by the browser, all stays in its place: ${before}; ${after}`);
  await put(browser, "trigger-on", "");
}

async function empty(browser, expect) {
  await browser.run(`document.getElementById("diagram-panel").open = true;`);
  await put(browser, "machine", "exact");
  await until(browser, `document.getElementById("sheet").hidden`, 10);
  const said = await text(browser, "block");
  const isHidden = await browser.run(`return document.getElementById("sheet").hidden;`);
  expect(said.startsWith("exact has no blocks") && isHidden, `a diagram without blocks says so: ${said}`);
  const [left, machine] = await browser.run(`return [document.getElementById("refused").textContent, document.getElementById("machine").value];`);
  expect(machine === "exact" && left.startsWith("set=loader.access_ns:90: "), `a setting that another machine does not have is left out, and listed: ${left}`);
  await put(browser, "machine", "pra-parts");
  await put(browser, "machine", "panels");
  const back = await browser.run(`return document.getElementById("machine").value;`);
  expect(back === "pra-parts", `a machine that cannot draw the scenario goes back to the one before: ${back}`);
  await put(browser, "machine", "");
  await browser.run(`document.getElementById("diagram-panel").open = false;`);
}
