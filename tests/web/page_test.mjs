// Tests of the page.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { Visit, difference } from "./browser.mjs";
import { browser, check, checkLooksAsInProgram, equal, noFaults, root, served, test } from "./suite.mjs";

const catalogue = join(root, "lessons/catalogue");
const lessons = readdirSync(catalogue, { recursive: true }).filter((f) => f.endsWith(".toml") && basename(f) !== "course.toml").sort();
const stems = lessons.map((f) => basename(f, ".toml"));

const address = await served("build/web/page");
const visit = async (options) => Visit.begin(browser, address, options);

// a software renderer draws pictures half as wide four times as fast
const quick = { width: 640, height: 401 };

/** A visit whose storage is its own; it must end without faults. */
async function visitAlone({ hash = "#four-bar/12", ...options }, run) {
  const context = await browser.createBrowserContext();
  const v = await visit({ context, ...options });
  await v.open(hash);
  await v.rest();
  await run(v);
  noFaults(v);
  await v.close();
  await context.close();
}

/** A visit alone, with the text of the lesson beside the picture. */
async function visitEditing(run) {
  await visitAlone({ width: 1500 }, async (v) => {
    await v.tab.click("#edit");
    await v.tab.waitForSelector(".cm-content");
    await run(v);
  });
}

test("The list of lessons opens, and keys choose one", async () => {
  const v = await visit();
  await v.open();
  check(!(await v.state()).shows_lesson, "a lesson is shown");
  await v.rest();
  await v.key("ArrowRight");
  await v.key("Enter");
  check((await v.state()).shows_lesson, "no lesson is shown");
  noFaults(v);
  await v.close();
});

test("Every lesson opens by its address, steps, plays and is pulled without a fault", async () => {
  const v = await visit(quick);
  await v.open();
  for (const stem of stems) {
    await v.tab.evaluate((s) => { location.hash = `${s}/1`; }, stem);
    await v.tab.waitForFunction((s) => window.jointwise.program.state().shows_lesson && window.jointwise.program.address().startsWith(s), { timeout: 60000 }, stem);
    await v.tab.evaluate(() => {
      const { program, loop } = window.jointwise;
      const canvas = document.getElementById("canvas");
      for (const key of ["ArrowRight", "ArrowRight", "PageDown", "End", "ArrowLeft"]) {
        program.key(key, 1);
        program.frame(0.02);
        program.key(key, 0);
        program.frame(0.02);
      }
      program.key(" ", 1);
      program.frame(0.02);
      program.key(" ", 0);
      for (let k = 0; k < 5; ++k) { program.frame(0.3); }
      program.key(" ", 1);
      program.frame(0.02);
      program.key(" ", 0);
      const [x, y] = [canvas.width * 0.3, canvas.height * 0.4];
      program.pointer(x, y);
      program.frame(0.02);
      program.button(0, 1);
      for (let k = 1; k < 6; ++k) {
        program.pointer(x + 10 * k, y + 4 * k);
        program.frame(0.02);
      }
      program.button(0, 0);
      program.frame(0.02);
      loop.rouse();
    });
    equal(v.faults, [], `faults in ${stem}`);
  }
  await v.close();
});

test("An address opens a step, and the address follows what is shown", async () => {
  const v = await visit();
  await v.open("#four-bar/12");
  await v.rest();
  equal((await v.state()).step, 11, "step");
  await v.key("ArrowRight");
  await v.tab.waitForFunction(() => location.hash === "#four-bar/13", { timeout: 10000 });
  noFaults(v);
  await v.close();
});

