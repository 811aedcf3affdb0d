// SPDX-License-Identifier: MIT
// Chromium without a window, driven by chromedriver through the WebDriver protocol: real events of pointer and keys.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";

const pollMilliseconds = 20;

export class Browser {
  /** @param {{width?: number, height?: number, dark?: boolean, touch?: boolean, ratio?: number, locale?: string,
   *   switches?: string[], traces?: boolean}} options traces: for requests() */
  static async start(options = {}) {
    const { width = 1280, height = 900, dark = false, touch = false, ratio = 1, locale = "en", switches = [], traces = false } = options;
    const driver = spawn("chromedriver", ["--port=0"], { stdio: ["ignore", "pipe", "ignore"] });
    const port = await new Promise((found, failed) => {
      driver.once("error", failed);
      createInterface(driver.stdout).on("line", (line) => {
        const match = line.match(/started successfully on port (\d+)/);
        if (match) found(match[1]);
      });
    });
    const browser = new Browser(driver, `http://127.0.0.1:${port}`);
    const chrome = { args: ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
      `--lang=${locale}`, `--window-size=${width},${height}`, ...(dark ? ["--force-dark-mode"] : []), ...switches],
      prefs: { "intl.accept_languages": locale },
      ...(touch ? { mobileEmulation: { deviceMetrics: { width, height, pixelRatio: ratio, touch: true } } } : {}) };
    const made = await browser.call("POST", "/session", { capabilities: { alwaysMatch: { browserName: "chrome",
      "goog:chromeOptions": chrome, "goog:loggingPrefs": { browser: "ALL", ...(traces ? { performance: "ALL" } : {}) } } } });
    browser.session = `/session/${made.sessionId}`;
    if (!touch) await browser.send("POST", "/window/rect", { width, height });
    if (dark) await browser.send("POST", "/goog/cdp/execute", { cmd: "Emulation.setEmulatedMedia",
      params: { features: [{ name: "prefers-color-scheme", value: "dark" }] } });
    return browser;
  }

  constructor(driver, address) {
    this.driver = driver;
    this.address = address;
    this.session = "";
  }

  async call(method, path, body) {
    const answer = await fetch(this.address + path, { method, body: body && JSON.stringify(body) });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${path}: ${value.message ?? JSON.stringify(value)}`);
    return value;
  }

  send(method, path, body) {
    return this.call(method, this.session + path, body);
  }

  open(address) {
    return this.send("POST", "/url", { url: address });
  }

  /** The value of an expression in the page. @param {string} expression */
  value(expression) {
    return this.send("POST", "/execute/sync", { script: `return ${expression};`, args: [] });
  }

  /** Waits until an expression is true in the page. @param {string} expression */
  async until(expression, seconds = 30) {
    const end = Date.now() + 1000 * seconds;
    while (!(await this.value(expression))) {
      if (Date.now() > end) throw new Error(`it never came that ${expression}`);
      await new Promise((go) => setTimeout(go, pollMilliseconds));
    }
  }

  /** A drag with a pointer: "mouse", "touch" or "pen". Points in pixels of the page. */
  async drag(points, { pointer = "mouse", key = null, release = true } = {}) {
    const moves = points.map(([x, y], i) => ({ type: "pointerMove", duration: i === 0 ? 0 : 60, x: Math.round(x), y: Math.round(y) }));
    const actions = [{ type: "pointer", id: pointer, parameters: { pointerType: pointer },
      actions: [moves[0], { type: "pointerDown", button: 0 }, ...moves.slice(1), ...(release ? [{ type: "pointerUp", button: 0 }] : [])] }];
    if (key) await this.send("POST", "/actions", { actions: [{ type: "key", id: "keys", actions: [{ type: "keyDown", value: key }] }] });
    await this.send("POST", "/actions", { actions });
    if (key) await this.send("POST", "/actions", { actions: [{ type: "key", id: "keys", actions: [{ type: "keyUp", value: key }] }] });
  }

  /** Two fingers from one pair of points to another. */
  async pinch(from, to) {
    const finger = (i) => ({ type: "pointer", id: `finger${i}`, parameters: { pointerType: "touch" }, actions: [
      { type: "pointerMove", duration: 0, x: from[i][0], y: from[i][1] }, { type: "pointerDown", button: 0 },
      { type: "pointerMove", duration: 80, x: to[i][0], y: to[i][1] }, { type: "pointerUp", button: 0 }] });
    await this.send("POST", "/actions", { actions: [finger(0), finger(1)] });
  }

  /** Presses keys one after the other. */
  async keys(...values) {
    const actions = values.flatMap((value) => [{ type: "keyDown", value }, { type: "keyUp", value }]);
    await this.send("POST", "/actions", { actions: [{ type: "key", id: "keys", actions }] });
  }

  /** What the page has complained about. */
  async complaints() {
    const entries = await this.send("POST", "/se/log", { type: "browser" });
    return entries.filter((entry) => entry.level !== "INFO" && entry.level !== "DEBUG").map((entry) => entry.message);
  }

  /** What has been asked for, by the page and its frames. @returns {Promise<string[]>} addresses */
  async requests() {
    const entries = await this.send("POST", "/se/log", { type: "performance" });
    const events = entries.map((entry) => JSON.parse(entry.message).message);
    return events.filter(({ method }) => method === "Network.requestWillBeSent").map(({ params }) => params.request.url);
  }

  /** A PNG of what is seen. @returns {Promise<Buffer>} */
  async picture() {
    return Buffer.from(await this.send("GET", "/screenshot"), "base64");
  }

  async end() {
    await this.send("DELETE", "").catch(() => {});
    this.driver.kill();
    if (this.driver.exitCode === null) await once(this.driver, "exit");
  }
}
