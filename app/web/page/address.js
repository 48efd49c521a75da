// What is shown, as the part of the address behind '#': a link opens it, and the back button undoes.

/** A long story is being told: what was open before is shown. */
const isTelling = (state) => state.told_part !== undefined;

export class Address {
  constructor(program, toast) {
    this.program = program;
    this.toast = toast;
    this.shown = "";
  }
  /** What makes another entry of the history: the lesson, and what was tried with it. */
  entryOf(state) { return JSON.stringify([state.file, state.tried]); }
  /** Opens what the address says, now and whenever it changes. */
  open(rouse) {
    const go = () => {
      const wanted = location.hash.slice(1);
      if (wanted === this.shown) { return; }
      this.shown = wanted;
      const why = this.program.goToAddress(wanted);
      // where an address leads is no further entry, even if it takes a while
      const state = this.program.state();
      this.arrives = isTelling(state);
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
    const isNew = entry !== this.entry && !this.arrives;
    this.entry = entry;
    this.arrives = false;
    const now = this.program.address();
    if (now === this.shown) { return; }
    this.shown = now;
    history[isNew ? "pushState" : "replaceState"](null, "", now ? `#${now}` : location.pathname + location.search);
  }
}
