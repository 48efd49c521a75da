// Typing: browsers bring up the keyboard of a screen, and compose letters, for fields of the page, never for a canvas.
import { listenToKeys, press } from "./input.js";

// stands in the field: Backspace is told only where there is something to take away
const FILLING = " ".repeat(8);
// pictures until a tap has become a text field that waits for letters: pressed, released, begun
const PICTURES = 4;

/** A field of the page that nobody sees; what is typed into it goes to the text field of the picture. */
export class ScreenKeyboard {
  constructor(field, canvas, program, loop) {
    this.field = field;
    this.canvas = canvas;
    this.program = program;
    this.loop = loop;
    listenToKeys(field, program, loop, true);
    field.addEventListener("input", (event) => this.take(event));
    field.addEventListener("compositionend", (event) => this.take(event));
    // where it stood the page would have room for it, also when the picture has become smaller
    field.addEventListener("blur", () => this.put(0, 0));
    this.fill();
  }
  fill() {
    this.field.value = this.before = FILLING;
    this.field.setSelectionRange(FILLING.length, FILLING.length);
  }
  put(x, y) { Object.assign(this.field.style, { left: `${x}px`, top: `${y}px` }); }
  /** Hands on what has changed. Words that are being composed change to their end. */
  take({ inputType = "", isComposing = false }) {
    const [before, now] = [[...this.before], [...this.field.value]];
    if (/^delete(Word|SoftLine|HardLine)/.test(inputType)) {
      // of words the filling knows nothing
      press(this.program, "Control", "Backspace");
      isComposing = false;
    } else {
      let same = 0;
      while (same < before.length && same < now.length && before[same] === now[same]) { ++same; }
      for (let k = same; k < before.length; ++k) { press(this.program, "Backspace"); }
      for (const letter of now.slice(same)) { this.program.text(letter.codePointAt(0)); }
    }
    this.before = this.field.value;
    if (!isComposing) { this.fill(); }
    this.loop.rouse();
  }
  /** Brings the keyboard up if a finger has tapped a text field. Browsers allow that in the event of the tap alone. */
  followTap() {
    for (let k = 0; k < PICTURES; ++k) { this.loop.turn(); }
    if (document.activeElement !== this.field) { return; }
    // one that was put away comes up for a field that gets the keyboard anew
    this.field.blur();
    this.followPicture();
  }
  /** Has the keyboard of the page as long as somebody types in the picture. */
  followPicture() {
    const active = document.activeElement;
    const place = this.program.typingPlace();
    if (!place) {
      if (active === this.field) { this.canvas.focus({ preventScroll: true }); }
      return;
    }
    // where it is, since browsers move the page until the field is seen above their keyboard
    this.put(...place.split(" ").map((pixels) => pixels * this.canvas.clientWidth / this.canvas.width));
    if (active !== this.canvas && active !== document.body) { return; }
    this.fill();
    this.field.focus({ preventScroll: true });
  }
}
