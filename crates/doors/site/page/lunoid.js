// The machine in a page: scenarios in, pictures and signals out. Types: lunoid.d.ts.

import { WorkerHome } from "./worker-home.js";

export { EndedError } from "./home.js";
export { SocketHome } from "./socket-home.js";
export { WorkerHome } from "./worker-home.js";

/** The faults of files or of a request. `problems` has file, line, column, key, title, found, expected and help of each. */
export class LunoidError extends Error {
  name = "LunoidError";

  constructor(problems) {
    super(problems.map(told).join("\n"));
    this.problems = problems;
  }
}

function told({ file, line, title, found, expected, help }) {
  const place = [file, line].filter((part) => part !== null && part !== undefined).join(":");
  const rest = [found && `found ${found}`, expected && `expected ${expected}`, help].filter(Boolean);
  return [`${place}: ${title}`, ...rest].join("; ");
}

/** The machine, in whatever home answers: a worker of this page unless another is given. */
export class Lunoid {
  #home;

  constructor(home = new WorkerHome()) {
    this.#home = home;
  }

  /** Sends a request of the protocol; answers what is under `ok`, with `planes` by name. */
  async request(header, planes = [], options = {}) {
    const answered = await this.#home.request(header, planes, options);
    const { ok, error } = answered.header;
    if (error) throw new LunoidError(error.problems);
    return { ...ok, planes: Object.fromEntries(answered.planes.map((plane) => [plane.name, plane])) };
  }

  hello(options) {
    return this.request({ do: "hello" }, [], options);
  }

  /** Opens `scenario`, a name of `files` or of a file given before. `files` maps names to bytes or text. */
  open(scenario, { files = {}, machine, overlays, channel, set, ...options } = {}) {
    const bytes = (content) => (typeof content === "string" ? new TextEncoder().encode(content) : new Uint8Array(content));
    const planes = Object.entries(files).map(([name, content]) => ({ name, values: bytes(content) }));
    return this.request({ do: "open", scenario, ...wanted({ machine, overlays, channel, set }) }, planes, options);
  }

  frame(frame, { planes, ...options } = {}) {
    return this.request({ do: "frame", frame, ...wanted({ planes }) }, [], options);
  }

  look(pose, { frame, planes, ...options } = {}) {
    return this.request({ do: "look", pose, ...wanted({ frame, planes }) }, [], options);
  }

  step(pose, { planes, ...options } = {}) {
    return this.request({ do: "step", pose, ...wanted({ planes }) }, [], options);
  }

  ahead({ pose, metres = 0, turn_deg = 0 } = {}, options) {
    return this.request({ do: "ahead", metres, turn_deg, ...wanted({ pose }) }, [], options);
  }

  probe(signals, sweeps, { frame, pose, ...options } = {}) {
    return this.request({ do: "probe", signals, sweeps, ...wanted({ frame, pose }) }, [], options);
  }

  explain(column, line, { frame, pose, ...options } = {}) {
    return this.request({ do: "explain", column, line, ...wanted({ frame, pose }) }, [], options);
  }

  /** Changes settings and keeps the loop; a value of null takes a setting back. */
  set(set, { machine, overlays, channel, ...options } = {}) {
    return this.request({ do: "set", ...wanted({ set, machine, overlays, channel }) }, [], options);
  }

  events({ frame, pose, sweeps, unit, event, colour, level, from, to, limit, ...options } = {}) {
    const keys = wanted({ frame, pose, sweeps, unit, event, colour, level, from, to, limit });
    return this.request({ do: "events", ...keys }, [], options);
  }

  /** Places of a frame where a condition is met, in the language of `lunoid trigger`; the first one unless `limit` asks for more. */
  trigger(on, { frame, pose, sweeps, samples, after, limit, ...options } = {}) {
    return this.request({ do: "trigger", on, ...wanted({ frame, pose, sweeps, samples, after, limit }) }, [], options);
  }

  /** The pixels that late words changed; `late` is a late event as text, or its sweep and crossing, as "260:60". */
  effect(late, { frame, pose, ...options } = {}) {
    return this.request({ do: "effect", late, ...wanted({ frame, pose }) }, [], options);
  }

  /** What of a frame was late: folds, late words, missed deadlines. */
  timing({ frame, pose, ...options } = {}) {
    return this.request({ do: "timing", ...wanted({ frame, pose }) }, [], options);
  }

  omissions(options) {
    return this.request({ do: "omissions" }, [], options);
  }

  signals(options) {
    return this.request({ do: "signals" }, [], options);
  }

  blocks(options) {
    return this.request({ do: "blocks" }, [], options);
  }

  parameters(options) {
    return this.request({ do: "parameters" }, [], options);
  }

  faults(options) {
    return this.request({ do: "faults" }, [], options);
  }

  /** The plane with which `restore` goes on, in this page or another; with `frames` after so many frames of the loop. */
  async state({ frames, ...options } = {}) {
    return (await this.request({ do: "state", ...wanted({ frames }) }, [], options)).planes.state;
  }

  restore(state, options) {
    return this.request({ do: "restore" }, [state], options);
  }

  record(name, options) {
    return this.request({ do: "record", ...wanted({ name }) }, [], options);
  }

  close() {
    this.#home.close();
  }
}

/** Only the keys that have a value. */
function wanted(keys) {
  return Object.fromEntries(Object.entries(keys).filter(([, value]) => value !== undefined));
}
