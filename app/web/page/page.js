// The page around the program: canvas, input, files, address. What is drawn and computed is in jointwise.wasm.
import createJointwise from "./jointwise.js";
import { listen, press } from "./input.js";
import { ScreenKeyboard } from "./screen_keyboard.js";
import { Address, isTelling } from "./address.js";
import { keepFolder, restoreFolder, store, stored, writeFiles } from "./kept.js";

const $ = (id) => document.getElementById(id);
const canvas = $("canvas");
const GRAPHICS = "Firefox, Chromium and Safari of the last years have WebGL 2; it may be switched off in the settings, or by the driver of the graphics card.";

/** Words of the page in the language of the program, by the English ones. */
let words = {};

export function toast(text) {
  $("toast").textContent = words[text] ?? text;
  $("toast").hidden = false;
  clearTimeout(toast.timer);
  toast.timer = setTimeout(() => { $("toast").hidden = true; }, 4000);
}

/** A message in place of the program: never a blank page. */
function giveUp(why, help = "") {
  const words = document.createElement("div");
  words.className = "missing";
  words.innerHTML = "<h1>Jointwise cannot begin here</h1><p></p><p></p>";
  [words.children[1].textContent, words.children[2].textContent] = [why, help];
  document.querySelector("main").replaceChildren(words);
}

function download(path, bytes) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = path.split("/").pop();
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    toast("The browser does not let this page write to the clipboard.");
  }
}

/** The functions of main.cpp with arguments and results as JavaScript has them. */
function programOf(module) {
  const wrap = (name, result, ...types) => module.cwrap(name, result, types);
  return {
    module,
    begin: wrap("jw_begin", "string", "string", "number", "number", "number", "number", "number", "string", "string"),
    frame: wrap("jw_frame", "number", "number"),
    resize: wrap("jw_resize", null, "number", "number", "number"),
    loseContext: wrap("jw_lose_context", null),
    restoreContext: wrap("jw_restore_context", "string"),
    pointer: wrap("jw_pointer", null, "number", "number"),
    button: wrap("jw_button", null, "number", "number"),
    wheel: wrap("jw_wheel", null, "number"),
    key: wrap("jw_key", "number", "string", "number"),
    text: wrap("jw_text", null, "number"),
    leave: wrap("jw_leave", null),
    setClipboard: wrap("jw_set_clipboard", null, "string"),
    typingPlace: wrap("jw_typing_place", "string"),
    isScene: wrap("jw_is_scene", "number", "number", "number"),
    open: wrap("jw_open", "number", "string", "string", "string"),
    words: wrap("jw_words", "string"),
    stateText: wrap("jw_state", "string"),
    state: () => JSON.parse(module.ccall("jw_state", "string", [], [])),
    address: wrap("jw_address", "string"),
    goToAddress: wrap("jw_go_to_address", "string", "string"),
    lessonSource: wrap("jw_lesson_source", "string"),
    check: wrap("jw_check", "string", "string", "string"),
    follow: wrap("jw_follow", null, "string"),
    measured: wrap("jw_measured", null, "number", "string"),
    keepUnsaved: wrap("jw_keep_unsaved", null),
  };
}

/** Shows the words around the picture in the language of the program. */
function translate(program) {
  words = JSON.parse(program.words());
  for (const button of document.querySelectorAll("button")) {
    button.dataset.english ??= button.getAttribute("aria-label") ?? button.textContent;
    const shown = words[button.dataset.english] ?? button.dataset.english;
    if (button.hasAttribute("aria-label")) { button.setAttribute("aria-label", shown); } else { button.textContent = shown; }
  }
}

/** Calls the program when a picture is due, and sleeps otherwise. */
class Loop {
  constructor(program, shown) {
    this.program = program;
    this.shown = shown;
    this.last = performance.now();
    this.waiting = null;
    this.stopped = false;
  }
  rouse() {
    if (this.stopped || this.asked) { return; }
    clearTimeout(this.waiting);
    this.asked = true;
    requestAnimationFrame(() => this.turn());
  }
  turn() {
    this.asked = false;
    if (this.stopped) { return; }
    const now = performance.now();
    const due = this.program.frame((now - this.last) / 1000);
    this.last = now;
    this.frames = (this.frames ?? 0) + 1;
    this.shown();
    if (due <= 0.02) { this.rouse(); } else if (Number.isFinite(due)) {
      this.waiting = setTimeout(() => this.rouse(), due * 1000);
    }
  }
}

function fitCanvas(program, loop) {
  const fit = (width, height, ratio) => {
    if (width <= 0 || height <= 0) { return; }
    canvas.width = width;
    canvas.height = height;
    program.resize(width, height, ratio);
    loop.rouse();
  };
  new ResizeObserver(([entry]) => {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    // whole pixels of the screen where the browser tells them; one that imitates another screen does not
    const box = entry.devicePixelContentBoxSize?.[0];
    const told = box && Math.abs(box.inlineSize - width) < 2 && Math.abs(box.blockSize - height) < 2;
    fit(told ? box.inlineSize : Math.round(width), told ? box.blockSize : Math.round(height), ratio);
  }).observe(canvas);
}

