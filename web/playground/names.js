// Names of the library in the editor: they are completed, and say what they mean. The list is that of
// the reference (scripts/manual.lua --names).

import list from "../../build/names.json";

const LOVE = ["load", "update", "draw", "keypressed", "keyreleased", "graphics", "keyboard", "mouse", "timer"];

const names = list.map(([label, type, detail, text, address]) => ({ label, type, detail, text, address }));
const short = (label) => label.replace(/^\w+[.:]/, "");

// What is shown of a name: its head, its meaning, and a link to the reference.
function describe({ label, detail, text, address }) {
  const box = document.createElement("div");
  box.className = "pg-about";
  const head = document.createElement("code");
  head.textContent = detail.includes("(") ? detail : `${label}${detail && ": "}${detail}`;
  const meaning = document.createElement("p");
  meaning.textContent = text.replaceAll("`", "");
  const link = document.createElement("a");
  link.href = new URL(`../${address}`, document.baseURI).href;
  link.target = "_blank";
  link.textContent = "Reference";
  box.append(head, meaning, link);
  return box;
}

function option(name) {
  return { label: short(name.label), type: name.type, detail: name.type, info: () => describe(name) };
}

const functions = names.filter(({ type }) => type === "function");
const fields = names.filter(({ type }) => type !== "function");

/** What may stand at the cursor: functions after `world:` and `physics.`, else fields and settings. */
export function complete(context) {
  const word = context.matchBefore(/[\w.:]+/);
  if (!word) return null;
  const [, owner, mark, part] = word.text.match(/^(?:.*?)(\w*)([.:]?)(\w*)$/);
  const from = context.pos - part.length;
  if (mark === ":") return { from, options: functions.filter(({ label }) => /^(world|tiles):/.test(label)).map(option) };
  if (owner === "love") return { from, options: LOVE.map((label) => ({ label })) };
  if (owner === "physics" && mark) return { from, options: functions.map(option) };
  if (mark || part.length > 1 || context.explicit) return { from, options: fields.map(option) };
  return null;
}

/** What a name under the mouse means. */
export function aboutName(view, place) {
  const { from, text } = view.state.doc.lineAt(place);
  let start = place - from;
  let end = start;
  while (start > 0 && /\w/.test(text[start - 1])) start -= 1;
  while (end < text.length && /\w/.test(text[end])) end += 1;
  const word = text.slice(start, end);
  const isCalled = /[.:]$/.test(text.slice(0, start)) && /^\s*[({]/.test(text.slice(end));
  const name = (isCalled ? functions : fields).find(({ label }) => short(label) === word);
  if (!name) return null;
  return { pos: from + start, end: from + end, above: true, create: () => ({ dom: describe(name) }) };
}
