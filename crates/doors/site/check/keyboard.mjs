// A walk by keyboard alone: from load to the late word of a torn pixel, with a name and a visible focus at every stop.

import { drawn, hash, open, text, until } from "./instrument.mjs";

/** The element that has the focus: its id or place, its name, and whether the focus can be seen. */
const FOCUS = `
  const held = document.activeElement;
  const { outlineStyle, outlineWidth } = getComputedStyle(held);
  const name = held.getAttribute("aria-label") || held.labels?.[0]?.textContent.trim() || held.textContent.trim() || held.title;
  return { id: held.id || (held.matches("#events button") ? "event" : held.tagName), name, isSeen: outlineStyle !== "none" && parseFloat(outlineWidth) > 0 };`;

export async function keyboard(browser, host, native, expect) {
  await open(browser, host, "#scenario=scenarios%2Ffirst-light.toml&set=loader.access_ns%3A90&frame=60&sweep=500&wires=tg.height");
  const stops = [];
  /** Presses `key` until an element with this id has the focus. */
  const to = async (id, key = "Tab") => {
    for (let turn = 0; turn < 120; turn += 1) {
      await browser.keys(key);
      const focus = await browser.run(FOCUS);
      stops.push(focus);
      if (focus.id === id) return true;
    }
    return false;
  };

  expect(await to("tube"), "Tab comes to the tube");
  await browser.keys(...Array(9).fill("Shift+Up"), "Down", "Down", "Down");
  await drawn(browser);
  const torn = await text(browser, "pixel");
  expect(torn.startsWith("Column 500, line 200: late word: tg."), `arrow keys move the marker to a torn pixel, and its late word is named: ${torn}`);
  const { crossing } = JSON.parse(await browser.run(`return document.getElementById("word").dataset.late;`));
  expect(await to("word"), "Tab comes to the pixels of this word");
  await browser.keys("Enter");
  expect(await until(browser, `!document.getElementById("largest").hidden`), `Enter marks them: ${await text(browser, "effect")}`);
  expect(await to("largest"), "Tab comes to the one that changed most");
  await browser.keys("Space");
  await until(browser, `!document.getElementById("pixel").textContent.startsWith("Column 500, line 200:")`);
  await drawn(browser);
  expect(await to("explained"), "Tab goes on to the explanation of that pixel");
  const told = await text(browser, "explained");
  expect(told.includes(`crossing ${crossing},`), `which has the word: ${told.split("\n").find((row) => row.includes(`crossing ${crossing},`))}`);
  expect(await to("SUMMARY"), "Tab comes to the digital events");
  await browser.keys("Enter");
  expect(await to("event"), "and on to the button of the first late word");
  const event = await browser.run(`return document.activeElement.closest("tr").className;`);
  expect(event === "late", `which is late: ${event}`);
  expect(await to("play", "Shift+Tab"), "Shift and Tab go back to all before");
  await browser.keys("Space");
  await until(browser, `document.getElementById("frame-says").textContent !== "frame 60 of 90"`);
  await browser.keys("Space");
  await drawn(browser);
  const still = await text(browser, "frame-says");
  expect(still !== "frame 60 of 90" && (await browser.run(`return document.getElementById("play").getAttribute("aria-pressed");`)) === "false", `Space plays and stops: ${still}`);
  const nameless = stops.filter(({ id, name }) => id !== "BODY" && !name).map(({ id }) => id);
  const unseen = stops.filter(({ id, isSeen }) => id !== "BODY" && !isSeen).map(({ id }) => id);
  expect(nameless.length === 0, `every stop has a name: ${nameless}`);
  expect(unseen.length === 0, `the focus can be seen at every stop: ${unseen}`);
  expect((await hash(browser)) !== native[1].hash, "the picture went on");
}
