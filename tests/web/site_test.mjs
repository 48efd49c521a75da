// Tests of the site that the program has written of its own lessons, as a student meets it.
import { execFileSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, root, served, test } from "./suite.mjs";

const SIZES = [[390, 844], [820, 1180], [1280, 800], [1920, 1080]];
const LESSON = "lessons/loops/four-bar.html";
const address = await served("build/site");
const pages = readdirSync(join(root, "build/site"), { recursive: true }).filter((f) => f.endsWith(".html") && !f.startsWith("live")).sort();

/** A visit of a page whose figure loads only on demand, as on a metered line; it must end without faults. */
async function visitPage(path, run, { saving = true, scripts = true, ...options } = {}) {
  const context = await browser.createBrowserContext();
  const v = await Visit.begin(browser, address, { context, width: 1280, height: 800, ...options });
  if (saving) {
    await v.tab.evaluateOnNewDocument(() => Object.defineProperty(navigator, "connection", { value: { saveData: true } }));
  }
  await v.tab.setJavaScriptEnabled(scripts);
  await v.tab.goto(address + path);
  await run(v, v.tab);
  noFaults(v);
  await v.close();
  await context.close();
}

/** The program in the figure of a page, once it runs. */
async function programIn(tab) {
  const handle = await tab.waitForSelector("figure.live iframe", { timeout: 60000 });
  const frame = await handle.contentFrame();
  await frame.waitForFunction(() => window.jointwise?.loop.frames > 0, { timeout: 60000 });
  return {
    frame,
    state: () => frame.evaluate(() => window.jointwise.program.state()),
    address: () => frame.evaluate(() => window.jointwise.program.address()),
    until: (holds, ...values) => frame.waitForFunction(holds, { timeout: 60000 }, ...values),
  };
}

test("Every page of the site opens without a fault, and asks no other host", async () => {
  check(pages.length > 60, `${pages.length} pages`);
  await visitPage("index.html", async (v, tab) => {
    for (const page of pages) {
      await tab.goto(address + page);
      const [title, headings] = await tab.evaluate(() => [document.title, [...document.querySelectorAll("h1, h2, h3")].map((h) => Number(h.tagName[1]))]);
      check(title !== "", `${page} has no title`);
      equal(headings.filter((level) => level === 1).length, 1, `headings of ${page}`);
      check(headings.every((level, k) => k === 0 || level <= headings[k - 1] + 1), `${page} leaves a level of headings out: ${headings}`);
      equal(v.faults, [], `faults of ${page}`);
    }
  });
});

test("The search of the site finds what the program finds", async () => {
  await visitPage("index.html", async (v, tab) => {
    for (const words of ["screw", "bennett", "slide 8", "slides 4-6, 20", "REVOLUTE rank", "θ", "no such words", "four bar"]) {
      let told = { lessons: [] };
      try {
        told = JSON.parse(execFileSync(join(root, "build/release/app/jointwise"), ["list", join(root, "lessons/catalogue"), ...words.split(" "), "--format", "json"], { stdio: ["ignore", "pipe", "ignore"] }));
      } catch (error) { equal(error.status, 1, "status where nothing is found"); }
      const expected = told.lessons.map((lesson) => basename(lesson.file, ".toml")).sort();
      await tab.$eval("#search", (field) => { field.value = ""; });
      await tab.type("#search", words);
      await tab.waitForFunction(() => document.getElementById("found").textContent !== "");
      const found = await tab.evaluate(() => [...document.querySelectorAll("[data-lesson]")].filter((card) => card.checkVisibility()).map((card) => card.dataset.lesson.split("/").pop()).sort());
      equal(found, expected, `lessons with ${words}`);
    }
    await tab.$eval("#search", (field) => { field.value = ""; field.dispatchEvent(new Event("input")); });
    equal(await tab.evaluate(() => document.querySelectorAll("[data-lesson]:not([hidden])").length), pages.length - 2, "lessons without a search");
  });
});

