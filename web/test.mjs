// Plays the examples in a headless Chromium: CHROMIUM=/path node web/test.mjs FOLD EXAMPLE...
//
// Serves build/ on the loopback address, starts every example on the page, presses the keys that
// move an object, and reads from the lines of `--say` (examples/main.lua) that one moved. Then it
// plays the scene of the determinism spec: its number must be FOLD. Pictures go to
// build/web-pictures/. The last line is "N passed, N failed".

import { mkdirSync } from "node:fs";
import { join } from "node:path";

import { assert, begin, check, line, readPicture } from "./harness.mjs";

const [FOLD, ...EXAMPLES] = process.argv.slice(2);
const PICTURES = join("build", "web-pictures");

// Which key makes what larger; all others: the right arrow, x.
const MOVES = {
  menu: { key: "ArrowDown", value: "chosen" },
  tutorial: { key: "ArrowRight", value: "page" },
  marbles: { key: "ArrowUp", value: "marbles" },
  pile: { key: "ArrowUp", value: "boxes" },
};
const WINDOWS = [
  { width: 1280, height: 800 },
  { width: 800, height: 900 },
  { width: 640, height: 360 },
];

const { open, finish } = await begin("build");

// The value in the next line that `--say` writes.
async function next(told, example, value) {
  const pattern = new RegExp(`^example ${example} second \\d+:.*\\b${value}=(-?[\\d.]+)`);
  return Number((await line(told, pattern, told.lines.length))[1]);
}

// Saves a picture of the page and returns how many colours a grid of samples has.
async function shoot(page, name) {
  const picture = await page.screenshot({ path: join(PICTURES, `${name}.png`) });
  const { width, height, bytes } = await readPicture(page, picture);
  const colors = new Set();
  // The middle half: the game, without the page's own text.
  for (let y = Math.floor(height / 4); y < (height * 3) / 4; y++) {
    for (let x = Math.floor(width / 4); x < (width * 3) / 4; x += 7) {
      colors.add(bytes.readUIntBE(4 * (y * width + x), 3));
    }
  }
  return colors.size;
}

async function play(example) {
  const told = await open(`/web/?say&example=${example}`, { viewport: WINDOWS[0] });
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
  await told.close();
}

async function playMenu() {
  const told = await open("/web/?say", { viewport: WINDOWS[0] });
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
      assert(await told.page.locator("footer").getByText(key, { exact: true }).first().isVisible(), key);
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
  await told.close();
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

console.log(`The pictures are in ${PICTURES}/`);
await finish();
