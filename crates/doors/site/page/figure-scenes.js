// What living figures and tasks look at, as the comments in the Markdown have it.

import { contents, scenarios } from "./shipped.js";

/** What a slider can move beside numbers of the model and the scenario. */
export const PLACES = ["frame", "sweep"];

/** The files of a shipped scenario. */
export async function given(scenario) {
  const row = (await scenarios()).find((row) => row.scenario === scenario);
  if (!row) throw new Error(`${scenario} does not ship with this site`);
  return contents(row.files);
}

/** What a figure shows at first: its scene with the sliders where they begin. */
export function first({ scenario, machine = null, faults = [], set = {}, frame = 0, sweep = 0, wires = "", vary = [] }) {
  const view = { scenario: `scenarios/${scenario}.toml`, machine, faults, set: { ...set }, frame, sweep, wires };
  for (const { key, value } of vary) Object.assign(PLACES.includes(key) ? view : view.set, { [key]: value });
  return view;
}

/** The same without the sliders of the machine, for the other side of a difference. */
export function other({ against, set, vary = [], ...scene }) {
  return first({ ...scene, ...against, set: { ...set, ...against.set }, vary: vary.filter(({ key }) => PLACES.includes(key)) });
}