test("The figure of a lesson runs when it comes into view, and is led by the page", async () => {
  await visitPage(LESSON, async (v, tab) => {
    await new Promise((later) => setTimeout(later, 500));
    // on a phone the figure stands below the words
    equal(await tab.evaluate(() => document.querySelectorAll("iframe").length), 0, "figures that nobody sees");
    await tab.evaluate(() => document.querySelector("figure.live").scrollIntoView());
    const program = await programIn(tab);
    const last = (await program.state()).step;
    check(last > 20, `step ${last}`);
    const click = (selector) => tab.$eval(selector, (link) => link.click());
    await click("#step-1 a.go");
    await program.until(() => window.jointwise.program.state().step === 0);
    await click(".trials a.go");
    await program.until(() => window.jointwise.program.state().tried.length === 1);
    equal(await tab.$eval(".own", (link) => decodeURIComponent(link.hash).includes("try=")), true, "the link to a window of its own");
    await click(".exercise a.go");
    const name = await tab.$eval(".exercise", (part) => part.id.replace("exercise-", ""));
    await program.until((wanted) => window.jointwise.program.address() === `four-bar?exercise=${wanted}`, name);
    equal(await tab.evaluate(() => document.querySelectorAll("iframe").length), 1, "figures");
  }, { saving: false, width: 390, height: 320 });
});

test("Pages fit windows of four sizes, light and dark, and letters stand out from what is behind them", async () => {
  for (const path of ["index.html", "slides.html", LESSON, "lessons/jacobians/table-omega.html", "lessons/hard/cannot-close.html", "lessons/dynamics/andrews.html"]) {
    await visitPage(path, async (v, tab) => {
      for (const [width, height] of SIZES) {
        await tab.setViewport({ width, height });
        const wide = await tab.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        check(wide <= 0, `${path} is ${wide} pixels wider than ${width}`);
      }
      for (const scheme of ["light", "dark"]) {
        await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
        const faint = await tab.evaluate(() => {
          const parts = (colour) => colour.match(/[\d.]+/gu).map(Number);
          const light = ([r, g, b]) => [r, g, b].map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
            .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
          const behind = (element) => {
            for (let e = element; e; e = e.parentElement) {
              const colour = parts(getComputedStyle(e).backgroundColor);
              if ((colour[3] ?? 1) === 1) { return colour; }
            }
            return [255, 255, 255];
          };
          const found = [];
          const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
          while (walker.nextNode()) {
            const element = walker.currentNode.parentElement;
            if (walker.currentNode.textContent.trim() === "" || !element.checkVisibility()) { continue; }
            const style = getComputedStyle(element);
            const pair = [light(parts(style.color)), light(behind(element))].sort((a, b) => b - a);
            const contrast = (pair[0] + 0.05) / (pair[1] + 0.05);
            // 4.5: WCAG 2.1, level AA
            if (contrast < 4.5) { found.push(`${contrast.toFixed(2)} ${walker.currentNode.textContent.trim().slice(0, 30)}`); }
          }
          return found;
        });
        equal(faint, [], `faint letters of ${path}, ${scheme}`);
      }
    });
  }
});

test("By keys alone a lesson is found, opened, and its figure led", async () => {
  await visitPage("index.html", async (v, tab) => {
    await tab.keyboard.press("Tab");
    equal(await tab.evaluate(() => document.activeElement.className), "skip", "the first stop");
    await tab.keyboard.press("Enter");
    for (let k = 0; k < 3 && (await tab.evaluate(() => document.activeElement.id)) !== "search"; ++k) { await tab.keyboard.press("Tab"); }
    equal(await tab.evaluate(() => document.activeElement.id), "search", "the stop behind the skipped ones");
    await tab.keyboard.type("bennett");
    await tab.waitForFunction(() => document.getElementById("found").textContent === "1 lesson");
    for (let k = 0; k < 20 && !(await tab.evaluate(() => document.activeElement.pathname?.includes("bennett"))); ++k) { await tab.keyboard.press("Tab"); }
    await Promise.all([tab.waitForNavigation(), tab.keyboard.press("Enter")]);
    check((await tab.title()).startsWith("Bennett"), await tab.title());
    for (let k = 0; k < 60 && !(await tab.evaluate(() => document.activeElement.classList.contains("go"))); ++k) { await tab.keyboard.press("Tab"); }
    await tab.keyboard.press("Enter");
    const program = await programIn(tab);
    equal(await tab.evaluate(() => document.activeElement.tagName), "IFRAME", "where the keys go");
    equal((await program.state()).step, 0, "step");
  });
});

