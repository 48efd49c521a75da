// Test of the page on phones and tablets, by touch.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";

const address = await served("build/web/page");

/** A finger on the screen. */
class Finger {
  static async on(v) {
    const finger = new Finger();
    finger.v = v;
    finger.client = await v.tab.createCDPSession();
    return finger;
  }
  send(type, ...points) {
    return this.client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  }
  async tap(x, y) {
    await this.send("touchStart", [x, y]);
    await this.send("touchEnd");
    await this.v.tab.waitForFunction(() => !window.jointwise.loop.asked);
    await this.v.rest();
  }
  async drag(x, from, to) {
    await this.send("touchStart", [x, from]);
    for (let y = from; Math.abs(y - to) >= 5; y += 5 * Math.sign(to - from)) {
      await this.send("touchMove", [x, y]);
      // a screen reports the place of a finger once in a frame, however long the frame takes
      await this.v.tab.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
    }
    await this.send("touchEnd");
    await this.v.rest();
  }
}

const phone = { touch: true, width: 390, height: 664, ratio: 3 };

test("On phones and tablets most of the screen is the lesson, held upright and turned, and everything is as large as a finger", async () => {
  const v = await Visit.begin(browser, address, phone);
  await v.open("#four-bar/12");
  await v.rest();
  const finger = await Finger.on(v);
  for (const [width, height] of [[390, 664], [844, 390], [820, 1180]]) {
    await v.tab.setViewport({ width, height, hasTouch: true, deviceScaleFactor: 3 });
    await v.rest();
    const seen = await v.tab.evaluate(() => {
      const buttons = [...document.querySelectorAll("header button")].map((b) => b.getBoundingClientRect()).filter((b) => b.width > 1);
      return {
        header: document.querySelector("header").getBoundingClientRect().height,
        canvas: document.getElementById("canvas").getBoundingClientRect().toJSON(),
        smallest: Math.min(...buttons.map((b) => Math.min(b.width, b.height))),
        rows: new Set(buttons.map((b) => b.top)).size,
        page: document.documentElement.scrollHeight,
      };
    });
    equal(seen.rows, 1, `rows of buttons at ${width}x${height}`);
    check(seen.smallest >= 40, `a button is ${seen.smallest} pixels`);
    check(seen.header <= 46, `the header is ${seen.header} high`);
    check(seen.canvas.width === width && Math.abs(seen.canvas.height + seen.header - height) < 1, `the picture is ${seen.canvas.width}x${seen.canvas.height}`);
    check(seen.page <= height, "the page scrolls");
  }
  await v.tab.setViewport({ width: 390, height: 664, hasTouch: true, deviceScaleFactor: 3 });
  await v.rest();
  // in the row of buttons at its foot
  const step = (await v.state()).step;
  await finger.tap(252, 638);
  equal((await v.state()).step, step + 1, "step after a tap on >");
  await finger.tap(77, 638);
  equal((await v.state()).step, step, "step after a tap on <");
  // a panel follows the finger
  const before = await v.picture();
  await finger.drag(200, 560, 460);
  check(await v.picture() !== before, "a finger does not scroll the column");
  equal((await v.state()).step, step, "step after scrolling");
  noFaults(v);
  await v.close();
});

test("On a phone whoever taps a text field gets the keyboard of the screen, and what it writes is in the picture", async () => {
  const v = await Visit.begin(browser, address, phone);
  await v.open("#");
  await v.rest();
  const finger = await Finger.on(v);
  const has = () => v.tab.evaluate(() => document.activeElement.id);
  // beside the field nothing comes up
  await finger.tap(200, 60);
  equal(await has(), "canvas", "what has the keyboard");
  await finger.tap(200, 106);
  equal(await has(), "typing", "what has the keyboard after a tap on the search");
  const field = await v.tab.evaluate(() => document.getElementById("typing").getBoundingClientRect().toJSON());
  check(Math.abs(field.y - 100) < 20, `the field is at ${field.y}, and the search at 106`);
  // as keyboards that finish words do: what is composed changes until it is done
  await v.tab.keyboard.type("no ");
  for (let k = 0; k < 3; ++k) { await v.tab.keyboard.press("Backspace"); }
  for (const text of ["B", "Bent", "Bennett"]) { await finger.client.send("Input.imeSetComposition", { text, selectionStart: text.length, selectionEnd: text.length }); }
  await finger.client.send("Input.insertText", { text: "Bennett" });
  await v.rest();
  await v.tab.keyboard.press("Enter");
  await v.rest();
  check((await v.state()).title.includes("Bennett"), `the lesson found is ${(await v.state()).title}`);
  equal(await has(), "canvas", "what has the keyboard in a lesson");
  noFaults(v);
  await v.close();
});

test("On a phone an exercise is answered, and judged", async () => {
  const v = await Visit.begin(browser, address, phone);
  await v.open("#newton-raphson?exercise=rocker-angle");
  const tried = () => v.tab.evaluate(() => {
    const { FS } = window.jointwise.program.module;
    return FS.analyzePath("/kept/progress.json").exists ? FS.readFile("/kept/progress.json", { encoding: "utf8" }) : "";
  });
  await v.rest();
  const finger = await Finger.on(v);
  await finger.drag(200, 560, 100);
  await finger.tap(200, 530);
  equal(await tried(), "", "what was answered before");
  await v.tab.keyboard.type("82,5");
  await v.tab.keyboard.press("Enter");
  await v.rest();
  check((await tried()).includes("rocker-angle"), `what was answered is ${await tried()}`);
  noFaults(v);
  await v.close();
});
