// The text editor of the page: CodeMirror with TOML, a mark at every mistake, and completion from the schema of lessons.
import { autocompletion } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { StreamLanguage, defaultHighlightStyle, syntaxHighlighting, bracketMatching } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, hoverTooltip, keymap, lineNumbers } from "@codemirror/view";
import { completionsAt, meaningAt } from "./completions.js";
import { Format } from "./format.js";
import schema from "./lesson.schema.json";

const format = new Format(schema);

/** Options at the cursor, for CodeMirror. */
function complete({ state, pos, explicit }) {
  const found = completionsAt(format, state.doc.toString(), pos, explicit);
  return found && {
    from: found.from, to: found.to, validFor: found.same,
    options: found.options.map(({ label, insert, detail, info, kind }, k) => ({
      // the space is for readers of the screen
      label, apply: insert, detail: detail && ` ${detail}`, info, type: kind,
      // in the order of the schema, not of the alphabet
      sortText: String(k).padStart(4, "0"),
    })),
  };
}

/** What the key under the pointer means. */
const meanings = hoverTooltip((view, pos) => {
  const found = meaningAt(format, view.state.doc.toString(), pos);
  if (!found) { return null; }
  const create = () => {
    const dom = document.createElement("div");
    dom.className = "meaning";
    dom.append(Object.assign(document.createElement("strong"), { textContent: found.title }), ` ${found.detail}: ${found.info}`);
    return { dom };
  };
  return { pos: found.from, end: found.to, create };
});

export class TextEditor {
  /** @param changed called with the whole text after every change by the person */
  constructor(parent, changed) {
    this.silent = false;
    const told = EditorView.updateListener.of((update) => {
      if (update.docChanged && !this.silent) { changed(update.state.doc.toString()); }
    });
    this.extensions = [
      lineNumbers(), history(), drawSelection(), bracketMatching(), highlightActiveLine(), highlightSelectionMatches(),
      lintGutter(), StreamLanguage.define(toml), syntaxHighlighting(defaultHighlightStyle, { fallback: true }),
      // Escape, then Tab leaves the editor, as screen readers expect
      keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, indentWithTab]),
      // behind a key that was chosen its words are offered
      autocompletion({ override: [complete], icons: false, activateOnCompletion: ({ type }) => type === "property" }), meanings,
      EditorView.lineWrapping, told,
      EditorView.contentAttributes.of({ "aria-label": "Text of the lesson. Ctrl-Space completes. Tab indents; Escape, then Tab leaves." }),
    ];
    this.view = new EditorView({ parent, state: this.stateOf("") });
  }
  stateOf(text) { return EditorState.create({ doc: text, extensions: this.extensions }); }
  get text() { return this.view.state.doc.toString(); }
  /** Another text: what was undone before cannot be undone into it. */
  show(text) {
    this.silent = true;
    this.view.setState(this.stateOf(text));
    this.silent = false;
  }
  /** @param mistakes with line and column from 1 on, severity "error" or "warning", and message */
  mark(mistakes) {
    const doc = this.view.state.doc;
    const marks = mistakes.map(({ line, column, severity, message }) => {
      const on = doc.line(Math.min(Math.max(line, 1), doc.lines));
      const from = Math.min(on.from + Math.max(column - 1, 0), on.to);
      return { from, to: Math.max(from, on.to), severity, message };
    });
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }
  goTo(line, column) {
    const on = this.view.state.doc.line(Math.min(Math.max(line, 1), this.view.state.doc.lines));
    const at = Math.min(on.from + Math.max(column - 1, 0), on.to);
    this.view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
    this.view.focus();
  }
  focus() { this.view.focus(); }
}
