// The lesson as text beside the picture: read anew while it is typed, kept in the browser, opened and saved as a file.
const $ = (id) => document.getElementById(id);
const FOLDER = "/kept/edited";
// [ms] after the last key until the text is read
const PAUSE = 300;

export class Editor {
  constructor({ program, loop, download, toast }) {
    Object.assign(this, { program, loop, download, toast });
    this.FS = program.module.FS;
    this.FS.mkdirTree(FOLDER);
    this.saved = "";
    $("edit").addEventListener("click", () => { if ($("editor").hidden) { this.show(); } else { this.close(); } });
    $("close-editor").addEventListener("click", () => this.close());
    $("save-file").addEventListener("click", () => this.save());
    $("open-file").addEventListener("click", () => $("file").click());
    $("file").addEventListener("change", () => { this.openFile($("file").files[0]); $("file").value = ""; });
    $("editor").addEventListener("keydown", (event) => {
      if ((event.ctrlKey || event.metaKey) && event.key === "s") { event.preventDefault(); this.save(); }
    });
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      const file = event.dataTransfer?.files[0];
      if (file) { this.openFile(file); }
    });
    window.addEventListener("beforeunload", (event) => { if (this.isUnsaved) { event.preventDefault(); } });
  }
  get isUnsaved() { return this.editor && !$("editor").hidden && this.editor.text !== this.saved; }

  /** The text of the open lesson as it stands, with what was tried. */
  show() {
    const state = this.program.state();
    if (!state.shows_lesson) { return this.toast("Open a lesson first, or drop a file on the page."); }
    this.path = `${FOLDER}/${state.file.split("/").pop()}`;
    this.saved = this.program.lessonSource();
    this.reveal(this.saved);
  }
  /** Loads the editor when it is first wanted. Of two texts that wait for it the last one is shown. */
  async reveal(text) {
    this.wanted = text;
    this.loading ??= import("./text_editor.js").then(({ TextEditor }) => {
      this.editor = new TextEditor($("text"), () => this.changed());
    });
    await this.loading;
    if (this.wanted !== text) { return; }
    $("file-name").textContent = this.path.split("/").pop();
    $("editor").hidden = false;
    $("edit").setAttribute("aria-expanded", "true");
    this.editor.show(text);
    this.read();
    this.editor.focus();
  }
  close() {
    if (this.isUnsaved && !confirm("The text was changed and not saved as a file. It stays in this browser. Close it?")) { return; }
    $("editor").hidden = true;
    $("edit").setAttribute("aria-expanded", "false");
    document.getElementById("canvas").focus();
  }
  changed() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.read(true), PAUSE);
  }
  /** Marks the mistakes; a text without any is shown at the same step. @param write the text was changed */
  read(write = false) {
    const text = this.editor.text;
    const mistakes = JSON.parse(this.program.check(text, this.path.split("/").pop()));
    this.editor.mark(mistakes);
    $("mistakes").textContent = mistakes.map((m) => `${m.line}:${m.column}: ${m.message}`).join("\n");
    if (write && !mistakes.some((m) => m.severity === "error")) {
      this.FS.writeFile(this.path, text);
      this.program.follow(this.path);
    }
    this.loop.rouse();
  }
  save() {
    this.download(this.path, new TextEncoder().encode(this.editor.text));
    this.saved = this.editor.text;
  }
  async openFile(file) {
    if (!file) { return; }
    if (this.isUnsaved && !confirm("The text was changed and not saved as a file. Open another one?")) { return; }
    if (file.size > 1_000_000) { return this.toast(`${file.name} has ${Math.round(file.size / 1e6)} MB: this is no lesson.`); }
    const text = await file.text();
    // a name of one's own in the folder: nothing above it can be reached
    this.path = `${FOLDER}/${file.name.replace(/[^\p{L}\p{N}._ -]/gu, "_").replace(/^\.+/, "_")}`;
    this.FS.writeFile(this.path, text);
    this.saved = text;
    this.program.open(this.path, "", "");
    this.reveal(text);
  }
}
