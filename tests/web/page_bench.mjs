// Sizes and times of the page against their budgets: node page_bench.mjs ROOT; ./dev web bench. Times are those of this
// machine and its software renderer.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { serve } from "../../app/web/serve.mjs";
import { Visit, startBrowser } from "./browser.mjs";
import { rowOfRods } from "./row_of_rods.mjs";

const root = process.argv[2];
const folder = join(root, "build/web/page");
let over = 0;
function report(what, value, unit, most, least) {
  const bad = (most !== undefined && value > most) || (least !== undefined && value < least);
  if (bad) { ++over; }
  const budget = most !== undefined ? `at most ${most}` : least !== undefined ? `at least ${least}` : "";
  console.log(`${what.padEnd(58)} ${value.toFixed(value < 10 ? 2 : 0).padStart(8)} ${unit.padEnd(12)} ${budget}${bad ? "  OVER" : ""}`);
}

// files that the first lesson needs: all but the text editor, the letters of Chinese and the notices
let compressed = 0;
for (const file of readdirSync(folder)) {
  if (["text_editor.js", "chinese.ttf", "notices.txt"].includes(file)) { continue; }
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

// a body of the closed four-bar is pulled to and fro: each frame solves for another place of the pointer
await v.open("#four-bar/28");
await v.rest();
const pulls = (scale) => v.tab.evaluate((k) => {
  const { program } = window.jointwise;
  const canvas = document.getElementById("canvas");
  [canvas.width, canvas.height] = [1280 * k, 720 * k];
  program.resize(canvas.width, canvas.height);
  const move = (x, y) => { program.pointer(x * k, y * k); program.frame(0.02); };
  // on the rocker
  move(513, 249);
  program.button(0, 1);
  program.frame(0.02);
  move(525, 255);
  if (!program.state().in_hand) { return 0; }
  const began = performance.now();
  for (let turn = 0; turn < 30; turn += 0.1) { move(525 + 30 * Math.sin(turn), 255 + 20 * Math.cos(turn)); }
  const rate = 300000 / (performance.now() - began);
  program.button(0, 0);
  program.frame(0.02);
  program.key("Escape", 1);
  program.frame(0.02);
  program.key("Escape", 0);
  return rate;
}, scale);
report("a body that is pulled: places solved and drawn, 1280x720", await pulls(1), "a second");
// the software renderer has next to nothing to do
report("a body that is pulled: places solved, 320x180", await pulls(0.25), "a second", undefined, 60);
await v.tab.reload();
await v.ready();
/** Steps to and fro, in parts that no browser takes for a page that hangs. @returns bytes of the program's memory */
async function steps(count) {
  let bytes = 0;
  for (let done = 0; done < count; done += 50) {
    bytes = await v.tab.evaluate(() => {
      const { program } = window.jointwise;
      for (let k = 0; k < 50; ++k) {
        const key = k % 2 ? "ArrowLeft" : "ArrowRight";
        program.key(key, 1);
        program.frame(0.02);
        program.key(key, 0);
      }
      return program.module.HEAPU8.length;
    });
  }
  return bytes;
}
// a small canvas: memory does not depend on it, and the software renderer's time does
await v.tab.setViewport({ width: 480, height: 360 });
await v.rest();
const memory = [await steps(500), await steps(9500)];
report("memory after 500 steps", memory[0] / 1e6, "MB");
report("memory after 10,000 steps, beyond that", (memory[1] - memory[0]) / 1e6, "MB", 0);

// the story runs in turns of the page; drawing by the software renderer is not counted
const w = await Visit.begin(browser, address);
await w.open("#four-bar");
await w.rest();
const long = await w.tab.evaluate(async (text) => {
  const { program, loop } = window.jointwise;
  program.module.FS.writeFile("/row.toml", text);
  const turns = [];
  const frame = program.frame;
  program.frame = (seconds) => {
    const began = performance.now();
    const due = frame(seconds);
    if (program.state().told_part !== undefined) { turns.push(performance.now() - began); }
    return due;
  };
  const began = performance.now();
  program.open("/row.toml", "", "");
  const first = performance.now() - began;
  loop.rouse();
  while (program.state().told_part !== undefined) { await new Promise((done) => { setTimeout(done, 20); }); }
  program.frame = frame;
  turns.sort((a, b) => a - b);
  return { first, whole: performance.now() - began, median: turns[turns.length >> 1] };
}, rowOfRods(499));
report("a lesson of 499 bodies is told", long.whole / 1000, "s");
report("  its part that is told at once", long.first, "ms");
report("  turn of the page: median", long.median, "ms", 50);

const faults = [...v.faults, ...w.faults];
console.log(faults.length === 0 ? "no faults" : `faults: ${faults.join("; ")}`);
await browser.close();
server.close();
process.exit(over > 0 || faults.length > 0 ? 1 : 0);
