// What the tests in the browser have in common: counting, a server of a folder on the loopback
// address, Chromium (CHROMIUM=/path), and pages that keep what they said.

import { createServer } from "node:http";
import { createRequire } from "node:module";
import { readFileSync, statSync } from "node:fs";
import { extname, join, normalize } from "node:path";

const { chromium } = createRequire(import.meta.url)("playwright-core");

const PATIENCE = 60000; // ms, for what takes a moment on a busy machine
const TYPES = {
  ".css": "text/css",
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

let passed = 0;
let failed = 0;

export async function check(what, run) {
  try {
    const told = await run();
    passed += 1;
    console.log(`ok      ${what}${told ? ": " + told : ""}`);
  } catch (problem) {
    failed += 1;
    console.log(`FAILED  ${what}\n        ${String(problem.message).replaceAll("\n", "\n        ")}`);
  }
}

export function assert(holds, message) {
  if (!holds) throw new Error(message);
}

// Waits until `find` returns something that is not null, false or undefined, and returns it.
export async function until(find, message, patience = PATIENCE) {
  const end = Date.now() + patience;
  for (;;) {
    const found = await find();
    if (found) return found;
    if (Date.now() > end) throw new Error(typeof message === "function" ? await message() : message);
    await new Promise((done) => setTimeout(done, 50));
  }
}

// A published site lies below `base`; here its addresses lead to the folder, too. As there, 404.html stands
// for what does not exist.
function serve(folder, base) {
  const server = createServer((request, response) => {
    let path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    if (path.startsWith(base)) path = "/" + path.slice(base.length);
    if (path.endsWith("/")) path += "index.html";
    let file = join(folder, path);
    const isThere = (file) => statSync(file, { throwIfNoEntry: false })?.isFile();
    const isFound = isThere(file);
    if (!isFound) file = join(folder, "404.html");
    response.writeHead(isFound ? 200 : 404, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
    response.end(isFound || isThere(file) ? readFileSync(file) : "");
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}

// Serves a folder, starts the browser, and returns { site, open, finish }.
export async function begin(folder, base = "/") {
  const server = await serve(folder, base);
  const site = `http://127.0.0.1:${server.address().port}`;
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM,
    args: [
      "--no-sandbox",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--enable-unsafe-swiftshader",
    ],
  });

  // A page with all that it said: `lines` of the console, `errors` of the console and the browser.
  // The options are those of a browser context.
  async function open(path, options) {
    const context = await browser.newContext(options);
    const page = await context.newPage();
    const told = { page, lines: [], errors: [], close: () => context.close() };
    page.on("console", (message) => {
      (message.type() === "error" ? told.errors : told.lines).push(message.text());
    });
    page.on("pageerror", (problem) => told.errors.push(problem.message));
    page.on("response", (answer) => {
      if (answer.status() >= 400) told.errors.push(`${answer.status()} ${answer.url()}`);
    });
    page.on("request", (request) => {
      const { protocol, origin } = new URL(request.url());
      if (protocol.startsWith("http") && origin !== site) {
        told.errors.push(`it asks another server: ${request.url()}`);
      }
    });
    await page.goto(site + path);
    return told;
  }

  // Ends all, and the process.
  async function finish() {
    await browser.close();
    server.close();
    console.log(`${passed} passed, ${failed} failed`);
    process.exit(failed === 0 && passed > 0 ? 0 : 1);
  }

  return { site, open, finish };
}

// Waits until a line from number `from` on fits, and returns the match.
export function line(told, pattern, from = 0) {
  const find = () => {
    assert(told.errors.length === 0, told.errors.join("\n"));
    return told.lines.slice(from).map((text) => text.match(pattern)).find(Boolean);
  };
  return until(find, () => `no line ${pattern}; the last ones: ${told.lines.slice(-5).join("\n")}`);
}

// The colours of a picture, [red, green, blue] of each pixel and its place: visit(x, y, colour).
// Runs in the page, which can read pictures.
export async function readPicture(page, picture) {
  const { width, height, text } = await page.evaluate(async (data) => {
    const image = new Image();
    image.src = "data:image/png;base64," + data;
    await image.decode();
    const sheet = new OffscreenCanvas(image.width, image.height).getContext("2d");
    sheet.drawImage(image, 0, 0);
    const { data: bytes } = sheet.getImageData(0, 0, image.width, image.height);
    let text = "";
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return { width: image.width, height: image.height, text: btoa(text) };
  }, picture.toString("base64"));
  return { width, height, bytes: Buffer.from(text, "base64") };
}
