// What is shown, as the part of the address behind '#': a link opens it, and the back button undoes.

/** A long story is being told: what was open before is shown. */
export const isTelling = (state) => state.told_part !== undefined;

export class Address {
  constructor(program, toast) {
    this.program = program;
    this.toast = toast;
    this.shown = "";
    // the entries of the history are numbered: where a link is given up, the one before is shown again
    this.number = history.state?.number ?? 0;
    this.left = undefined;
  }
  /** What makes another entry of the history: the lesson, and what was tried with it. */
  entryOf(state) { return JSON.stringify([state.file, state.tried]); }
  /** Opens what the address says, now and whenever it changes. */
  open(rouse) {
    const go = () => {
      const wanted = location.hash.slice(1);
      const number = history.state?.number ?? this.number + (this.entry === undefined ? 0 : 1);
      if (wanted === this.shown) {
        this.number = number;
        return;
      }
      this.left ??= { shown: this.shown, number: this.number };
      this.shown = wanted;
      this.number = number;
      history.replaceState({ number }, "", location.href);
      const why = this.program.goToAddress(wanted);
      // where an address leads is no further entry, even if it takes a while
      const state = this.program.state();
      if (!isTelling(state)) { this.left = undefined; }
      this.entry = this.entryOf(state);
      if (why) { this.toast(why); }
      rouse();
    };
    window.addEventListener("hashchange", go);
    go();
    this.entry ??= this.entryOf(this.program.state());
  }
  /** Writes what is shown into the address: an experiment or another lesson is an entry of the history, all else is not. */
  follow(state) {
    // the person changed the address a moment ago: where it leads comes first
    if (location.hash.slice(1) !== this.shown || isTelling(state)) { return; }
    const entry = this.entryOf(state);
    const arrives = this.left !== undefined && entry !== this.entry;
    if (this.left && !arrives && this.left.number !== this.number) { return this.goBack(); }
    const isNew = entry !== this.entry && !arrives;
    this.entry = entry;
    this.left = undefined;
    const now = this.program.address();
    if (now === this.shown) { return; }
    this.shown = now;
    if (isNew) { ++this.number; }
    history[isNew ? "pushState" : "replaceState"]({ number: this.number }, "", now ? `#${now}` : location.pathname + location.search);
  }
  /** To the entry of what is shown still, since the one chosen was given up. */
  goBack() {
    const by = this.left.number - this.number;
    this.shown = this.left.shown;
    this.number = this.left.number;
    this.left = undefined;
    history.go(by);
  }
}
