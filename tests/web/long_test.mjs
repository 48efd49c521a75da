// Test of lessons whose story takes long: it runs in turns of the page, with progress, and can be cancelled.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";
import { rowOfRods } from "./row_of_rods.mjs";

const address = await served("build/web/page");
// two lengths: a short story, and the longest that a lesson can have
const [LONG, ENDLESS] = [300, 499];

/** A page with both lessons beside those of the catalogue. */
async function visitWithRows() {
  const v = await Visit.begin(browser, address, { width: 641, height: 401, context: await browser.createBrowserContext() });
  await v.open("#four-bar/3");
  await v.rest();
  await v.tab.evaluate((files) => {
    const { FS } = window.jointwise.program.module;
    FS.mkdirTree("/kept/lessons");
    for (const [name, text] of files) { FS.writeFile(`/kept/lessons/${name}.toml`, text); }
  }, [["row", rowOfRods(LONG)], ["endless", rowOfRods(ENDLESS, 0.01)]]);
  return v;
}
const open = (v, name) => v.tab.evaluate((n) => {
  const { program, loop } = window.jointwise;
  program.open(`/kept/lessons/${n}.toml`, "", "");
  loop.rouse();
  return program.state().told_part;
}, name);
const told = (v) => v.tab.waitForFunction(() => window.jointwise.program.state().told_part === undefined, { timeout: 60000 });

test("A long lesson is told in turns of the page, and what was open is shown until it is there", async () => {
  const v = await visitWithRows();
  const before = (await v.state()).text;
  await v.tab.evaluate(() => {
    window.parts = [];
    const { program } = window.jointwise;
    const { frame } = program;
    program.frame = (seconds) => { const due = frame(seconds); window.parts.push(program.state().told_part); return due; };
  });
  check(await open(v, "endless") < 1, "the lesson was told at once");
  equal((await v.state()).text, before, "text while it is told");
  await told(v);
  await v.rest();
  const parts = (await v.tab.evaluate(() => window.parts)).filter((part) => part !== undefined && part !== null);
  check(parts.length > 5, `told in ${parts.length} turns`);
  check(parts.every((part, k) => k === 0 || part >= parts[k - 1]), `parts that do not grow: ${parts.join(" ")}`);
  check(new Set(parts).size > 3, `parts that stay: ${parts.join(" ")}`);
  equal((await v.state()).title, "A row of rods", "title");
  noFaults(v);
  await v.close();
});

test("The sheet of a long lesson is drawn now and then while turns follow each other closely", async () => {
  const v = await visitWithRows();
  await open(v, "endless");
  const drawn = await v.tab.evaluate(() => {
    const { program, loop } = window.jointwise;
    loop.stopped = true;
    let any = false;
    const draw = WebGL2RenderingContext.prototype.drawElements;
    WebGL2RenderingContext.prototype.drawElements = function (...what) { any = true; return draw.apply(this, what); };
    // the first two frames are drawn so that ImGui comes to rest
    const turns = [];
    for (let k = 0; k < 14; ++k) {
      any = false;
      program.frame(0.05);
      turns.push(any);
    }
    return program.state().told_part === undefined ? [] : turns;
  });
  check(drawn.length > 0, "the lesson was told before");
  const later = drawn.slice(4).filter(Boolean).length;
  check(later >= 2 && later <= 3, `drawn in ${later} of ten turns of 0.05 s, expected every fourth: ${drawn}`);
  noFaults(v);
  await v.close();
});

test("A link that is given up, by the keyboard wherever it is, leads back to the entry before", async () => {
  const v = await visitWithRows();
  await v.tab.evaluate(() => { location.hash = "#four-bar/5"; });
  await v.rest();
  const before = await v.tab.evaluate(() => [location.hash, history.length]);
  await open(v, "endless");
  await told(v);
  await v.rest();
  await v.tab.waitForFunction(() => location.hash.startsWith("#endless"), { timeout: 20000 });
  const open_one = await v.tab.evaluate(() => location.hash);
  // back to the four-bar, forward to the rods and cancelled, and forward again
  await v.tab.goBack();
  await v.tab.waitForFunction((hash) => location.hash === hash && window.jointwise.program.state().told_part === undefined, { timeout: 20000 }, before[0]);
  await v.rest();
  await v.tab.evaluate(() => history.forward());
  await v.tab.waitForFunction(() => window.jointwise.program.state().told_part !== undefined, { timeout: 20000 });
  await v.tab.waitForFunction(() => !document.getElementById("stop").hidden, { timeout: 20000 });
  await v.tab.focus("#link");
  await v.tab.keyboard.press("Escape");
  await v.tab.waitForFunction((hash) => location.hash === hash, { timeout: 20000 }, before[0]);
  equal((await v.state()).notice, "Stopped.", "notice");
  await v.rest();
  await v.tab.evaluate(() => history.forward());
  await v.tab.waitForFunction((hash) => location.hash === hash && window.jointwise.program.state().title === "A row of rods", { timeout: 60000 }, open_one);
  noFaults(v);
  await v.close();
});

test("A film is recorded in the page", async () => {
  const v = await Visit.begin(browser, address, { width: 641, height: 401, context: await browser.createBrowserContext() });
  await v.tab.evaluateOnNewDocument(() => {
    window.given = [];
    HTMLAnchorElement.prototype.click = function () { window.given.push(this.download); };
  });
  await v.open("#revolute");
  await v.key("End");
  await v.key("ArrowLeft");
  await v.tab.focus("#canvas");
  await v.tab.keyboard.type("R");
  await v.tab.waitForFunction(() => window.given.length > 0, { timeout: 60000 });
  check((await v.tab.evaluate(() => window.given[0])).endsWith(".apng"), "what was recorded is no film");
  noFaults(v);
  await v.close();
});

test("A long address arrives as one entry of the history, its experiment is undone, and Escape gives up", async () => {
  const v = await visitWithRows();
  await open(v, "row");
  await told(v);
  await v.rest();
  await v.tab.evaluate(() => { location.hash = "#row.toml/9?try=take+out+%22joint+4%22"; });
  await v.tab.waitForFunction(() => window.jointwise.program.state().tried?.length === 1, { timeout: 60000 });
  await v.rest();
  equal((await v.state()).step, 8, "step of the address");
  const entries = await v.tab.evaluate(() => history.length);
  await v.tab.goBack();
  await v.tab.waitForFunction(() => window.jointwise.program.state().tried.length === 0, { timeout: 60000 });
  await v.rest();
  equal(await v.tab.evaluate(() => history.length), entries, "entries of the history after the back button");

  const before = (await v.state()).text;
  check(await open(v, "endless") < 1, "the lesson was told at once");
  await v.tab.focus("#canvas");
  await v.tab.keyboard.press("Escape");
  await told(v);
  equal((await v.state()).notice, "Stopped.", "notice");
  equal((await v.state()).text, before, "text after Escape");
  noFaults(v);
  await v.close();
});
