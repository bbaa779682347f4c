// Plays the examples in a headless Chromium: CHROMIUM=/path node web/test.mjs FOLD EXAMPLE...
//
// Serves build/ on the loopback address, starts every example on the page, presses the keys that
// move an object, and reads from the lines of `--say` (examples/main.lua) that one moved. Then it
// plays the scene of the determinism spec: its number must be FOLD. Pictures go to
// build/web-pictures/. The last line is "N passed, N failed".

import { createServer } from "node:http";
import { createRequire } from "node:module";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { extname, join, normalize } from "node:path";

const { chromium } = createRequire(import.meta.url)("playwright-core");

const [FOLD, ...EXAMPLES] = process.argv.slice(2);
const BUILD = "build";
const PICTURES = join(BUILD, "web-pictures");
const PATIENCE = 60000; // ms, for what takes a moment on a busy machine

// Which key makes what larger; all others: the right arrow, x.
const MOVES = {
  menu: { key: "ArrowDown", value: "chosen" },
  tutorial: { key: "ArrowRight", value: "page" },
  pile: { key: "ArrowUp", value: "boxes" },
};
const WINDOWS = [
  { width: 1280, height: 800 },
  { width: 800, height: 900 },
  { width: 640, height: 360 },
];
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

let passed = 0;
let failed = 0;

async function check(what, run) {
  try {
    const told = await run();
    passed += 1;
    console.log(`ok      ${what}${told ? ": " + told : ""}`);
  } catch (problem) {
    failed += 1;
    console.log(`FAILED  ${what}\n        ${String(problem.message).replaceAll("\n", "\n        ")}`);
  }
}

function assert(holds, message) {
  if (!holds) throw new Error(message);
}