function surviveLostContext(program, loop) {
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    program.loseContext();
    toast("The graphics card is not available at the moment; waiting for it.");
  });
  canvas.addEventListener("webglcontextrestored", () => {
    const why = program.restoreContext();
    if (why) { return giveUp(why, GRAPHICS); }
    loop.rouse();
  });
}

/** What the picture shows, in words, for those who do not see it. */
class Story {
  tell(state) {
    const list = "The list of lessons is shown. Arrows choose, Enter opens.";
    this.tellLines(state.shows_lesson ? state.text : words[list] ?? list);
    const news = [state.notice, state.mistakes].filter(Boolean).join("\n");
    if ($("news").textContent !== news) { $("news").textContent = news; }
    document.title = state.shows_lesson ? `${state.title}${state.changed ? " (changed)" : ""} – Jointwise` : "Jointwise";
  }
  /** Lines that stay are left alone: readers of the screen say what is new. */
  tellLines(text) {
    const [before, now] = [[...$("story").children], text.split(/(?<=\n)/)];
    const most = Math.min(before.length, now.length);
    let first = 0;
    while (first < most && before[first].textContent === now[first]) { ++first; }
    let last = 0;
    while (first + last < most && before.at(-1 - last).textContent === now.at(-1 - last)) { ++last; }
    const next = before[before.length - last] ?? null;
    for (const line of before.slice(first, before.length - last)) { line.remove(); }
    for (const line of now.slice(first, now.length - last)) {
      const element = document.createElement("span");
      element.textContent = line;
      $("story").insertBefore(element, next);
    }
  }
}

/** A copy of the program in a thread of the browser, which measures and is ended when nobody waits for it. */
class Measuring {
  constructor(program, loop) {
    this.program = program;
    this.loop = loop;
  }
  begin(number, lesson, treatment) {
    this.end();
    this.number = number;
    this.worker = new Worker("measure.js", { type: "module" });
    this.worker.addEventListener("message", ({ data }) => {
      if (data.number !== this.number) { return; }
      this.program.measured(number, data.news);
      this.loop.rouse();
    });
    this.worker.addEventListener("error", (event) => {
      this.program.measured(number, JSON.stringify({ runs: [], origin: "", failure: event.message ?? "measure.js could not be run", done: true }));
      this.loop.rouse();
    });
    this.worker.postMessage({ number, lesson, treatment });
  }
  /** @param number  of what is measured; none: whatever it is */
  end(number = this.number) {
    if (number !== this.number) { return; }
    this.worker?.terminate();
    this.worker = this.number = undefined;
  }
}

/** The lessons of the page: {lessons: folder of the course, language: of a site, files: texts by their paths}. */
async function fetchLessons() {
  const answer = await fetch("lessons.json");
  if (!answer.ok) { throw new Error(`The lessons could not be fetched: ${answer.status} ${answer.statusText}`); }
  return answer.json();
}

/** Letters of Chinese, which the fonts in the page do not have; without them marks stand in their place. */
const letters = { file: "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", asked: false };
const lacksLetters = (language) => language.startsWith("zh") && !letters.asked;
async function fetchLetters(FS, language) {
  if (!lacksLetters(language)) { return; }
  letters.asked = true;
  const answer = await fetch("chinese.ttf").catch(() => null);
  if (answer?.ok) { writeFiles(FS, { [letters.file]: new Uint8Array(await answer.arrayBuffer()) }); }
}

/** The steps as words, where nothing can be drawn: the program runs, and its buttons lead it. */
function showWords(course) {
  document.body.classList.add("words");
  $("loading").hidden = true;
  for (const id of ["story", "news"]) { $(id).classList.remove("unseen"); }
  const notice = document.createElement("section");
  notice.className = "missing";
  notice.innerHTML = "<h1>This browser shows no WebGL 2</h1><p>The steps of the lessons stand below as words; the buttons above lead through them. " +
    `${GRAPHICS}</p>` +
    "<p id=\"pictures\"></p><p><label>Lesson <select></select></label></p>";
  if (course.site) {
    const link = document.createElement("a");
    link.href = course.site;
    link.textContent = "The same lessons with pictures";
    notice.querySelector("#pictures").append(link);
  }
  const choice = notice.querySelector("select");
  choice.add(new Option("…", ""));
  for (const path of Object.keys(course.files).filter((file) => file.startsWith(`${course.lessons}/`) && !file.endsWith("/course.toml"))) {
    const name = path.slice(course.lessons.length + 1, -".toml".length);
    choice.add(new Option(name, name));
  }
  choice.addEventListener("change", () => { location.hash = `${encodeURIComponent(choice.value)}/1`; });
  document.querySelector("main").replaceChildren(notice);
}

