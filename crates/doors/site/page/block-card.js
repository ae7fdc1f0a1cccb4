// A block of the machine in words: its parts, its numbers with their source, what was left out, and its wires.

/** Most wires that get a button. */
const MOST_WIRES = 60;

/** Fills `box` with a block. `parameters` are the numbers of the model; `choose` is called with a wire. */
export function showBlock(box, block, parameters, choose) {
  const own = parameters.filter(({ key }) => block.tables.includes(key.split(".")[0]));
  box.replaceChildren(
    element("h3", {}, block.left_out ? `${block.name} (left out)` : block.name),
    ...block.omissions.map(({ what, why }) => element("p", {}, `Left out: ${what}; ${why}.`)),
    ...(block.parts.length ? [element("p", {}, `Parts: ${block.parts.join("; ")}.`)] : []),
    ...(own.length ? [table(own)] : []),
    element("p", {}, ...block.signals.slice(0, MOST_WIRES).map((name) => wire(name, choose))),
  );
}

function table(rows) {
  const head = element("tr", {}, ...["number", "value", "unit", "source"].map((text) => element("th", { scope: "col" }, text)));
  const row = ({ key, value, unit, source }) => element("tr", {}, ...[key, String(value), unit ?? "", source].map((text) => element("td", {}, text)));
  return element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows.map(row)));
}

function wire(name, choose) {
  const button = element("button", { type: "button" }, name);
  button.addEventListener("click", () => choose(name));
  return button;
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}
