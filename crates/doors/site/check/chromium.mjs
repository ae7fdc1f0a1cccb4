// Chromium without a window, by WebDriver.

import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { Browser } from "./browser.mjs";

const ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1000,800"];

export class Chromium extends Browser {
  static async open() {
    const driver = spawn("chromedriver", ["--port=0"], { stdio: ["ignore", "pipe", "ignore"] });
    const chromium = new Chromium();
    chromium.driver = driver;
    const port = await new Promise((resolve, reject) => {
      driver.on("exit", (code) => reject(new Error(`chromedriver ended with ${code} before it named a port`)));
      driver.on("error", () => reject(new Error("chromedriver is missing: install chromium and chromium-driver")));
      createInterface({ input: driver.stdout }).on("line", (line) => {
        const found = line.match(/successfully on port (\d+)/);
        if (found) resolve(found[1]);
      });
    });
    chromium.base = `http://127.0.0.1:${port}`;
    const wishes = { "goog:chromeOptions": { args: ARGUMENTS }, "goog:loggingPrefs": { browser: "ALL" } };
    const opened = chromium.ask("POST", "/session", { capabilities: { alwaysMatch: wishes } });
    const { sessionId, capabilities } = await opened.catch((error) => {
      driver.kill();
      throw error;
    });
    chromium.version = capabilities.browserVersion;
    chromium.base += `/session/${sessionId}`;
    await chromium.ask("POST", "/timeouts", { script: 600_000 });
    return chromium;
  }

  async ask(method, path, body) {
    const response = await fetch(this.base + path, { method, body: body && JSON.stringify(body) });
    const { value } = await response.json();
    if (!response.ok) throw new Error(`${path}: ${value.message}`);
    return value;
  }

  go(url) {
    return this.ask("POST", "/url", { url });
  }

  /** What the body of an async function returns in any page, with `values`. */
  async script(body, ...values) {
    const script = `
      const done = arguments[arguments.length - 1];
      const values = [...arguments].slice(0, -1);
      (async () => { ${body} })().then((ok) => done({ ok }), (error) => done({ error: String(error && error.stack || error) }));`;
    const { ok, error } = await this.ask("POST", "/execute/async", { script, args: values });
    if (error) throw new Error(error);
    return ok;
  }

  act(actions) {
    return this.ask("POST", "/actions", { actions });
  }

  /** What the console has had since the last look. */
  console() {
    return this.ask("POST", "/se/log", { type: "browser" });
  }

  /** Makes the page so many pixels wide, with a light or a dark look. */
  async emulate(width, scheme) {
    const devtools = (cmd, params) => this.ask("POST", "/goog/cdp/execute", { cmd, params });
    await devtools("Emulation.setDeviceMetricsOverride", { width, height: 900, deviceScaleFactor: 1, mobile: width < 600 });
    await devtools("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
  }

  /** Shows the page as on a `media`: "screen" or "print". */
  media(media) {
    return this.ask("POST", "/goog/cdp/execute", { cmd: "Emulation.setEmulatedMedia", params: { media } });
  }

  async screenshot() {
    return Buffer.from(await this.ask("GET", "/screenshot"), "base64");
  }

  async close() {
    await this.ask("DELETE", "").catch(() => {});
    this.driver.kill();
  }
}
