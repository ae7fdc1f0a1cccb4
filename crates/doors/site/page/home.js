// A home: whoever answers requests, by a link that may end and is made again with the same state. See `Home` in lunoid.d.ts.

import { Journal } from "./journal.js";
import { decode, encode } from "./message.js";

/** Whoever answered has ended meanwhile; the next one has the same state. */
export class EndedError extends Error {
  name = "EndedError";
}

/**
 * A link has `start()`, `ask(bytes, signal)`, `end()` and `isLive`. `ask` answers `bytes` of the reply and `memory` in bytes, or null where that
 * is not known. An error that ends the link leaves `isLive` false.
 */
export class Home {
  #link;
  #hear;
  #starting = null;
  #journal = new Journal();
  #turn = Promise.resolve();
  #number = 0;

  /** `hear` is told of progress: see `Progress` in lunoid.d.ts. */
  constructor(link, hear) {
    this.#link = link;
    this.#hear = hear;
  }

  /** Answers `header` and `planes` after all requests before. Where `signal` aborts, the link is ended and made again. */
  request(header, planes = [], { signal } = {}) {
    return this.inTurn(() => this.#answer(header, planes, signal));
  }

  /** Ends the link for good. */
  close() {
    this.#link.end();
  }

  /** Does `once` after all requests before, and restores what it ends. */
  inTurn(once) {
    const done = this.#turn.then(async () => {
      await this.ready();
      return once().catch((error) => this.#recover(error));
    });
    this.#turn = done.catch(() => {});
    return done;
  }

  /** Answers when there is a link with the state of everything that was answered before. */
  ready() {
    if (this.#starting === null || !this.#link.isLive) {
      this.#starting = this.#start();
      this.#starting.catch(() => this.#link.end());
    }
    return this.#starting;
  }

  async #answer(header, planes, signal) {
    signal?.throwIfAborted();
    const begun = performance.now();
    this.#hear({ phase: "working", do: header.do });
    const reply = await this.#link.ask(this.#bytes(header, planes), signal);
    const milliseconds = performance.now() - begun;
    this.#hear({ phase: "idle", do: header.do, milliseconds, memory: reply.memory });
    const { header: told, planes: answered } = decode(reply.bytes);
    if (told.ok !== undefined) await this.#note(header, planes);
    return { header: told, planes: answered };
  }

  #bytes(header, planes) {
    this.#number += 1;
    return encode({ id: this.#number, ...header }, planes);
  }

  async #note(header, planes) {
    this.#journal.note(header, planes);
    if (!this.#journal.isStateDue) return;
    const { bytes } = await this.#link.ask(this.#bytes({ do: "state" }, []));
    const { planes: [state] } = decode(bytes);
    if (state) this.#journal.keep(state);
  }

  /** Makes a new link where the last one has ended, and tells `error`. A fault of the request alone has left the link as it was. */
  async #recover(error) {
    if (!this.#link.isLive) {
      this.#hear({ phase: "ended", reason: error.message });
      await this.ready();
    }
    throw error;
  }

  async #start() {
    await this.#link.start();
    const files = this.#journal.files();
    // The scenario is none: the files alone are meant, and they stay.
    if (files.length) await this.#link.ask(this.#bytes({ do: "open", scenario: "" }, files));
    for (const [header, planes] of this.#journal.requests()) {
      this.#hear({ phase: "restoring", do: header.do });
      await this.#link.ask(this.#bytes(header, planes));
    }
    this.#hear({ phase: "ready" });
  }
}
