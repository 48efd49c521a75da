// Test of the completion in the text editor of the page, by keys; completions_test.mjs tests what is offered.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";

const address = await served("build/web/page");

/** The text editor with a text in it, and the cursor at its end. */
class Editing {
  static async begin(text, options) {
    const editing = new Editing();
    editing.context = await browser.createBrowserContext();
    editing.v = await Visit.begin(browser, address, { context: editing.context, ...options });
    editing.tab = editing.v.tab;
    // closing asks whether the changed text may go
    editing.tab.on("dialog", (dialog) => dialog.accept());
    await editing.v.open("#four-bar/12");
    await editing.v.rest();
    await editing.tab.click("#edit");
    await editing.tab.waitForSelector(".cm-content");
    await editing.tab.evaluate((t) => {
      const content = document.querySelector(".cm-content");
      const view = content.cmTile?.view ?? content.cmView.view;
      window.textOfLesson = () => view.state.doc.toString();
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: t }, selection: { anchor: t.length }, scrollIntoView: true });
      view.focus();
    }, text);
    return editing;
  }
  async end() {
    noFaults(this.v);
    await this.v.close();
    await this.context.close();
  }
  text() { return this.tab.evaluate(() => window.textOfLesson()); }
  options() { return this.tab.evaluate(() => [...document.querySelectorAll(".cm-tooltip-autocomplete .cm-completionLabel")].map((label) => label.textContent)); }
  /** Waits until the list begins with an option; keys choose it a moment after it was shown. */
  async offers(first) {
    await this.tab.waitForFunction((label) => document.querySelector(".cm-tooltip-autocomplete [aria-selected] .cm-completionLabel")?.textContent === label, { timeout: 20000 }, first);
    await new Promise((later) => setTimeout(later, 150));
  }
  closed() { return this.tab.waitForFunction(() => !document.querySelector(".cm-tooltip-autocomplete"), { timeout: 20000 }); }
  press(key) { return this.tab.keyboard.press(key); }
  type(text) { return this.tab.keyboard.type(text); }
  async ask() {
    await this.tab.keyboard.down("Control");
    await this.press("Space");
    await this.tab.keyboard.up("Control");
  }
}

const bodies = '[[body]]\nname = "ground"\n\n[[body]]\nname = "crank"\n\n';

test("In the editor a joint is written by choosing: header, keys, word and names", async () => {
  const editing = await Editing.begin(bodies, { width: 1500 });
  await editing.type("[[jo");
  await editing.offers("[[joint]]");
  await editing.press("Enter");
  await editing.closed();
  // the list is closed: a new line
  await editing.press("Enter");
  await editing.ask();
  await editing.offers("name");
  const keys = await editing.options();
  equal(keys.slice(0, 3), ["name", "type", "bodies"], "the keys that a joint needs");
  await editing.type("ty");
  await editing.offers("type");
  await editing.press("Enter");
  // behind the key its words
  await editing.offers("spherical");
  await editing.type("rev");
  await editing.offers("revolute");
  check(await editing.tab.evaluate(() => document.querySelector(".cm-completionInfo").textContent.length > 5), "no description");
  await editing.press("Enter");
  await editing.closed();
  await editing.press("Enter");
  await editing.type('bodies = ["');
  await editing.offers("ground");
  equal(await editing.options(), ["ground", "crank"], "names");
  await editing.press("Enter");
  await editing.type(', "');
  await editing.offers("crank");
  await editing.press("Enter");
  await editing.type("]");
  await editing.closed();
  equal(await editing.text(), `${bodies}[[joint]]\ntype = "revolute"\nbodies = ["ground", "crank"]`, "text");
  await editing.press("Enter");
  await editing.ask();
  await editing.offers("name");
  check(!(await editing.options()).includes("type"), "a key that is written is offered again");
  await editing.end();
});

test("In the editor Escape closes the list first, and Tab and Enter do as before when it is closed", async () => {
  const editing = await Editing.begin(`${bodies}[motion]\n`, { width: 1500 });
  const isIn = () => editing.tab.evaluate(() => document.activeElement.classList.contains("cm-content"));
  await editing.ask();
  await editing.offers("to_s");
  await editing.press("Escape");
  await editing.closed();
  await editing.press("Tab");
  equal(await editing.text(), `${bodies}[motion]\n  `, "the line is indented");
  await editing.press("Enter");
  equal((await editing.text()).split("\n").length, 9, "lines");
  check(await isIn(), "Tab left the editor");
  await editing.press("Escape");
  await editing.press("Tab");
  check(!(await isIn()), "Escape, then Tab stays in the editor");
  await editing.end();
});

test("In the editor the key under the pointer is described", async () => {
  const editing = await Editing.begin(`${bodies}mass = 2\n`, { width: 1500 });
  const [x, y] = await editing.tab.evaluate(() => {
    const line = [...document.querySelectorAll(".cm-line")].find((l) => l.textContent.startsWith("mass"));
    const range = document.createRange();
    range.selectNodeContents(line);
    const { left, top, height } = range.getBoundingClientRect();
    return [left + 12, top + height / 2];
  });
  await editing.tab.mouse.move(x - 4, y);
  await editing.tab.mouse.move(x, y);
  await editing.tab.waitForFunction(() => document.querySelector(".meaning")?.textContent === "mass number above 0 [kg]: mass [kg]", { timeout: 20000 });
  await editing.end();
});

test("On a phone the list of the editor covers less than half of the screen, with options as large as a finger", async () => {
  // a keyboard on the screen leaves this much
  const editing = await Editing.begin(bodies, { width: 390, height: 400, touch: true, ratio: 2 });
  await editing.ask();
  await editing.tab.waitForSelector(".cm-tooltip-autocomplete [aria-selected]");
  const boxes = await editing.tab.evaluate(() => ["ul", "li", ".cm-completionInfo"].map((part) => document.querySelector(`.cm-tooltip-autocomplete ${part}`).getBoundingClientRect().toJSON()));
  const [list, option, info] = boxes;
  check(list.height <= 125 && list.width <= 390 && list.left >= 0, `the list is ${list.width}x${list.height}`);
  check(option.height >= 40, `an option is ${option.height} high`);
  check(info.height <= 100 && (info.top >= list.bottom - 2 || info.bottom <= list.top + 2), "the description covers options");
  await editing.end();
});
