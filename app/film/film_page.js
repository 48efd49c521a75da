'use strict';
const film = JSON.parse(document.getElementById('film').textContent);
const pictures = film.pictures;
const starts = [];
let length = 0;
for (const picture of pictures) { starts.push(length); length += picture.seconds; }

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) { made.setAttribute(name, value); }
  made.append(...children);
  return made;
}

const canvas = element('canvas', {width: film.width, height: film.height, role: 'img', tabindex: '0'});
const context = canvas.getContext('2d');
// what is put together of parts is shown when it is whole
const hidden = element('canvas', {width: film.width, height: film.height});
const parts = hidden.getContext('2d');
const play = element('button', {type: 'button'}, 'Play');
const back = element('button', {type: 'button', 'aria-label': 'previous step'}, '◀');
const next = element('button', {type: 'button', 'aria-label': 'next step'}, '▶');
const slider = element('input', {type: 'range', min: 0, max: length, step: 'any', value: 0, 'aria-label': 'time'});
const clock = element('span', {class: 'time'});
const speed = element('select', {'aria-label': 'speed'});
for (const rate of [0.25, 0.5, 1, 2, 4]) { speed.append(element('option', {value: rate}, rate + ' ×')); }
speed.value = 1;
const chapters = element('nav', {class: 'bar', 'aria-label': 'chapters'});
const caption = element('section', {class: 'caption', 'aria-live': 'polite', 'aria-label': 'what happens'});
const transcript = element('ol', {});
document.querySelector('main').append(
  canvas, element('div', {class: 'bar'}, back, play, next, slider, clock, speed), chapters, caption,
  element('p', {class: 'keys'}, 'Space: play or stop. ← →: step. , .: picture. Home, End. 1 to 9: chapters.'),
  element('details', {}, element('summary', {}, 'All steps as text'), transcript));

let time = 0;      // of the film, in seconds
let shown = -1;    // picture on the canvas
let wanted = 0;    // picture that is to be there
let drawing = false;
let playing = 0;   // when the last frame of the browser was, in milliseconds; 0: stands still

async function decoded(picture) {
  const image = new Image();
  image.src = 'data:image/png;base64,' + picture.png;
  await image.decode();
  return image;
}

// a picture is a whole one and the parts that have changed since
async function draw() {
  if (drawing) { return; }
  drawing = true;
  while (shown !== wanted) {
    const target = wanted;
    let first = target;
    while (!pictures[first].whole) { --first; }
    if (shown >= first && shown < target) { first = shown + 1; }
    for (let k = first; k <= target; ++k) {
      const image = await decoded(pictures[k]);
      // a part of an opaque film is transparent where nothing has changed
      if (!film.opaque) { parts.clearRect(pictures[k].x, pictures[k].y, image.width, image.height); }
      parts.drawImage(image, pictures[k].x, pictures[k].y);
      shown = k;
    }
    context.clearRect(0, 0, film.width, film.height);
    context.drawImage(hidden, 0, 0);
  }
  drawing = false;
}

function two(number) { return String(number).padStart(2, '0'); }
function clockText(seconds) { return Math.floor(seconds / 60) + ':' + two(Math.floor(seconds % 60)); }

function pictureAt(seconds) {
  let low = 0;
  let high = pictures.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (starts[middle] <= seconds) { low = middle; } else { high = middle - 1; }
  }
  return low;
}

let told = '';
function tell(step) {
  const lines = film.captions[step];
  const text = lines.join('\n');
  if (text === told) { return; }
  told = text;
  caption.replaceChildren(...lines.map((line) => element('p', {}, line)));
  canvas.setAttribute('aria-label', text);
}

function go(seconds) {
  time = Math.min(Math.max(seconds, 0), length);
  wanted = pictureAt(Math.min(time, length - 1e-6));
  slider.value = time;
  clock.textContent = clockText(time) + ' / ' + clockText(length);
  tell(pictures[wanted].step);
  film.chapters.forEach((chapter, k) => {
    const end = k + 1 < film.chapters.length ? film.chapters[k + 1].from : Infinity;
    chapters.children[k].setAttribute('aria-current', String(time >= chapter.from && time < end));
  });
  draw();
}

function stop() { playing = 0; play.textContent = 'Play'; }
function start() {
  if (time >= length - 1e-6) { go(0); }
  playing = performance.now();
  play.textContent = 'Stop';
  requestAnimationFrame(frame);
}
function frame(now) {
  if (!playing) { return; }
  go(time + Math.max(0, now - playing) / 1000 * Number(speed.value));
  playing = now;
  if (time >= length - 1e-6) { stop(); } else { requestAnimationFrame(frame); }
}
function toggle() { if (playing) { stop(); } else { start(); } }

// where a step has arrived: its last picture
function arrived(step) {
  let k = pictures.findLastIndex((picture) => picture.step === step);
  return starts[k];
}
function step(direction) {
  stop();
  let k = wanted;
  const here = pictures[k].step;
  while (k >= 0 && k < pictures.length && pictures[k].step === here) { k += direction; }
  if (k >= 0 && k < pictures.length) { go(arrived(pictures[k].step)); }
}
function one(direction) { stop(); go(starts[Math.min(Math.max(wanted + direction, 0), pictures.length - 1)]); }

film.chapters.forEach((chapter, k) => {
  const button = element('button', {type: 'button'}, (k + 1) + ' ' + chapter.title);
  button.addEventListener('click', () => go(chapter.from));
  chapters.append(button);
});
let before = '';
for (const picture of pictures) {
  const lines = film.captions[picture.step];
  const text = lines.join('\n');
  if (text === before) { continue; }
  before = text;
  const button = element('button', {type: 'button'}, lines[0] || 'step ' + picture.step);
  button.addEventListener('click', () => { stop(); go(arrived(picture.step)); canvas.scrollIntoView(); });
  transcript.append(element('li', {}, button, ...lines.slice(1).map((line) => element('p', {}, line))));
}

play.addEventListener('click', toggle);
canvas.addEventListener('click', toggle);
back.addEventListener('click', () => step(-1));
next.addEventListener('click', () => step(1));
slider.addEventListener('input', () => { stop(); go(Number(slider.value)); });
document.addEventListener('keydown', (event) => {
  const isField = event.target instanceof HTMLSelectElement;
  if (event.ctrlKey || event.altKey || event.metaKey || isField) { return; }
  const isButton = event.target instanceof HTMLButtonElement;
  const number = Number(event.key);
  if (event.key === ' ' && !isButton) { toggle(); }
  else if (event.key === 'ArrowRight') { step(1); }
  else if (event.key === 'ArrowLeft') { step(-1); }
  else if (event.key === '.') { one(1); }
  else if (event.key === ',') { one(-1); }
  else if (event.key === 'Home') { stop(); go(0); }
  else if (event.key === 'End') { stop(); go(length); }
  else if (number >= 1 && number <= film.chapters.length) { go(film.chapters[number - 1].from); }
  else { return; }
  event.preventDefault();
});
go(0);
