// What a new worker needs to go on where the last one ended: the given files, the last state, and the requests since.

/** Requests that change what is opened or driven. */
const CHANGES = new Set(["open", "set", "step", "restore"]);

/** A state of so many bytes is asked for once for each change; a longer one less often. */
const BYTES_OF_A_CHANGE = 1 << 14;

export class Journal {
  #files = new Map();
  #state = null;
  #since = [];

  /** Notes a request that was answered without an error. */
  note(header, planes) {
    if (!CHANGES.has(header.do)) return;
    if (header.do === "open") {
      for (const plane of planes) this.#files.set(plane.name, plane);
      this.#state = null;
      this.#since = [[header, []]];
    } else if (header.do === "restore") {
      this.#state = planes[0];
      this.#since = [];
    } else {
      this.#since.push([header, planes]);
    }
  }

  /** Whether it is time to ask for a state. */
  get isStateDue() {
    const bytes = this.#state?.values.byteLength ?? 0;
    return this.#since.length > bytes / BYTES_OF_A_CHANGE;
  }

  /** Keeps the state after everything that was noted. */
  keep(state) {
    this.#state = state;
    this.#since = [];
  }

  /** The given files, as planes. */
  files() {
    return [...this.#files.values()];
  }

  /** The requests that bring a module with the given files where the last one was, in their order. */
  requests() {
    const restored = this.#state ? [[{ do: "restore" }, [this.#state]]] : [];
    return [...restored, ...this.#since];
  }
}
