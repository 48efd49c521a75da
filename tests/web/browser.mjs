// Chromium with the page in it, for tests: everything is done as a person does it, by mouse, keys and addresses.
import puppeteer from "../../build/web-npm/node_modules/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js";

// [ms] a software renderer on a busy machine is slow
const PATIENCE = 120000;

export function startBrowser(flags = []) {
  return puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    protocolTimeout: PATIENCE,
    // WebGL without a graphics card
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", ...flags],
  });
}

/** Firefox: without a display it has no WebGL. */
export function startFirefox() {
  return puppeteer.launch({
    browser: "firefox", executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr", headless: false, protocolTimeout: PATIENCE,
    // Firefox does not use a software renderer by itself
    extraPrefsFirefox: { "webgl.force-enabled": true },
  });
}

/** A visit of the page. Messages of the console and requests to other hosts are kept in `faults`. */
export class Visit {
  static async begin(browser, address, { width = 1280, height = 761, touch = false, ratio = 1, context } = {}) {
    const visit = new Visit();
    visit.tab = await (context ?? browser).newPage();
    visit.faults = [];
    visit.address = address;
    visit.tab.on("console", (m) => { if (m.type() === "error" || m.type() === "warn") { visit.faults.push(m.text()); } });
    visit.tab.on("pageerror", (e) => visit.faults.push(e.message));
    visit.tab.on("request", (r) => {
      const url = r.url();
      if (!url.startsWith(address) && !url.startsWith("blob:") && !url.startsWith("data:")) { visit.faults.push(`asked ${url}`); }
    });
    await visit.tab.setViewport({ width, height, hasTouch: touch, deviceScaleFactor: ratio });
    return visit;
  }
  /** From the next page on the browser shows no WebGL 2. */
  hideWebgl() {
    return this.tab.evaluateOnNewDocument(() => {
      const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === "webgl2" ? null : get.call(this, kind, ...rest); };
    });
  }
  async open(hash = "") {
    await this.tab.goto(this.address + hash);
    await this.ready();
  }
  async ready() {
    await this.tab.waitForFunction(() => window.jointwise?.loop.frames > 0 || document.querySelector(".missing h1"), { timeout: PATIENCE });
  }
  /** Waits until nothing changes any more without input. */
  async rest() {
    await this.tab.waitForFunction(() => {
      const { loop } = window.jointwise;
      const same = loop.frames === window.framesBefore && !loop.asked;
      window.framesBefore = loop.frames;
      return same;
    }, { timeout: PATIENCE, polling: 150 });
  }
  state() { return this.tab.evaluate(() => window.jointwise.program.state()); }
  fragment() { return this.tab.evaluate(() => window.jointwise.program.address()); }
  async key(name) {
    await this.tab.focus("#canvas");
    await this.tab.keyboard.press(name);
    await this.rest();
  }
  async type(text) {
    await this.tab.focus("#canvas");
    await this.tab.keyboard.type(text);
    await this.rest();
  }
  /** Makes the canvas as large as a picture. */
  async fit(width, height) {
    const now = await this.tab.evaluate(() => [innerWidth - document.getElementById("canvas").width, innerHeight - document.getElementById("canvas").height]);
    await this.tab.setViewport({ width: width + now[0], height: height + now[1] });
    await this.tab.waitForFunction((w, h) => { const c = document.getElementById("canvas"); return c.width === w && c.height === h; }, { timeout: PATIENCE }, width, height);
    await this.rest();
  }
  /** The canvas as the data of a PNG, drawn again, since the browser keeps the picture that was shown. */
  picture() {
    return this.tab.evaluate(() => {
      const canvas = document.getElementById("canvas");
      const { program } = window.jointwise;
      program.resize(canvas.width, canvas.height);
      for (let k = 0; k < 3; ++k) { program.frame(1); }
      return canvas.toDataURL();
    });
  }
  close() { return this.tab.close(); }
}

/** How two pictures differ: share of the pixels that differ at all, and by more than `clearly` of 255 in a channel. */
export async function difference(browser, a, b, clearly = 8) {
  const tab = await browser.newPage();
  try {
    return await tab.evaluate(async (one, other, least) => {
      const pixelsOf = async (data) => {
        const image = new Image();
        image.src = data;
        await image.decode();
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      };
      const [p, q] = [await pixelsOf(one), await pixelsOf(other)];
      if (p.width !== q.width || p.height !== q.height) { return { share: 1, clear: 1 }; }
      let count = 0;
      let clear = 0;
      for (let k = 0; k < p.data.length; k += 4) {
        const d = Math.max(Math.abs(p.data[k] - q.data[k]), Math.abs(p.data[k + 1] - q.data[k + 1]), Math.abs(p.data[k + 2] - q.data[k + 2]));
        if (d > 0) { ++count; }
        if (d > least) { ++clear; }
      }
      return { share: count / (p.width * p.height), clear: clear / (p.width * p.height) };
    }, a, b, clearly);
  } finally { await tab.close(); }
}
