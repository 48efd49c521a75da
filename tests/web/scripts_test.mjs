// Scripts of events lead the page and the program to the same states, text for text and number for number.
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { Visit } from "./browser.mjs";
import { browser, check, noFaults, root, served, test } from "./suite.mjs";

/** Numbers from a seed: mulberry32. */
function randomOf(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A script of somebody who tries keys, panels, the timeline and the experiments of a lesson. The picture is left alone: what is
 * pointed at there depends on what was drawn; so is the sphere on which axes are set by hand: they depend on where the eye is.
 * @param trials  lists of experiments that its author proposes */
function scriptOf(name, seed, length, trials) {
  const random = randomOf(seed);
  const one = (all) => all[Math.floor(random() * all.length)];
  const lines = [`go #${name}`, "frame 0.05"];
  const press = (key) => lines.push(`key ${key} 1`, "frame 0.05", `key ${key} 0`, "frame 0.05");
  for (let k = 0; k < length; ++k) {
    const kind = random();
    if (kind < 0.08 && trials.length > 0) {
      lines.push(`go #${name}?${one(trials).map((experiment) => `try=${encodeURIComponent(experiment)}`).join("&")}`, "frame 0.05");
    } else if (kind < 0.35) {
      press(one(["ArrowRight", "ArrowLeft", "PageDown", "PageUp", "Home", "End", "Space", "Escape", "Enter"]));
    } else if (kind < 0.65) {
      // no exercises, prices and files: they take long, or leave the page
      lines.push(`text ${one([..."1345fxyzvuU0tT.,+-[]{}mMda"]).codePointAt(0)}`, "frame 0.05");
    } else {
      const timeline = random() < 0.4;
      const [x, y] = timeline ? [360 + 740 * random(), 690 + 25 * random()] : [780 + 490 * random(), 110 + 540 * random()];
      lines.push(`pointer ${Math.round(x)} ${Math.round(y)}`, "frame 0.05");
      if (random() < 0.3) { lines.push(`wheel ${one([-1, 1])}`, "frame 0.05"); } else { lines.push("button 0 1", "frame 0.05", "button 0 0", "frame 0.05"); }
    }
    lines.push("frame 0.2");
  }
  return lines;
}

test("Scripts of events lead the page and the program to the same states", async () => {
  const program = join(root, "build/release/tests/web/scripts");
  const seed = Number(process.env.SEED ?? 1);
  const names = readdirSync(join(root, "lessons/catalogue"), { recursive: true }).filter((f) => f.endsWith(".toml") && basename(f) !== "course.toml").sort();
  const v = await Visit.begin(browser, await served("build/web/page"));
  // each begins without the settings of the one before; nothing is drawn, as in the program of the scripts
  await v.tab.evaluateOnNewDocument(() => localStorage.clear());
  await v.hideWebgl();
  let states = 0;
  const seen = new Set();
  for (const [k, file] of names.entries()) {
    const name = basename(file, ".toml");
    const trials = [...readFileSync(join(root, "lessons/catalogue", file), "utf8").matchAll(/^do = (\[.*\])$/gmu)]
      .map(([, list]) => list.match(/"(?:[^"\\]|\\.)*"|'[^']*'/gu).map((text) => (text[0] === '"' ? JSON.parse(text) : text.slice(1, -1))));
    const script = scriptOf(name, seed + k, 25, trials);
    const here = execFileSync(program, { input: script.join("\n") + "\n", maxBuffer: 1 << 28, env: { ...process.env, JOINTWISE_LESSONS: join(root, "lessons/catalogue") } }).toString().trimEnd().split("\n");
    await v.open();
    const there = await v.tab.evaluate((lines) => {
      const { program, loop } = window.jointwise;
      loop.stopped = true;
      program.resize(1280, 720, 1);
      const told = [];
      for (const line of lines) {
        const [what, a, b] = line.split(" ");
        if (what === "go") { program.goToAddress(a); }
        if (what === "key") { program.key(a === "Space" ? " " : a, Number(b)); }
        if (what === "text") { program.text(Number(a)); }
        if (what === "pointer") { program.pointer(Number(a), Number(b)); }
        if (what === "button") { program.button(Number(a), Number(b)); }
        if (what === "wheel") { program.wheel(Number(a)); }
        if (what === "frame") {
          program.frame(Number(a));
          told.push(`${program.address()}\t${program.stateText()}`);
        }
      }
      return told;
    }, script);
    check(here.length === there.length, `${name}: ${here.length} states here, ${there.length} in the page`);
    // the paths of files differ; the place of the eye comes from sines of the C library, whose last digit may differ
    const CAMERA = /[?&]camera=[^&\t]*|"camera":\[[^\]]*\]/gu;
    const placeless = (text) => text.replace(/"file":"[^"]*"/u, "").replace(CAMERA, "");
    const camera = (text) => (text.match(CAMERA) ?? []).join(" ").match(/-?[\d.]+(e[-+]?\d+)?/gu)?.map(Number) ?? [];
    const isNear = (a, b) => a.length === b.length && a.every((x, n) => Math.abs(x - b[n]) <= 1e-12 * Math.max(1, Math.abs(x)));
    for (let state = 0; state < here.length; ++state) {
      check(isNear(camera(here[state]), camera(there[state])), `${name}, seed ${seed + k}, state ${state}: the eye is elsewhere\n${here[state].slice(0, 300)}\n${there[state].slice(0, 300)}`);
      check(placeless(here[state]) === placeless(there[state]), `${name}, seed ${seed + k}, state ${state}:\nhere ${here[state].slice(0, 600)}\npage ${there[state].slice(0, 600)}`);
      seen.add(placeless(here[state]));
    }
    states += here.length;
  }
  console.log(`  ${names.length} scripts, ${states} states are the same, ${seen.size} of them different ones`);
  // most frames change nothing
  check(seen.size > 10 * names.length, `${seen.size} different states`);
  noFaults(v);
  await v.close();
});
