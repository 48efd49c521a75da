// Parts that the tests of the page and of the site share: one browser, servers, checks.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { serve } from "../../app/web/serve.mjs";
import { difference, startBrowser } from "./browser.mjs";

export const root = process.argv[2];
export const browser = await startBrowser();

const servers = [];
/** Address of a folder of the project that is served until the end. */
export async function served(folder) {
  const { server, address } = await serve(join(root, folder));
  servers.push(server);
  return address;
}

const tests = [];
export const test = (name, run) => tests.push({ name, run });

export function check(holds, what) {
  if (!holds) { throw new Error(what); }
}
export function equal(found, expected, what) {
  check(JSON.stringify(found) === JSON.stringify(expected), `${what}: ${JSON.stringify(found)}, expected ${JSON.stringify(expected)}`);
}
export function noFaults(visit) { equal(visit.faults, [], "faults"); }

/** Checks that a visit of 1280x720 pixels shows a step as the program draws it, and that the next step differs from it. */
export async function checkLooksAsInProgram(v, name, step) {
  const program = join(root, "build/release/app/jointwise");
  check(existsSync(program), "build the program first: ./dev setup");
  const folder = mkdtempSync(join(tmpdir(), "jointwise-page-"));
  try {
    const picture = join(folder, "native.png");
    execFileSync(program, ["open", `#${name}/${step}`, "--size", "1280x720", "--picture", picture]);
    await v.tab.mouse.move(0, 0);
    await v.rest();
    const native = `data:image/png;base64,${readFileSync(picture).toString("base64")}`;
    const found = await difference(browser, await v.picture(), native);
    console.log(`  ${name}/${step}: ${(100 * found.share).toFixed(2)} % of the pixels differ, ${(100 * found.clear).toFixed(3)} % by more than 8 of 255`);
    // renderers round colours and place the edges of triangles in their own ways; a missing letter is more
    check(found.clear < 0.001, `${name}: ${100 * found.clear} % of the pixels differ by more than 8 of 255`);
    await v.key("ArrowRight");
    equal((await v.state()).step, step, "step");
    check((await difference(browser, await v.picture(), native)).clear > 0.001, `${name}: the next step passes for this one`);
  } finally { rmSync(folder, { recursive: true }); }
}

/** Runs the tests with `part` in their name, and ends the program. */
export async function runAll(part) {
  let failed = 0;
  const chosen = tests.filter((t) => t.name.toLowerCase().includes(part.toLowerCase()));
  for (const { name, run } of chosen) {
    const began = Date.now();
    try {
      await run();
      console.log(`passed  ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n        ${String(error.message).replaceAll("\n", "\n        ")}`);
    }
  }
  await browser.close();
  for (const server of servers) { server.close(); }
  console.log(`${chosen.length - failed} passed, ${failed} failed`);
  process.exit(failed > 0 || chosen.length === 0 ? 1 : 0);
}
