// What a machine knows of what a link asks for: each wish alone, where all together are refused.

import { LunoidError } from "./lunoid.js";

/** The answer to `ask`; null where the machine refuses it, which `refused` is told. An ended machine knows nothing, and its error goes on. */
async function answered(ask, refused) {
  return ask().catch((error) => {
    if (!(error instanceof LunoidError)) throw error;
    refused(error);
    return null;
  });
}

/**
 * Opens as much of `{ machine, faults, set }` as the machine takes: the scenario alone, then one wish after another. Answers what `opening` tells
 * last, the wishes that stand, and those that do not, as `{ part, error }` with the part of a link.
 */
export async function openKnown(opening, scenario, { machine, faults, set }) {
  const refused = [];
  let wishes = { machine: null, faults: [], set: {} };
  let opened = await opening.open(scenario, wishes);
  const more = async (part, change) => {
    const next = { ...wishes, ...change(wishes) };
    const answer = await answered(() => opening.open(scenario, next), (error) => refused.push({ part, error }));
    if (answer === null) return;
    opened = { ...answer, isOther: opened?.isOther ?? false };
    wishes = next;
  };
  if (machine) await more(`machine=${machine}`, () => ({ machine }));
  for (const fault of faults) await more(`fault=${fault}`, (known) => ({ faults: [...known.faults, fault] }));
  for (const [key, value] of Object.entries(set)) await more(`set=${key}:${value}`, (known) => ({ set: { ...known.set, [key]: value } }));
  return { opened, wishes, refused };
}

/** Those of `names` that `probe` answers one by one, and the parts of a link that it refuses. */
export async function knownWires(names, probe) {
  const [known, refused] = [[], []];
  for (const name of names) {
    const answer = await answered(() => probe([name]), (error) => refused.push({ part: `wires=${name}`, error }));
    if (answer) known.push(name);
  }
  return { known, refused };
}

/** Numbers of a link that lie outside of what is opened: `view` with them brought back, and the parts of the link. */
export function bounded(view, frames, { columns, lines, sweeps }) {
  const refused = [];
  const outside = (key, count, what) => {
    const is = view[key] !== null && view[key] >= count && count > 0;
    if (is) refused.push({ part: `${key}=${view[key]}`, error: new RangeError(`there are ${count} ${what}`) });
    return is;
  };
  const known = {};
  if (outside("frame", frames, "frames")) known.frame = frames - 1;
  if (outside("sweep", sweeps, "sweeps")) known.sweep = sweeps - 1;
  if ([outside("column", columns, "columns"), outside("line", lines, "lines")].includes(true)) [known.column, known.line] = [null, null];
  return { known, refused };
}
