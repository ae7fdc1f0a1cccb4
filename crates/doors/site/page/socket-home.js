// The home at the other end of a socket: a program that draws with all its threads.

import { EndedError, Home } from "./home.js";

class SocketLink {
  #address;
  #socket = null;

  constructor(address) {
    this.#address = address;
  }

  get isLive() {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  start() {
    const socket = new WebSocket(this.#address);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    return new Promise((resolve, reject) => {
      socket.onopen = resolve;
      socket.onclose = async () => reject(new EndedError(await this.#why()));
    });
  }

  /** Why no socket was opened: a browser does not say what the program answered, so the page asks without one. */
  async #why() {
    const reply = await fetch(new URL(String(this.#address).replace(/^ws/, "http"))).catch(() => null);
    if (reply === null) return "the program has ended or does not answer: start it again, and open the address that it prints";
    const said = (await reply.text()).trim().replace(/^lunoid: /, "");
    return `the program opens no connection for this page: ${said}`;
  }

  /** The program goes on with a request that is given up, and its answer is thrown away with the socket. */
  ask(request, signal) {
    const socket = this.#socket;
    return new Promise((resolve, reject) => {
      const done = (settle, value) => {
        signal?.removeEventListener("abort", abort);
        settle(value);
      };
      const abort = () => {
        this.end();
        done(reject, signal.reason);
      };
      signal?.addEventListener("abort", abort);
      socket.onclose = () => done(reject, new EndedError("the connection to the program has ended"));
      socket.onmessage = ({ data }) => done(resolve, { bytes: new Uint8Array(data), memory: null });
      socket.send(request);
    });
  }

  end() {
    this.#socket?.close();
    this.#socket = null;
  }
}

export class SocketHome extends Home {
  /** `address` is that of the socket. `hear` is told of progress: see `Progress` in lunoid.d.ts. */
  constructor({ address = new URL("loop", import.meta.url.replace(/^http/, "ws")), hear = () => {} } = {}) {
    super(new SocketLink(address), hear);
  }
}
