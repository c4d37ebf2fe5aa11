// SPDX-License-Identifier: BSL-1.0
import { spawn } from "node:child_process";

/** Controls headless Chromium by JSON messages through its debugging pipe. A zero byte ends each message. */
export class Browser {
  constructor(program, profile, options = []) {
    this.process = spawn(program, ["--headless", "--no-sandbox", "--no-first-run", "--disable-quic", "--hide-scrollbars",
      "--disable-background-networking", "--disable-component-update", "--disable-sync", "--force-device-scale-factor=1",
      "--remote-debugging-pipe", `--user-data-dir=${profile}`, ...options, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.waiting = new Map();
    this.latest = 0;
    this.errors = []; // of the page's scripts
    this.requests = []; // of the page, except for the page itself
    let rest = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      messages.forEach((message) => this.receive(JSON.parse(message)));
    });
    this.process.on("exit", () => this.waiting.forEach(({ reject }) => reject(new Error("the browser ended"))));
    this.process.on("error", (error) => this.waiting.forEach(({ reject }) => reject(error)));
  }

  receive({ id, result, error, method, params }) {
    if (id !== undefined) {
      const { resolve, reject } = this.waiting.get(id);
      this.waiting.delete(id);
      error ? reject(new Error(error.message)) : resolve(result);
    } else if (method === "Runtime.exceptionThrown") {
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    } else if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type)) {
      this.errors.push(params.args.map(({ value, description }) => value ?? description).join(" "));
    } else if (method === "Network.requestWillBeSent" && params.type !== "Document") {
      this.requests.push(params.request.url);
    }
  }

  ask(method, params = {}, session = this.session) {
    const id = ++this.latest;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  async start(width, height) {
    const { targetInfos } = await this.ask("Target.getTargets");
    const { targetId } = targetInfos.find(({ type }) => type === "page");
    ({ sessionId: this.session } = await this.ask("Target.attachToTarget", { targetId, flatten: true }));
    for (const domain of ["Page", "Runtime", "Network"]) {
      await this.ask(`${domain}.enable`);
    }
    await this.resize(width, height);
  }

  resize(width, height) {
    return this.ask("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
  }

  colour_scheme(value) {
    return this.ask("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
  }

  async value(expression) {
    const { result, exceptionDetails } = await this.ask("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) {
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    }
    return result.value;
  }

  /** Opens a page, and waits until it is ready and its next frame is shown. */
  async open(address) {
    await this.ask("Page.navigate", { url: "about:blank" });
    await this.ask("Page.navigate", { url: address });
    await this.until('location.protocol !== "about:" && document.body?.dataset.ready === "true"');
    await this.frame();
  }

  async go(fragment) {
    await this.value(`location.hash = ${JSON.stringify(fragment)}; 0`);
    await this.frame();
  }

  /** Waits until the pending frame is drawn and shown. */
  frame() {
    return this.value("new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(() => go())))");
  }

  /** Waits for the condition, for at least a minute. */
  async until(condition) {
    for (let tries = 0; tries < 1200; ++tries) {
      if (await this.value(condition).catch(() => false)) {
        return;
      }
      await new Promise((go) => setTimeout(go, 50));
    }
    throw new Error(`never came true: ${condition}`);
  }

  async key(key, modifiers = 0) {
    for (const type of ["keyDown", "keyUp"]) {
      await this.ask("Input.dispatchKeyEvent", { type, key, modifiers, ...(key === " " ? { text: " " } : {}) });
    }
  }

  async picture() {
    const { data } = await this.ask("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }

  async stop() {
    const ended = new Promise((go) => this.process.on("exit", go));
    await this.ask("Browser.close", {}, undefined).catch(() => {});
    await ended;
  }
}
