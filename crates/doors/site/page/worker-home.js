// The home in the browser alone: the module in a worker of its own.

import { EndedError, Home } from "./home.js";
import { loadModule } from "./module.js";

class WorkerLink {
  #address;
  #hear;
  #worker = null;

  constructor(address, hear) {
    this.#address = address;
    this.#hear = hear;
  }

  get isLive() {
    return this.#worker !== null;
  }

  async start() {
    const module = await loadModule(this.#address, this.#hear);
    this.#worker = new Worker(new URL("worker.js", import.meta.url), { type: "module", name: "lunoid" });
    await this.#post({ module });
  }

  ask(request, signal) {
    return this.#post({ request }, signal);
  }

  /** Makes the module panic. */
  fail() {
    return this.#post({ fail: true });
  }

  end() {
    this.#worker?.terminate();
    this.#worker = null;
  }

  /** What the worker posts in answer to `message`. */
  #post(message, signal) {
    const worker = this.#worker;
    return new Promise((resolve, reject) => {
      const done = (settle, value) => {
        signal?.removeEventListener("abort", abort);
        settle(value);
      };
      const ended = (error) => {
        this.end();
        done(reject, error);
      };
      const abort = () => ended(signal.reason);
      signal?.addEventListener("abort", abort);
      worker.onerror = (event) => {
        event.preventDefault();
        ended(new EndedError(event.message || "the worker could not be started"));
      };
      worker.onmessage = ({ data }) => {
        if (data.ended !== undefined) ended(new EndedError(data.ended));
        else if (data.refused !== undefined) done(reject, new RangeError(data.refused));
        else done(resolve, { bytes: data.reply, memory: data.memory });
      };
      worker.postMessage(message);
    });
  }
}

export class WorkerHome extends Home {
  #link;

  /** `module` is the address of lunoid.wasm. `hear` is told of progress: see `Progress` in lunoid.d.ts. */
  constructor({ module = new URL("lunoid.wasm", import.meta.url), hear = () => {} } = {}) {
    const link = new WorkerLink(module, hear);
    super(link, hear);
    this.#link = link;
  }

  /** Makes the module panic, for tests of a page. */
  fail() {
    return this.inTurn(() => this.#link.fail());
  }
}
