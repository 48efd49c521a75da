// The text editor of the page: CodeMirror with TOML, and a mark at every mistake.
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { StreamLanguage, defaultHighlightStyle, syntaxHighlighting, bracketMatching } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";

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
      EditorView.lineWrapping, told,
      EditorView.contentAttributes.of({ "aria-label": "Text of the lesson. Tab indents; Escape, then Tab leaves.", title: "Tab indents; Escape, then Tab leaves" }),
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
