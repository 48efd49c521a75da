// Completion in the text editor of the page, without a browser: node completions_test.mjs ROOT. It ends with "N passed, N failed".
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { completionsAt, meaningAt } from "../../app/web/npm/completions.js";
import { Format } from "../../app/web/npm/format.js";

const root = process.argv[2];
const schema = JSON.parse(readFileSync(join(root, "docs/lesson.schema.json"), "utf8"));
const format = new Format(schema);
const lessons = ["catalogue", "exercises", "benchmark"].flatMap((folder) => {
  const names = readdirSync(join(root, "lessons", folder), { recursive: true });
  return names.filter((name) => name.endsWith(".toml") && basename(name) !== "course.toml").sort()
    .map((name) => ({ name, text: readFileSync(join(root, "lessons", folder, name), "utf8") }));
});

// found without the reader that is tested: lessons are well-formed, so that a few expressions are enough
const QUIET = /'''[^]*?'''|"""(?:\\[^]|[^\\])*?"""|"(?:\\.|[^"\\\n])*"|'[^'\n]*'|#.*/g;
const KEY = /(?:^|[{,.])[ \t]*([A-Za-z0-9_-]+)(?=(?:\.[A-Za-z0-9_-]+)*[ \t]*=)/gm;
const HEADER = /^\[.*\]/gm;
const hush = (text) => text.replace(QUIET, (quiet) => "~".repeat(quiet.length));
// at every place of every lesson it takes minutes: JW_ALL_PLACES=1
const MOST = process.env.JW_ALL_PLACES ? Infinity : 25;
/** At most so many of a lesson, from everywhere in it. */
const some = (places) => places.filter((_, k) => Math.floor(k * MOST / places.length) !== Math.floor((k - 1) * MOST / places.length) || places.length <= MOST);
const placesOf = (text, expression) => some([...text.matchAll(expression)].map((m) => {
  const word = m[1] ?? m[0];
  return { word, from: m.index + m[0].length - word.length };
}));
/** Texts in one line under a key, also in lists: [{key, word, from}]. */
function textsOf(text) {
  const quiet = hush(text);
  return [...text.matchAll(QUIET)].filter((m) => /^["'](?!["'])/.test(m[0]) && m[0].length > 2).map((m) => {
    const before = /([A-Za-z0-9_-]+)[ \t]*=[^=]*$/.exec(quiet.slice(Math.max(0, m.index - 2000), m.index));
    return { key: before?.[1], word: m[0].slice(1, -1), from: m.index + 1 };
  });
}
const cut = (text, from, to) => text.slice(0, from) + text.slice(to);
/** The option that gives the text back from which something was cut out. */
function optionThatRestores(text, from, to, typed = 0) {
  const rest = cut(text, from + typed, to);
  const found = completionsAt(format, rest, from + typed);
  return found?.options.find(({ insert }) => rest.slice(0, found.from) + insert + rest.slice(found.to) === text);
}

const tests = {
  "Where a key of a lesson is taken out or half typed, it is offered, with its kind and what it means"() {
    let count = 0;
    let alone = 0;
    for (const { name, text } of lessons) {
      for (const { word, from } of placesOf(hush(text), KEY)) {
        const where = `${name}: ${word} at ${from}`;
        const to = from + word.length;
        const option = optionThatRestores(text, from, to);
        // which languages there are, only the text says
        if (!option && /^[a-z]{2,3}-/.test(word) && text.split(word).length === 2) {
          ++alone;
          continue;
        }
        assert.ok(option?.info && option.detail, where);
        assert.ok(optionThatRestores(text, from, to, word.length >> 1), `half of ${where}`);
        ++count;
      }
    }
    console.log(`  ${count} keys of ${lessons.length} lessons; ${alone} languages that stand once`);
    assert.ok(count > 3000 && alone < 10);
  },
  "Every key and every header of a lesson has a meaning, which is that of the schema"() {
    const about = new Set();
    JSON.stringify(schema, (key, value) => { if (key === "description") { about.add(value); } return value; });
    for (const { name, text } of lessons) {
      for (const { word, from } of placesOf(hush(text), KEY)) {
        const found = meaningAt(format, text, from + 1);
        assert.ok(found && about.has(found.info) && found.detail, `${name}: ${word} at ${from}`);
        assert.deepEqual([found.from, found.to, found.title], [from, from + word.length, word], name);
      }
      for (const { word, from } of placesOf(hush(text), HEADER)) {
        assert.ok(about.has(meaningAt(format, text, from + word.lastIndexOf(word.match(/\w+\]/)[0]))?.info), `${name}: ${word} at ${from}`);
      }
    }
  },
  "Where a header of a lesson is taken out or half typed, it is offered"() {
    let count = 0;
    for (const { name, text } of lessons) {
      for (const { word, from } of placesOf(hush(text), HEADER)) {
        if (/^\[[a-z]{2}-/.test(word) && text.split(word.slice(1, -1)).length === 2) { continue; }
        for (const typed of [0, 1, word.length >> 1]) {
          assert.ok(optionThatRestores(text, from, from + word.length, typed), `${name}: ${word} at ${from}, ${typed} letters`);
        }
        ++count;
      }
    }
    console.log(`  ${count} headers`);
    assert.ok(count > 2000);
  },
  "Where a word of the schema is taken out, it is offered, in its quotes and without them"() {
    const words = {};
    const collect = (table) => Object.entries(table.properties ?? {}).forEach(([key, node]) => {
      format.forms(node).forEach((form) => { (words[key] ??= new Set()).add(...[form.enum ?? []]); });
    });
    [schema, ...Object.values(schema.definitions)].forEach(collect);
    const isWord = ({ key, word }) => [...(words[key] ?? [])].some((list) => list.includes(word));
    let count = 0;
    for (const { name, text } of lessons) {
      for (const { key, word, from } of some(textsOf(text).filter(isWord))) {
        const where = `${name}: ${key} = "${word}" at ${from}`;
        const to = from + word.length;
        assert.ok(optionThatRestores(text, from, to)?.info, where);
        if (text[from - 1] === '"') { assert.ok(optionThatRestores(text, from - 1, to + 1), `without quotes ${where}`); }
        // the quote behind it is not typed yet
        assert.ok(optionThatRestores(text, from, to + 1), `open ${where}`);
        ++count;
      }
    }
    console.log(`  ${count} words`);
    assert.ok(count > 1000);
  },
  "Where the name of a body, joint or driver is taken out, it is offered, and no other kind of name"() {
    const kinds = { bodies: /^body$/, body: /^body$/, against: /^body$/, pose: /^body$/, joint: /^joint$/, after: /^(joint|driver)$/, at: /^(joint|driver|)$/, order: /^(joint|driver)$/ };
    let count = 0;
    for (const { name, text } of lessons) {
      const defined = new Set(textsOf(text).filter(({ key }) => key === "name").map(({ word }) => word));
      for (const { key, word, from } of some(textsOf(text).filter(({ key, word }) => Object.hasOwn(kinds, key ?? "") && defined.has(word)))) {
        const where = `${name}: ${key} = "${word}" at ${from}`;
        const option = optionThatRestores(text, from, from + word.length);
        assert.ok(option && kinds[key].test(option.detail), where);
        ++count;
      }
    }
    console.log(`  ${count} names`);
    assert.ok(count > 1500);
  },
  "What is written already is not offered: keys, tables that stand once, the other unit, a second shape"() {
    const labels = (text, at = text.length) => completionsAt(format, text, at)?.options.map(({ label }) => label) ?? [];
    const joint = labels('[[joint]]\n\nname = "A"\naxis = [0, 0, 1]\ntheta_deg = 3\n[[joint]]\ntype = "screw"\n', 10);
    assert.deepEqual(joint.slice(0, 3), ["type", "bodies", "text"]);
    for (const name of ["name", "axis", "theta_deg", "theta_rad"]) { assert.ok(!joint.includes(name), name); }
    assert.ok(joint.includes("theta_dot_rad_per_s") && joint.includes("[[joint]]"));
    assert.ok(!labels("[motion]\nto_s = 1\n[camera]\n").includes("[motion]"));
    assert.deepEqual(labels("[[body]]\nshape = { rod = {}, "), []);
    assert.deepEqual(labels('[[body]]\nname = "a"\n[[body]]\nname = "b"\n[[joint]]\nbodies = ["a", "'), ["b"]);
    assert.ok(labels('zh-Hant.text = "字"\n[[driver]]\n').includes("zh-Hant"));
    assert.deepEqual(labels('zh-Hant.text = "字"\n[[driver]]\nzh-Hant.'), ["text"]);
  },
  "Nothing is offered unasked where nothing is typed, and Enter goes to the next line behind a whole word"() {
    const unasked = (text) => completionsAt(format, text, text.length, false);
    for (const text of ["", "[[joint]]\n", "[[joint]]\nname", "fixed = ", "[[body]]\nfixed = true", "[motion]", '[[joint]]\nbodies = [', '[[joint]]\ntype = "screw"']) {
      const isKey = text.endsWith("name");
      assert.equal(unasked(text) !== null, isKey, text);
    }
    assert.ok(unasked('[[joint]]\ntype = '));
  },
  "Nothing is offered in comments, texts and numbers, and half-typed text does not hide what follows"() {
    const at = (text) => completionsAt(format, text.replace("|", ""), text.indexOf("|"))?.options.map(({ label }) => label) ?? null;
    for (const text of [
      "# [[jo|", "a = 1 # na|", "text = '''\n[[jo|\n'''", 'text = """\n[[joint]]\nna|\n"""', 'text = """\n[[jo|', "[motion]\nto_s = 1|",
      '[[joint]]\nname = "|"', "[[joint]]\n[other]\n|\n", "__proto__.|", "[[joint]] |", "[[no-such.table]]\nna|", "title = \"a\\\"|",
    ]) { assert.equal(at(text)?.filter((label) => !label.startsWith("[")).length || null, null, text); }
    for (const text of [
      "text = '''\n[[body]]\n'''\n[[joint]]\nna|", 'text = """\n\\"""[[body]] ""\\" """\n[[joint]]\nna|', '[[joint]]\nbodies = ["a", \n[[joint]]\nna|',
      "[[joint]]\naxis = [0, 0\nna|", '[[joint]]\ntext = "not closed [[body]]\nna|', "[[body]]\nrotation = { axis = [0, 0, 1], \n[[joint]]\nna|",
      "[[joint]] # [[body]]\r\n  na|\r\n", "[ [joint]]\n[[ joint ]]\nna|", "[body\n[[joint]]\nna|", "[[joint]]\n中文 = 1\nna|", "[[joint]]\n= 1\nna|",
    ]) { assert.equal(at(text)?.[0], "name", text); }
  },
  "With line ends of Windows the same is offered"() {
    const { text } = lessons.find(({ name }) => name === "loops/four-bar.toml");
    const lines = text.split("\n");
    let [at, there] = [0, 0];
    for (const line of lines) {
      for (let k = 0; k <= line.length; k += 3) {
        const labels = (t, place) => completionsAt(format, t, place)?.options.map(({ insert }) => insert);
        assert.deepEqual(labels(text.replaceAll("\n", "\r\n"), there + k), labels(text, at + k), `${line} at ${k}`);
      }
      [at, there] = [at + line.length + 1, there + line.length + 2];
    }
  },
  "Any text has an answer at any place, and options replace what is at the place"() {
    let seed = 7;
    const random = (below) => { seed = (seed * 48271) % 2147483647; return seed % below; };
    const pieces = ["[", "]", "{", "}", "=", ",", ".", '"', "'", '"""', "'''", "\\", "#", "\n", "\r\n", " ", "\u00a0", "\0", "[[joint]]", "name", "type", "bodies", "shape", "zh-Hant", "字", "😀", "1", "__proto__", "constructor", "toString", "hasOwnProperty"];
    for (let k = 0; k < 30000; ++k) {
      const text = Array.from({ length: random(25) }, () => pieces[random(pieces.length)]).join("");
      const at = random(text.length + 1);
      const found = completionsAt(format, text, at, random(2) === 0);
      assert.ok(!found || (0 <= found.from && found.from <= at && at <= found.to && found.to <= text.length && found.options.length > 0), JSON.stringify([text, at, found]));
      const meaning = meaningAt(format, text, at);
      assert.ok(!meaning || (meaning.info && meaning.from <= at && at <= meaning.to), JSON.stringify([text, at, meaning]));
    }
    for (const { text } of lessons.slice(0, 30)) {
      for (let k = 0; k < 60; ++k) {
        const broken = cut(text, random(text.length), random(text.length));
        completionsAt(format, broken, random(broken.length + 1));
      }
    }
  },
  "A long text has its answer in linear time"() {
    const size = 2e5;
    for (const piece of ["[", "{", "[{a=", "a.", "a", '"', "'", "\\", '"""', "'''", "=", ",", " ", "\n", "#", "# \n", "[[joint]]\n", "[motion]\n", "[a.", "x = [\n", '"\\"', "x = [\na b", "字", "[[joint]]\nname = \"A\"\n", "zh-Hant.text = 1\n", "[[joint]]\nbodies = [\"A\", \"", "a = [ ", "a-bcdef-", "[\n "]) {
      for (const before of ["", "x = ", "[[joint]]\nx = [\n"]) {
        const text = before + piece.repeat(size / piece.length);
        const began = performance.now();
        completionsAt(format, text, text.length);
        meaningAt(format, text, text.length >> 1);
        // [ms] a hundred times that of an idle machine; quadratic time is minutes
        assert.ok(performance.now() - began < 4000, `${JSON.stringify(before + piece)}: ${performance.now() - began} ms`);
      }
    }
  },
};

let failed = 0;
for (const [name, run] of Object.entries(tests)) {
  const began = performance.now();
  try {
    run();
    console.log(`passed  ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n        ${String(error.message).replaceAll("\n", "\n        ")}`);
  }
}
console.log(`${Object.keys(tests).length - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
