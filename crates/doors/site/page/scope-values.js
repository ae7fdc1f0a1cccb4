// The values at the cursors of the scope, in words.

/** A number in five digits. */
export function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "none";
}

/** The values of a sample, with its place; of a signal that is told when it changes, none. */
function values(traces, sample) {
  const analog = traces.signals.filter(({ name }) => !traces.planes[`times:${name}`]);
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

/** Says the trigger, the values at both cursors, their difference, and what the reference has at A. */
export function told({ traces, reference, cursors, trigger }) {
  const last = traces.planes.places.values.length - 1;
  const [a, b] = cursors.map((sample) => (sample === null ? null : Math.max(0, Math.min(last, Math.round(sample)))));
  const at = (sample) => values(traces, sample).map(({ name, unit, value }) => `${name} ${short(value)}${unit}`).join(", ");
  const said = trigger === null ? [] : [`Trigger T at ${trigger.toFixed(3)} samples.`];
  if (a !== null) said.push(`A, sample ${a}: ${at(a)}.`);
  if (a !== null && reference) {
    const behind = values(traces, a).filter(({ name }) => reference.planes[name]);
    said.push(`Reference: ${behind.map(({ name, unit }) => `${name} ${short(reference.planes[name].values[a])}${unit}`).join(", ")}.`);
  }
  if (b !== null) said.push(`B, sample ${b}: ${at(b)}.`);
  if (a !== null && b !== null) {
    const before = values(traces, a);
    const less = values(traces, b).map(({ name, unit, value }, row) => `${name} ${short(value - before[row].value)}${unit}`);
    said.push(`B less A, ${b - a} samples: ${less.join(", ")}.`);
  }
  return said.join(" ") || "Wheel or two fingers zoom, drag moves, a click sets cursor A, with Shift cursor B.";
}
