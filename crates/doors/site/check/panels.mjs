// The panels of the instrument: trigger, bar of time, slow motion, block diagram, effects, pad and gamepad.

import { click, drawn, hash, open, press, put, text, until } from "./instrument.mjs";

const TORN = "#scenario=scenarios%2Ffirst-light.toml&set=loader.access_ns%3A90&frame=60&wires=tg.height";
/** What `lunoid trigger scenarios/first-light.toml --set loader.access_ns=90 --on 'rising tg.height 12' --frames 60..61` finds first. */
const FIRST = { sweep: 0, sample: 907, instant: 906.9878588177583 };

/** In the page: the bytes of a canvas, from a copy, since Chromium warns of a canvas that is read twice. */
const DATA = `((id) => {
  const canvas = document.getElementById(id);
  const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, canvas.width, canvas.height).data;
})`;

export async function panels(browser, host, native, expect) {
  await open(browser, host, TORN);
  await trigger(browser, expect);
  await effects(browser, native, expect);
  await slowMotion(browser, native, expect);
  await diagram(browser, expect);
  await compared(browser, native, expect);
  await drives(browser, expect);
  await hands(browser, expect);
}

/** The state of the scope: sweep, instant of the trigger, and column of its mark. */
const scope = (browser) => browser.run(`const { sweep, trigger, mark } = document.getElementById("scope").dataset; return { sweep: Number(sweep), trigger: trigger === "" ? null : Number(trigger), mark: Number(mark) };`);

async function trigger(browser, expect) {
  await put(browser, "sweep", "500");
  await put(browser, "trigger-on", "rising tg.height 12");
  const found = await scope(browser);
  expect(found.sweep === FIRST.sweep && found.trigger === FIRST.instant, `the trigger is the native one, to the bit: ${JSON.stringify(found)}`);
  const red = await browser.run(
    `const [x] = values;
     const data = ${DATA}("scope");
     const row = 4 * 40 * document.getElementById("scope").width;
     return [-1, 0, 1].map((by) => row + 4 * (Math.round(x) + by)).some((at) => data[at] > 150 && data[at + 1] < 120 && data[at + 3] > 60);`,
    found.mark,
  );
  expect(red, "the mark T stands at the instant");
  // The step of the mark across the canvas is that of the samples: one sample beside would be seen.
  const [left, width] = [88, await browser.run(`return document.getElementById("scope").width - 88 - 8;`)];
  const samples = ((found.mark - left) / width) * 999;
  expect(Math.abs(samples - FIRST.instant) < 0.01, `the mark lies at sample ${samples.toFixed(3)}, not one beside`);
  await press(browser, "trigger-next");
  await until(browser, `document.getElementById("scope").dataset.trigger !== "${FIRST.instant}"`);
  const second = await scope(browser);
  expect(second.trigger !== null && (second.sweep > found.sweep || second.trigger > found.trigger), `the next place is behind the first: ${JSON.stringify(second)}`);
  await put(browser, "trigger-mode", "normal");
  await put(browser, "trigger-on", "rising tg.height 1e6");
  expect((await text(browser, "trigger-says")).includes("waiting"), `a normal trigger waits: ${await text(browser, "trigger-says")}`);
  expect((await scope(browser)).sweep === second.sweep, "the trace stands meanwhile");
  await put(browser, "trigger-mode", "automatic");
  expect((await scope(browser)).trigger === null && (await text(browser, "trigger-says")).includes("sweep of the cursor"), "an automatic one shows the sweep of the cursor");
  await put(browser, "trigger-mode", "single");
  await put(browser, "trigger-on", "rising tg.height 12");
  await press(browser, "on");
  const single = await scope(browser);
  const { trigger: again } = await scope(browser);
  expect(single.trigger === FIRST.instant && again === FIRST.instant, `a single trigger stands when the frame goes on: ${JSON.stringify(single)}`);
  await put(browser, "trigger-on", "rising tg.hight 12");
  expect((await text(browser, "state")).includes("tg.height"), `a condition that is none is told: ${await text(browser, "state")}`);
  await put(browser, "trigger-on", "");
  await put(browser, "trigger-mode", "automatic");
  await press(browser, "back");
}

