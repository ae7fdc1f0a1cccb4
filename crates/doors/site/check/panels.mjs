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

export async function panels(chromium, host, native, expect) {
  await open(chromium, host, TORN);
  await trigger(chromium, expect);
  await effects(chromium, native, expect);
  await slowMotion(chromium, native, expect);
  await diagram(chromium, expect);
  await compared(chromium, native, expect);
  await drives(chromium, expect);
  await hands(chromium, expect);
}

/** The state of the scope: sweep, instant of the trigger, and column of its mark. */
const scope = (chromium) => chromium.run(`const { sweep, trigger, mark } = document.getElementById("scope").dataset; return { sweep: Number(sweep), trigger: trigger === "" ? null : Number(trigger), mark: Number(mark) };`);

async function trigger(chromium, expect) {
  await put(chromium, "sweep", "500");
  await put(chromium, "trigger-on", "rising tg.height 12");
  const found = await scope(chromium);
  expect(found.sweep === FIRST.sweep && found.trigger === FIRST.instant, `the trigger is the native one, to the bit: ${JSON.stringify(found)}`);
  const red = await chromium.run(
    `const [x] = values;
     const data = ${DATA}("scope");
     const row = 4 * 40 * document.getElementById("scope").width;
     return [-1, 0, 1].map((by) => row + 4 * (Math.round(x) + by)).some((at) => data[at] > 150 && data[at + 1] < 120 && data[at + 3] > 60);`,
    found.mark,
  );
  expect(red, "the mark T stands at the instant");
  // The step of the mark across the canvas is that of the samples: one sample beside would be seen.
  const [left, width] = [88, await chromium.run(`return document.getElementById("scope").width - 88 - 8;`)];
  const samples = ((found.mark - left) / width) * 999;
  expect(Math.abs(samples - FIRST.instant) < 0.01, `the mark lies at sample ${samples.toFixed(3)}, not one beside`);
  await press(chromium, "trigger-next");
  await until(chromium, `document.getElementById("scope").dataset.trigger !== "${FIRST.instant}"`);
  const second = await scope(chromium);
  expect(second.trigger !== null && (second.sweep > found.sweep || second.trigger > found.trigger), `the next place is behind the first: ${JSON.stringify(second)}`);
  await put(chromium, "trigger-mode", "normal");
  await put(chromium, "trigger-on", "rising tg.height 1e6");
  expect((await text(chromium, "trigger-says")).includes("waiting"), `a normal trigger waits: ${await text(chromium, "trigger-says")}`);
  expect((await scope(chromium)).sweep === second.sweep, "the trace stands meanwhile");
  await put(chromium, "trigger-mode", "automatic");
  expect((await scope(chromium)).trigger === null && (await text(chromium, "trigger-says")).includes("sweep of the cursor"), "an automatic one shows the sweep of the cursor");
  await put(chromium, "trigger-mode", "single");
  await put(chromium, "trigger-on", "rising tg.height 12");
  await press(chromium, "on");
  const single = await scope(chromium);
  const { trigger: again } = await scope(chromium);
  expect(single.trigger === FIRST.instant && again === FIRST.instant, `a single trigger stands when the frame goes on: ${JSON.stringify(single)}`);
  await put(chromium, "trigger-on", "rising tg.hight 12");
  expect((await text(chromium, "state")).includes("tg.height"), `a condition that is none is told: ${await text(chromium, "state")}`);
  await put(chromium, "trigger-on", "");
  await put(chromium, "trigger-mode", "automatic");
  await press(chromium, "back");
}

