// What is refused: links with parts that are not there, fields with bad values, presses before there is a picture and faster than it comes.

import { drawn, hash, open, press, put, text, until } from "./instrument.mjs";

const SCENARIO = "#scenario=scenarios%2Ffirst-light.toml";

export async function refused(browser, host, native, expect) {
  const at = (fragment) => open(browser, host, fragment);
  await links(browser, at, native, expect);
  await values(browser, at, native, expect);
  await early(browser, host, native, expect);
  await quick(browser, at, native, expect);
  await homewards(browser, at, expect);
  await words(browser, at, expect);
}

const leftOut = (browser) => text(browser, "refused");
const link = (browser) => browser.run(`return document.getElementById("link").href;`);

/** A link opens with what is known, lists the rest, and gives a link without it. */
async function links(browser, at, native, expect) {
  const [healed, torn] = native;
  const parts = {
    "scenario=scenarios%2Fnone.toml": "scenarios/none.toml",
    "machine=zap": "machine=zap",
    "fault=zap": "fault=zap",
    "set=loader.zap%3A1": "set=loader.zap:1",
    "set=raster.sweeps%3Amany": "set=raster.sweeps:many",
    "wires=zap%2Cmu.height": "wires=zap",
    "column=5000&line=3": "column=5000",
    "sweep=99999": "sweep=99999",
    "colour=red": "colour=red",
  };
  for (const [part, listed] of Object.entries(parts)) {
    await at(`#${part.startsWith("scenario") ? "" : "scenario=scenarios%2Ffirst-light.toml&"}${part}&set=loader.access_ns%3A90&frame=60`);
    const said = await leftOut(browser);
    expect((await hash(browser)) === torn.hash && said.includes(listed), `a link with ${part} opens with the rest, and lists it: ${said}`);
    expect(!(await link(browser)).includes(part), `the page's own link is without ${part}`);
  }
  await at(`${SCENARIO}&frame=99999`);
  const says = await text(browser, "frame-says");
  expect((await leftOut(browser)).includes("frame=99999") && says === "frame 89 of 90", `a frame beyond the path is its last: ${says}`);
  await at(`${SCENARIO}&frame=60`);
  expect((await leftOut(browser)) === "" && (await hash(browser)) === healed.hash, "nothing is listed where all is known");
}

/** What is refused stands neither in the picture's settings, nor in fields, nor in the link. */
async function values(browser, at, native, expect) {
  const [healed, torn] = native;
  await at(`${SCENARIO}&set=loader.access_ns%3A90&frame=60&wires=mu.height`);
  const number = (value) => browser.run(
    `const field = document.querySelector('#numbers input[name="loader.access_ns"]');
     field.focus();
     field.value = values[0];
     field.dispatchEvent(new Event("change", { bubbles: true }));`,
    value,
  );
  for (const bad of ["abc", "-5"]) {
    await number(bad);
    await drawn(browser);
    const [field, focus] = await browser.run(`return [document.querySelector('#numbers input[name="loader.access_ns"]').value, document.activeElement.name];`);
    expect(field === "90" && focus === "loader.access_ns", `a number that is refused goes back, and the focus stays: ${field}, ${focus}`);
    expect((await text(browser, "state")).includes(bad), `and the page says which: ${await text(browser, "state")}`);
    expect((await link(browser)).includes("access_ns%3A90&") && (await hash(browser)) === torn.hash, "picture and link are those of before");
  }
  await put(browser, "machine", "panels");
  const machine = await browser.run(`return document.getElementById("machine").value;`);
  expect(machine === "" && !(await link(browser)).includes("panels"), `a machine that cannot draw the scenario goes back: "${machine}"`);
  await put(browser, "wires", "no.such");
  const wires = await browser.run(`return document.getElementById("wires").value;`);
  expect(wires === "mu.height" && (await text(browser, "state")).includes("no.such"), `wires that are not there go back: ${wires}`);
  await put(browser, "wires", "tg.height,no.such");
  expect((await browser.run(`return document.getElementById("wires").value;`)) === "tg.height", "those that are there stay");
  const bounds = { speed: [["99", "16"], ["-99", "-16"], ["", "8"]], turn: [["400", "30"]], sweep: [["99999", "999"], ["-3", "0"]] };
  for (const [id, pairs] of Object.entries(bounds)) {
    for (const [typed, stands] of pairs) {
      await put(browser, id, typed);
      const value = await browser.run(`return document.getElementById(values[0]).value;`, id);
      expect(value === stands, `${id} of ${typed || "nothing"} becomes ${stands}: ${value}`);
    }
  }
  await put(browser, "trigger-on", "rising tg.height 12");
  await put(browser, "trigger-on", "rising tg.hight 12");
  const condition = await browser.run(`return document.getElementById("trigger-on").value;`);
  expect(condition === "rising tg.height 12", `a condition that is none goes back to the last: ${condition}`);
  await put(browser, "trigger-on", "");
  await press(browser, "heal");
  expect((await hash(browser)) === healed.hash, "after all that everything can be taken back");
}

