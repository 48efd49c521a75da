// The page and the site in Firefox, which draws by other libraries: a display without a screen stands for one.
import { Visit, startFirefox } from "./browser.mjs";
import { checkLooksAsInProgram, noFaults, served, test } from "./suite.mjs";

test("In Firefox lessons open, step, and look as the program draws them", async () => {
  const firefox = await startFirefox();
  try {
    const v = await Visit.begin(firefox, await served("build/web/page"));
    for (const [name, step] of [["four-bar", 23], ["screw-jack", 3], ["universal", 4]]) {
      await v.open(`#${name}/${step}`);
      await v.fit(1280, 720);
      await checkLooksAsInProgram(v, name, step);
    }
    noFaults(v);
    // a page of the site, and the program in it
    const site = await Visit.begin(firefox, await served("build/site"));
    await site.tab.goto(`${site.address}lessons/loops/four-bar.html`);
    const handle = await site.tab.waitForSelector("figure.live iframe", { timeout: 60000 });
    const frame = await handle.contentFrame();
    await frame.waitForFunction(() => window.jointwise?.loop.frames > 0, { timeout: 60000 });
    await site.tab.$eval("#step-1 a.go", (link) => link.click());
    await frame.waitForFunction(() => window.jointwise.program.state().step === 0, { timeout: 60000 });
    noFaults(site);
  } finally {
    await firefox.close();
  }
});
