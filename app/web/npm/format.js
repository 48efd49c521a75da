// The format of lessons as docs/lesson.schema.json describes it: which keys a table has, and what their values are.

// unit of a number by the end of its key, as in lessons/format
const ENDINGS = [
  ["_deg_per_s2", "deg/s²"], ["_rad_per_s2", "rad/s²"], ["_deg_per_s", "deg/s"], ["_rad_per_s", "rad/s"],
  ["_deg", "deg"], ["_rad", "rad"], ["_s", "s"], ["_hz", "Hz"],
];

export class Format {
  constructor(schema) {
    this.root = schema;
    this.known = new Map();
    // made once: a pattern that names all keys of a table is long
    this.patterns = new Map();
  }
  /** The forms that a value can have: references are followed, alternatives listed. */
  forms(node) {
    if (node === undefined) { return []; }
    if (!this.known.has(node)) { this.known.set(node, this.findForms(node)); }
    return this.known.get(node);
  }
  findForms(node) {
    if (node.$ref) { return this.forms(this.root.definitions[node.$ref.split("/").pop()]); }
    const parts = node.allOf ?? node.anyOf;
    return parts ? parts.flatMap((part) => this.forms(part)) : [node];
  }
  /** Forms of the entries of a list. */
  entries(forms) { return forms.flatMap((form) => this.forms(form.items)); }
  /** The form that is a table; undefined if there is none. */
  table(forms) { return forms.find((form) => form.properties); }
  /** What the schema says of a key of a table; undefined if the table does not have it. */
  key(table, name) {
    if (!table) { return undefined; }
    return Object.hasOwn(table.properties, name) ? table.properties[name] : this.language(table, name);
  }
  /** The texts of a table in the language `name`; undefined if that is not the tag of one, or if the table has no texts. */
  language(table, name) {
    if (!table?.patternProperties || Object.hasOwn(table.properties, name)) { return undefined; }
    for (const [pattern, node] of Object.entries(table.patternProperties)) {
      if (!this.patterns.has(pattern)) { this.patterns.set(pattern, new RegExp(pattern)); }
      // tags are short
      if (name.length < 40 && this.patterns.get(pattern).test(name)) { return node; }
    }
    return undefined;
  }
  /** The table that a key holds, and whether it holds a list of them; undefined for other values. */
  tableOf(node) {
    const forms = this.forms(node);
    const list = this.table(this.entries(forms));
    const table = list ?? this.table(forms);
    return table && { table, isList: list !== undefined };
  }
  /** The words that a value can be: [{word, isText}]. */
  words(forms) {
    return forms.flatMap((form) => {
      if (form.enum) { return form.enum.map((word) => ({ word, isText: true })); }
      if (form.type === "boolean") { return [{ word: "true", isText: false }, { word: "false", isText: false }]; }
      return form.type === "integer" && form.minimum === form.maximum ? [{ word: `${form.minimum}`, isText: false }] : [];
    });
  }
  /** Kind and unit of the value of a key, such as "three numbers [m]". */
  kind(name, node) {
    const held = this.tableOf(node);
    if (held) { return held.isList ? "tables" : "table"; }
    const kinds = new Set(this.forms(node).map((form) => this.kindOf(form)));
    const kind = [...kinds].join(" or ");
    const unit = /number/.test(kind) ? unitOf(name, node.description ?? "") : undefined;
    return unit ? `${kind} [${unit}]` : kind;
  }
  kindOf(form) {
    if (form.enum) { return "word"; }
    switch (form.type) {
      case "string": return "text";
      case "boolean": return "true or false";
      case "integer": return form.minimum === form.maximum ? `${form.minimum}` : "whole number";
      case "number": return form.exclusiveMinimum === 0 ? "number above 0" : "number";
      case "array": return this.kindOfList(form);
      // depends on other keys
      default: return "any value";
    }
  }
  kindOfList(form) {
    const [entry] = this.forms(form.items);
    if (entry.type === "string") { return "list of texts"; }
    if (entry.type === "array") { return "rows of three numbers"; }
    if (!form.minItems || form.minItems !== form.maxItems) { return "list of numbers"; }
    return form.minItems === 3 ? "three numbers" : `${form.minItems} numbers`;
  }
}

/** The unit in a key's name, or in brackets in its description: no comma is in a unit. */
function unitOf(name, about) {
  return ENDINGS.find(([ending]) => name.endsWith(ending))?.[1] ?? /\[([^\],]+)\]/.exec(about)?.[1];
}
