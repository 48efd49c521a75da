// The page and the site in Firefox, which draws by other libraries: a display without a screen stands for one.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { Visit, difference, startFirefox } from "./browser.mjs";
import { browser, check, equal, noFaults, root, served, test } from "./suite.mjs";

test("In Firefox lessons open, step, and look as the program draws them", async () => {
  const firefox = await startFirefox();
  const folder = mkdtempSync(join(tmpdir(), "jointwise-firefox-"));
  try {
    const v = await Visit.begin(firefox, await served("build/web/page"));
    for (const [name, step] of [["four-bar", 23], ["screw-jack", 3], ["universal", 4]]) {
      await v.open(`#${name}/${step}`);
      await v.fit(1280, 720);
      await v.tab.mouse.move(0, 0);
      await v.rest();
      const picture = join(folder, "native.png");
      execFileSync(join(root, "build/release/app/jointwise"), ["open", `#${name}/${step}`, "--size", "1280x720", "--picture", picture]);
      const native = `data:image/png;base64,${readFileSync(picture).toString("base64")}`;
      const found = await difference(browser, await v.picture(), native);
      console.log(`  ${name}/${step}: ${(100 * found.share).toFixed(2)} % of the pixels differ, ${(100 * found.clear).toFixed(3)} % by more than 8 of 255`);
      // as in Chromium: edges of triangles
      check(found.clear < 0.001, `${name}: ${100 * found.clear} % of the pixels differ by more than 8 of 255`);
      await v.key("ArrowRight");
      equal((await v.state()).step, step, "step");
      check((await difference(browser, await v.picture(), native)).clear > 0.001, `${name}: the next step passes for this one`);
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
    rmSync(folder, { recursive: true });
    await firefox.close();
  }
});