function serve() {
  const server = createServer((request, response) => {
    let path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    if (path.endsWith("/")) path += "index.html";
    const file = join(BUILD, path);
    if (!existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
    response.end(readFileSync(file));
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}

const server = await serve();
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

// A page with all that it said: `lines` of the game, `errors` of the game and of the browser.
async function open(path) {
  const page = await browser.newPage({ viewport: WINDOWS[0] });
  const told = { page, lines: [], errors: [] };
  page.on("console", (message) => {
    const list = message.type() === "error" ? told.errors : told.lines;
    list.push(message.text());
  });
  page.on("pageerror", (problem) => told.errors.push(problem.message));
  page.on("response", (answer) => {
    if (answer.status() >= 400) told.errors.push(`${answer.status()} ${answer.url()}`);
  });
  await page.goto(site + path);
  return told;
}

// Waits until a line from number `from` on fits, and returns the match.
async function line(told, pattern, from = 0) {
  const end = Date.now() + PATIENCE;
  while (Date.now() < end) {
    for (const text of told.lines.slice(from)) {
      const match = text.match(pattern);
      if (match) return match;
    }
    assert(told.errors.length === 0, told.errors.join("\n"));
    await new Promise((done) => setTimeout(done, 50));
  }
  throw new Error(`no line ${pattern}; the last ones: ${told.lines.slice(-5).join("\n")}`);
}

// The value in the next line that `--say` writes.
async function next(told, example, value) {
  const pattern = new RegExp(`^example ${example} second \\d+:.*\\b${value}=(-?[\\d.]+)`);
  return Number((await line(told, pattern, told.lines.length))[1]);
}

// Saves a picture of the page and returns how many colours a grid of samples has.
async function shoot(page, name) {
  const picture = await page.screenshot({ path: join(PICTURES, `${name}.png`) });
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = "data:image/png;base64," + data;
    await image.decode();
    const sheet = new OffscreenCanvas(image.width, image.height).getContext("2d");
    sheet.drawImage(image, 0, 0);
    // The middle half: the game, without the page's own text.
    const left = image.width / 4, top = image.height / 4;
    const { data: bytes } = sheet.getImageData(left, top, image.width / 2, image.height / 2);
    const colors = new Set();
    for (let i = 0; i < bytes.length; i += 4 * 7) {
      colors.add((bytes[i] << 16) | (bytes[i + 1] << 8) | bytes[i + 2]);
    }
    return colors.size;
  }, picture.toString("base64"));
}

async function play(example) {
  const told = await open(`/web/?say&example=${example}`);
  const { key, value } = MOVES[example] ?? { key: "ArrowRight", value: "x" };
  await check(`${example} starts`, async () => {
    await line(told, new RegExp(`^example ${example} started$`));
  });
  await check(`${example}: ${key} moves ${value} on`, async () => {
    const before = await next(told, example, value);
    await told.page.keyboard.down(key);
    await new Promise((done) => setTimeout(done, 700));
    await told.page.keyboard.up(key);
    const after = await next(told, example, value);
    // A place in px must grow by more than rounding or a tremble.
    const least = value === "x" ? 20 : 1;
    assert(after - before >= least, `${value} was ${before}, is ${after}`);
    return `${before} to ${after}`;
  });
  await check(`${example}: its picture is not empty`, async () => {
    const colors = await shoot(told.page, example);
    assert(colors >= 10, `${colors} colours`);
    return `${colors} colours`;
  });
  await check(`${example}: no errors`, async () => {
    assert(told.errors.length === 0, told.errors.join("\n"));
  });
  await told.page.close();
}

async function playMenu() {
  const told = await open("/web/?say");
  await check("the menu comes first", () => line(told, /^example menu started$/).then(() => ""));
  await check("Down and Enter start the second example, Esc leads back", async () => {
    for (const key of ["ArrowDown", "Enter"]) {
      await told.page.keyboard.press(key, { delay: 100 });
    }
    await line(told, new RegExp(`^example ${EXAMPLES[1]} started$`));
    const from = told.lines.length;
    await told.page.keyboard.press("Escape", { delay: 100 });
    await line(told, /^example menu started$/, from);
  });
  await check("the page has a title and shows the keys", async () => {
    assert((await told.page.title()).includes("physics.lua"), await told.page.title());
    for (const key of ["Enter", "Esc", "Space", "←"]) {
      assert(await told.page.getByText(key, { exact: true }).first().isVisible(), key);
    }
  });
  for (const size of WINDOWS) {
    await check(`the page fits a window of ${size.width} x ${size.height}`, async () => {
      await told.page.setViewportSize(size);
      await new Promise((done) => setTimeout(done, 300));
      const found = await told.page.evaluate(() => {
        const { left, top, right, bottom } = document.getElementById("canvas").getBoundingClientRect();
        const root = document.documentElement;
        const scrolls = root.scrollWidth > innerWidth || root.scrollHeight > innerHeight;
        return { left, top, right, bottom, scrolls };
      });
      const { left, top, right, bottom } = found;
      const text = JSON.stringify(found);
      assert(left >= 0 && top >= 0 && right <= size.width && bottom <= size.height, text);
      assert(!found.scrolls, text);
      const shape = (right - left) / (bottom - top);
      assert(Math.abs(shape - 1200 / 640) < 0.02, `the shape is ${shape}: ${text}`);
      assert(right - left > 0.5 * size.width || bottom - top > 0.5 * size.height, text);
      await shoot(told.page, `window-${size.width}x${size.height}`);
      return `${Math.round(right - left)} x ${Math.round(bottom - top)}`;
    });
  }
  await told.page.close();
}

mkdirSync(PICTURES, { recursive: true });
await playMenu();
for (const example of ["menu", ...EXAMPLES]) await play(example);
await check("the determinism scene gives the same number as here", async () => {
  const told = await open("/web-determinism/");
  const [, fold] = await line(told, /^fold (\d+)$/);
  assert(fold === FOLD, `${fold} in the browser, ${FOLD} here`);
  return fold;
});

await browser.close();
server.close();
console.log(`The pictures are in ${PICTURES}/`);
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 && passed > 0 ? 0 : 1);