/** A press before there is a picture changes nothing, and nothing is thrown. */
async function early(browser, host, native, expect) {
  await browser.go("about:blank");
  await browser.go(`${host.address}instrument.html${SCENARIO}&frame=60&column=500&line=200`);
  const before = await browser.run(`
    const isReached = document.elementFromPoint(200, document.getElementById("tube").getBoundingClientRect().top + 4)?.id === "tube";
    document.getElementById("tube").click();
    return { isReached, busy: document.body.dataset.busy, hash: document.getElementById("tube").dataset.hash ?? null };`);
  await drawn(browser);
  const said = await text(browser, "pixel");
  expect(before.hash === null && said.startsWith("Column 500, line 200"), `a click before the picture is none: ${JSON.stringify(before)}, ${said}`);
  expect((await hash(browser)) === native[0].hash && !(await browser.run(`return document.querySelector("main").inert;`)), "then all can be used");
}

/** Buttons of slow motion, pressed faster than pictures come, in many orders: no fault, and the whole picture at the end. */
async function quick(browser, at, native, expect) {
  await at(`${SCENARIO}&set=loader.access_ns%3A90&frame=60`);
  const said = await browser.run(`
    const faults = [];
    new MutationObserver(() => { if (document.getElementById("state").dataset.fault) faults.push(document.getElementById("state").textContent); })
      .observe(document.getElementById("state"), { attributes: true });
    addEventListener("unhandledrejection", ({ reason }) => faults.push(String(reason)));
    const ids = ["slow-on", "slow-leave", "sweep-on", "slow-back", "sweep-back", "slow-pause", "on", "back"];
    let seed = 7;
    for (let turn = 0; turn < 160; turn += 1) {
      seed = (seed * 1103515245 + 12345) % 2147483648;
      document.getElementById(ids[(seed >> 12) % ids.length]).click();
      if (turn % 5 === 0) await new Promise((resolve) => setTimeout(resolve, (seed >> 8) % 120));
    }
    document.getElementById("slow-leave").click();
    return faults;`);
  await drawn(browser);
  expect(said.length === 0, `slow motion bears any order of presses: ${said.slice(0, 3)}`);
  await put(browser, "frame", "59");
  await browser.run(`const field = document.getElementById("frame"); field.value = 60; field.dispatchEvent(new Event("input"));`);
  await drawn(browser);
  expect((await hash(browser)) === native[1].hash, "and the whole picture comes back");
  await press(browser, "sweep-on");
  await until(browser, `document.getElementById("tube").dataset.built === "1"`, 20);
  await press(browser, "slow-leave");
  await press(browser, "sweep-on");
  expect(await until(browser, `document.getElementById("tube").dataset.built === "1"`, 20), "slow motion begins again on the picture that stood whole");
  await press(browser, "slow-leave");
  // The slider is moved faster than frames are drawn: the last frame stands.
  await browser.run(`
    for (let turn = 0; turn < 30; turn += 1) {
      const field = document.getElementById("frame");
      field.value = turn === 29 ? 60 : 30 + turn;
      field.dispatchEvent(new Event("input"));
      await new Promise((resolve) => setTimeout(resolve, 17));
    }`);
  await drawn(browser);
  expect((await hash(browser)) === native[1].hash, "of frames wished for faster than they are drawn the last one stands");
}