test("An experiment is an entry of the history: its link opens it, and the back button undoes it", async () => {
  const v = await visit();
  await v.open("#four-bar/D?try=form+D+drop+x");
  await v.rest();
  equal((await v.state()).tried, ["form D drop x"], "what was tried");
  const link = await v.fragment();
  const text = (await v.state()).text;
  const other = await visit();
  await other.open(`#${link}`);
  await other.rest();
  equal((await other.state()).text, text, "text of the step behind the link");
  await other.close();

  await v.tab.evaluate(() => { location.hash = "#four-bar/D?try=form+D+drop+x&try=take+out+motor"; });
  await v.tab.waitForFunction(() => window.jointwise.program.state().tried.length === 2, { timeout: 20000 });
  await v.type("u");
  await v.tab.waitForFunction(() => !location.hash.includes("motor"), { timeout: 20000 });
  await v.tab.goBack();
  await v.tab.waitForFunction(() => window.jointwise.program.state().tried.length === 2, { timeout: 20000 });
  await v.tab.goBack();
  await v.tab.waitForFunction(() => window.jointwise.program.state().tried.length === 1, { timeout: 20000 });
  noFaults(v);
  await v.close();
});

test("An address that leads nowhere says so, and nothing is lost", async () => {
  const v = await visit();
  await v.open("#four-bar/12");
  await v.rest();
  for (const bad of ["no-such-lesson/3", "four-bar/12?try=nonsense", "four-bar/12?camera=1,2", "four-bar?tab=none", "%ff%00", "?".repeat(50)]) {
    await v.tab.evaluate((hash) => { location.hash = hash; }, bad);
    await new Promise((r) => setTimeout(r, 300));
    await v.rest();
    const state = await v.state();
    equal([state.file.split("/").pop(), state.step], ["four-bar.toml", 11], `what is shown after ${bad}`);
    await v.tab.waitForFunction((said) => said && document.getElementById("news").textContent.includes(said), { timeout: 20000 }, state.mistakes);
  }
  noFaults(v);
  await v.close();
});

test("A screen reader announces exercises and new verdicts", async () => {
  await visitAlone({ hash: "#newton-raphson/3" }, async (v) => {
    const told = (words) => v.tab.waitForFunction((w) => document.getElementById("story").textContent.includes(w), { timeout: 20000 }, words);
    const step = await v.state();
    await told(step.text);
    await v.type("6");
    await told("Chosen: 1. ");
    // a screen reader says the lines that are added
    await v.tab.evaluate(() => {
      window.said = [];
      new MutationObserver((changes) => {
        for (const change of changes) { window.said.push(...[...change.addedNodes].map((node) => node.textContent)); }
      }).observe(document.getElementById("story"), { childList: true });
    });
    await v.key("ArrowDown");
    await told("Chosen: 2. ");
    const said = await v.tab.evaluate(() => window.said);
    equal(said.map((line) => line.slice(0, 10)), ["Chosen: 2."], "what is said when the next exercise is chosen");
    await v.tab.evaluate(() => { location.hash = "newton-raphson?exercise=rocker-angle"; });
    await told("Type the answer; Enter checks it.");
    await v.type("7");
    await v.tab.keyboard.press("Enter");
    await told("In the field: 7");
    await told("Not correct");
    equal(await v.tab.evaluate(() => document.getElementById("story").textContent), (await v.state()).text, "the text of the page");
  });
});

test("The page draws what the program draws", async () => {
  const v = await visit();
  await v.open("#four-bar/11");
  await v.fit(1280, 720);
  for (const [name, step] of [["four-bar", 11], ["screw-jack", 3], ["andrews", 6], ["universal", 4]]) {
    await v.tab.evaluate((hash) => { location.hash = hash; }, `${name}/${step}`);
    await v.tab.waitForFunction((s) => window.jointwise.program.address().startsWith(s), { timeout: 60000 }, `${name}/${step}`);
    await checkLooksAsInProgram(v, name, step);
  }
  noFaults(v);
  await v.close();
});

