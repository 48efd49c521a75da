// Test of lessons whose story takes long: told in turns of the page, with progress, and given up at will.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";
import { rowOfRods } from "./row_of_rods.mjs";

const address = await served("build/web/page");
// of two lengths: told in a moment, and so long that nobody waits for it
const [LONG, ENDLESS] = [350, 499];

/** A page with both lessons beside those of the catalogue. */
async function visitWithRows() {
  const v = await Visit.begin(browser, address, { width: 641, height: 401, context: await browser.createBrowserContext() });
  await v.open("#four-bar/3");
  await v.rest();
  await v.tab.evaluate((files) => {
    const { FS } = window.jointwise.program.module;
    FS.mkdirTree("/kept/lessons");
    for (const [name, text] of files) { FS.writeFile(`/kept/lessons/${name}.toml`, text); }
  }, [["row", rowOfRods(LONG)], ["endless", rowOfRods(ENDLESS)]]);
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
    const frame = program.frame;
    program.frame = (seconds) => { const due = frame(seconds); window.parts.push(program.state().told_part); return due; };
  });
  check(await open(v, "row") < 1, "the lesson was told at once");
  equal((await v.state()).text, before, "text while it is told");
  await told(v);
  await v.rest();
  const parts = (await v.tab.evaluate(() => window.parts)).filter((part) => part !== undefined && part !== null);
  check(parts.length > 10, `told in ${parts.length} turns`);
  check(parts.every((part, k) => k === 0 || part >= parts[k - 1]), `parts that do not grow: ${parts.join(" ")}`);
  check(new Set(parts).size > 5, `parts that stay: ${parts.join(" ")}`);
  equal((await v.state()).title, "A row of rods", "title");
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
