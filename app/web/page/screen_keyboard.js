// The keyboard on the screen of phones and tablets: browsers bring it up for fields of the page, never for a canvas.
import { listenToKeys } from "./input.js";

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
    field.addEventListener("input", (event) => this.take(event.isComposing));
    field.addEventListener("compositionend", () => this.take(false));
    this.fill();
  }
  fill() {
    this.field.value = this.before = FILLING;
    this.field.setSelectionRange(FILLING.length, FILLING.length);
  }
  /** Hands on what has changed. Words that are being composed change to their end. */
  take(composes) {
    const [before, now] = [[...this.before], [...this.field.value]];
    let same = 0;
    while (same < before.length && same < now.length && before[same] === now[same]) { ++same; }
    for (let k = same; k < before.length; ++k) {
      this.program.key("Backspace", 1);
      this.program.key("Backspace", 0);
    }
    for (const letter of now.slice(same)) { this.program.text(letter.codePointAt(0)); }
    this.before = this.field.value;
    if (!composes) { this.fill(); }
    this.loop.rouse();
  }
  /** Brings the keyboard up if a finger has tapped a text field. Browsers allow that in the event of the tap alone. */
  followTap() {
    for (let k = 0; k < PICTURES; ++k) { this.loop.turn(); }
    const place = this.program.typingPlace();
    if (!place) { return; }
    // where it is, since browsers move the page until the field is seen above their keyboard
    const [x, y] = place.split(" ").map((pixels) => pixels * this.canvas.clientWidth / this.canvas.width);
    Object.assign(this.field.style, { left: `${x}px`, top: `${y}px` });
    this.fill();
    this.field.focus({ preventScroll: false });
  }
  /** Puts it away where nobody types any more. */
  followPicture() {
    if (document.activeElement === this.field && !this.program.typingPlace()) { this.canvas.focus({ preventScroll: true }); }
  }
}
