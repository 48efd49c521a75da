// Test of what a person writes and the page keeps: fields, clipboard, storage, several tabs.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";

const address = await served("build/web/page");
const EXERCISE = "#newton-raphson?exercise=rocker-angle";

/** Runs with a storage that nobody else has. @param run  is given a function that begins a visit */
async function alone(run) {
  const context = await browser.createBrowserContext();
  try {
    await run((options = {}) => Visit.begin(browser, address, { ...options, context }));
  } finally { await context.close(); }
}
const fileOf = (v, path) => v.tab.evaluate((p) => {
  const { FS } = window.jointwise.program.module;
  return FS.analyzePath(p).exists ? FS.readFile(p, { encoding: "utf8" }) : "";
}, path);
const kept = (v, path) => v.tab.evaluate((p) => localStorage.getItem(`jointwise-file:${p}`) ?? "", path);
const untilKept = (v, path, text) => v.tab.waitForFunction((p, t) => localStorage.getItem(`jointwise-file:${p}`)?.includes(t), { timeout: 20000 }, path, text);
/** Text in the field that is typed into: Ctrl+A, Ctrl+C give it to the clipboard. */
async function written(v) {
  for (const key of ["a", "c"]) {
    await v.tab.keyboard.down("Control");
    await v.tab.keyboard.press(key);
    await v.tab.keyboard.up("Control");
    await v.rest();
  }
  return v.tab.evaluate(() => window.copied);
}
const paste = (v, text) => v.tab.evaluate((t) => {
  const data = new DataTransfer();
  data.setData("text/plain", t);
  document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
}, text);
const startAnswer = async (v) => {
  // not the clipboard of another tab
  await v.tab.evaluateOnNewDocument(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
  await v.open(EXERCISE);
  await v.rest();
  await v.tab.bringToFront();
  await v.key("Enter");
};

test("Text of other programs is pasted into a field, and a word is deleted as a word", async () => {
  await alone(async (begin) => {
    const v = await begin();
    await startAnswer(v);
    equal(await v.tab.evaluate(() => document.activeElement.id), "typing", "what has the keyboard");
    await v.tab.keyboard.type("82.5");
    await v.rest();
    await paste(v, " deg");
    await v.rest();
    equal(await written(v), "82.5 deg", "what was pasted");
    await v.tab.keyboard.press("End");
    const client = await v.tab.createCDPSession();
    await client.send("Input.dispatchKeyEvent", { type: "keyDown", key: "Process", commands: ["deleteWordBackward"] });
    await v.rest();
    check((await written(v)).trim() === "82.5", `after a deleted word there is '${await written(v)}'`);
    noFaults(v);
  });
});

test("Two tabs keep what was done in both", async () => {
  await alone(async (begin) => {
    const first = await begin();
    await startAnswer(first);
    const second = await begin();
    await second.open("#four-bar/12");
    await second.rest();
    await first.tab.bringToFront();
    await first.tab.keyboard.type("82.5");
    await first.tab.keyboard.press("Enter");
    await first.rest();
    await untilKept(first, "/kept/progress.json", "rocker-angle");
    await second.tab.bringToFront();
    await second.tab.evaluate(() => { location.hash = "bennett/3"; });
    await untilKept(second, "/kept/recent", "bennett");
    check((await kept(second, "/kept/progress.json")).includes("rocker-angle"), "the other tab has taken the progress away");
    check((await fileOf(second, "/kept/progress.json")).includes("rocker-angle"), "the other tab knows nothing of the progress");
    noFaults(first);
    noFaults(second);
  });
});

test("Without a storage, or with one full of nonsense, the page begins, and says what is lost", async () => {
  await alone(async (begin) => {
    const v = await begin();
    await v.tab.evaluateOnNewDocument(() => Object.defineProperty(window, "localStorage", { get() { throw new DOMException("denied", "SecurityError"); } }));
    await v.open("#four-bar/12");
    await v.rest();
    equal((await v.state()).step, 11, "step without a storage");
    check(await v.tab.evaluate(() => document.getElementById("toast").textContent.includes("cannot store more")), "nothing is said");
    noFaults(v);
  });
  await alone(async (begin) => {
    const v = await begin();
    await v.tab.evaluateOnNewDocument(() => {
      for (const [key, text] of [["jointwise-settings", "{oops"], ["jointwise-files", "null"], ["jointwise-file:/etc/passwd", "x"], ["jointwise-file:/kept/recent", "\u0000"]]) { localStorage.setItem(key, text); }
    });
    await v.open("#four-bar/12");
    await v.rest();
    equal((await v.state()).step, 11, "step with nonsense in the storage");
    equal(await fileOf(v, "/etc/passwd"), "", "what was written outside the folder");
    noFaults(v);
  });
});

test("Text with a mistake is kept, and neither it nor what was edited before is written over unasked", async () => {
  await alone(async (begin) => {
    const v = await begin({ width: 1500 });
    const answers = [];
    const asked = [];
    v.tab.on("dialog", async (dialog) => {
      asked.push(dialog.message());
      if (dialog.type() === "beforeunload" || answers.shift()) { await dialog.accept(); } else { await dialog.dismiss(); }
    });
    const edit = async (comment) => {
      await v.tab.click("#edit");
      await v.tab.waitForFunction(() => !document.getElementById("editor").hidden, { timeout: 20000 });
      if (!comment) { return; }
      await v.tab.click(".cm-content");
      await v.tab.keyboard.down("Control");
      await v.tab.keyboard.press("Home");
      await v.tab.keyboard.up("Control");
      await v.tab.keyboard.type(`${comment}\n`);
    };
    const shows = (text) => v.tab.waitForFunction((t) => document.querySelector(".cm-content")?.textContent.includes(t), { timeout: 20000 }, text);
    await v.open("#four-bar/12");
    await v.rest();
    await edit("half done = [work");
    await untilKept(v, "/kept/edited/four-bar.toml.draft", "half done");
    await v.tab.reload();
    await v.ready();
    await v.rest();
    answers.push(true);
    await edit("");
    await shows("half done");
    check(asked.some((words) => words.includes("edited before")), `what was asked: ${asked}`);
    await v.tab.reload();
    await v.ready();
    await v.rest();
    // the lesson as it was, under another name
    answers.push(false);
    await edit("# another one");
    await untilKept(v, "/kept/edited/four-bar-2.toml", "another one");
    check((await kept(v, "/kept/edited/four-bar.toml.draft")).includes("half done"), "the first text is gone");
    noFaults(v);
  });
});

test("A picture that becomes smaller while somebody types stays in its place", async () => {
  await alone(async (begin) => {
    const v = await begin({ width: 1000, height: 1400 });
    await startAnswer(v);
    await v.tab.setViewport({ width: 900, height: 420 });
    await v.rest();
    await v.tab.keyboard.type("8");
    await v.rest();
    const seen = await v.tab.evaluate(() => [document.documentElement.scrollHeight <= innerHeight, scrollY, document.getElementById("stage").scrollTop]);
    equal(seen, [true, 0, 0], "height of the page, and what is scrolled");
    noFaults(v);
  });
});
