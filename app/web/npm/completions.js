// What can be written at a place of a lesson's text, and what a key means. It needs no browser.
import { placeAt } from "./place.js";

// what texts name: the schema says only that they are texts
const NAMED = {
  bodies: ["body"], body: ["body"], against: ["body"], pose: ["body"], joint: ["joint"],
  after: ["joint", "driver"], order: ["joint", "driver"], at: ["joint", "driver"],
};
// of steps and questions
const FURTHER = { at: ["bodies", "motion"] };

// text that leaves the options as they are while it is typed
const SAME = { key: /^[\w-]*$/, header: /^\[{0,2}[\w.-]*$/, text: /^[^"',\n]*$/ };

/**
 * What can be written at a place.
 * @param asked the person asked for it; else nothing is offered where nothing is typed yet
 * @returns {from, to, options, same} or null: options replace the text from `from` to `to`, and stay the same while that text
 *     matches `same`. An option has label, insert, detail, info and kind
 */
export function completionsAt(format, text, at, asked = true) {
  const place = placeAt(format, text, at);
  if (!place) { return null; }
  const found = place.kind === "value" ? valueAt(format, text, place, at, asked) : nameAt(format, text, place, at, asked);
  return found && found.options.length > 0 ? found : null;
}

/** A key or a header. */
function nameAt(format, text, place, at, asked) {
  const { kind, from, to, open } = place;
  const isEmpty = from === at;
  if (isEmpty && !asked) { return null; }
  const options = kind === "header" ? headersAt(format, place) : keysAt(format, text, place);
  if (kind === "key" && isEmpty && open) { options.push(...headersAt(format, place)); }
  return { from, to, options, same: SAME[kind] };
}

/** A word or a name, in quotes if it is a text. */
function valueAt(format, text, place, at, asked) {
  const { from, to, quote, inList } = place;
  const words = valuesAt(format, place);
  const option = ({ word, ...more }, insert) => ({ label: word, insert, info: place.node?.description, ...more });
  if (quote) {
    const end = endOfText(text, place, at);
    const close = text[end] === quote ? "" : quote;
    return { from, to: end, options: words.filter(({ isText }) => isText).map((word) => option(word, word.word + close)), same: SAME.text };
  }
  // neither is Enter taken from who goes on with a list in the next line, nor behind a whole word
  const written = text.slice(from, to);
  if (!asked && ((inList && written === "") || words.some(({ word }) => word === written))) { return null; }
  return { from, to, options: words.map((word) => option(word, word.isText ? `"${word.word}"` : word.word)) };
}

/** Where the text in quotes ends that an option replaces: further entries of a list behind a quote that is missing stay. */
function endOfText(text, { from, to, isClosed }, at) {
  if (isClosed && !text.slice(from, to).includes(",")) { return to; }
  const rest = /[^\s"',\]}#]*/y;
  rest.lastIndex = at;
  return at + rest.exec(text)[0].length;
}

/** What the key or the header at a place means: {from, to, title, detail, info}; null where there is none. */
export function meaningAt(format, text, at) {
  const place = placeAt(format, text, at);
  if (!place?.node || place.kind === "value") { return null; }
  const { kind, name, node } = place;
  const [from, to] = kind === "header" ? [place.nameFrom, place.nameTo] : [place.from, place.to];
  return { from, to, title: name, detail: format.kind(name, node), info: node.description };
}

/** Keys of the table that are not written yet, required ones first, as the schema lists them. */
function keysAt(format, text, { table, to, languages, open }) {
  const { form, keys } = table;
  if (!form || keys.size >= (form.maxProperties ?? Infinity)) { return []; }
  const needed = new Set(form.required);
  const isFree = (name) => !keys.has(name) && !keys.has(otherUnit(name));
  const isFollowed = /[ \t]*[=.]/y;
  isFollowed.lastIndex = to;
  const follows = isFollowed.test(text) ? "" : " = ";
  const option = (name, node, end) => ({
    label: name, insert: name + end, kind: "property", detail: detailOf(format, form, name, node), info: node.description,
  });
  // the lesson's own tables are written as headers
  const own = Object.entries(form.properties).filter(([name, node]) => isFree(name) && !(open && form === format.root && format.tableOf(node)));
  const sorted = [...own.filter(([name]) => needed.has(name)), ...own.filter(([name]) => !needed.has(name))];
  const tags = [...languages].filter((tag) => format.language(form, tag));
  return [
    ...sorted.map(([name, node]) => option(name, node, follows)),
    ...tags.map((tag) => option(tag, format.language(form, tag), follows && ".")),
  ];
}

function detailOf(format, form, name, node) {
  return format.kind(name, node) + (form.required?.includes(name) ? ", required" : "");
}

/** The same key with the other unit of angles: only one of them can be written. */
function otherUnit(name) { return name.includes("_deg") ? name.replace("_deg", "_rad") : name.replace("_rad", "_deg"); }

/** Headers of tables within the tables that are open, the innermost first. */
function headersAt(format, { open, languages }) {
  return [...open].reverse().flatMap(({ path, table }) => {
    const own = Object.entries(table.form?.properties ?? {});
    const tags = [...languages].map((tag) => [tag, format.language(table.form, tag)]);
    return [...own, ...tags].flatMap(([name, node]) => {
      const held = format.tableOf(node);
      if (!held || (table.keys.has(name) && !(held.isList && table.keys.get(name)))) { return []; }
      const label = held.isList ? `[[${[...path, name].join(".")}]]` : `[${[...path, name].join(".")}]`;
      return [{ label, insert: label, kind: "class", detail: detailOf(format, table.form, name, node), info: node.description }];
    });
  });
}

/** Words of the schema, and names that the text defines: [{word, isText, kind, detail}]. */
function valuesAt(format, { key, forms, others, names }) {
  const groups = forms.some((form) => form.type === "string") && Object.hasOwn(NAMED, key ?? "") ? NAMED[key] : [];
  const words = [
    ...format.words(forms).map((word) => ({ ...word, kind: "enum" })),
    ...groups.flatMap((group) => [...new Set(names[group])].map((word) => ({ word, isText: true, kind: "variable", detail: group }))),
    ...(groups.length > 0 && Object.hasOwn(FURTHER, key) ? FURTHER[key] : []).map((word) => ({ word, isText: true, kind: "enum" })),
  ];
  const used = new Set(others);
  return words.filter(({ word }) => !used.has(word));
}