test("Cost of accuracy is measured in another copy of the program, with the errors of the program, and can be stopped", async () => {
  const lesson = join(mkdtempSync(join(tmpdir(), "jointwise-price-")), "four-bar-1.toml");
  // outside the catalogue it has no stored reference, as in the page
  copyFileSync(join(catalogue, "dynamics/four-bar-1.toml"), lesson);
  const native = JSON.parse(execFileSync(join(root, "build/release/app/jointwise"), ["bench", lesson, "--format", "json"], { stdio: ["ignore", "pipe", "ignore"] }));
  rmSync(dirname(lesson), { recursive: true });
  await visitAlone({ hash: "#four-bar-1?tab=price" }, async (v) => {
    await v.tab.evaluate(() => {
      const { program, loop } = window.jointwise;
      window.told = [];
      window.longest = 0;
      const measured = program.measured;
      program.measured = (number, news) => { window.told.push(JSON.parse(news)); measured(number, news); };
      const frame = program.frame;
      program.frame = (seconds) => {
        const began = performance.now();
        const due = frame(seconds);
        window.longest = Math.max(window.longest, performance.now() - began);
        return due;
      };
      loop.rouse();
    });
    // [ms] other tests may keep both cores busy
    const copies = async (count, patience = 20000) => {
      for (let waited = 0; waited < patience && v.tab.workers().length !== count; waited += 50) {
        await new Promise((later) => setTimeout(later, 50));
      }
      return v.tab.workers().length;
    };
    // the button is somewhere at the top of the panels
    let y = 150;
    const press = () => v.tab.mouse.click(800, y);
    for (; y < 260 && v.tab.workers().length === 0; y += 8) {
      await press();
      await copies(1, 1000);
    }
    y -= 8;
    equal(await copies(1), 1, "copies that measure");
    await v.tab.waitForFunction(() => window.told.some((news) => news.runs.length > 0), { timeout: 60000 });
    await press();
    equal(await copies(0), 0, "copies that measure after a stop");
    await v.tab.evaluate(() => { window.told = []; });
    await press();
    await v.tab.waitForFunction(() => window.told.at(-1)?.done, { timeout: 100000 });
    const news = await v.tab.evaluate(() => window.told.at(-1));
    equal(news.failure, "", "failure");
    equal(await copies(0), 0, "copies after the end");
    let compared = 0;
    for (const run of native.scenes[0].runs) {
      const here = news.runs.find((other) => other.method === run.method);
      // how far a sweep goes depends on the time that it takes
      for (let k = 0; k < Math.min(run.points.length, here.points.length); ++k) {
        equal(here.points[k][0], run.points[k].setting, `setting ${k} of ${run.method}`);
        equal(here.points[k][2], run.points[k].position_m, `error at setting ${k} of ${run.method}`);
        ++compared;
      }
    }
    check(compared > 30, `${compared} points`);
    console.log(`  ${compared} errors of ${native.scenes[0].runs.length} methods are those of the program; longest frame meanwhile ${(await v.tab.evaluate(() => window.longest)).toFixed(0)} ms`);
  });
});

test("The copyrights of all that the page contains are beside it", async () => {
  const answer = await fetch(new URL("notices.txt", address));
  const text = await answer.text();
  check(answer.ok && !text.includes(root), "no notices, or paths of this machine in them");
  for (const words of ["authors of Jointwise", "Mozilla Public License", "Omar Cornut", "Niels Lohmann", "Victor Zverovich",
    "FreeType", "Bitstream Vera", "GUST Font", "University of Illinois", "@codemirror/view ====", "Marijn Haverbeke"]) {
    check(text.includes(words), `no "${words}" in the notices`);
  }
  check(!text.includes("esbuild ===="), "a notice of a tool that is not in the page");
});

test("After the first visit the page opens without network", async () => {
  await visitAlone({ hash: "#four-bar/4" }, async (v) => {
    await v.tab.evaluate(async () => { await navigator.serviceWorker.ready; });
    await v.tab.reload();
    await v.ready();
    await v.tab.setOfflineMode(true);
    await v.tab.reload();
    await v.ready();
    await v.rest();
    equal((await v.state()).step, 3, "step");
  });
});

