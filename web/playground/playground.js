// The page of the playground: an editor, a picture, buttons. The program runs in worker.js.

import { autocompletion } from "@codemirror/autocomplete";
import { defaultKeymap, history as undo, historyKeymap, indentWithTab } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, indentOnInput } from "@codemirror/language";
import { indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lua } from "@codemirror/legacy-modes/mode/lua";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { highlightActiveLineGutter, hoverTooltip } from "@codemirror/view";
import { tags } from "@lezer/highlight";

import { nameOf } from "./keys.js";
import { pack, unpack } from "./link.js";
import { HEIGHT, WIDTH } from "./paint.js";
import { aboutName, complete } from "./names.js";
import { snippets, steps } from "./snippets.js";

const PATIENCE = 5000; // ms without an answer until a program counts as endless
const PERIOD = 1000; // ms between two questions
const SHARPEST = 2; // px of the screen for one of CSS, at most
const MOST_LINES = 200; // lines of output that are kept
const QUIET = 400; // ms after the last key until a changed program starts
const STORE = "physics.lua playground"; // where a program is kept over a reload

const find = (id) => document.getElementById(id);
const place = import.meta.url; // of this file; the others lie beside it
const page = {
  list: find("pg-snippets"),
  run: find("pg-run"),
  pause: find("pg-pause"),
  step: find("pg-step"),
  reset: find("pg-reset"),
  original: find("pg-original"),
  share: find("pg-share"),
  editor: find("pg-editor"),
  screen: find("pg-screen"),
  status: find("pg-status"),
  problem: find("pg-problem"),
  output: find("pg-output"),
  pad: find("pg-pad"),
};

// Editor ------------------------------------------------------------------------------------------

// The colours are those of the site, which has a dark and a light set of them.
const COLORS = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--md-code-hl-keyword-color)" },
  { tag: tags.string, color: "var(--md-code-hl-string-color)" },
  { tag: tags.number, color: "var(--md-code-hl-number-color)" },
  { tag: [tags.bool, tags.null, tags.atom], color: "var(--md-code-hl-constant-color)" },
  { tag: tags.comment, color: "var(--md-code-hl-comment-color)", fontStyle: "italic" },
  { tag: tags.standard(tags.variableName), color: "var(--md-code-hl-function-color)" },
  { tag: tags.operator, color: "var(--md-code-hl-operator-color)" },
]);