/** What a person has chosen, where it is not what is usual here; kept for the next visit. */
class Settings {
  constructor(course) {
    // in a page of a course the figure has less room than a window: its letters are a little larger there
    const framed = window.parent !== window && canvas.clientWidth > canvas.clientHeight;
    this.usual = {
      dark: matchMedia("(prefers-color-scheme: dark)").matches,
      text_scale: framed ? 1.25 : 1,
      language: course.language ?? (navigator.language.startsWith("zh") ? "zh-Hant" : "en"),
    };
    const kept = { ...this.usual, ...stored("jointwise-settings") };
    [this.dark, this.textScale, this.language] = [kept.dark, kept.text_scale, kept.language];
  }
  keep(state) {
    const chosen = Object.entries(this.usual).filter(([name, usual]) => state[name] !== usual).map(([name]) => [name, state[name]]);
    store("jointwise-settings", JSON.stringify(Object.fromEntries(chosen)));
  }
}

function listenToButtons({ program, loop, address }) {
  for (const button of document.querySelectorAll("button[data-key], button[data-text]")) {
    button.addEventListener("click", () => {
      if (button.dataset.key) { press(program, button.dataset.key); } else { program.text(button.dataset.text.codePointAt(0)); }
      loop.rouse();
    });
  }
  $("link").addEventListener("click", async () => {
    address.follow(program.state());
    await copy(location.href);
    toast("A link to what you see was copied.");
  });
  $("full").addEventListener("click", () => {
    if (document.fullscreenElement) { document.exitFullscreen(); } else { document.documentElement.requestFullscreen(); }
  });
  $("describe").addEventListener("click", () => {
    const unseen = $("story").classList.toggle("unseen");
    $("describe").setAttribute("aria-expanded", String(!unseen));
  });
}

async function begin() {
  const draws = Boolean(document.createElement("canvas").getContext("webgl2"));
  const fetched = fetchLessons();
  // told where it is waited for
  fetched.catch(() => {});
  const module = await createJointwise({
    page: {
      copy,
      download: (path) => download(path, module.FS.readFile(path)),
      beginMeasuring: (...what) => measuring.begin(...what),
      endMeasuring: (number) => measuring.end(number),
    },
    setStatus(text) {
      const part = /\((\d+(?:\.\d+)?)\/(\d+)\)/.exec(text);
      if (part) { $("progress").value = part[1] / part[2]; }
    },
  });
  const course = await fetched;
  writeFiles(module.FS, course.files);
  restoreFolder(module.FS, "/kept");
  const program = programOf(module);
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  const settings = new Settings(course);
  await fetchLetters(module.FS, settings.language);
  const why = program.begin(draws ? "#canvas" : "", canvas.width, canvas.height, ratio, settings.textScale, settings.dark ? 1 : 0, settings.language, course.lessons);
  if (why) { return giveUp(why, GRAPHICS); }
  if (!draws) { showWords(course); }

  translate(program);
  document.documentElement.lang = settings.language;

  const story = new Story();
  const address = new Address(program, toast);
  let timer = null;
  let lossTold = false;
  let keyboard = null;
  const loop = new Loop(program, () => {
    keyboard?.followPicture();
    // what is about the step waits until it has been shown for a moment
    timer ??= setTimeout(() => {
      timer = null;
      const state = program.state();
      if (state.language !== document.documentElement.lang) {
        translate(program);
        document.documentElement.lang = state.language;
      }
      story.tell(state);
      address.follow(state);
      $("stop").hidden = !isTelling(state);
      settings.keep(state);
      document.documentElement.style.colorScheme = state.dark ? "dark" : "light";
      document.documentElement.classList.toggle("dark", state.dark);
      program.keepUnsaved();
      if (!keepFolder(module.FS, "/kept") && !lossTold) {
        lossTold = true;
        toast("The browser cannot store more: its storage is full or not allowed. Save what you need as a file.");
      }
      // fonts are read when the program begins
      if (lacksLetters(state.language)) {
        letters.asked = true;
        toast("Reload the page to see the letters of this language.");
      }
    }, 200);
  });
  const measuring = new Measuring(program, loop);
  if (draws) {
    keyboard = new ScreenKeyboard($("typing"), canvas, program, loop);
    listen(canvas, program, loop, keyboard);
    fitCanvas(program, loop);
    surviveLostContext(program, loop);
  }
  // a page around leads the keyboard into this one, and then it is the program's
  window.addEventListener("focus", () => { if (document.activeElement === document.body) { canvas.focus({ preventScroll: true }); } });
  // wherever the keyboard is: the sheet says so
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.target === canvas || !isTelling(program.state())) { return; }
    press(program, "Escape");
    loop.rouse();
  });
  address.open(() => loop.rouse());

  listenToButtons({ program, loop, address });
  if (draws) {
    $("loading").hidden = true;
    const { Editor } = await import("./editor.js");
    new Editor({ program, loop, download, toast, address });
  }
  if ("serviceWorker" in navigator) { navigator.serviceWorker.register("service_worker.js", { updateViaCache: "none" }).catch(() => {}); }
  loop.rouse();
  // for tests, which ask what a person sees
  window.jointwise = { program, loop };
}

begin().catch((error) => {
  console.error(error);
  giveUp(String(error?.message ?? error));
});
