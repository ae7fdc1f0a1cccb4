// A walk by keyboard alone: from load to the late word of a torn pixel, with a name and a visible focus at every stop.

import { drawn, hash, open, text, until } from "./instrument.mjs";

/** The element that has the focus: its id or place, its name, and whether the focus can be seen. */
const FOCUS = `
  const held = document.activeElement;
  const { outlineStyle, outlineWidth } = getComputedStyle(held);
  const name = held.getAttribute("aria-label") || held.labels?.[0]?.textContent.trim() || held.textContent.trim() || held.title;
  return { id: held.id || (held.matches("#events button") ? "event" : held.tagName), name, isSeen: outlineStyle !== "none" && parseFloat(outlineWidth) > 0 };`;

export async function keyboard(chromium, host, native, expect) {
  await open(chromium, host, "#scenario=scenarios%2Ffirst-light.toml&set=loader.access_ns%3A90&frame=60&sweep=500&wires=tg.height");
  const stops = [];
  /** Presses `key` until an element with this id has the focus. */
  const to = async (id, key = "Tab") => {
    for (let turn = 0; turn < 120; turn += 1) {
      await chromium.keys(key);
      const focus = await chromium.run(FOCUS);
      stops.push(focus);
      if (focus.id === id) return true;
    }
    return false;
  };

  expect(await to("tube"), "Tab comes to the tube");
  await chromium.keys(...Array(9).fill("Shift+Up"), "Down", "Down", "Down");
  await drawn(chromium);
  const torn = await text(chromium, "pixel");
  expect(torn.startsWith("Column 500, line 200: late word: tg."), `arrow keys move the marker to a torn pixel, and its late word is named: ${torn}`);
  const { crossing } = JSON.parse(await chromium.run(`return document.getElementById("word").dataset.late;`));
  expect(await to("word"), "Tab comes to the pixels of this word");
  await chromium.keys("Enter");
  expect(await until(chromium, `!document.getElementById("largest").hidden`), `Enter marks them: ${await text(chromium, "effect")}`);
  expect(await to("largest"), "Tab comes to the one that changed most");
  await chromium.keys("Space");
  await until(chromium, `!document.getElementById("pixel").textContent.startsWith("Column 500, line 200:")`);
  await drawn(chromium);
  expect(await to("explained"), "Tab goes on to the explanation of that pixel");
  const told = await text(chromium, "explained");
  expect(told.includes(`crossing ${crossing},`), `which has the word: ${told.split("\n").find((row) => row.includes(`crossing ${crossing},`))}`);
  expect(await to("SUMMARY"), "Tab comes to the digital events");
  await chromium.keys("Enter");
  expect(await to("event"), "and on to the button of the first late word");
  const event = await chromium.run(`return document.activeElement.closest("tr").className;`);
  expect(event === "late", `which is late: ${event}`);
  expect(await to("play", "Shift+Tab"), "Shift and Tab go back to all before");
  await chromium.keys("Space");
  await until(chromium, `document.getElementById("frame-says").textContent !== "frame 60 of 90"`);
  await chromium.keys("Space");
  await drawn(chromium);
  const still = await text(chromium, "frame-says");
  expect(still !== "frame 60 of 90" && (await chromium.run(`return document.getElementById("play").getAttribute("aria-pressed");`)) === "false", `Space plays and stops: ${still}`);
  const nameless = stops.filter(({ id, name }) => id !== "BODY" && !name).map(({ id }) => id);
  const unseen = stops.filter(({ id, isSeen }) => id !== "BODY" && !isSeen).map(({ id }) => id);
  expect(nameless.length === 0, `every stop has a name: ${nameless}`);
  expect(unseen.length === 0, `the focus can be seen at every stop: ${unseen}`);
  expect((await hash(chromium)) !== native[1].hash, "the picture went on");
}
