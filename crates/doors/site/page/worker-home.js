// The home in the browser alone: the module in a worker of its own. See `Home` in lunoid.d.ts.

import { Journal } from "./journal.js";
import { decode, encode } from "./message.js";
import { loadModule } from "./module.js";

/** The module ended while it answered; a new one has the same state. */
export class EndedError extends Error {
  name = "EndedError";
}

export class WorkerHome {
  #address;
  #hear;
  #worker = null;
  #starting = null;
  #journal = new Journal();
  #turn = Promise.resolve();
  #number = 0;

  /** `module` is the address of lunoid.wasm. `hear` is told of progress: see `Progress` in lunoid.d.ts. */
  constructor({ module = new URL("lunoid.wasm", import.meta.url), hear = () => {} } = {}) {
    this.#address = module;
    this.#hear = hear;
  }

  /** Answers `header` and `planes` after all requests before. Where `signal` aborts, the worker is ended and started again. */
  request(header, planes = [], { signal } = {}) {
    const answered = this.#turn.then(() => this.#answer(header, planes, signal));
    this.#turn = answered.catch(() => {});
    return answered;
  }

  /** Ends the worker for good. */
  close() {
    this.#end();
  }

  /** Makes the module panic, for tests of a page. */
  fail() {
    const failed = this.#turn.then(async () => {
      await this.#ready();
      return this.#ask({ fail: true }).catch((error) => this.#recover(error));
    });
    this.#turn = failed.catch(() => {});
    return failed;
  }

  async #answer(header, planes, signal) {
    signal?.throwIfAborted();
    await this.#ready();
    const begun = performance.now();
    this.#hear({ phase: "working", do: header.do });
    try {
      const reply = await this.#ask({ request: this.#bytes(header, planes) }, signal);
      const milliseconds = performance.now() - begun;
      this.#hear({ phase: "idle", do: header.do, milliseconds, memory: reply.memory });
      const { header: told, planes: answered } = decode(reply.bytes);
      if (told.ok !== undefined) await this.#note(header, planes);
      return { header: told, planes: answered };
    } catch (error) {
      return this.#recover(error);
    }
  }

  #bytes(header, planes) {
    this.#number += 1;
    return encode({ id: this.#number, ...header }, planes);
  }

  async #note(header, planes) {
    this.#journal.note(header, planes);
    if (!this.#journal.isStateDue) return;
    const { bytes } = await this.#ask({ request: this.#bytes({ do: "state" }, []) });
    const { planes: [state] } = decode(bytes);
    if (state) this.#journal.keep(state);
  }

  /** Brings a new worker where the last one was, and tells `error`. A fault of the request alone has left the worker as it was. */
  async #recover(error) {
    if (this.#worker === null) {
      this.#hear({ phase: "ended", reason: error.message });
      await this.#ready();
    }
    throw error;
  }

  #ready() {
    if (this.#starting === null) {
      this.#starting = this.#start();
      this.#starting.catch(() => this.#end());
    }
    return this.#starting;
  }

  async #start() {
    const module = await loadModule(this.#address, this.#hear);
    this.#worker = new Worker(new URL("worker.js", import.meta.url), { type: "module", name: "lunoid" });
    await this.#ask({ module });
    const files = this.#journal.files();
    // The scenario is none: the files alone are meant, and they stay.
    if (files.length) await this.#ask({ request: this.#bytes({ do: "open", scenario: "" }, files) });
    for (const [header, planes] of this.#journal.requests()) {
      this.#hear({ phase: "restoring", do: header.do });
      await this.#ask({ request: this.#bytes(header, planes) });
    }
    this.#hear({ phase: "ready" });
  }

  /** What the worker posts in answer to `message`. */
  #ask(message, signal) {
    const worker = this.#worker;
    return new Promise((resolve, reject) => {
      const done = (settle, value) => {
        signal?.removeEventListener("abort", abort);
        settle(value);
      };
      const ended = (error) => {
        this.#end();
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

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#starting = null;
  }
}