const editor = new EditorView({
  parent: page.editor,
  state: EditorState.create({
    extensions: [
      lineNumbers(),
      lintGutter(),
      undo(),
      drawSelection(),
      indentOnInput(),
      bracketMatching(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      highlightSelectionMatches(),
      indentUnit.of("  "),
      StreamLanguage.define(lua),
      syntaxHighlighting(COLORS),
      autocompletion({ override: [complete], icons: false }),
      hoverTooltip(aboutName),
      keymap.of([
        { key: "Mod-Enter", run: () => (run(), true) },
        indentWithTab,
        ...defaultKeymap,
        ...historyKeymap,
        ...searchKeymap,
      ]),
      EditorView.contentAttributes.of({ "aria-label": "Program" }),
      EditorView.updateListener.of((update) => {
        if (!update.docChanged) return;
        rememberSoon();
        runSoon();
      }),
    ],
  }),
});

const codeNow = () => editor.state.doc.toString();

function show(code) {
  editor.dispatch({ changes: { from: 0, to: editor.state.doc.length, insert: code } });
}

// Marks a line of the program, 0 for none.
function mark(line, message) {
  const { doc } = editor.state;
  const isKnown = line >= 1 && line <= doc.lines;
  const { from, to } = isKnown ? doc.line(line) : { from: 0, to: 0 };
  const found = isKnown ? [{ from, to, severity: "error", message }] : [];
  editor.dispatch(setDiagnostics(editor.state, found));
  if (isKnown) editor.dispatch({ effects: EditorView.scrollIntoView(from, { y: "center" }) });
}

// Address -----------------------------------------------------------------------------------------

const programs = [...snippets, ...steps];
let original = ""; // the program before it was changed
let timer;
let written = ""; // the part of the address after "#", as it was last written here

async function remember() {
  clearTimeout(timer);
  const code = codeNow();
  const snippet = programs.find((each) => each.code === code);
  keep(code);
  page.list.value = snippet?.name ?? "";
  const part = snippet ? `snippet=${snippet.name}` : `code=${await pack(code)}`;
  if (code !== codeNow()) return; // it has been changed meanwhile, and will be remembered later
  written = part;
  history.replaceState(null, "", `#${part}`);
}

function rememberSoon() {
  clearTimeout(timer);
  timer = setTimeout(remember, 300);
}

// What was written last in this browser: { code, original }, if it can be kept and read.
function kept() {
  try {
    return JSON.parse(localStorage.getItem(STORE)) ?? {};
  } catch {
    return {};
  }
}

function keep(code) {
  try {
    localStorage.setItem(STORE, JSON.stringify({ code, original }));
  } catch {} // a browser may forbid it
}

// Shows and starts the program that the address names. When it names none: what was written last in
// this browser, else the first snippet.
async function openAddress() {
  const wishes = new URLSearchParams(location.hash.slice(1));
  const name = wishes.get("snippet");
  let { code } = programs.find((each) => each.name === name) ?? snippets[0];
  let problem = "";
  original = code;
  if (!name && !wishes.has("code") && kept().code) ({ code, original = code } = kept());
  if (wishes.has("code")) {
    try {
      code = await unpack(wishes.get("code"));
      original = code;
    } catch {
      problem = "The program in the address cannot be read; it may be cut off. This is the first snippet.";
    }
  }
  show(code);
  run();
  if (problem) showProblem(problem, 0);
}

// Program -----------------------------------------------------------------------------------------

let worker = null;
let canvas = null;
let isPaused = false;
let started = ""; // the program that runs
let answered = 0; // ms, when the worker last answered; Infinity until it is ready

const say = (order, values = {}, transfer = []) => worker.postMessage({ order, ...values }, transfer);

function widthOfScreen() {
  return page.screen.clientWidth * Math.min(SHARPEST, window.devicePixelRatio);
}

function openWorker() {
  worker?.terminate();
  canvas?.remove();
  canvas = document.createElement("canvas");
  canvas.id = "pg-canvas";
  canvas.tabIndex = 0;
  canvas.setAttribute("aria-label", "The running program. It takes the keys when it has the focus.");
  page.screen.prepend(canvas);
  listen(canvas);
  const sheet = canvas.transferControlToOffscreen();
  answered = Infinity;
  worker = new Worker(new URL("worker.js", place));
  worker.onmessage = ({ data }) => news[data.kind](data);
  worker.onerror = (event) => showProblem(`The playground itself failed: ${event.message}`, 0);
  const [wasm, library] = ["glue.wasm", "physics.lua"].map((name) => new URL(name, place).href);
  say("open", { canvas: sheet, width: widthOfScreen(), wasm, library }, [sheet]);
}

function showProblem(message, line) {
  page.problem.hidden = false;
  page.problem.textContent = message;
  page.problem.dataset.line = line;
  mark(line, message);
}

function showStatus({ steps, objects, hash, spent }) {
  const parts = [`step ${steps}`, `${objects} objects`, `${spent.toFixed(1)} ms a frame`];
  if (hash !== null) parts.push(`hash ${hash}`);
  page.status.textContent = parts.join(" · ");
}

function setPaused(value) {
  isPaused = value;
  page.pause.textContent = isPaused ? "Continue" : "Pause";
  page.pause.setAttribute("aria-pressed", isPaused);
}

function clear() {
  page.problem.hidden = true;
  page.status.textContent = "";
  page.output.textContent = "";
  page.output.hidden = true;
  mark(0);
}

function start(code) {
  clear();
  started = code;
  page.screen.dataset.state = "waiting";
  say("run", { code, isPaused });
}

// Starts what stands in the editor.
function run() {
  clearTimeout(soon);
  setPaused(false);
  start(codeNow());
  canvas.focus({ preventScroll: true });
}

let soon; // the timer of a changed program

// Starts a changed program when no key was pressed for a while; the editor keeps the keys.
function runSoon() {
  clearTimeout(soon);
  soon = setTimeout(() => {
    if (codeNow() !== started) start(codeNow());
  }, QUIET);
}

const waiting = []; // for the hash of `play`

const news = {
  ready() {
    answered = performance.now();
  },
  started() {
    page.screen.dataset.state = "running";
  },
  status: showStatus,
  print({ lines }) {
    page.output.hidden = false;
    const all = [...page.output.textContent.split("\n").filter(Boolean), ...lines];
    page.output.textContent = all.slice(-MOST_LINES).join("\n");
    page.output.scrollTop = page.output.scrollHeight;
  },
  error({ message, line, isBroken }) {
    page.screen.dataset.state = "failed";
    showProblem(message, line);
    for (const { reject } of waiting.splice(0)) reject(new Error(message));
    if (isBroken) openWorker();
  },
  over({ steps }) {
    page.screen.dataset.state = "over";
    for (const { reject } of waiting.splice(0)) reject(new Error("the program ended itself"));
    page.status.textContent = `The program ended itself after ${steps} steps.`;
  },
  played({ hash }) {
    waiting.shift().resolve(hash);
  },
  pong() {
    answered = performance.now();
  },
};

// A worker that does not answer is busy with a program that does not end.
setInterval(() => {
  if (document.hidden || answered === Infinity) {
    return;
  } else if (performance.now() - answered > PATIENCE + PERIOD) {
    page.screen.dataset.state = "failed";
    showProblem("The program was stopped: it did not come back for five seconds. Is there an endless loop?", 0);
    openWorker();
  } else {
    say("ping");
  }
}, PERIOD);
document.addEventListener("visibilitychange", () => {
  if (answered !== Infinity) answered = performance.now();
});

// Keys and mouse ----------------------------------------------------------------------------------

const held = new Set();

function press(name, isDown) {
  if (isDown) held.add(name);
  else held.delete(name);
  say("key", { name, isDown });
}

function releaseAll() {
  for (const name of [...held]) press(name, false);
}

function placeIn(event) {
  const box = canvas.getBoundingClientRect();
  return {
    x: Math.round(((event.clientX - box.left) / box.width) * WIDTH),
    y: Math.round(((event.clientY - box.top) / box.height) * HEIGHT),
  };
}

const BUTTONS = { 0: 1, 1: 3, 2: 2 }; // of the browser: of LÖVE

function listen(canvas) {
  // The site has keys of its own, and arrows scroll: what the program takes goes no further. Tab
  // leaves the picture, and what is pressed with Ctrl or Cmd is the browser's.
  const take = (event, isDown) => {
    const name = nameOf(event);
    if (!name || name === "tab" || event.metaKey || (event.ctrlKey && !name.endsWith("ctrl"))) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) press(name, isDown);
  };
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey && event.key === "Enter") run();
    else take(event, true);
  });
  canvas.addEventListener("keyup", (event) => take(event, false));
  canvas.addEventListener("blur", releaseAll);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointermove", (event) => say("move", placeIn(event)));
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    say("move", placeIn(event));
    say("button", { number: BUTTONS[event.button], isDown: true });
  });
  const lift = (event) => say("button", { number: BUTTONS[event.button] ?? 1, isDown: false });
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);
}