/** From a late word to its pixels, and from one of them back to the word. */
async function effects(browser, native, expect) {
  await put(browser, "sweep", "500");
  await put(browser, "zoom", "1");
  const said = `document.getElementById("effect").textContent.includes("changed")`;
  const late = await browser.run(`
    document.querySelector("#events").closest("details").open = true;
    document.querySelector("#events tr.late button").click();
    return document.querySelector("#events tr.late").textContent;`);
  expect(await until(browser, said), `a late word tells its pixels: ${late}`);
  await click(browser, "tube", 500.5 / 1000, 200.5 / 575);
  const word = JSON.parse(await browser.run(`return document.getElementById("word").dataset.late;`));
  await browser.run(`document.getElementById("effect").textContent = ""; document.getElementById("word").click();`);
  expect(await until(browser, said), `the word of a pixel has its pixels: ${JSON.stringify(word)}`);
  const found = await browser.run(`return { says: document.getElementById("effect").textContent, marked: Number(document.getElementById("tube").dataset.changed) };`);
  const [, column, line] = found.says.match(/at column (\d+), line (\d+)/) ?? [];
  expect(found.marked > 0 && found.says.includes(`changed ${found.marked} pixels`), `they are marked: ${found.says}`);
  await click(browser, "tube", (Number(column) + 0.5) / 1000, (Number(line) + 0.5) / 575);
  const told = await text(browser, "explained");
  expect(told.includes(`crossing ${word.crossing}`), `one of them names the word: ${told.split("\n").filter((row) => row.includes("late")).join(" ")}`);
  expect((await hash(browser)) === native[1].hash, "the picture is the same as before");
}

async function slowMotion(browser, native, expect) {
  await put(browser, "rate", "100");
  await browser.run(`document.getElementById("slow-on").click();`);
  const built = `Number(document.getElementById("tube").dataset.built)`;
  const on = await browser.run(`
    for (let turn = 0; turn < 3000 && ${built} <= 40; turn += 1) await new Promise(requestAnimationFrame);
    document.getElementById("slow-pause").click();
    return ${built};`);
  await drawn(browser);
  expect(on > 40 && on < 900, `the picture builds up: ${on}`);
  const half = await browser.run(`
    return { built: ${built}, sweep: Number(document.getElementById("sweep").value) };`);
  expect(half.sweep === half.built || half.sweep === half.built - 1, `the cursor is at the sweep that is written: ${JSON.stringify(half)}`);
  await press(browser, "sweep-on");
  const next = await browser.run(`return ${built};`);
  expect(next === half.built + 1, `a sweep further: ${next} after ${half.built}`);
  // Stopped in the page: the way of a question through WebDriver may take a frame.
  const back = await browser.run(
    `const [from] = values;
     document.getElementById("slow-back").click();
     for (let turn = 0; turn < 1000 && ${built} >= from; turn += 1) await new Promise(requestAnimationFrame);
     document.getElementById("slow-pause").click();
     return ${built};`,
    half.built,
  );
  await drawn(browser);
  expect(back < half.built, `backwards it goes back: ${back}`);
  const [wrong, checked] = await browser.run(
    `const [built] = values;
     const { contents } = await import(new URL("shipped.js", document.baseURI));
     const machine = new lunoid.Lunoid();
     await machine.open("scenarios/first-light.toml", { files: await contents(["scenarios/first-light.toml"]), set: { "loader.access_ns": 90 } });
     const before = (await machine.frame(59)).planes.picture.values;
     const { picture, sweep } = (await machine.frame(60, { planes: ["picture", "sweep"] })).planes;
     machine.close();
     const tube = document.getElementById("tube");
     const data = ${DATA}("tube");
     const now = Number(tube.dataset.built);
     let wrong = 0;
     picture.values.forEach((code, pixel) => { wrong += data[4 * pixel] !== (sweep.values[pixel] < now ? code : before[pixel]); });
     return [wrong, new Set(sweep.values).size];`,
    half.built,
  );
  expect(wrong === 0 && checked > 990, `the tube has the new picture up to the sweep and the old one behind: ${wrong} pixels are otherwise, by ${checked} sweeps`);
  await press(browser, "slow-leave");
  expect((await hash(browser)) === native[1].hash, "the whole picture comes back");
}