test("Without scripts the pages are words, mathematics and pictures", async () => {
  await visitPage("index.html", async (v, tab) => {
    equal(await tab.$$eval("[data-lesson]", (cards) => cards.filter((card) => card.checkVisibility()).length), pages.length - 2, "lessons");
    equal(await tab.$eval("form.search", (form) => form.checkVisibility()), false, "a search that does nothing");
    await tab.goto(address + LESSON);
    check(await tab.$eval("figure.live img", (image) => image.complete && image.naturalWidth === 1280), "the picture of the program");
    check((await tab.$$("math")).length > 8, "mathematics");
  }, { scripts: false });
});

test("On paper a page is its words and pictures, without buttons and answers", async () => {
  await visitPage(LESSON, async (v, tab) => {
    await tab.evaluate(() => document.querySelector("figure.live .screen a").click());
    await programIn(tab);
    await tab.emulateMediaType("print");
    const seen = (selector) => tab.$$eval(selector, (all) => all.filter((e) => e.checkVisibility()).length);
    for (const selector of [".go", "iframe", "header.site nav", ".neighbours", "details"]) { equal(await seen(selector), 0, selector); }
    for (const selector of ["h1", "figure.live img", ".station img", "math", ".numbers"]) { check(await seen(selector) > 0, `${selector} is not seen`); }
    await tab.$$eval("img", (all) => all.forEach((image) => { image.loading = "eager"; }));
    const pdf = Buffer.from(await tab.pdf({ format: "A4" })).toString("latin1");
    const sheets = pdf.match(/\/Type\s*\/Page\b/gu).length;
    check(sheets >= 3 && sheets <= 9, `${sheets} sheets`);
  });
});

test("Pages that were visited are there without network, the figure too", async () => {
  await visitPage(LESSON, async (v, tab) => {
    await tab.evaluate(async () => { await navigator.serviceWorker.ready; });
    // the first visit of all is not seen by the service worker
    await tab.reload();
    // of another course on the same host
    const other = "jointwise-program https://example.org/other/live/ 0123456789abcdef";
    await tab.evaluate((name) => caches.open(name), other);
    await tab.evaluate(() => document.querySelector("figure.live .screen a").click());
    const program = await programIn(tab);
    await program.frame.evaluate(async () => { await navigator.serviceWorker.ready; });
    equal(await tab.evaluate((name) => caches.has(name), other), true, "the files of another course");
    await tab.setOfflineMode(true);
    await tab.reload();
    check((await tab.title()).startsWith("A four-bar"), await tab.title());
    check(await tab.$eval("#steps img", async (image) => { image.loading = "eager"; await image.decode(); return image.naturalWidth > 0; }), "a picture");
    await tab.evaluate(() => document.querySelector("figure.live .screen a").click());
    check((await (await programIn(tab)).state()).shows_lesson, "the figure");
  });
});

test("From a folder that no server serves the site can be read and searched, and the program says why it does not run", async () => {
  const tab = await browser.newPage();
  const folder = `file://${join(root, "build/site")}/`;
  await tab.goto(`${folder}index.html`);
  await tab.type("#search", "bennett");
  await tab.waitForFunction(() => document.getElementById("found").textContent === "1 lesson");
  await tab.goto(folder + LESSON);
  check(await tab.$eval("figure.live img", (image) => image.complete && image.naturalWidth === 1280), "the picture of the program");
  equal((await tab.$$("iframe")).length, 0, "figures");
  await tab.goto(`${folder}live/index.html`);
  await tab.waitForFunction(() => document.getElementById("loading").innerText.includes("web server"));
  await tab.close();
});
