// The values at the cursors of the scope, in words and in a table.

/** A number in five digits. */
export function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "none";
}

/** The values of the wires `analog` at a sample, and its place first. */
function values(traces, analog, sample) {
  const value = ({ name, unit }) => ({ name, unit: unit === "1" ? "" : ` ${unit}`, value: traces.planes[name].values[sample] });
  return [{ name: traces.place, unit: "", value: traces.planes.places.values[sample] }, ...analog.map(value)];
}

/** The value of a signal at an instant of a sweep (samples): the last one before it, of a signal that is told when it changes. Null before any. */
export function valueAt(traces, name, instant) {
  const times = traces.planes[`times:${name}`]?.values;
  const { values: own } = traces.planes[name];
  if (!times) return own[Math.max(0, Math.min(own.length - 1, Math.round(instant)))] ?? null;
  const next = times.findIndex((time) => time > instant);
  return own[(next < 0 ? times.length : next) - 1] ?? null;
}

/** The cursors, the pointer, the trigger and the values there: `lead` in words, `heads` of columns, and `rows` of text, one for each of the wires `analog`. */
export function told({ traces, analog, reference, cursors, pointer, trigger, sampleUs, notes }) {
  const last = traces.planes.places.values.length - 1;
  const [a, b] = cursors.map((sample) => (sample === null ? null : Math.max(0, Math.min(last, Math.round(sample)))));
  const time = (sample) => (sampleUs ? `, ${(sample * sampleUs).toFixed(3)} µs` : "");
  const lead = [...notes];
  if (trigger !== null) lead.push(`Trigger T at sample ${trigger.toFixed(3)}${time(trigger)}.`);
  if (pointer !== null) lead.push(`Pointer at sample ${pointer}${time(pointer)}.`);
  if (a !== null) lead.push(`Cursor A at sample ${a}${time(a)}.`);
  if (b !== null) lead.push(`Cursor B at sample ${b}${time(b)}.`);
  if (a !== null && b !== null) lead.push(`B less A: ${b - a} samples${time(b - a)}.`);
  if (lead.length === 0) lead.push("Wheel or two fingers zoom, drag moves, a click sets cursor A, with Shift cursor B.");
  const columns = [];
  if (pointer !== null) columns.push(["pointer", values(traces, analog, pointer)]);
  if (a !== null) columns.push(["A", values(traces, analog, a)]);
  if (b !== null) columns.push(["B", values(traces, analog, b)]);
  if (a !== null && b !== null) columns.push(["B less A", less(values(traces, analog, b), values(traces, analog, a))]);
  if (a !== null && reference) columns.push(["reference at A", values(traces, analog, a).map((row) => ({ ...row, value: reference.planes[row.name]?.values[a] }))]);
  const names = columns[0]?.[1] ?? [];
  const text = ({ value, unit }) => (value === undefined ? "" : `${short(value)}${unit}`);
  const rows = names.map(({ name }, row) => [name, ...columns.map(([, own]) => text(own[row]))]);
  return { lead: lead.join(" "), heads: columns.map(([head]) => head), rows };
}

function less(after, before) {
  return after.map((row, at) => ({ ...row, value: row.value - before[at].value }));
}

/** The same in one text, for a few wires. */
export function inSentence({ lead, heads, rows }) {
  const column = (head, at) => `${head}: ${rows.map(([name, ...own]) => `${name} ${own[at]}`).join(", ")}.`;
  return [lead, ...heads.map(column)].join(" ");
}

/** Shows them: the words in the element `words`, and the wires in `table` with its frame around it, where a cursor is set. */
export function showValues(words, table, { lead, heads, rows }) {
  words.textContent = lead;
  table.parentElement.hidden = rows.length === 0;
  const row = (cells, name) => {
    const made = document.createElement("tr");
    made.append(...cells.map((textContent) => Object.assign(document.createElement(name), { textContent })));
    return made;
  };
  table.tHead.replaceChildren(row(["wire", ...heads], "th"));
  table.tBodies[0].replaceChildren(...rows.map((cells) => row(cells, "td")));
}
