// What a reader of the instrument does: waits, reads, sets a field, presses a button.

/** Waits until the page has drawn what it was asked for. */
export async function drawn(chromium) {
  for (let turn = 0; turn < 600; turn += 1) {
    if (await chromium.run(`return document.body.dataset.busy === "false" && document.getElementById("state").textContent !== "The machine draws.";`)) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error("the page still draws after a minute");
}

export const hash = (chromium) => chromium.run(`return document.getElementById("tube").dataset.hash;`);
export const text = (chromium, id) => chromium.run(`return document.getElementById(values[0]).textContent;`, id);

/** Sets a field as a reader does, and waits. */
export async function put(chromium, id, value) {
  await chromium.run(`const field = document.getElementById(values[0]); field.value = values[1]; field.dispatchEvent(new Event("change", { bubbles: true }));`, id, value);
  await drawn(chromium);
}

export async function press(chromium, id) {
  await chromium.run(`document.getElementById(values[0]).click();`, id);
  await drawn(chromium);
}

/** Waits until `body`, a condition in the page, holds; answers whether it came to. */
export async function until(chromium, body, seconds = 60) {
  for (let turn = 0; turn < 10 * seconds; turn += 1) {
    if (await chromium.run(`return Boolean(${body});`)) return true;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  return false;
}

/** Clicks a place of an element, in shares of its width and height. */
export async function click(chromium, id, across, down) {
  await chromium.run(
    `const [id, across, down] = values;
     const element = document.getElementById(id);
     const { left, top, width, height } = element.getBoundingClientRect();
     element.dispatchEvent(new MouseEvent("click", { clientX: left + across * width, clientY: top + down * height, bubbles: true }));`,
    id,
    across,
    down,
  );
  await drawn(chromium);
}
