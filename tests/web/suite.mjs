// What the tests of the page and of the site share: one browser, servers, checks.
import { join } from "node:path";
import { serve } from "../../app/web/serve.mjs";
import { startBrowser } from "./browser.mjs";

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
