// On every page of the site: examples start in their pictures, and programs lead to the playground.

import { pack } from "../playground/link.js";

const root = new URL("..", import.meta.url); // this file lies in assets/

// Puts the game into the place of its picture.
function start(example) {
  const { example: name, keys } = example.dataset;
  const wishes = new URLSearchParams({ example: name, keys });
  if (example.matches(".hero")) wishes.set("wide", ""); // its picture scrolls: it fills any frame
  if (new URLSearchParams(location.search).has("say")) wishes.set("say", "");
  const frame = document.createElement("iframe");
  frame.title = `The example ${name}`;
  frame.allow = "autoplay; fullscreen";
  frame.src = new URL(`play/?${wishes}`, root);
  frame.addEventListener("load", () => frame.contentWindow.focus());
  example.replaceChildren(frame);
  example.scrollIntoView({ block: "nearest" });
}

const wished = new URLSearchParams(location.search).get("example");
for (const example of document.querySelectorAll(".example")) {
  example.querySelector("button").addEventListener("click", () => start(example));
  if (example.dataset.example === wished) start(example);
}

// Clips play while they are seen. Where less motion is wished they show one picture, and play when their
// reader wants.
const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
function show(clip) {
  seen.unobserve(clip);
  clip.addEventListener("loadedmetadata", () => (clip.currentTime = clip.duration / 2), { once: true });
  clip.preload = "auto";
  clip.controls = !clip.closest("button");
}
const seen = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    if (isStill) isIntersecting && show(target);
    else isIntersecting ? target.play().catch(() => {}) : target.pause();
  }
});
for (const clip of document.querySelectorAll("video.clip")) seen.observe(clip);

// A whole program, which needs nothing that the playground does not have.
const MISSING = /love\.(audio|filesystem|joystick|sound|system|thread|touch)|graphics\.new(?!Font)/;

function isProgram(code) {
  const isWhole = /require\s*\(?\s*["']physics["']/.test(code) && /love\.(update|draw)/.test(code);
  return isWhole && !MISSING.test(code);
}

for (const block of document.querySelectorAll(".md-typeset .language-lua.highlight")) {
  const code = block.querySelector("code").textContent;
  if (!isProgram(code) || block.closest("[data-no-try]")) continue;
  if (block.nextElementSibling?.querySelector(".try")) continue; // the page has a link of its own
  const link = document.createElement("a");
  link.className = "try";
  link.textContent = "Run it in the playground";
  link.href = new URL(`playground/#code=${await pack(code)}`, root);
  block.after(link);
}

// The page of a wrong address offers to search the words of that address.
const lost = document.querySelector(".lost");
if (lost) {
  const words = location.pathname.split(/[^\p{L}\p{N}]+/u).filter((word) => word.length > 2 && word !== "html");
  const last = words.at(-1) ?? "";
  lost.search = new URLSearchParams({ q: last });
  lost.querySelector("strong").textContent = last || "another word";
}

document.documentElement.dataset.isReady = ""; // for the tests
