// The fault board: every shipped fault as a switch, every number of the model as a field with its unit and range.

/** Fills `box` with a switch a fault. `change` is called with the names of those that are on. */
export function showFaults(box, faults, on, change) {
  box.replaceChildren();
  for (const { name, proves, keys } of faults) {
    const input = element("input", { type: "checkbox", value: name, checked: on.includes(name) });
    const values = Object.entries(keys).map(([key, value]) => `${key} = ${value}`).join(", ");
    const label = element("label", { title: values }, input, `${name}: ${proves}`);
    input.addEventListener("change", () => {
      change([...box.querySelectorAll("input:checked")].map((checked) => checked.value));
    });
    box.append(label);
  }
  if (faults.length === 0) box.append("This generator has no shipped faults.");
}

/** Fills `box` with a field for each number whose key has `word` in it, those that were set first. `change` is called with a key and its new text, or null for the model's own. */
export function showNumbers(box, parameters, set, word, change) {
  box.replaceChildren();
  const found = parameters.filter(({ key }) => key.includes(word)).sort((a, b) => (b.key in set) - (a.key in set));
  for (const { key, value, unit, low, high, words, source } of found) {
    const range = [low ?? "−∞", high ?? "∞"].join(" to ");
    const title = `${range}${words.length ? ` or ${words.join(", ")}` : ""}; ${source}`;
    const input = element("input", { type: "text", value: set[key] ?? value, name: key, title, spellcheck: false });
    input.addEventListener("change", () => change(key, input.value.trim() === "" ? null : input.value));
    const label = element("label", { title }, key, input, unit ?? "");
    if (key in set) label.dataset.set = "";
    box.append(label);
  }
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}