/** Home and End right after a drive, by a machine with memory. */
async function homewards(browser, at, expect) {
  await at("#scenario=scenarios%2Fnominal-drive.toml&machine=pra-nominal&frame=2&set=scenario.raster.columns%3A160&set=scenario.raster.lines%3A92&set=raster.sweeps%3A100");
  const found = await browser.run(`
    const faults = [];
    const bar = document.getElementById("bar");
    const key = (name) => bar.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
    const wait = (is) => new Promise((resolve) => { const turn = () => (is() ? resolve() : setTimeout(turn, 10)); turn(); });
    new MutationObserver(() => { if (document.getElementById("state").dataset.fault) faults.push(document.getElementById("state").textContent); })
      .observe(document.getElementById("state"), { attributes: true });
    const says = [];
    const driven = () => document.getElementById("driven").textContent;
    const delays = [0, 4, 8, 15, 25, 40, 60, 90, 130, 180];
    for (const [turn, delay] of delays.entries()) {
      const name = turn % 2 === 0 ? "Home" : "End";
      const before = driven();
      document.getElementById("drive").click();
      await wait(() => driven() !== before);
      await new Promise((resolve) => setTimeout(resolve, delay));
      document.getElementById("drive").click();
      key(name);
      await wait(() => document.getElementById("drive").dataset.runs === "false" && document.body.dataset.busy === "false");
      says.push([name, document.getElementById("frame-says").textContent]);
    }
    return { faults, says };`);
  expect(found.faults.length === 0, `Home and End right after a drive tell no fault: ${found.faults}`);
  const ends = found.says.map(([name, says]) => [name, ...says.match(/frame (\d+) of (\d+)/).slice(1).map(Number)]);
  // A frame that was under way when End was pressed comes behind it.
  const isThere = ([name, frame, frames]) => (name === "Home" ? frame === 0 : frame >= frames - 2);
  expect(ends.every(isThere), `and go there: ${found.says.join("; ")}`);
}

/** Messages of the page name nothing of the command line. */
async function words(browser, at, expect) {
  const said = [];
  for (const part of ["machine=zap", "machine=lunsim", "machine=panels", "fault=zap", "set=loader.zap%3A1", "set=loader.access_ns%3A-1", "wires=zap", "machine=exact&set=loader.access_ns%3A9"]) {
    await at(`${SCENARIO}&${part}`);
    said.push(await leftOut(browser));
  }
  await at(SCENARIO);
  const known = await browser.run(`
    const { contents } = await import(new URL("shipped.js", document.baseURI));
    const machine = new lunoid.Lunoid();
    const files = await contents(["scenarios/first-light.toml"]);
    const refused = await machine.open("scenarios/first-light.toml", { files, machine: "zap" }).catch((error) => error.message);
    machine.close();
    return refused.match(/known: (.*)/)[1].split(", ");`);
  for (const machine of ["lunsim", "panels"]) {
    await put(browser, "machine", machine);
    said.push(await text(browser, "state"));
  }
  await put(browser, "wires", "zap");
  said.push(await text(browser, "state"));
  const strange = said.filter((text) => text === "" || /(^|\s)--\w|`lunoid |given:/.test(text));
  expect(strange.length === 0, `no message speaks of the command line: ${strange}`);
  const listed = await browser.run(`return [...document.getElementById("machine").options].map(({ value }) => value).filter(Boolean).sort();`);
  expect(listed.join() === known.sort().join(), `the menu has every machine that ships: ${listed}`);
}