async function diagram(browser, expect) {
  await browser.run(`document.getElementById("diagram-panel").open = true;`);
  expect(await until(browser, `document.querySelectorAll("#diagram .wire").length > 20 && document.querySelector("#diagram .register.loaded")`), "the diagram has wires and loaded registers");
  await drawn(browser);
  const found = await browser.run(`
    const blocks = [...document.querySelectorAll("#diagram .block")];
    const wire = [...document.querySelectorAll("#diagram .wire")].find((label) => label.textContent.startsWith("tg.height"));
    wire.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
    blocks.find((block) => block.getAttribute("aria-label").startsWith("terrain generator")).dispatchEvent(new MouseEvent("click"));
    return { blocks: blocks.length, pale: blocks.filter((block) => block.classList.contains("left-out")).map((block) => block.getAttribute("aria-label")),
      label: wire.textContent, wires: document.getElementById("wires").value, card: document.getElementById("block").textContent,
      nameless: document.querySelectorAll("#diagram [role=button]:not([aria-label])").length };`);
  await drawn(browser);
  expect(found.blocks === 12 && found.pale.some((name) => name.startsWith("feature generator")), `blocks that are left out are pale: ${found.pale}`);
  expect(/^tg\.height -?\d/.test(found.label), `a wire shows its value: ${found.label}`);
  expect(found.wires.split(",").includes("tg.height") && found.nameless === 0, `Enter on a wire puts it on the scope: ${found.wires}`);
  expect(/108 analog multipliers/.test(found.card) && /amplifier\..*hardware-models|ideal\.toml/.test(found.card), `a block has its parts and numbers with their source: ${found.card.slice(0, 120)}`);
  const value = await browser.run(`
    const label = () => [...document.querySelectorAll("#diagram .wire")].find((one) => one.textContent.startsWith("tg.height")).textContent;
    const before = label();
    document.getElementById("scope").dispatchEvent(new KeyboardEvent("keydown", { key: "PageDown", bubbles: true }));
    return [before, label(), [...document.querySelectorAll("#value-rows tr")].map((row) => [...row.cells].map((cell) => cell.textContent).join(" ")).join("; ")];`);
  const shown = value[1].replace(/^tg\.height /, "");
  expect(value[0] !== value[1] && value[2].includes(`tg.height ${shown}`), `the values follow the cursor: ${value}`);
  await browser.run(`document.getElementById("diagram-panel").open = false;`);
  await drawn(browser);
}

async function compared(browser, native, expect) {
  await press(browser, "heal");
  await browser.run(`document.querySelector('#faults input[value="edge"]').click();`);
  await drawn(browser);
  const faulty = await hash(browser);
  await press(browser, "compare");
  expect(await until(browser, `document.getElementById("seen").textContent !== ""`), "a fault is compared with and without");
  const found = { predicted: await text(browser, "predicted"), seen: await text(browser, "seen") };
  expect(found.predicted.includes("A13, displaced edges") && found.predicted.includes("beyond their place"), `what it predicts stands beside: ${found.predicted}`);
  expect(/^Seen: [\d.]+ % of the pixels differ/.test(found.seen), `and what is seen: ${found.seen}`);
  await press(browser, "without");
  expect((await hash(browser)) === native[0].hash, "the picture without is the healed one");
  await press(browser, "without");
  expect((await hash(browser)) === faulty && faulty !== native[0].hash, "the picture with comes back");
  await press(browser, "heal");
  await put(browser, "machine", "sampled");
  await press(browser, "slow-on");
  expect(await until(browser, `document.getElementById("state").textContent.includes("sampled has no sweeps")`), `a generator without sweeps says so: ${await text(browser, "state")}`);
  await put(browser, "machine", "");
}

/** Waits until the last frame of a drive stands. */
async function stands(browser) {
  await until(browser, `document.getElementById("drive").dataset.runs === "false"`);
  await drawn(browser);
}