/** From a late word to its pixels, and from one of them back to the word. */
async function effects(chromium, native, expect) {
  await put(chromium, "sweep", "500");
  await put(chromium, "zoom", "1");
  const said = `document.getElementById("effect").textContent.includes("changed")`;
  const late = await chromium.run(`
    document.querySelector("#events").closest("details").open = true;
    document.querySelector("#events tr.late button").click();
    return document.querySelector("#events tr.late").textContent;`);
  expect(await until(chromium, said), `a late word tells its pixels: ${late}`);
  await click(chromium, "tube", 500.5 / 1000, 200.5 / 575);
  const word = JSON.parse(await chromium.run(`return document.getElementById("word").dataset.late;`));
  await chromium.run(`document.getElementById("effect").textContent = ""; document.getElementById("word").click();`);
  expect(await until(chromium, said), `the word of a pixel has its pixels: ${JSON.stringify(word)}`);
  const found = await chromium.run(`return { says: document.getElementById("effect").textContent, marked: Number(document.getElementById("tube").dataset.changed) };`);
  const [, column, line] = found.says.match(/at column (\d+), line (\d+)/) ?? [];
  expect(found.marked > 0 && found.says.includes(`changed ${found.marked} pixels`), `they are marked: ${found.says}`);
  await click(chromium, "tube", (Number(column) + 0.5) / 1000, (Number(line) + 0.5) / 575);
  const told = await text(chromium, "explained");
  expect(told.includes(`crossing ${word.crossing}`), `one of them names the word: ${told.split("\n").filter((row) => row.includes("late")).join(" ")}`);
  expect((await hash(chromium)) === native[1].hash, "the picture is the same as before");
}