// Buttons in place of keys, for screens that are touched.
for (const button of page.pad.querySelectorAll("[data-key]")) {
  const name = button.dataset.key;
  button.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    press(name, true);
  });
  for (const kind of ["pointerup", "pointercancel"]) button.addEventListener(kind, () => press(name, false));
  button.addEventListener("contextmenu", (event) => event.preventDefault());
}

// Buttons -----------------------------------------------------------------------------------------

function addChoices(label, list) {
  const group = document.createElement("optgroup");
  group.label = label;
  group.append(...list.map(({ name, title }) => new Option(title, name)));
  page.list.append(group);
}
addChoices("Snippets", snippets);
addChoices("Step by step", steps);

page.list.addEventListener("change", () => {
  const chosen = programs.find((each) => each.name === page.list.value);
  if (!chosen) return;
  original = chosen.code;
  show(chosen.code);
  remember();
  run();
});
page.run.addEventListener("click", run);
page.pause.addEventListener("click", () => {
  setPaused(!isPaused);
  say("pause", { isPaused });
});
page.step.addEventListener("click", () => {
  if (!isPaused) {
    setPaused(true);
    say("pause", { isPaused });
  }
  say("step");
});
page.reset.addEventListener("click", () => start(started));
page.original.addEventListener("click", () => {
  show(original);
  remember();
  run();
});
page.share.addEventListener("click", async () => {
  await remember();
  let text = "Copied";
  try {
    await navigator.clipboard.writeText(location.href);
  } catch {
    text = "It is in the address";
  }
  page.share.textContent = text;
  setTimeout(() => (page.share.textContent = "Share"), 2000);
});
page.problem.addEventListener("click", () => {
  const line = Number(page.problem.dataset.line);
  if (line < 1 || line > editor.state.doc.lines) return;
  editor.dispatch({ selection: { anchor: editor.state.doc.line(line).from }, scrollIntoView: true });
  editor.focus();
});

new ResizeObserver(() => say("resize", { width: widthOfScreen() })).observe(page.screen);

window.addEventListener("hashchange", () => {
  if (location.hash.slice(1) !== written) openAddress();
});

if (HTMLCanvasElement.prototype.transferControlToOffscreen) {
  openWorker();
  openAddress();
} else {
  showProblem("The playground needs a browser of 2023 or later.", 0);
}

// For tests, and for curious ones: plays steps with written keys, "right:20-90,space:40".
window.playground = {
  editor,
  snippets: snippets.map(({ name }) => name),
  play(steps, keys = "") {
    return new Promise((resolve, reject) => {
      waiting.push({ resolve, reject });
      say("play", { steps, keys });
    });
  },
};
