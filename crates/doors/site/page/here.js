// Where the machine of these pages is: in a worker of the page. `lunoid drive` serves another file of this name.

export { WorkerHome as Here } from "./worker-home.js";

/** What the instrument shows where its address says nothing: a late word tears the mountain. */
export const FIRST = { scenario: "scenarios/first-light.toml", frame: 60, wires: "mu.height,sweep.x", set: { "loader.access_ns": 90 }, faults: [] };

/** Whether the books of the documentation lie beside these pages. */
export const HAS_BOOKS = true;

/** Whether files of the reader can be opened. */
export const TAKES_FILES = true;