async function slowMotion(chromium, native, expect) {
  await put(chromium, "rate", "100");
  await chromium.run(`document.getElementById("slow-on").click();`);
  const built = `Number(document.getElementById("tube").dataset.built)`;
  const on = await chromium.run(`
    for (let turn = 0; turn < 3000 && ${built} <= 40; turn += 1) await new Promise(requestAnimationFrame);
    document.getElementById("slow-pause").click();
    return ${built};`);
  await drawn(chromium);
  expect(on > 40 && on < 900, `the picture builds up: ${on}`);
  const half = await chromium.run(`
    return { built: ${built}, sweep: Number(document.getElementById("sweep").value) };`);
  expect(half.sweep === half.built || half.sweep === half.built - 1, `the cursor is at the sweep that is written: ${JSON.stringify(half)}`);
  await press(chromium, "sweep-on");
  const next = await chromium.run(`return ${built};`);
  expect(next === half.built + 1, `a sweep further: ${next} after ${half.built}`);
  // Stopped in the page: the way of a question through WebDriver may take a frame.
  const back = await chromium.run(
    `const [from] = values;
     document.getElementById("slow-back").click();
     for (let turn = 0; turn < 1000 && ${built} >= from; turn += 1) await new Promise(requestAnimationFrame);
     document.getElementById("slow-pause").click();
     return ${built};`,
    half.built,
  );
  await drawn(chromium);
  expect(back < half.built, `backwards it goes back: ${back}`);
  const [wrong, checked] = await chromium.run(
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
  await press(chromium, "slow-leave");
  expect((await hash(chromium)) === native[1].hash, "the whole picture comes back");
}

async function diagram(chromium, expect) {
  await chromium.run(`document.getElementById("diagram-panel").open = true;`);
  expect(await until(chromium, `document.querySelectorAll("#diagram .wire").length > 20 && document.querySelector("#diagram .register.loaded")`), "the diagram has wires and loaded registers");
  await drawn(chromium);
  const found = await chromium.run(`
    const blocks = [...document.querySelectorAll("#diagram .block")];
    const wire = [...document.querySelectorAll("#diagram .wire")].find((label) => label.textContent.startsWith("tg.height"));
    wire.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
    blocks.find((block) => block.getAttribute("aria-label").startsWith("terrain generator")).dispatchEvent(new MouseEvent("click"));
    return { blocks: blocks.length, pale: blocks.filter((block) => block.classList.contains("left-out")).map((block) => block.getAttribute("aria-label")),
      label: wire.textContent, wires: document.getElementById("wires").value, card: document.getElementById("block").textContent,
      nameless: document.querySelectorAll("#diagram [role=button]:not([aria-label])").length };`);
  await drawn(chromium);
  expect(found.blocks === 12 && found.pale.some((name) => name.startsWith("feature generator")), `blocks that are left out are pale: ${found.pale}`);
  expect(/^tg\.height -?\d/.test(found.label), `a wire shows its value: ${found.label}`);
  expect(found.wires.split(",").includes("tg.height") && found.nameless === 0, `Enter on a wire puts it on the scope: ${found.wires}`);
  expect(/108 analog multipliers/.test(found.card) && /amplifier\..*hardware-models|ideal\.toml/.test(found.card), `a block has its parts and numbers with their source: ${found.card.slice(0, 120)}`);
  const value = await chromium.run(`
    const label = () => [...document.querySelectorAll("#diagram .wire")].find((one) => one.textContent.startsWith("tg.height")).textContent;
    const before = label();
    document.getElementById("scope").dispatchEvent(new KeyboardEvent("keydown", { key: "PageDown", bubbles: true }));
    return [before, label(), [...document.querySelectorAll("#value-rows tr")].map((row) => [...row.cells].map((cell) => cell.textContent).join(" ")).join("; ")];`);
  const shown = value[1].replace(/^tg\.height /, "");
  expect(value[0] !== value[1] && value[2].includes(`tg.height ${shown}`), `the values follow the cursor: ${value}`);
  await chromium.run(`document.getElementById("diagram-panel").open = false;`);
  await drawn(chromium);
}

async function compared(chromium, native, expect) {
  await press(chromium, "heal");
  await chromium.run(`document.querySelector('#faults input[value="edge"]').click();`);
  await drawn(chromium);
  const faulty = await hash(chromium);
  await press(chromium, "compare");
  expect(await until(chromium, `document.getElementById("seen").textContent !== ""`), "a fault is compared with and without");
  const found = { predicted: await text(chromium, "predicted"), seen: await text(chromium, "seen") };
  expect(found.predicted.includes("A13, displaced edges") && found.predicted.includes("beyond their place"), `what it predicts stands beside: ${found.predicted}`);
  expect(/^Seen: [\d.]+ % of the pixels differ/.test(found.seen), `and what is seen: ${found.seen}`);
  await press(chromium, "without");
  expect((await hash(chromium)) === native[0].hash, "the picture without is the healed one");
  await press(chromium, "without");
  expect((await hash(chromium)) === faulty && faulty !== native[0].hash, "the picture with comes back");
  await press(chromium, "heal");
  await put(chromium, "machine", "sampled");
  await press(chromium, "slow-on");
  expect(await until(chromium, `document.getElementById("state").textContent.includes("sampled has no sweeps")`), `a generator without sweeps says so: ${await text(chromium, "state")}`);
  await put(chromium, "machine", "");
}

/** Waits until the last frame of a drive stands. */
async function stands(chromium) {
  await until(chromium, `document.getElementById("drive").dataset.runs === "false"`);
  await drawn(chromium);
}

/** A drive with a fault switched under way, gone back to, and driven anew from there. */
async function drives(chromium, expect) {
  const drive = async (frames) => {
    await chromium.run(
      `const [frames] = values;
       const count = () => Number(document.getElementById("driven").textContent.match(/\\d+/)?.[0] ?? 0);
       document.getElementById("drive").click();
       while (count() < frames) await new Promise((resolve) => setTimeout(resolve, 20));
       document.getElementById("drive").click();`,
      frames,
    );
    await stands(chromium);
  };
  await drive(3);
  await chromium.run(`document.querySelector('#faults input[value="tear"]').click();`);
  await drawn(chromium);
  const switched = Number((await text(chromium, "driven")).match(/\d+/)[0]);
  await drive(switched + 3);
  const marks = await text(chromium, "marks");
  expect(marks.includes("drive 1") && marks.includes("tear on"), `a fault that was switched under way has its time: ${marks}`);
  const end = { says: await text(chromium, "frame-says"), hash: await hash(chromium) };
  await chromium.run(`const bar = document.getElementById("bar"); bar.focus(); bar.dispatchEvent(new KeyboardEvent("keydown", { key: "Home", bubbles: true }));`);
  await drawn(chromium);
  expect((await text(chromium, "frame-says")).startsWith("drive 1, frame 0 "), `any place of the drive by a key: ${await text(chromium, "frame-says")}`);
  const isOn = await chromium.run(`return document.querySelector('#faults input[value="tear"]').checked;`);
  expect(!isOn, "there the fault is not on yet");
  // One click on the bar: the second lane is the drive, and its second frame.
  const total = await chromium.run(`return Number(document.getElementById("bar").getAttribute("aria-valuemax"));`);
  expect(total >= switched + 2, `the drive has ${total + 1} frames`);
  await chromium.run(`document.getElementById("bar").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));`);
  await drawn(chromium);
  await chromium.run(`window.before = document.getElementById("driven").textContent; document.getElementById("turn").value = 20; document.getElementById("drive").click();`);
  expect(await until(chromium, `document.getElementById("frame-says").textContent.startsWith("drive 2, frame")`), "driven on from there, a second drive begins");
  await chromium.run(`document.getElementById("drive").click();`);
  await stands(chromium);
  const height = await chromium.run(`return document.getElementById("bar").clientHeight;`);
  const lanes = Math.round((height - 12) / 26);
  expect(lanes === 3, `the bar has the path and two drives: ${height} pixels`);
  await chromium.run(`const bar = document.getElementById("bar"); for (const key of ["ArrowUp", "End"]) bar.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));`);
  await drawn(chromium);
  const again = { says: await text(chromium, "frame-says"), hash: await hash(chromium) };
  expect(again.hash === end.hash && again.says === end.says, `the first drive is kept, to its last frame: ${JSON.stringify([end, again])}`);
  await click(chromium, "bar", 0.5, 0.2);
  expect(/^frame \d+ of/.test(await text(chromium, "frame-says")), `a click on the first lane is on the path: ${await text(chromium, "frame-says")}`);
  await chromium.run(`document.getElementById("mark-text").value = "look here"; document.getElementById("mark").click();`);
  expect((await text(chromium, "marks")).includes("look here"), "a mark of the reader stands in the list");
  await press(chromium, "heal");
  await chromium.run(`document.getElementById("find-late").click();`);
  expect(await until(chromium, `/among ([5-9]|\\d\\d+) of/.test(document.getElementById("late-says").textContent)`), `late frames are looked for: ${await text(chromium, "late-says")}`);
  await chromium.run(`document.getElementById("find-late").click();`);
  await drawn(chromium);
}

/** A finger on the pad and a stick drive; two fingers zoom the scope. */
async function hands(chromium, expect) {
  const pointer = (id, type, across, down, number = 1) => chromium.run(
    `const [id, type, across, down, number] = values;
     const element = document.getElementById(id);
     const { left, top, width, height } = element.getBoundingClientRect();
     element.dispatchEvent(new PointerEvent(type, { pointerId: number, pointerType: "touch", clientX: left + across * width, clientY: top + down * height, bubbles: true }));`,
    id, type, across, down, number,
  );
  const state = () => chromium.run(`const value = (id) => document.getElementById(id).value; return { speed: Number(value("speed")), turn: Number(value("turn")), drives: document.getElementById("drive").getAttribute("aria-pressed") === "true" };`);
  await pointer("pad", "pointerdown", 0.75, 0.25);
  const held = await state();
  expect(held.speed === 8 && held.turn === 15 && held.drives, `a finger on the pad drives: ${JSON.stringify(held)}`);
  await pointer("pad", "pointerup", 0.75, 0.25);
  const free = await state();
  expect(free.speed === 0 && free.turn === 0 && !free.drives, `let go, it stands: ${JSON.stringify(free)}`);
  await stands(chromium);
  await chromium.run(`
    window.pad = { connected: true, axes: [-0.5, -1], buttons: Array.from({ length: 16 }, () => ({ pressed: false })) };
    navigator.getGamepads = () => [window.pad];
    dispatchEvent(new Event("gamepadconnected"));
    await new Promise((resolve) => setTimeout(resolve, 200));`);
  const stick = await state();
  expect(stick.speed === 16 && stick.turn === -15 && stick.drives, `a stick drives: ${JSON.stringify(stick)}`);
  await chromium.run(`window.pad.axes = [0.05, 0.02]; await new Promise((resolve) => setTimeout(resolve, 200));`);
  const rest = await state();
  expect(rest.speed === 0 && !rest.drives, `at rest it stands: ${JSON.stringify(rest)}`);
  await chromium.run(`window.pad.connected = false;`);
  await stands(chromium);
  const says = await text(chromium, "values");
  const drawing = () => chromium.run(`return ${DATA}("scope").reduce((sum, value, at) => (sum * 31 + value * (at % 97)) % 1000003, 7);`);
  const before = await drawing();
  await pointer("scope", "pointerdown", 0.4, 0.5, 1);
  await pointer("scope", "pointerdown", 0.6, 0.5, 2);
  await pointer("scope", "pointermove", 0.9, 0.5, 2);
  await pointer("scope", "pointerup", 0.9, 0.5, 2);
  await pointer("scope", "pointerup", 0.4, 0.5, 1);
  expect((await drawing()) !== before && (await text(chromium, "values")) === says, "two fingers zoom and set no cursor");
}
