// The lesson as text beside the picture: read anew while it is typed, kept in the browser, opened and saved as a file.
const $ = (id) => document.getElementById(id);
const FOLDER = "/kept/edited";
// [ms] after the last key until the text is read
const PAUSE = 300;

/** The text of a lesson as it was left with mistakes in it: no lesson, so its name does not end like one. */
const draftOf = (path) => `${path}.draft`;

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
    const own = `${FOLDER}/${state.file.split("/").pop()}`;
    const before = this.textOf(draftOf(own)) ?? (state.file === own ? undefined : this.textOf(own));
    const source = this.program.lessonSource();
    const goesOn = before !== undefined && before !== source && confirm("This lesson was edited before, and the text was kept. Go on with that text?");
    this.path = before === undefined || before === source || goesOn || state.file === own ? own : this.freePath(own);
    this.saved = source;
    this.reveal(goesOn ? before : source);
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
    const isWrong = mistakes.some((m) => m.severity === "error");
    if (write && !isWrong) {
      this.FS.writeFile(this.path, text);
      this.program.follow(this.path);
    }
    // one with mistakes is kept, too, beside the last good one
    const draft = draftOf(this.path);
    if (write && isWrong) { this.FS.writeFile(draft, text); } else if (write && this.textOf(draft) !== undefined) { this.FS.unlink(draft); }
    this.loop.rouse();
  }
  /** Text of a file; undefined if it is not there. */
  textOf(path) { return this.FS.analyzePath(path).exists ? this.FS.readFile(path, { encoding: "utf8" }) : undefined; }
  /** Path that no text of before has: this one, or one with a number. */
  freePath(path) {
    let free = path;
    const isTaken = (name) => this.textOf(name) !== undefined || this.textOf(draftOf(name)) !== undefined;
    for (let k = 2; isTaken(free); ++k) { free = path.replace(/(\.toml)?$/, `-${k}$1`); }
    return free;
  }
  save() {
    this.download(this.path, new TextEncoder().encode(this.editor.text));
    this.saved = this.editor.text;
  }
  async openFile(file) {
    if (!file) { return; }
    if (this.isUnsaved && !confirm("The text was changed and not saved as a file. Open another one?")) { return; }
    if (file.size > 1_000_000) { return this.toast(`${file.name} has ${Math.round(file.size / 1e6)} MB: this is not a lesson.`); }
    const text = await file.text();
    // a name of one's own in the folder: nothing above it can be reached
    const path = `${FOLDER}/${file.name.replace(/[^\p{L}\p{N}._ -]/gu, "_").replace(/^\.+/, "_")}`;
    if (file.name === "course.toml") { return this.toast("course.toml has the order of a course, and is not a lesson."); }
    this.path = this.textOf(path) === text ? path : this.freePath(path);
    this.FS.writeFile(this.path, text);
    this.saved = text;
    this.program.open(this.path, "", "");
    this.reveal(text);
  }
}
