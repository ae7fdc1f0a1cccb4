// Fields: a number stays within its bounds, and lists that are filled anew keep the focus.

/** Brings the number of `field` back within its bounds; what is no number becomes what stood there first. */
export function bound(field) {
  const number = field.value.trim() === "" ? Number.NaN : Number(field.value);
  const [low, high] = [field.min, field.max].map((text, at) => (text === "" ? [-Infinity, Infinity][at] : Number(text)));
  field.value = Number.isFinite(number) ? Math.max(low, Math.min(high, number)) : field.defaultValue;
}

/** Notes what a reader types into `field` until it is taken up. */
export function noteTyping(field) {
  field.addEventListener("input", () => { field.dataset.typed = ""; });
  field.addEventListener("change", () => { delete field.dataset.typed; });
  field.addEventListener("blur", () => { delete field.dataset.typed; });
}

/** Makes `field` say `value`, unless the reader is typing into it. */
export function fill(field, value) {
  if (field.dataset.typed === undefined) field.value = value;
}

/** Does `make`, which makes the fields in `box` anew. The one that had the focus has it again. */
export function keepingFocus(box, make) {
  const held = box.contains(document.activeElement) ? document.activeElement : null;
  make();
  if (!held) return;
  const fields = [...box.querySelectorAll("input, button")];
  fields.find(({ type, name, value }) => type === held.type && (type === "checkbox" ? value === held.value : name === held.name))?.focus();
}
