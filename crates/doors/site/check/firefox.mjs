// Firefox without a window, by WebDriver BiDi: the same calls as `chromium.mjs`.

import { spawn } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { Browser } from "./browser.mjs";

/** What a profile of its own has: no first page, no asking home, and times as fine as in Chromium. */
const PREFERENCES = {
  "browser.shell.checkDefaultBrowser": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "app.update.enabled": false,
  "privacy.reduceTimerPrecision": false,
};

/** What Firefox says of requests that end because their page is left. The walk through the books leaves figures that still load. */
const LEFT = /^NS_BINDING_ABORTED: $/;

export class Firefox extends Browser {
  #asked = new Map();
  #messages = [];
  #count = 0;

  static async open() {
    const firefox = new Firefox();
    firefox.profile = await mkdtemp(join(tmpdir(), "lunoid-firefox-"));
    const lines = Object.entries(PREFERENCES).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`);
    await writeFile(join(firefox.profile, "user.js"), lines.join(""));
    const address = await firefox.#start();
    firefox.socket = new WebSocket(`${address}/session`);
    firefox.socket.onmessage = ({ data }) => firefox.#hear(JSON.parse(data));
    await new Promise((resolve, reject) => {
      firefox.socket.onopen = resolve;
      firefox.socket.onerror = () => reject(new Error("Firefox takes no WebDriver BiDi"));
    });
    const { capabilities } = await firefox.ask("session.new", { capabilities: {} });
    firefox.version = capabilities.browserVersion;
    await firefox.ask("session.subscribe", { events: ["log.entryAdded"] });
    // Keys press buttons only in a window that has the focus, which the first one never gets.
    const { context } = await firefox.ask("browsingContext.create", { type: "window" });
    firefox.context = context;
    await firefox.ask("browsingContext.activate", { context });
    await firefox.emulate(1000);
    return firefox;
  }

  /** Starts the program; answers the address that it names. */
  #start() {
    const names = ["--headless", "--no-remote", "--remote-debugging-port=0", "--profile", this.profile, "about:blank"];
    this.program = spawn(process.env.FIREFOX ?? "firefox-esr", names, { stdio: ["ignore", "ignore", "pipe"] });
    return new Promise((resolve, reject) => {
      this.program.on("exit", (code) => reject(new Error(`Firefox ended with ${code} before it named an address`)));
      this.program.on("error", () => reject(new Error("Firefox is missing: install firefox-esr, or name its program in the variable FIREFOX")));
      createInterface({ input: this.program.stderr }).on("line", (line) => {
        const found = line.match(/WebDriver BiDi listening on (ws:\S+)/);
        if (found) resolve(found[1]);
      });
    });
  }

  #hear({ id, type, error, message, result, method, params }) {
    if (method === "log.entryAdded") {
      const isTold = params.level === "error" || params.level === "warn";
      if (isTold && !LEFT.test(params.text)) this.#messages.push({ level: params.level, message: params.text });
      return;
    }
    const waiting = this.#asked.get(id);
    this.#asked.delete(id);
    if (type === "success") waiting?.resolve(result);
    else waiting?.reject(new Error(`${waiting.method}: ${error}: ${message}`));
  }

  ask(method, params) {
    this.#count += 1;
    const id = this.#count;
    return new Promise((resolve, reject) => {
      this.#asked.set(id, { method, resolve, reject });
      this.socket.send(JSON.stringify({ id, method, params }));
    });
  }

  go(url) {
    return this.ask("browsingContext.navigate", { context: this.context, url, wait: "complete" });
  }

  /** What the body of an async function returns in any page, with `values`. */
  async script(body, ...values) {
    const told = await this.ask("script.callFunction", {
      functionDeclaration: `async (text) => { const values = JSON.parse(text); const told = await (async () => { ${body} })(); return JSON.stringify(told ?? null); }`,
      arguments: [{ type: "string", value: JSON.stringify(values) }],
      awaitPromise: true,
      target: { context: this.context },
      userActivation: true,
    });
    if (told.type === "exception") throw new Error(`${told.exceptionDetails.text}\n${JSON.stringify(told.exceptionDetails.stackTrace?.callFrames?.[0] ?? null)}`);
    return JSON.parse(told.result.value);
  }

  act(actions) {
    return this.ask("input.performActions", { context: this.context, actions });
  }

  /** What the console has had since the last look. */
  console() {
    return this.#messages.splice(0);
  }

  /** Makes the page so many pixels wide. Its look is that of the system: BiDi has no light and dark. */
  emulate(width) {
    return this.ask("browsingContext.setViewport", { context: this.context, viewport: { width, height: 900 }, devicePixelRatio: 1 });
  }

  async screenshot() {
    const { data } = await this.ask("browsingContext.captureScreenshot", { context: this.context });
    return Buffer.from(data, "base64");
  }

  async close() {
    await this.ask("browser.close", {}).catch(() => {});
    this.socket.close();
    this.program.kill();
    await rm(this.profile, { recursive: true, force: true });
  }
}
