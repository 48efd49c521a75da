// MuJoCo of npm against our own WebAssembly, in one process: node race.mjs ROOT LIMIT LESSON...; ./dev peers --only
// mujoco-web. No run takes longer than LIMIT seconds.
import { cpus } from "node:os";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { Mujoco, clock, loadMujoco } from "./race_mujoco.mjs";

const [, , root, seconds, ...files] = process.argv;
const limit = 1000 * Number(seconds);
const levels = [1e-3, 1e-6, 1e-9];
// runs with smaller errors are not needed [m]
const enough = 1e-10;

const program = await (await import(pathToFileURL(join(root, "build/web/tests/bench/peers/race.mjs")))).default();
const openScene = program.cwrap("open_scene", "string", ["string", "string"]);
const runScene = program.cwrap("run_scene", "number", ["number", "number", "number"]);

/** Our methods. A family is one method, its settings are tolerances, the loosest first: four a decade. */
class Jointwise {
  constructor(scene) {
    this.families = scene.methods.map(([method, name]) => ({ method, name }));
  }
  setting(family, k) { return { family, tolerance: 10 ** (-2 - k / 4) }; }
  exists(setting) { return setting.tolerance > 1e-13; }
  between() { return []; }
  prepare() {}
  // by the wall clock, which runs faster on a machine with other work
  run({ family, tolerance }, milliseconds) { return runScene(family.method, tolerance, 4 * milliseconds); }
  text({ family, tolerance }) { return `${family.name}, tolerance ${tolerance.toExponential(1)}`; }
}

/** One run. @returns its setting, time [ms] and error [m] */
function timed(engine, setting) {
  engine.prepare(setting);
  const began = clock();
  const error = engine.run(setting, limit);
  const ms = clock() - began;
  return { engine, setting, error: ms > limit ? Infinity : error, ms };
}

/** Least time of a run, repeated until 20 ms or five runs are over. */
function leastOfSeveral(engine, setting) {
  const best = timed(engine, setting);
  for (let k = 1, spent = best.ms; k < 5 && spent < 20; ++k) {
    const { ms } = timed(engine, setting);
    spent += ms;
    best.ms = Math.min(best.ms, ms);
  }
  return best;
}

const fastestFirst = (rows, level) => rows.filter((row) => row.error <= level).sort((a, b) => a.ms - b.ms);
const accuracy = (rows) => Math.min(...rows.map((row) => row.error));

/** Adds finer and finer settings of a family to its rows, until one takes longer than `most` [ms] or is not needed. */
function refine(engine, family, rows, most, needless) {
  for (let setting; engine.exists(setting = engine.setting(family, rows.length));) {
    const last = rows.at(-1);
    if (last && (last.error < enough || last.ms > Math.min(most, needless()))) { return; }
    rows.push(leastOfSeveral(engine, setting));
  }
}

/** All settings of an engine: every family for a short time, the most accurate ones until the limit, and then those between
    the best settings and the next coarser ones. */
function sweep(engine) {
  // until the browser's compiler has done its best for this engine
  for (const end = clock() + 500; clock() < end;) { timed(engine, engine.setting(engine.families[0], 5)); }
  const tried = engine.families.map((family) => ({ family, rows: [] }));
  const all = () => tried.flatMap(({ rows }) => rows);
  // what costs ten times as much as the smallest error needs is never the best
  const needless = () => 10 * (fastestFirst(all(), levels.at(-1))[0]?.ms ?? Infinity);
  for (const { family, rows } of tried) { refine(engine, family, rows, limit / 40, needless); }
  tried.sort((a, b) => accuracy(a.rows) - accuracy(b.rows));
  for (const { family, rows } of tried.slice(0, 5)) { refine(engine, family, rows, limit, needless); }
  const best = levels.flatMap((level) => fastestFirst(all(), level).slice(0, 2));
  const between = [...new Set(best)].flatMap((row) => engine.between(row.setting));
  return { rows: [...all(), ...between.map((setting) => leastOfSeveral(engine, setting))], tried };
}

/** Runs the fastest rows of both engines again, in turn, so that whatever disturbs the machine disturbs both. */
function duel(both) {
  const few = both.map((rows) => [...new Set(levels.flatMap((level) => fastestFirst(rows, level).slice(0, 6)))]);
  const end = clock() + 3 * limit;
  for (let round = 0; round < 40 && (round < 2 || clock() < end); ++round) {
    for (let k = 0; k < Math.max(...few.map((rows) => rows.length)); ++k) {
      for (const row of few.map((rows) => rows[k]).filter(Boolean)) {
        const { ms } = timed(row.engine, row.setting);
        // the first time is that of the sweep, when the other engine was not running
        row.ms = round === 0 ? ms : Math.min(row.ms, ms);
      }
    }
  }
  return levels.map((level) => few.map((rows) => fastestFirst(rows, level)[0]));
}

const number = (ms) => (ms >= 100 ? ms.toFixed(0) : ms.toPrecision(2));
const cell = (row) => (row ? `${number(row.ms)} ms  ${row.engine.text(row.setting)}, error ${row.error.toExponential(1)}` : "not reached");

/** Races both on one lesson. @returns a row of the table */
function race(lesson, mujoco) {
  const reference = join(root, "lessons/reference", `${basename(lesson, ".toml")}.csv`);
  const scene = JSON.parse(openScene(lesson, reference));
  if (scene.why_not) {
    console.error(`${lesson}: ${scene.why_not}`);
    return undefined;
  }
  const rows = [];
  const engines = scene.models.map((model) => new Mujoco(mujoco, scene, model));
  for (const engine of engines) {
    const swept = sweep(engine);
    rows.push(...swept.rows);
    console.error(`mujoco-web ${scene.name}${engine.hinges && `, balls as hinges ${engine.hinges}`}: ${engine.compared()}; ` +
      `order of RK4 ${engine.order(swept.tried)}; smallest error ${accuracy(swept.rows).toExponential(1)} m`);
  }
  const results = duel([rows, sweep(new Jointwise(scene)).rows]);
  for (const engine of engines) { engine.delete(); }
  const cells = results.map(([a, b], k) => {
    const ratio = a && b ? number(a.ms / b.ms) : "";
    console.error(`  ${levels[k].toExponential(0)}  ${cell(a).padEnd(72)}${cell(b).padEnd(64)}${ratio}`);
    const short = (row) => (row ? `${number(row.ms)} ${row.setting.family.name}` : "not reached");
    return `${short(a)} / ${short(b)}${ratio && ` = ${ratio}`}`;
  });
  return `| ${scene.name} | ${cells.join(" | ")} |`;
}

const mujoco = await loadMujoco(join(root, "build/race-npm"));
const table = [`MuJoCo ${mujoco.mj_versionString()} / Jointwise, both WebAssembly in node ${process.version}, on ${cpus()[0].model}:`, "",
  "| scene | to 1e-3 m [ms] | to 1e-6 m [ms] | to 1e-9 m [ms] |", "| --- | --- | --- | --- |"];
for (const lesson of files) {
  const row = race(lesson, mujoco);
  if (row) { table.push(row); }
}
console.log(table.join("\n"));
