// Mouse, touch, pen and keyboard as the events of the program.

// [ms] a finger that rests so long picks up what is below it
const LONG_PRESS = 450;
// [CSS pixels] a finger that moves less than this rests
const SLOP = 8;
// [CSS pixels] of a wheel that counts them, for one notch
const NOTCH = 100;
// [CSS pixels] of a finger for one notch: panels follow it, some a little slower than others
const FINGER_NOTCH = 55;
// distance between fingers for one notch of the wheel, as in app/host/parts/scene_input.cpp
const CLOSER_PER_NOTCH = 0.9;
const BUTTONS = [0, 2, 1];
// keys that stay the browser's: leaving the canvas, reading the page again
const IS_MAC = navigator.platform.startsWith("Mac");
const BROWSERS_KEYS = new Set(["Tab", "F5", "F11", "F12"]);

function placeOf(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [(event.clientX - box.left) * canvas.width / box.width, (event.clientY - box.top) * canvas.height / box.height];
}

/** Presses keys one after the other, and lets them go. */
export function press(program, ...keys) {
  for (const key of keys) { program.key(key, 1); }
  for (const key of keys.reverse()) { program.key(key, 0); }
}

/** Fingers: one turns the picture or scrolls a panel, two shift and zoom, one that rests picks up. */
class Fingers {
  constructor(canvas, program, loop, keyboard) {
    this.canvas = canvas;
    this.program = program;
    this.loop = loop;
    this.keyboard = keyboard;
    this.down = new Map();
    this.held = -1;
    this.scrolls = false;
  }
  middle() {
    const all = [...this.down.values()];
    return [all.reduce((sum, f) => sum + f[0], 0) / all.length, all.reduce((sum, f) => sum + f[1], 0) / all.length];
  }
  spread() {
    const [a, b] = [...this.down.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  }
  press(number) {
    this.held = number;
    this.program.button(number, 1);
  }
  release() {
    if (this.held >= 0) { this.program.button(this.held, 0); }
    this.held = -1;
    this.scrolls = false;
    clearTimeout(this.timer);
  }
  begin(event) {
    const at = placeOf(this.canvas, event);
    this.down.set(event.pointerId, at);
    if (this.down.size === 1) {
      this.start = at;
      this.rests = true;
      this.program.pointer(...at);
      this.timer = setTimeout(() => {
        if (!this.rests) { return; }
        this.rests = false;
        this.press(0);
        this.loop.rouse();
      }, LONG_PRESS);
    } else if (this.down.size === 2) {
      this.release();
      this.rests = false;
      this.apart = this.spread();
      this.program.pointer(...this.middle());
      this.press(1);
    }
  }
  move(event) {
    if (!this.down.has(event.pointerId)) { return; }
    const before = this.down.get(event.pointerId);
    const at = placeOf(this.canvas, event);
    this.down.set(event.pointerId, at);
    if (this.down.size === 2) {
      const apart = this.spread();
      this.program.wheel(Math.log(this.apart / apart) / Math.log(CLOSER_PER_NOTCH));
      this.apart = apart;
      return this.program.pointer(...this.middle());
    }
    const ratio = this.canvas.width / this.canvas.clientWidth;
    if (this.rests && Math.hypot(at[0] - this.start[0], at[1] - this.start[1]) > SLOP * ratio) {
      this.rests = false;
      clearTimeout(this.timer);
      if (this.program.isScene(...this.start)) {
        this.press(3);
      } else if (Math.abs(at[1] - this.start[1]) > Math.abs(at[0] - this.start[0])) {
        this.scrolls = true;
      } else { this.press(0); }
    }
    if (this.scrolls) { return this.program.wheel((at[1] - before[1]) / (FINGER_NOTCH * ratio)); }
    if (!this.rests) { this.program.pointer(...at); }
  }
  end(event) {
    if (!this.down.delete(event.pointerId)) { return; }
    const taps = this.rests;
    if (taps) { this.press(0); }
    this.rests = false;
    this.release();
    if (taps) { this.keyboard.followTap(); }
    if (this.down.size === 0) { setTimeout(() => { this.program.leave(); this.loop.rouse(); }, 50); }
  }
}

function listenToPointers(canvas, program, loop, keyboard) {
  const fingers = new Fingers(canvas, program, loop, keyboard);
  const on = (name, act) => canvas.addEventListener(name, (event) => { act(event); loop.rouse(); });
  on("pointerdown", (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") { return fingers.begin(event); }
    program.pointer(...placeOf(canvas, event));
    program.button(BUTTONS[event.button] ?? 0, 1);
  });
  on("pointermove", (event) => {
    if (event.pointerType === "touch") { return fingers.move(event); }
    program.pointer(...placeOf(canvas, event));
  });
  on("pointerup", (event) => {
    if (event.pointerType === "touch") { return fingers.end(event); }
    program.pointer(...placeOf(canvas, event));
    program.button(BUTTONS[event.button] ?? 0, 0);
  });
  on("pointercancel", (event) => {
    if (event.pointerType === "touch") { return fingers.end(event); }
    for (const button of [0, 1, 2]) { program.button(button, 0); }
  });
  on("pointerleave", (event) => { if (event.pointerType !== "touch") { program.leave(); } });
  on("contextmenu", (event) => event.preventDefault());
  // browsers tell a tap once more as a click of a mouse, which would take the keyboard from the field that has it
  canvas.addEventListener("mousedown", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    // with Ctrl the browser zooms the page
    if (event.ctrlKey) { return; }
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / NOTCH : event.deltaY / 3;
    program.wheel(-lines);
    loop.rouse();
  }, { passive: false });
}

/** @param target  what has the keyboard @param writes  letters change its text, and come from there */
export function listenToKeys(target, program, loop, writes = false) {
  target.addEventListener("keydown", (event) => {
    if (BROWSERS_KEYS.has(event.key) || event.isComposing) { return; }
    const chord = event.ctrlKey || event.metaKey;
    const letter = [...event.key].length === 1 ? event.key : "";
    // with Option a Mac types signs, brackets on many keyboards; elsewhere Alt is the browser's
    if (event.altKey && !(letter && IS_MAC)) { return; }
    // the browser pastes: the event of that has the text
    if (chord && letter.toLowerCase() === "v") { return; }
    if (writes && !chord && (letter || event.key === "Backspace")) { return; }
    if (chord && letter && !"zyosacvx".includes(letter.toLowerCase())) { return; }
    let used = false;
    // of letters the program wants what was typed; with Ctrl, which key it was
    if (!letter || chord || event.key === " ") { used = program.key(chord ? event.key.toLowerCase().replace("control", "Control").replace("meta", "Meta") : event.key, 1) === 1; }
    if (letter && !chord) {
      program.text(event.key.codePointAt(0));
      used = true;
    }
    if (used && event.key !== "Control" && event.key !== "Meta") { event.preventDefault(); }
    loop.rouse();
  });
  target.addEventListener("keyup", (event) => {
    program.key([...event.key].length === 1 ? event.key.toLowerCase() : event.key, 0);
    loop.rouse();
  });
  target.addEventListener("paste", (event) => {
    event.preventDefault();
    program.setClipboard(event.clipboardData.getData("text/plain"));
    press(program, "Control", "v");
    loop.rouse();
  });
  // keys that are held while it loses the keyboard would stay down
  target.addEventListener("blur", (event) => {
    if (event.relatedTarget?.closest("#stage")) { return; }
    program.leave();
    loop.rouse();
  });
}

export function listen(canvas, program, loop, keyboard) {
  listenToPointers(canvas, program, loop, keyboard);
  listenToKeys(canvas, program, loop);
}
