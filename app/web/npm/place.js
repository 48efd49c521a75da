// Where a place of a lesson's text is: in which table, at which key or value. The text may be half typed: brackets and strings
// that are not closed end where the next statement begins. The whole text is read once, since keys and names behind the
// place count, too; the time is proportional to its length.

/** A table as far as it is written. */
class Table {
  /** @param form what the schema says of it; undefined for a table that the format does not have */
  constructor(form) {
    this.form = form;
    this.keys = new Map();
  }
}

const BLANK = /[ \t\r]*/y;
const BEFORE_NAME = /[ \t\r]*(?=[^\s=.,[\]{}#])|/y;
// as much of a bare key as there is: other letters than those of TOML are told by the reader of lessons
const BARE = /[^\s=.,[\]{}#"']*/y;
const STRING = { '"': /[^"\\\n]*(?:\\[^\n][^"\\\n]*)*/y, "'": /[^'\n]*/y };
const BARE_VALUE = /[^,\]}#\n]*/y;
const LINE = /[^\n]*/y;
// a line that cannot be an entry of a list: the list above it was not closed
const STATEMENT = /[ \t]*(?:\[{1,2}[A-Za-z][\w.-]*\]{0,2}[ \t\r]*(?:#[^\n]*)?(?:\n|$)|(?!(?:true|false|inf|nan)\b)[A-Za-z])/y;
// deeper than any table of the format
const DEEPEST = 8;

/**
 * The place `at` in a text; null where nothing can be completed, in comments and other texts.
 * kind "key": table, name, from, to; open, the tables that a header may add to, where a statement may begin.
 * kind "header": from, to of the whole header, open, and node, nameFrom, nameTo of the name at the place.
 * kind "value": key, node, forms, from, to; quote, empty outside of strings; others, further entries of its list.
 * With it: languages and names {body, joint, driver} of the text.
 */
export function placeAt(format, text, at) { return new Reader(format, text, at).read(); }

class Reader {
  constructor(format, text, at) {
    Object.assign(this, { format, text, at, i: 0, place: undefined });
    this.root = new Table(format.root);
    this.open = [{ path: [], table: this.root }];
    this.names = { body: [], joint: [], driver: [] };
    this.languages = new Set();
    this.frames = [{ kind: "line", table: this.root, expects: "key" }];
  }
  read() {
    while (this.i < this.text.length) {
      this.atBoundary();
      this.token(this.frames.at(-1), this.text[this.i]);
    }
    this.atBoundary();
    return this.place ? { ...this.place, names: this.names, languages: this.languages } : null;
  }
  /** Matches a sticky expression here and goes behind it. */
  take(expression) {
    const from = this.i;
    expression.lastIndex = from;
    expression.test(this.text);
    this.i = expression.lastIndex;
    return this.text.slice(from, this.i);
  }
  token(frame, c) {
    if (c === "\n") { return this.endLine(); }
    if (c === " " || c === "\t" || c === "\r") { return this.blank(); }
    if (c === "#") { return this.comment(); }
    if (frame.expects === "key" && frame.kind === "line" && c === "[") { return this.header(frame); }
    if (frame.expects === "key" && !"=,[]{}".includes(c)) { return this.key(frame); }
    if (`"'`.includes(c)) { return this.string(frame, c); }
    if (c === "=" && (frame.expects === "key" || frame.expects === "equals")) { return this.equals(frame); }
    if (c === "," && frame.kind !== "line") { return this.comma(frame); }
    if ((c === "]" && frame.kind === "list") || (c === "}" && frame.kind === "table")) {
      this.frames.pop();
      return ++this.i;
    }
    if (frame.expects !== "value") { return ++this.i; }
    return "[{".includes(c) ? this.bracket(frame, c) : this.bareValue(frame);
  }
  equals(frame) {
    if (frame.expects === "key") { Object.assign(frame, { owner: frame.table, key: undefined, node: undefined, forms: [] }); }
    frame.expects = "value";
    ++this.i;
  }
  comma(frame) {
    frame.expects = frame.kind === "list" ? "value" : "key";
    ++this.i;
  }
  comment() {
    const from = this.i;
    this.take(LINE);
    if (from < this.at && this.at <= this.i) { this.place = null; }
  }
  blank() {
    const from = this.i;
    this.take(BLANK);
    if (from < this.at && this.at < this.i) { this.nothingYet(); }
  }
  /** Between two tokens nothing is written yet. */
  atBoundary() {
    if (this.i === this.at && this.place === undefined) { this.nothingYet(); }
  }
  nothingYet() {
    const frame = this.frames.at(-1);
    const here = { from: this.at, to: this.at };
    if (frame.expects === "key") {
      this.place = { kind: "key", table: frame.table, name: "", ...here, open: frame.kind === "line" ? this.open : undefined };
    } else { this.place = frame.expects === "value" ? this.valueAt(frame, { ...here, quote: "" }) : null; }
  }
  valueAt(frame, more) {
    return { kind: "value", key: frame.key, node: frame.node, forms: frame.forms, others: frame.values ?? [], inList: frame.kind === "list", ...more };
  }
  endLine() {
    ++this.i;
    while (this.frames.at(-1).kind === "table") { this.frames.pop(); }
    STATEMENT.lastIndex = this.i;
    if (this.frames.at(-1).kind === "list" && STATEMENT.test(this.text)) { this.frames.length = 1; }
    if (this.frames.length === 1) { this.frames[0].expects = "key"; }
  }
  /** A part of a key, bare or in quotes: {name, from, to, isHere}. */
  name() {
    const from = this.i;
    const quote = this.text[from];
    let name;
    if (STRING[quote]) {
      ++this.i;
      name = this.take(STRING[quote]);
      if (this.text[this.i] === quote) { ++this.i; }
    } else { name = this.take(BARE); }
    return { name, from, to: this.i, isHere: from <= this.at && this.at <= this.i };
  }
  key(frame) {
    const open = frame.kind === "line" ? this.open : undefined;
    let table = frame.table;
    for (let isFirst = true; ; isFirst = false) {
      const { name, from, to, isHere } = this.name();
      const node = this.format.key(table.form, name);
      if (isHere) { this.place = { kind: "key", table, name, node, from, to, open: isFirst ? open : undefined }; }
      this.take(BLANK);
      if (this.text[this.i] === ".") {
        table = this.below(table, name, isHere);
        ++this.i;
        this.take(BEFORE_NAME);
        continue;
      }
      if (!isHere && !table.keys.has(name)) { this.write(table, name, null); }
      Object.assign(frame, { owner: table, key: name, node, forms: this.format.forms(node), expects: "equals" });
      return;
    }
  }
  /** The table under a key of a table; a new one if there is none. What stands at the place does not count as written. */
  below(table, name, isHere, isNew = false) {
    const before = table.keys.get(name);
    if (before && !isNew) { return before; }
    const node = this.format.key(table.form, name);
    const made = this.grouped(new Table(this.format.tableOf(node)?.table), table, name);
    if (!isHere) { this.write(table, name, made); }
    return made;
  }
  /** @param value the table under the key; null for other values */
  write(table, name, value) {
    table.keys.set(name, value);
    if (this.format.language(table.form, name)) { this.languages.add(name); }
  }
  /** Bodies, joints and drivers of the lesson have names that others refer to. */
  grouped(made, parent, name) {
    if (parent === this.root && Object.hasOwn(this.names, name)) { made.group = name; }
    return made;
  }
  header(frame) {
    const from = this.i;
    const isList = this.text[from + 1] === "[";
    this.i += isList ? 2 : 1;
    const parts = [];
    do {
      if (parts.length > 0) { ++this.i; }
      this.take(BLANK);
      parts.push(this.name());
      this.take(BLANK);
    } while (this.text[this.i] === ".");
    const end = this.i;
    while (this.text[this.i] === "]" && this.i < end + 2) { ++this.i; }
    const isHere = from < this.at && this.at <= end;
    if (this.at === from) { this.place = null; }
    if (isHere) { this.place = { kind: "header", from, to: this.i, open: this.open }; }
    this.enter(frame, parts.slice(0, DEEPEST), isList, isHere);
    frame.expects = "nothing";
  }
  enter(frame, parts, isList, isHere) {
    let table = this.root;
    this.open = [{ path: [], table }];
    parts.forEach((part, k) => {
      if (part.isHere) { Object.assign(this.place ?? {}, { node: this.format.key(table.form, part.name), name: part.name, nameFrom: part.from, nameTo: part.to }); }
      table = this.below(table, part.name, isHere, isList && k === parts.length - 1);
      this.open.push({ path: parts.slice(0, k + 1).map(({ name }) => name), table });
    });
    frame.table = table;
  }
  bracket(frame, c) {
    if (this.i === this.at) { this.place = null; }
    frame.expects = "nothing";
    const inherited = { owner: frame.owner, key: frame.key, node: frame.node };
    if (c === "[") {
      this.frames.push({ kind: "list", expects: "value", ...inherited, forms: this.format.entries(frame.forms), values: [] });
    } else {
      const table = this.grouped(new Table(this.format.table(frame.forms)), frame.owner, frame.key);
      this.frames.push({ kind: "table", expects: "key", table });
    }
    ++this.i;
  }
  string(frame, quote) {
    const from = this.i;
    if (from === this.at) { this.place = null; }
    const isValue = frame.expects === "value";
    if (isValue) { frame.expects = "nothing"; }
    if (this.text.startsWith(quote.repeat(3), from)) { return this.longString(quote); }
    ++this.i;
    const content = this.take(STRING[quote]);
    const to = this.i;
    const isClosed = this.text[to] === quote;
    if (isClosed) { ++this.i; }
    if (from < this.at && this.at <= to) {
      this.place = isValue ? this.valueAt(frame, { from: from + 1, to, quote, isClosed }) : null;
    } else if (isValue) {
      frame.values?.push(content);
      if (frame.key === "name" && frame.owner.group) { this.names[frame.owner.group].push(content); }
    }
  }
  longString(quote) {
    const from = this.i;
    const end = quote === '"' ? /\\[^]|"""/g : /'''/g;
    end.lastIndex = from + 3;
    let found = end.exec(this.text);
    while (found && found[0][0] === "\\") { found = end.exec(this.text); }
    this.i = found ? end.lastIndex : this.text.length;
    // up to two more quotes belong to it
    for (let k = 0; k < 2 && found && this.text[this.i] === quote; ++k) { ++this.i; }
    if (from < this.at && (this.at < this.i || !found)) { this.place = null; }
  }
  bareValue(frame) {
    const from = this.i;
    const to = from + this.take(BARE_VALUE).trimEnd().length;
    frame.expects = "nothing";
    if (from <= this.at && this.at <= to) { this.place = this.valueAt(frame, { from, to, quote: "" }); }
  }
}