/** A drive with a fault switched under way, gone back to, and driven anew from there. */
async function drives(browser, expect) {
  const drive = async (frames) => {
    await browser.run(
      `const [frames] = values;
       const count = () => Number(document.getElementById("driven").textContent.match(/\\d+/)?.[0] ?? 0);
       document.getElementById("drive").click();
       while (count() < frames) await new Promise((resolve) => setTimeout(resolve, 20));
       document.getElementById("drive").click();`,
      frames,
    );
    await stands(browser);
  };
  await drive(3);
  await browser.run(`document.querySelector('#faults input[value="tear"]').click();`);
  await drawn(browser);
  const switched = Number((await text(browser, "driven")).match(/\d+/)[0]);
  await drive(switched + 3);
  const marks = await text(browser, "marks");
  expect(marks.includes("drive 1") && marks.includes("tear on"), `a fault that was switched under way has its time: ${marks}`);
  const end = { says: await text(browser, "frame-says"), hash: await hash(browser) };
  await browser.run(`const bar = document.getElementById("bar"); bar.focus(); bar.dispatchEvent(new KeyboardEvent("keydown", { key: "Home", bubbles: true }));`);
  await drawn(browser);
  expect((await text(browser, "frame-says")).startsWith("drive 1, frame 0 "), `any place of the drive by a key: ${await text(browser, "frame-says")}`);
  const isOn = await browser.run(`return document.querySelector('#faults input[value="tear"]').checked;`);
  expect(!isOn, "there the fault is not on yet");
  // One click on the bar: the second lane is the drive, and its second frame.
  const total = await browser.run(`return Number(document.getElementById("bar").getAttribute("aria-valuemax"));`);
  expect(total >= switched + 2, `the drive has ${total + 1} frames`);
  await browser.run(`document.getElementById("bar").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));`);
  await drawn(browser);
  await browser.run(`window.before = document.getElementById("driven").textContent; document.getElementById("turn").value = 20; document.getElementById("drive").click();`);
  expect(await until(browser, `document.getElementById("frame-says").textContent.startsWith("drive 2, frame")`), "driven on from there, a second drive begins");
  await browser.run(`document.getElementById("drive").click();`);
  await stands(browser);
  const height = await browser.run(`return document.getElementById("bar").clientHeight;`);
  const lanes = Math.round((height - 12) / 26);
  expect(lanes === 3, `the bar has the path and two drives: ${height} pixels`);
  await browser.run(`const bar = document.getElementById("bar"); for (const key of ["ArrowUp", "End"]) bar.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));`);
  await drawn(browser);
  const again = { says: await text(browser, "frame-says"), hash: await hash(browser) };
  expect(again.hash === end.hash && again.says === end.says, `the first drive is kept, to its last frame: ${JSON.stringify([end, again])}`);
  await click(browser, "bar", 0.5, 0.2);
  expect(/^frame \d+ of/.test(await text(browser, "frame-says")), `a click on the first lane is on the path: ${await text(browser, "frame-says")}`);
  await browser.run(`document.getElementById("mark-text").value = "look here"; document.getElementById("mark").click();`);
  expect((await text(browser, "marks")).includes("look here"), "a mark of the reader stands in the list");
  await press(browser, "heal");
  await browser.run(`document.getElementById("find-late").click();`);
  expect(await until(browser, `/among ([5-9]|\\d\\d+) of/.test(document.getElementById("late-says").textContent)`), `late frames are looked for: ${await text(browser, "late-says")}`);
  await browser.run(`document.getElementById("find-late").click();`);
  await drawn(browser);
}

/** A finger on the pad and a stick drive; two fingers zoom the scope. */
async function hands(browser, expect) {
  const pointer = (id, type, across, down, number = 1) => browser.run(
    `const [id, type, across, down, number] = values;
     const element = document.getElementById(id);
     const { left, top, width, height } = element.getBoundingClientRect();
     element.dispatchEvent(new PointerEvent(type, { pointerId: number, pointerType: "touch", clientX: left + across * width, clientY: top + down * height, bubbles: true }));`,
    id, type, across, down, number,
  );
  const state = () => browser.run(`const value = (id) => document.getElementById(id).value; return { speed: Number(value("speed")), turn: Number(value("turn")), drives: document.getElementById("drive").getAttribute("aria-pressed") === "true" };`);
  await pointer("pad", "pointerdown", 0.75, 0.25);
  const held = await state();
  expect(held.speed === 8 && held.turn === 15 && held.drives, `a finger on the pad drives: ${JSON.stringify(held)}`);
  await pointer("pad", "pointerup", 0.75, 0.25);
  const free = await state();
  expect(free.speed === 0 && free.turn === 0 && !free.drives, `let go, it stands: ${JSON.stringify(free)}`);
  await stands(browser);
  await browser.run(`
    window.pad = { connected: true, axes: [-0.5, -1], buttons: Array.from({ length: 16 }, () => ({ pressed: false })) };
    navigator.getGamepads = () => [window.pad];
    dispatchEvent(new Event("gamepadconnected"));
    await new Promise((resolve) => setTimeout(resolve, 200));`);
  const stick = await state();
  expect(stick.speed === 16 && stick.turn === -15 && stick.drives, `a stick drives: ${JSON.stringify(stick)}`);
  await browser.run(`window.pad.axes = [0.05, 0.02]; await new Promise((resolve) => setTimeout(resolve, 200));`);
  const rest = await state();
  expect(rest.speed === 0 && !rest.drives, `at rest it stands: ${JSON.stringify(rest)}`);
  await browser.run(`window.pad.connected = false;`);
  await stands(browser);
  const says = await text(browser, "values");
  const drawing = () => browser.run(`return ${DATA}("scope").reduce((sum, value, at) => (sum * 31 + value * (at % 97)) % 1000003, 7);`);
  const before = await drawing();
  await pointer("scope", "pointerdown", 0.4, 0.5, 1);
  await pointer("scope", "pointerdown", 0.6, 0.5, 2);
  await pointer("scope", "pointermove", 0.9, 0.5, 2);
  await pointer("scope", "pointerup", 0.9, 0.5, 2);
  await pointer("scope", "pointerup", 0.4, 0.5, 1);
  expect((await drawing()) !== before && (await text(browser, "values")) === says, "two fingers zoom and set no cursor");
}
