// The pages of a site: the figure that runs in place, and the search. Without scripts, or from a folder that no server
// serves, the pages are pictures, words and links.
"use strict";

const servable = location.protocol !== "file:";

/** The program in place of its picture. */
class Figure {
  constructor(figure) {
    this.figure = figure;
    this.screen = figure.querySelector(".screen");
    this.link = this.screen.querySelector("a");
    this.own = figure.querySelector(".own");
  }
  /** Runs it when it is seen; on a line that counts each byte when it is asked for. */
  wait() {
    this.link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) { return; }
      event.preventDefault();
      this.show(this.link.href);
    });
    if (navigator.connection?.saveData) { return; }
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) { return; }
      seen.disconnect();
      if (!this.frame) { this.show(this.link.href); }
    }, { threshold: 0.3 });
    seen.observe(this.screen);
  }
  show(address) {
    this.own.href = address;
    if (this.frame) {
      this.frame.contentWindow.location.replace(address);
      return;
    }
    this.frame = document.createElement("iframe");
    this.frame.title = this.screen.querySelector("img").alt;
    this.frame.src = address;
    this.frame.allow = "fullscreen; clipboard-write";
    this.screen.classList.add("runs");
    this.screen.append(this.frame);
    // behind the program nothing is reached by keys
    this.link.tabIndex = -1;
    this.figure.querySelector(".state").textContent = "";
  }
}

const live = servable && document.querySelector("figure.live");
if (live) {
  const figure = new Figure(live);
  figure.wait();
  for (const link of document.querySelectorAll("a.go")) {
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) { return; }
      event.preventDefault();
      figure.show(link.href);
      live.scrollIntoView({ block: "nearest", behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth" });
      figure.frame.focus({ preventScroll: true });
    });
  }
}

/** Lessons that have all words; as the search of the program: "slide 5" is a number of a slide. */
function found(search) {
  let words = search.toLowerCase();
  const slides = [];
  words = words.replace(/\bslides?\s+([\d\s,–-]+)/gu, (_, numbers) => {
    for (const [, first, last] of numbers.matchAll(/(\d+)(?:\s*[-–]\s*(\d+))?/gu)) {
      slides.push([Number(first), Number(last ?? first)]);
    }
    return " ";
  });
  const wanted = words.split(/\s+/u).filter((word) => word !== "");
  return window.jointwiseLessons.filter((lesson) =>
    wanted.every((word) => lesson.words.includes(word)) &&
    (slides.length === 0 || slides.some(([first, last]) => lesson.slides.some((slide) => first <= slide && slide <= last))));
}

function showFound(field, told) {
  const all = field.value.trim() === "";
  const names = new Set(all ? [] : found(field.value).map((lesson) => lesson.name));
  for (const card of document.querySelectorAll("[data-lesson]")) { card.hidden = !all && !names.has(card.dataset.lesson); }
  for (const chapter of document.querySelectorAll("section.chapter")) {
    chapter.hidden = !all && !chapter.querySelector("[data-lesson]:not([hidden])");
    for (const link of document.querySelectorAll(`a[href="#${chapter.id}"]`)) { (link.closest("li") ?? link).hidden = chapter.hidden; }
  }
  const count = names.size;
  told.textContent = all ? "" : count === 0 ? told.dataset.none : count === 1 ? told.dataset.one : told.dataset.several.replace("#", count);
}

const search = document.querySelector("form.search");
if (search) {
  const field = search.querySelector("input");
  const told = search.querySelector("#found");
  let words = null;
  const show = async () => {
    words ??= new Promise((resolve) => {
      const script = document.createElement("script");
      script.src = "search_data.js";
      script.onload = resolve;
      document.head.append(script);
    });
    await words;
    showFound(field, told);
  };
  field.addEventListener("input", show);
  search.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = document.querySelector("[data-lesson]:not([hidden])");
    (first?.matches("a") ? first : first?.querySelector("a"))?.focus();
  });
  search.hidden = false;
  // what was searched for is there again after the way back from a lesson
  if (field.value) { show(); }
}

if (servable && "serviceWorker" in navigator) {
  const top = new URL(".", document.currentScript.src);
  navigator.serviceWorker.register(new URL("service_worker.js", top), { scope: top.href }).catch(() => {});
}