test("A context that is lost and given back draws the same picture", async () => {
  const v = await visit();
  await v.open("#four-bar/11");
  await v.rest();
  const before = await v.picture();
  await v.tab.evaluate(() => { window.lost = document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context"); window.lost.loseContext(); });
  await new Promise((r) => setTimeout(r, 300));
  await v.tab.evaluate(() => window.lost.restoreContext());
  await new Promise((r) => setTimeout(r, 500));
  await v.rest();
  equal((await difference(browser, before, await v.picture())).share, 0, "share of pixels that differ");
  await v.close();
});

test("Without WebGL 2 the steps are words, and the buttons lead through them", async () => {
  const v = await visit();
  await v.hideWebgl();
  await v.open("#four-bar/D");
  const words = async (part) => v.tab.waitForFunction((p) => document.getElementById("story").innerText.includes(p) && document.body.innerText.includes("WebGL 2"), { timeout: 20000 }, part)
    .catch(async () => { throw new Error(`no "${part}" in ${await v.tab.evaluate(() => document.body.innerText)}`); });
  await words("Joint D");
  const step = (await v.state()).step;
  await v.tab.click("button[data-key=ArrowRight]");
  await v.tab.waitForFunction((before) => window.jointwise.program.state().step === before + 1, { timeout: 20000 }, step);
  await v.tab.select("select", "joints/spherical");
  await words("A ball in a socket");
  noFaults(v);
  await v.close();
});

test("A lesson is edited in the page: mistakes have their place, and the picture follows", async () => {
  await visitEditing(async (v) => {
    const type = async (find, replace) => v.tab.evaluate((a, b) => {
      const view = document.querySelector(".cm-content").cmTile?.view ?? document.querySelector(".cm-content").cmView.view;
      const at = view.state.doc.toString().indexOf(a);
      view.dispatch({ changes: { from: at, to: at + a.length, insert: b } });
    }, find, replace);
    await type("A four-bar of four revolutes", "Mine");
    await v.tab.waitForFunction(() => window.jointwise.program.state().title === "Mine", { timeout: 20000 });
    equal((await v.state()).step, 11, "step");
    await type("[[body]]", "[[bodie]]");
    await v.tab.waitForFunction(() => /^\d+:\d+: /.test(document.getElementById("mistakes").textContent), { timeout: 20000 });
    equal((await v.state()).title, "Mine", "title");
  });
});

test("Edited text is there after the page is read again, and closing it asks first", async () => {
  await visitEditing(async (v) => {
    await v.tab.click(".cm-content");
    await v.tab.keyboard.down("Control");
    await v.tab.keyboard.press("Home");
    await v.tab.keyboard.up("Control");
    await v.tab.keyboard.type("# a note of mine\n");
    await v.tab.waitForFunction(() => localStorage.getItem("jointwise-file:/kept/edited/four-bar.toml")?.includes("a note of mine"), { timeout: 20000 });
    const asked = [];
    v.tab.on("dialog", async (dialog) => { asked.push(dialog.type()); await dialog.accept(); });
    await v.tab.reload();
    await v.ready();
    equal(asked, ["beforeunload"], "what was asked");
    await v.rest();
    await v.tab.click("#edit");
    await v.tab.waitForFunction(() => document.querySelector(".cm-content")?.textContent.includes("a note of mine"), { timeout: 20000 });
  });
});

test("A file that is dropped on the page is opened, and a hostile one does no harm", async () => {
  await visitAlone({ width: 1500 }, async (v) => {
    const drop = (name, text) => v.tab.evaluate((n, t) => {
      const data = new DataTransfer();
      data.items.add(new File([t], n));
      document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, name, text);
    const text = readFileSync(join(catalogue, "joints/spherical.toml"), "utf8").replace(/^title = .*$/m, 'title = "<img src=x onerror=alert(1)>"');
    await drop("../../etc/one of mine.toml", text);
    await v.tab.waitForFunction(() => window.jointwise.program.state().title?.startsWith("<img"), { timeout: 20000 });
    equal(await v.tab.evaluate(() => document.querySelectorAll("img").length), 0, "elements made of a title");
    for (const [name, bad] of [["nothing.toml", ""], ["zeros.toml", "\0".repeat(1000)], ["deep.toml", "a=" + "[".repeat(100000)], ["odd.txt", "\u{1F980} = 1"]]) {
      await drop(name, bad);
      await v.tab.waitForFunction((n) => document.getElementById("file-name").textContent === n && document.getElementById("mistakes").textContent !== "", { timeout: 20000 }, name)
        .catch(() => { throw new Error(`${name} has no mistake`); });
      await v.rest();
      check((await v.state()).title?.startsWith("<img"), `after ${name} another lesson is shown`);
    }
  });
});

test("Fingers turn, shift and zoom the picture, and pull what they rest on", async () => {
  const v = await visit({ touch: true, width: 1280, height: 800 });
  await v.open("#four-bar/12");
  await v.rest();
  const client = await v.tab.createCDPSession();
  const touch = (type, points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const camera = () => v.tab.evaluate(() => window.jointwise.program.state().camera);
  const changed = (a, b) => a.some((x, k) => Math.abs(x - b[k]) > 1e-9);
  const before = await camera();
  await touch("touchStart", [[400, 300]]);
  for (let k = 1; k <= 8; ++k) { await touch("touchMove", [[400 + 8 * k, 300]]); }
  await touch("touchEnd", []);
  await v.rest();
  const turned = await camera();
  check(changed(before, turned), "one finger does not turn");
  equal((await v.state()).changed, false, "changed by turning");
  const distance = (c) => Math.hypot(c[0] - c[3], c[1] - c[4], c[2] - c[5]);
  check(Math.abs(distance(before) - distance(turned)) < 1e-9, "one finger zooms");
  await touch("touchStart", [[350, 300], [450, 300]]);
  for (let k = 1; k <= 8; ++k) { await touch("touchMove", [[350 - 8 * k, 300], [450 + 8 * k, 300]]); }
  await touch("touchEnd", []);
  await v.rest();
  check(distance(await camera()) < 0.8 * distance(turned), "two fingers do not bring nearer");
  noFaults(v);
  await v.close();
});

test("Random input to the page throws nothing", async () => {
  const v = await visit(quick);
  const seed = 20261126;
  // more by hand: a picture takes a software renderer a tenth of a second, so there are none then
  const events = Number(process.env.EVENTS ?? 20);
  if (events > 100) { await v.hideWebgl(); }
  await v.open("#four-bar/12");
  for (const stem of stems) {
    await v.tab.evaluate((s) => { location.hash = `${s}/1`; }, stem);
    await v.tab.waitForFunction((s) => window.jointwise.program.address().startsWith(s), { timeout: 60000 }, stem);
    await v.tab.evaluate((first, count) => {
      let state = first;
      const random = (n) => { state = (Math.imul(state, 1664525) + 1013904223) >>> 0; return state % n; };
      const { program } = window.jointwise;
      const { width, height } = document.getElementById("canvas");
      const keys = ["ArrowLeft", "ArrowRight", "ArrowUp", "PageDown", "Home", "End", " ", "Enter", "Escape", "Backspace", "Control", "Shift", "z", "y"];
      const letters = "nbMa.,123456w][}{tTuU0mHSNLfyYxXzZvhlkjiod+-Ge?gpcCsER";
      for (let k = 0; k < count; ++k) {
        switch (random(6)) {
          case 0: program.key(keys[random(keys.length)], random(2)); break;
          case 1: program.text(letters.codePointAt(random(letters.length))); break;
          case 2: program.button(random(4), random(2)); break;
          case 3: program.wheel(random(7) - 3); break;
          default: program.pointer(random(width), random(height));
        }
        program.frame(0.02);
      }
      for (const key of keys) { program.key(key, 0); }
      for (const button of [0, 1, 2, 3]) { program.button(button, 0); }
      program.frame(0.02);
      program.key("Escape", 1);
      program.frame(0.02);
      program.key("Escape", 0);
    }, seed + stems.indexOf(stem), events);
    equal(v.faults, [], `faults in ${stem}, seed ${seed + stems.indexOf(stem)}`);
  }
  await v.close();
});
