// What is shown, as the part of the address behind '#': a link opens it, and the back button undoes.

export class Address {
  constructor(program, toast) {
    this.program = program;
    this.toast = toast;
    this.shown = "";
  }
  /** Opens what the address says, now and whenever it changes. */
  open(rouse) {
    const go = () => {
      const wanted = location.hash.slice(1);
      if (wanted === this.shown) { return; }
      this.shown = wanted;
      const why = this.program.goToAddress(decodeURI(wanted));
      if (why) { this.toast(why); }
      rouse();
    };
    window.addEventListener("hashchange", go);
    go();
  }
  /** Writes what is shown into the address: an experiment or another lesson is an entry of the history, all else is not. */
  follow(state) {
    const now = this.program.address();
    if (now === this.shown) { return; }
    const entry = `${state.file ?? ""} ${state.tried ?? ""}`;
    const isNew = this.entry !== undefined && entry !== this.entry;
    this.entry = entry;
    this.shown = now;
    history[isNew ? "pushState" : "replaceState"](null, "", now ? `#${now}` : location.pathname + location.search);
  }
}
