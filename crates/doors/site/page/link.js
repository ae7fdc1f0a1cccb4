// What a link carries: everything that is set. #scenario=...&machine=...&fault=tear&set=part.key:value&frame=N&sweep=S&wires=...

const WHOLE = ["frame", "sweep", "column", "line"];

/** The view that a fragment asks for, and the parts of it that nobody knows. */
export function read(fragment) {
  const view = { set: {}, faults: [] };
  const unknown = [];
  for (const [key, value] of new URLSearchParams(fragment.replace(/^#/, ""))) {
    const colon = value.indexOf(":");
    if (key === "scenario" || key === "machine" || key === "wires") view[key] = value;
    else if (key === "fault") view.faults.push(value);
    else if (key === "set" && colon > 0) view.set[value.slice(0, colon)] = setting(value.slice(colon + 1));
    else if (WHOLE.includes(key) && /^\d{1,9}$/.test(value)) view[key] = Number(value);
    else unknown.push(`${key}=${value}`);
  }
  return { view, unknown };
}

/** The fragment of a view. */
export function written(view) {
  const pairs = ["scenario", "machine"].filter((key) => view[key]).map((key) => [key, view[key]]);
  pairs.push(...view.faults.map((fault) => ["fault", fault]));
  pairs.push(...Object.entries(view.set).map(([key, value]) => ["set", `${key}:${value}`]));
  const has = (key) => view[key] !== null && view[key] !== undefined;
  pairs.push(...[...WHOLE, "wires"].filter(has).map((key) => [key, view[key]]));
  return `#${new URLSearchParams(pairs)}`;
}

/** A value of a setting as the model reads it. */
export function setting(text) {
  if (text === "true" || text === "false") return text === "true";
  return text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : text;
}
