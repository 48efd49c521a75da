// Test of the page in a hand: on phones and tablets, by touch.
import { Visit } from "./browser.mjs";
import { browser, check, equal, noFaults, served, test } from "./suite.mjs";

const address = await served("build/web/page");

test("On phones and tablets most of the screen is the lesson, held upright and turned, and everything is as large as a finger", async () => {
  const v = await Visit.begin(browser, address, { touch: true, width: 390, height: 664, ratio: 3 });
  await v.open("#four-bar/12");
  await v.rest();
  const client = await v.tab.createCDPSession();
  const tap = async (x, y) => {
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y, id: 0 }] });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await v.tab.waitForFunction(() => !window.jointwise.loop.asked);
    await v.rest();
  };
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
  await tap(252, 638);
  equal((await v.state()).step, step + 1, "step after a tap on >");
  await tap(77, 638);
  equal((await v.state()).step, step, "step after a tap on <");
  // a panel follows the finger
  const column = (y) => client.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: 200, y, id: 0 }] });
  const before = await v.picture();
  await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x: 200, y: 560, id: 0 }] });
  for (let y = 555; y >= 460; y -= 5) { await column(y); }
  await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await v.rest();
  check(await v.picture() !== before, "a finger does not scroll the column");
  equal((await v.state()).step, step, "step after scrolling");
  noFaults(v);
  await v.close();
});
