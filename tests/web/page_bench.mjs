// Sizes and times of the page against their budgets: node page_bench.mjs ROOT; ./dev web bench. Times are those of this
// machine and its software renderer.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { serve } from "../../app/web/serve.mjs";
import { Visit, startBrowser } from "./browser.mjs";

const root = process.argv[2];
const folder = join(root, "build/web/page");
let over = 0;
function report(what, value, unit, most, least) {
  const bad = (most !== undefined && value > most) || (least !== undefined && value < least);
  if (bad) { ++over; }
  const budget = most !== undefined ? `at most ${most}` : least !== undefined ? `at least ${least}` : "";
  console.log(`${what.padEnd(58)} ${value.toFixed(value < 10 ? 2 : 0).padStart(8)} ${unit.padEnd(12)} ${budget}${bad ? "  OVER" : ""}`);
}

// what the first lesson needs: all but the text editor and the letters of Chinese
let compressed = 0;
for (const file of readdirSync(folder)) {
  if (file === "text_editor.js" || file === "chinese.ttf") { continue; }
  const size = brotliCompressSync(readFileSync(join(folder, file)), { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } }).length;
  if (size > 20000) { report(`  ${file}, brotli`, size / 1e6, "MB"); }
  compressed += size;
}
report("first lesson, brotli", compressed / 1e6, "MB", 2.2);

const { server, address } = await serve(folder);
const browser = await startBrowser();
for (let k = 0; k < 3; ++k) {
  const context = await browser.createBrowserContext();
  const v = await Visit.begin(browser, address, { context });
  const began = performance.now();
  await v.open("#four-bar/12");
  report(k === 0 ? "first picture, of a server that compresses" : "first picture, compressed files kept by the server", (performance.now() - began) / 1000, "s", k === 0 ? undefined : 2);
  await v.close();
  await context.close();
}

const v = await Visit.begin(browser, address);
await v.open("#four-bar/12");
await v.rest();
const frames = await v.tab.evaluate(() => {
  const { program } = window.jointwise;
  const times = [];
  for (let k = 0; k < 60; ++k) {
    program.pointer(5 + k % 2, 5);
    const began = performance.now();
    program.frame(0.02);
    times.push(performance.now() - began);
  }
  times.sort((a, b) => a - b);
  return { median: times[30], largest: times[59] };
});
report("frame that shows the same lesson: median", frames.median, "ms");
report("frame that shows the same lesson: longest", frames.largest, "ms", 50);
const memory = await v.tab.evaluate(() => {
  const { program } = window.jointwise;
  const bytes = () => program.module.HEAPU8.length;
  const run = (count) => { for (let k = 0; k < count; ++k) { program.key(k % 2 ? "ArrowLeft" : "ArrowRight", 1); program.frame(0.02); program.key(k % 2 ? "ArrowLeft" : "ArrowRight", 0); } };
  run(500);
  const before = bytes();
  run(9500);
  return [before, bytes()];
});
report("memory after 500 steps", memory[0] / 1e6, "MB");
report("memory after 10,000 steps, beyond that", (memory[1] - memory[0]) / 1e6, "MB", 0);
console.log(v.faults.length === 0 ? "no faults" : `faults: ${v.faults.join("; ")}`);
await browser.close();
server.close();
process.exit(over > 0 || v.faults.length > 0 ? 1 : 0);
