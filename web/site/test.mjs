// Opens the site in a headless Chromium: CHROMIUM=/path node web/site/test.mjs
//
// Serves build/site on the loopback address. Follows every link inside the site, opens every page and
// listens for errors, searches, starts an example in its page, and plays in the playground: its
// snippets must come to the same hash there as in LuaJIT (web/playground/native.lua) and in LÖVE
// (web/playground/in_love). Of the programs of the pages, which spec/project/docs_spec.lua runs, each third is
// started there; with --all each. Pictures go to build/site-pictures/. The last line is "N passed, N failed".

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync } from "node:fs";
import { basename, join, posix } from "node:path";

import { assert, begin, check, line, readPicture, until } from "../harness.mjs";

const SITE = "build/site";
const PICTURES = "build/site-pictures";
const SNIPPETS = "web/playground/snippets";
const STEPS = 300;
const KEYS = "right:20-120,space:45-55,2:100,space:130-150,left:160-220,down:230-240,up:240-260";
const DESKTOP = { viewport: { width: 1280, height: 800 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const LAPTOP = { viewport: { width: 1280, height: 720 } };
const SHARP_PHONE = { ...PHONE, deviceScaleFactor: 2 };

// The page of a wrong address asks for all from the root of the published site.
const address = readFileSync("build/site-source/mkdocs.yml", "utf8").match(/^site_url: (\S+)/m)?.[1];
const BASE = address ? new URL(address).pathname : "/";

const { site, open, finish } = await begin(SITE, BASE);
mkdirSync(PICTURES, { recursive: true });

const files = readdirSync(SITE, { recursive: true }).map((name) => name.replaceAll("\\", "/"));
const pages = files.filter((name) => name.endsWith(".html")).sort();
const articles = pages.filter((name) => !name.startsWith("play/") && name !== "404.html");
const addressOf = (file) => "/" + file.replace(/(^|\/)index\.html$/, "$1");

function quiet(told) {
  assert(told.errors.length === 0, told.errors.join("\n"));
}

// Links -------------------------------------------------------------------------------------------

// What each page holds: its links, its anchors, and lists that were not recognized as such.
async function readPages() {
  const { page, close } = await open("/", DESKTOP);
  const texts = Object.fromEntries(pages.map((name) => [name, readFileSync(join(SITE, name), "utf8")]));
  const found = await page.evaluate((texts) => {
    const read = ([name, text]) => {
      const document = new DOMParser().parseFromString(text, "text/html");
      const all = (selector, get) => Array.from(document.querySelectorAll(selector), get);
      const links = all("[href]", (each) => each.getAttribute("href"));
      const sources = all("[src]", (each) => each.getAttribute("src"));
      const anchors = all("[id], a[name]", (each) => each.id || each.name);
      const lists = all("p, li", (each) => each.textContent).filter((text) => /\n([-*] |\d+\. )/.test(text));
      const description = document.querySelector('meta[name="description"]')?.content ?? "";
      return [name, { links: [...links, ...sources], anchors, lists, description }];
    };
    return Object.fromEntries(Object.entries(texts).map(read));
  }, texts);
  await close();
  return found;
}

// Why a link of a page is dead, or null. Other sites are not asked.
function whyDead(link, from, found) {
  if (/^(https?:|mailto:|data:)/.test(link)) return null;
  const url = new URL(link.startsWith(BASE) ? "/" + link.slice(BASE.length) : link, "http://site/" + from);
  let file = decodeURIComponent(url.pathname).slice(1);
  if (file === "" || file.endsWith("/")) file += "index.html";
  if (!files.includes(file) || statSync(join(SITE, file)).isDirectory()) return `there is no ${file}`;
  const anchor = decodeURIComponent(url.hash.slice(1));
  // The playground has programs there.
  if (anchor === "" || !found[file] || (file === "playground/index.html" && anchor.includes("="))) return null;
  return found[file].anchors.includes(anchor) ? null : `${file} has no #${anchor}`;
}

async function checkLinks() {
  const found = await readPages();
  let count = 0;
  for (const name of pages) {
    await check(`${name}: no dead link`, () => {
      const { links } = found[name];
      const dead = links.map((link) => [link, whyDead(link, name, found)]).filter(([, why]) => why);
      count += links.length;
      assert(dead.length === 0, dead.map(([link, why]) => `${link}: ${why}`).join("\n"));
    });
  }
  await check("the links were really looked at", () => {
    assert(count > 100, `${count} links`);
    assert(whyDead("../nowhere/", "api/index.html", found) !== null, "a dead page counts as one");
    assert(whyDead("#nowhere", "api/index.html", found) !== null, "so does a dead anchor");
    return `${count} links`;
  });
  await check("every list is one", () => {
    const broken = pages.flatMap((name) => found[name].lists.map((text) => `${name}: ${text}`));
    assert(broken.length === 0, broken.join("\n"));
  });
  await check("every page has a description of its own, and that of the site names LÖVE", () => {
    const seen = new Map();
    for (const name of articles) {
      const { description } = found[name];
      assert(description.length > 20, `${name}: "${description}"`);
      assert(!seen.has(description), `${name} has that of ${seen.get(description)}: ${description}`);
      seen.set(description, name);
    }
    assert(/LÖVE/.test(found["index.html"].description), found["index.html"].description);
    assert(/LÖVE/.test(readFileSync(join(SITE, "index.html"), "utf8").match(/<title>(.*?)<\/title>/)[1]), "the title");
    return `${seen.size} pages`;
  });
}

// Pages -------------------------------------------------------------------------------------------

const scrollsSideways = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);

// Returns the addresses of all programs that lead to the playground, and the pages that show them.
async function checkArticles() {
  const told = await open("/", DESKTOP);
  const { page } = told;
  const programs = new Map();
  for (const name of articles) {
    await check(`${name}: no errors, and it fits a desktop and a phone`, async () => {
      told.errors = [];
      await page.setViewportSize(DESKTOP.viewport);
      await page.goto(site + addressOf(name));
      await page.locator("html[data-is-ready]").waitFor();
      const wide = await scrollsSideways(page);
      await page.setViewportSize(PHONE.viewport);
      const narrow = await scrollsSideways(page);
      for (const link of await page.locator("a.try").all()) programs.set(await link.evaluate((each) => each.href), name);
      quiet(told);
      assert(!wide, "it scrolls sideways on a desktop");
      assert(!narrow, "it scrolls sideways on a phone");
    });
  }
  await told.close();
  return programs;
}

async function checkColors() {
  const brightness = {};
  for (const colorScheme of ["light", "dark"]) {
    const { page, close } = await open("/", { ...DESKTOP, colorScheme });
    const color = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    brightness[colorScheme] = color.match(/\d+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0);
    await page.screenshot({ path: join(PICTURES, `start-${colorScheme}.png`) });
    await close();
  }
  await check("the site is light or dark, as the system is", () => {
    const text = JSON.stringify(brightness);
    assert(brightness.light > 600 && brightness.dark < 200, text);
    return text;
  });
}

// How far two colours of a text are apart, at the worst place of a page: 4.5 : 1 is wanted, 3 : 1 of large
// letters. Also, which links in its text are not underlined.
function findPale() {
  const sheet = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const read = (color) => {
    sheet.clearRect(0, 0, 1, 1);
    sheet.fillStyle = color;
    sheet.fillRect(0, 0, 1, 1);
    const [red, green, blue, alpha] = sheet.getImageData(0, 0, 1, 1).data;
    return { color: [red, green, blue], alpha: alpha / 255 };
  };
  const over = (upper, lower) => lower.map((part, i) => upper.color[i] * upper.alpha + part * (1 - upper.alpha));
  const light = (color) => {
    const [red, green, blue] = color.map((part) => (part < 10 ? part / 3294 : ((part / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05;
  };
  const behind = (element) => {
    const layers = [];
    for (let each = element; each; each = each.parentElement) layers.push(read(getComputedStyle(each).backgroundColor));
    return layers.reduceRight((lower, upper) => over(upper, lower), [255, 255, 255]);
  };
  const isLink = (element) => element.matches(".md-typeset p a[href], .md-typeset li a[href], .md-typeset td a[href]");
  const found = { texts: 0, links: 0, pale: new Set(), plain: new Set() };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const text = walker.currentNode.textContent.trim();
    const element = walker.currentNode.parentElement;
    const isSeen = element.checkVisibility({ opacityProperty: true, visibilityProperty: true });
    if (!text || !isSeen || element.closest("script, style, .md-search")) continue;
    const style = getComputedStyle(element);
    const size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.6 && Number(style.fontWeight) >= 700);
    const back = behind(element);
    const lights = [light(over(read(style.color), back)), light(back)].sort((a, b) => b - a);
    const ratio = lights[0] / lights[1];
    found.texts += 1;
    if (ratio < (isLarge ? 3 : 4.5)) found.pale.add(`${ratio.toFixed(2)}: ${text.slice(0, 40)}`);
    const link = element.closest("a");
    if (!link || !isLink(link) || link.closest(".hero-links, .headerlink, .try, .footnote-backref")) continue;
    found.links += 1;
    if (!getComputedStyle(link).textDecorationLine.includes("underline")) found.plain.add(text.slice(0, 40));
  }
  return { ...found, pale: [...found.pale], plain: [...found.plain] };
}

async function checkReading() {
  for (const colorScheme of ["light", "dark"]) {
    await check(`${colorScheme}: text is 4.5 : 1 away from what is behind it, links in text are underlined`, async () => {
      const told = await open("/", { ...DESKTOP, colorScheme });
      let texts = 0, links = 0;
      for (const name of ["", "faq/", "guide/", "guide/motion/", "api/fields/", "compare/", "examples/lifts/", "playground/"]) {
        await told.page.goto(`${site}/${name}`);
        await told.page.locator("html[data-is-ready]").waitFor();
        const found = await told.page.evaluate(findPale);
        assert(found.pale.length === 0, `${name}: ${found.pale.join("\n")}`);
        assert(found.plain.length === 0, `${name}: not underlined: ${found.plain.join("\n")}`);
        texts += found.texts;
        links += found.links;
      }
      await told.close();
      assert(texts > 1000 && links > 100, `${texts} texts, ${links} links`);
      return `${texts} texts, ${links} links`;
    });
  }
}

async function checkMenu() {
  await check("in the menu of the guide Learn stands above Ideas", async () => {
    const { page, close } = await open("/guide/", DESKTOP);
    const menu = page.locator(".md-sidebar--primary .md-nav__link");
    const heightOf = async (name) => (await menu.getByText(name, { exact: true }).first().boundingBox()).y;
    const [learn, recipes, ideas] = [await heightOf("Learn"), await heightOf("Recipes"), await heightOf("Ideas")];
    await close();
    assert(learn < recipes && recipes < ideas, `${learn}, ${recipes}, ${ideas}`);
  });
}

async function checkFields() {
  await check("the fields stand in groups; on a phone each shows its meaning", async () => {
    const { page, close } = await open("/api/fields/", PHONE);
    const groups = await page.locator("h2").allInnerTexts();
    for (const name of ["Place and shape", "Motion", "Contacts", "Events"]) {
      assert(groups.some((each) => each.startsWith(name)), `${name} is none of ${groups}`);
    }
    const cells = page.locator(".fields td:last-child");
    assert((await cells.count()) > 40, `${await cells.count()} fields`);
    const boxes = await cells.evaluateAll((all) => all.map((each) => each.getBoundingClientRect()));
    const width = PHONE.viewport.width;
    assert(boxes.every(({ left, right, width: own }) => left >= 0 && right <= width && own > 250), JSON.stringify(boxes[0]));
    await page.locator("#field-mass").scrollIntoViewIfNeeded();
    await page.screenshot({ path: join(PICTURES, "fields-phone.png") });
    await close();
    return `${boxes.length} fields`;
  });
  await check("on a phone the page Compare shows the numbers of all engines", async () => {
    const { page, close } = await open("/compare/", PHONE);
    const cells = page.locator(".engines td");
    const boxes = await cells.evaluateAll((all) => all.map((each) => each.getBoundingClientRect()));
    assert(boxes.length > 40 && boxes.every(({ left, right }) => left >= 0 && right <= PHONE.viewport.width), boxes.length);
    await cells.first().scrollIntoViewIfNeeded();
    await page.screenshot({ path: join(PICTURES, "compare-phone.png") });
    await close();
  });
}

async function checkLost() {
  await check("a wrong address leads to the search, the guide and the examples", async () => {
    const told = await open("/guide/knockback.html", DESKTOP);
    const { page } = told;
    await page.locator("html[data-is-ready]").waitFor();
    const main = page.locator(".md-content");
    assert(/does not exist/.test(await main.innerText()), await main.innerText());
    for (const name of ["Guide", "Recipes", "Reference", "Examples", "playground"]) {
      const link = await main.getByRole("link", { name, exact: true }).evaluate((each) => each.href);
      assert((await page.request.get(link)).ok(), link);
    }
    await page.screenshot({ path: join(PICTURES, "lost.png") });
    await page.locator(".lost").click();
    await page.locator(".md-search-result__item").first().waitFor();
    const text = await page.locator(".md-search-result__item").first().innerText();
    await told.close();
    const errors = told.errors.filter((each) => !/knockback\.html|status of 404/.test(each));
    assert(errors.length === 0, errors.join("\n"));
    assert(/Knockback/.test(text), text);
    return "a search for knockback";
  });
}

// What is typed, what one of the first three results must be about. A result is a page, then its sections.
const SEARCHES = {
  oneWay: /oneWay/,
  rotate: /Questions/,
  hp: /Questions/,
  "save game": /Questions|State/,
  trampoline: /Questions/,
  multiplayer: /Questions|State/,
  "jump buffer": /Platformers/,
  "one way platform": /Filters/,
  "jump through": /Filters/,
  scaling: /Recipes|Scal/,
  resolution: /Recipes|Scal/,
  fullscreen: /Recipes|Scal/,
  "pixel perfect": /Recipes|Scal/,
  "delta time": /Steps/,
  "slow motion": /slow motion/i,
  "object pooling": /Object pool/,
  knockback: /Knock-?back/,
  hitstun: /Hitstun/,
  isGrounded: /Contacts/,
  is_on_floor: /Contacts/,
  IsTouching: /Contacts/,
  license: /License/,
  mobile: /Mobile|phone/,
  android: /Android|phone/,
  ios: /iOS/,
  web: /Web|browser/,
  browser: /Browser/i,
  swim: /Zones|Swim/,
  wrap: /Portals|Wrap/,
  attack: /Sword|Attack/,
  ragdoll: /Questions/,
  "grid movement": /Sokoban|Grid/,
  "screen shake": /Camera|shake/,
  particles: /sprites/,
  "steep slope": /Slopes|Steep/,
  "max slope angle": /Slopes|slope/,
  bounce: /Contacts/,
  friction: /Contacts/,
  stuck: /Questions/,
};
const FOR_DEVELOPERS = /^\/(architecture|contributing|testing|benchmark|changelog)\//;

async function checkSearch() {
  const told = await open("/", DESKTOP);
  const { page } = told;
  const input = page.locator(".md-search__input");
  const read = (results) => results.map((each) => ({ text: each.innerText, path: new URL(each.querySelector("a").href).pathname }));
  const results = () => page.locator(".md-search-result__item").evaluateAll(read);
  await input.click();
  for (const [word, wanted] of Object.entries(SEARCHES)) {
    await check(`the search finds ${word}`, async () => {
      await input.fill("");
      await input.pressSequentially(word);
      // Results of the first letters may come before those of the word.
      const find = async () => (await results()).slice(0, 3).find(({ text }) => wanted.test(text));
      const { text } = await until(find, async () => (await results()).slice(0, 3).map(({ text }) => text).join("\n"));
      return text.split("\n")[0];
    });
  }
  await check("pages for developers come last", async () => {
    let count = 0;
    for (const word of ["stuck", "web", "polygon"]) {
      await input.fill("");
      await input.pressSequentially(word);
      // (Results of the first letters may still be there.)
      const found = async () => {
        const own = (await results()).map(({ path }) => FOR_DEVELOPERS.test(path));
        return own.includes(true) && own.lastIndexOf(false) < own.indexOf(true) && own.length;
      };
      count += await until(found, async () => `${word}: ${(await results()).map(({ path }) => path)}`);
    }
    await page.screenshot({ path: join(PICTURES, "search.png") });
    return `${count} results`;
  });
  quiet(told);
  await told.close();
}

// Plays on the front page, and measures the picture of the game, inside of its frame and of the page.
async function playFront(kind, options) {
  await check(`the front page plays across the width at full resolution: ${kind}`, async () => {
    const told = await open("/?say", options);
    const { page } = told;
    await page.locator(".hero button").click();
    await line(told, /^example hills started$/);
    const canvas = page.frameLocator(".hero iframe").locator("#canvas");
    const measure = () => canvas.evaluate((each) => ({ width: each.width, shown: each.clientWidth, sharp: devicePixelRatio }));
    const hero = await page.locator(".hero").boundingBox();
    const isSharp = ({ width, shown, sharp }) => width > 0.98 * shown * sharp;
    await until(async () => isSharp(await measure()), async () => JSON.stringify(await measure()));
    const box = await canvas.boundingBox();
    const found = await measure();
    await page.screenshot({ path: join(PICTURES, `front-${kind}.png`) });
    const pad = await page.frameLocator(".hero iframe").locator("#pad button").allInnerTexts();
    await told.close();
    quiet(told);
    const text = JSON.stringify([hero, box, found]);
    assert(box.width > 0.98 * hero.width, text);
    assert(box.y >= 40 && box.y + box.height <= options.viewport.height + 1, text);
    assert(pad.join() === "←,→,↓,jump", pad.join());
    return `${Math.round(box.width)} x ${Math.round(box.height)}, ${found.width} px`;
  });
}

async function checkFront() {
  const told = await open("/", DESKTOP);
  const { page } = told;
  await check("the front page has its buttons above the fold", async () => {
    const box = await page.locator(".hero-links").boundingBox();
    assert(box.y + box.height < DESKTOP.viewport.height, JSON.stringify(box));
    const frame = await page.locator(".hero").boundingBox();
    assert(frame.width > 700, JSON.stringify(frame));
    quiet(told);
  });
  await playFront("laptop", LAPTOP);
  await playFront("desktop", { viewport: { width: 1920, height: 1080 } });
  await playFront("phone", SHARP_PHONE);
  await check("clips play while they are seen, and stand still where less motion is wished", async () => {
    const isMoving = (page, selector) =>
      page.locator(selector).evaluate((clip) => !clip.paused && clip.currentTime > 0 && clip.videoWidth > 0);
    for (const reducedMotion of ["no-preference", "reduce"]) {
      const other = await open("/", { ...DESKTOP, reducedMotion });
      const clips = other.page.locator(".clips .clip");
      assert((await clips.count()) === 6, `${await clips.count()} clips`);
      const wanted = reducedMotion === "no-preference";
      if (wanted) await until(() => isMoving(other.page, ".hero video"), () => "the hero does not move");
      await clips.first().scrollIntoViewIfNeeded();
      if (wanted) await until(() => isMoving(other.page, ".clips .clip >> nth=0"), () => "the first clip does not move");
      else {
        const hasPicture = () => clips.first().evaluate((clip) => clip.readyState >= 2);
        await until(hasPicture, "the first clip shows no picture");
        assert(!(await isMoving(other.page, ".clips .clip >> nth=0")), "it moves");
      }
      await other.page.screenshot({ path: join(PICTURES, `clips-${reducedMotion}.png`) });
      await other.close();
      quiet(other);
    }
  });
  await check("the first load of the front page is below 800 kB, and names a picture for previews", async () => {
    const other = await open("/", DESKTOP);
    // The index of the search, which is packed to a fourth on its way, is not waited for.
    const sizes = await other.page.evaluate(() =>
      performance
        .getEntriesByType("resource")
        .filter((each) => !each.name.endsWith("search_index.json"))
        .map((each) => each.encodedBodySize),
    );
    const sum = sizes.reduce((a, b) => a + b, 0);
    const image = other.page.locator('meta[property="og:image"]');
    const address = execFileSync("luajit", ["scripts/publish.lua", "address"], { encoding: "utf8" }).trim();
    const picture = address && (await image.getAttribute("content"));
    const pictures = await image.count();
    await other.close();
    assert(sum < 8e5, `${sum} bytes`);
    assert(address ? /^https:.*\.png$/.test(picture) : pictures === 0, picture);
    return `${Math.round(sum / 1000)} kB`;
  });
  await told.close();
}

// Examples ----------------------------------------------------------------------------------------

async function checkExample(name) {
  await check(`${name} starts in its page, by a click`, async () => {
    const told = await open(`/examples/${name}/?say`, DESKTOP);
    assert((await told.page.locator("iframe").count()) === 0, "it has started before the click");
    await told.page.getByRole("button", { name: "Play" }).click();
    await line(told, new RegExp(`^example ${name} started$`));
    await told.close();
    quiet(told);
  });
}

async function checkExamples() {
  const names = pages.map((name) => name.match(/^examples\/(\w+)\/index\.html$/)?.[1]).filter(Boolean);
  await check("there are all examples of the menu", () => {
    const menu = readFileSync("examples/menu.lua", "utf8").matchAll(/\{ name = "(\w+)"/g);
    const wanted = Array.from(menu, (match) => match[1]).sort();
    assert(names.length > 0 && names.join() === wanted.join(), `${names} instead of ${wanted}`);
    return names.join(", ");
  });
  await check("each page has its own example", () => {
    for (const name of names) {
      const text = readFileSync(join(SITE, "examples", name, "index.html"), "utf8");
      assert(text.includes(`data-example="${name}"`), name);
    }
  });
  // All are started by web/test.mjs, which plays them.
  await checkExample(names[0]);
  await check("on a phone an example has the buttons that it needs, in its page and in a window of its own", async () => {
    const told = await open("/examples/platformer/?say&example=platformer", SHARP_PHONE);
    await line(told, /^example platformer started$/);
    const inside = await told.page.frameLocator("iframe").locator("#pad button").allInnerTexts();
    const address = await told.page.getByRole("link", { name: "window of its own" }).getAttribute("href");
    await told.page.goto(new URL(`${address}&say`, told.page.url()).href);
    await line(told, /^example platformer started$/, told.lines.length);
    const alone = await told.page.locator("#pad button").allInnerTexts();
    await told.page.screenshot({ path: join(PICTURES, "example-phone.png") });
    await told.close();
    quiet(told);
    assert(inside.join() === "←,→,jump" && alone.join() === "←,→,jump", `${inside}; ${alone}`);
  });
  await check("an address with ?example=lifts starts it", async () => {
    const told = await open("/examples/lifts/?say&example=lifts", DESKTOP);
    await line(told, /^example lifts started$/);
    await told.page.screenshot({ path: join(PICTURES, "example.png") });
    await told.close();
    quiet(told);
  });
}

// Playground --------------------------------------------------------------------------------------

const FALLING = `local physics = require("physics")
physics.load({ gravity = 400 })
physics.add("floors", { x = 0, y = 500, width = 800, height = 20, static = true })
physics.add("boxes", { x = 380, y = 20, width = 40, height = 40 })
function love.update(dt) physics.update(dt) end
function love.draw() physics.draw() end
`;

const stateOf = (page) => page.locator("#pg-screen").getAttribute("data-state");
const problemOf = (page) => page.locator("#pg-problem").innerText();
const stepOf = async (page) => {
  return Number((await page.locator("#pg-status").innerText()).match(/^step (\d+)/)?.[1] ?? -1);
};

async function isRunning(page) {
  await until(async () => (await stateOf(page)) === "running" && (await stepOf(page)) >= 0, () => "it does not run");
}

// Types a program into the editor, as a reader would, and presses Run.
async function type(page, code) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(code);
  await page.locator("#pg-run").click();
}

async function fails(page) {
  await until(async () => (await stateOf(page)) === "failed", "nothing fails");
  return problemOf(page);
}

// The middle of all that is coral or lilac on the canvas, in px of the program: a box.
async function placeOfBox(page, name) {
  const picture = await page.locator("#pg-canvas").screenshot({ path: join(PICTURES, `${name}.png`) });
  const { width, height, bytes } = await readPicture(page, picture);
  let count = 0, x = 0, y = 0;
  for (let i = 0; i < width * height; i++) {
    const [red, green, blue] = bytes.subarray(4 * i, 4 * i + 3);
    if (red > 110 && red > 1.3 * green && blue > green) {
      count += 1;
      x += i % width;
      y += Math.floor(i / width);
    }
  }
  return { count, x: ((x / count) * 800) / width, y: ((y / count) * 600) / height };
}

async function checkTyping() {
  const told = await open("/playground/", DESKTOP);
  const { page } = told;
  await check("the playground runs the first snippet at once", () => isRunning(page));
  await check("a box that is typed in falls, and lies on the floor", async () => {
    await type(page, FALLING);
    await isRunning(page);
    const first = await placeOfBox(page, "falling");
    await until(async () => (await stepOf(page)) > 150, "it does not go on");
    const last = await placeOfBox(page, "fallen");
    const text = `from ${first.y.toFixed()} to ${last.y.toFixed()} px`;
    assert(first.count > 0 && last.count > 0, "there is no box");
    // It starts at 40 and ends at 480, the middle of a box of 40 px on a floor at 500.
    assert(first.y < 400 && Math.abs(last.y - 480) < 3 && Math.abs(last.x - 400) < 3, text);
    return text;
  });
  await check("it goes at about 60 steps a second", async () => {
    const [before, from] = [await stepOf(page), performance.now()];
    await new Promise((done) => setTimeout(done, 2000));
    const rate = ((await stepOf(page)) - before) / ((performance.now() - from) / 1000);
    // Slower on a busy machine; the status is written five times a second.
    assert(rate > 20 && rate < 75, `${rate} steps a second`);
    return rate.toFixed();
  });
  await check("Pause holds it, Step makes one step, Restart goes back", async () => {
    await page.locator("#pg-pause").click();
    await until(async () => (await page.locator("#pg-status").innerText()).includes("hash"), "no pause");
    const paused = await stepOf(page);
    await page.locator("#pg-step").click();
    await until(async () => (await stepOf(page)) === paused + 1, "no step");
    await page.locator("#pg-reset").click();
    await until(async () => (await stepOf(page)) === 0, "no reset");
    await new Promise((done) => setTimeout(done, 300));
    assert((await stepOf(page)) === 0, "Restart ended the pause");
    await page.locator("#pg-pause").click();
    await until(async () => (await stepOf(page)) > 0, "it does not go on");
  });
  await check("a changed program starts by itself, stays over a reload, and Original takes it back", async () => {
    const codeOf = () => page.evaluate(() => window.playground.editor.state.doc.toString());
    await page.locator("#pg-snippets").selectOption("lift");
    const first = await codeOf();
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+End");
    await page.keyboard.insertText("\nprint('changed')\n");
    await until(async () => /changed/.test(await page.locator("#pg-output").textContent()), "it does not start");
    await page.waitForTimeout(400);
    await page.goto("about:blank");
    await page.goto(`${site}/playground/`);
    await isRunning(page);
    assert((await codeOf()).includes("print('changed')"), "the change is lost");
    await page.locator("#pg-original").click();
    assert((await codeOf()) === first, "it is not the original");
  });
  await check("names are completed, with a link to the reference", async () => {
    await type(page, FALLING);
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("physics.quer");
    const choice = page.locator(".cm-tooltip-autocomplete li").first();
    await choice.waitFor();
    const text = await choice.innerText();
    assert(/^query/.test(text), text);
    const link = await page.locator(".pg-about a").first().getAttribute("href");
    assert(/api\/queries\/#worldquery/.test(link), link);
    await page.screenshot({ path: join(PICTURES, "completion.png") });
    await page.keyboard.press("Escape");
    await type(page, FALLING);
  });
  await check("the playground says nothing to the console", () => quiet(told));
  await told.close();
}

async function checkErrors() {
  const told = await open("/playground/", DESKTOP);
  const { page } = told;
  const markedLine = () => page.locator(".cm-line:has(.cm-lintRange-error)").innerText();
  await isRunning(page);
  await check("a wrong field shows the library's message and its line", async () => {
    await type(page, FALLING.replace("height = 40", 'height = "tall"'));
    const text = await fails(page);
    const wanted = /^main\.lua:4: physics: .*height must be a number > 0, got "tall"/;
    assert(wanted.test(text), text);
    assert((await markedLine()).startsWith('physics.add("boxes"'), await markedLine());
    await page.screenshot({ path: join(PICTURES, "playground-error.png") });
    return text;
  });
  await check("an error in the middle of the run shows its line", async () => {
    await type(page, FALLING.replace("physics.update(dt) end", "physics.update(dt)\n  if love.timer.getTime() > 0.2 then physics.objects.boxes[1].vx = 0 / 0 end end"));
    const text = await fails(page);
    assert(/^main\.lua:5: physics: .*boxes\[1\]\.vx/.test(text), text);
    return text;
  });
  await check("what Lua cannot read shows its line", async () => {
    await type(page, FALLING.replace("local physics =", "local physics = ="));
    const text = await fails(page);
    assert(/^main\.lua:1: /.test(text), text);
    return text;
  });
  await check("an argument that LÖVE refuses shows its line", async () => {
    await type(page, FALLING.replace("physics.draw()", 'love.graphics.rectangle("fill", 1, 2, {}, 4)'));
    const text = await fails(page);
    assert(/^main\.lua:6: love: argument 4 of rectangle must be a number/.test(text), text);
    return text;
  });
  await check("a part of LÖVE that is not here says so", async () => {
    await type(page, FALLING.replace("physics.draw()", 'love.graphics.newImage("hero.png")'));
    const text = await fails(page);
    assert(/^main\.lua:6: the playground has no love\.graphics\.newImage/.test(text), text);
    return text;
  });
  await check("nothing of the machine behind Lua can be reached", async () => {
    await type(page, 'error(tostring(os.exit or io or debug.getregistry or debug.setmetatable or package.loadlib))');
    const text = await fails(page);
    assert(text === "main.lua:1: nil", text);
  });
  await check("a loop without an end is ended, and shows its line", async () => {
    await type(page, `${FALLING}\nlocal n = 0\nwhile true do pcall(function() n = n + 1 end) end\n`);
    const text = await fails(page);
    assert(/^main\.lua:9: /.test(text), text);
    return text;
  });
  await check("also one that comes late", async () => {
    const late = "function love.update() if love.timer.getTime() > 1.5 then while true do end end end";
    await type(page, `${FALLING}\n${late}\n`);
    await isRunning(page);
    return fails(page);
  });
  await check("and the playground goes on", async () => {
    await type(page, FALLING);
    await isRunning(page);
    assert(!(await page.locator("#pg-problem").isVisible()), "the old error is still there");
  });
  await check("all of a message can be read on a laptop and on a phone", async () => {
    const sizes = [LAPTOP.viewport, { width: 1366, height: 768 }, DESKTOP.viewport, PHONE.viewport];
    const problem = page.locator("#pg-problem");
    await type(page, `${FALLING}\nfor n = 1, 50 do print(n) end\nerror(("a long message. "):rep(12))`);
    await fails(page);
    for (const size of sizes) {
      await page.setViewportSize(size);
      await problem.scrollIntoViewIfNeeded();
      const box = await problem.boundingBox();
      const [seen, all] = await problem.evaluate((each) => [each.clientHeight, each.scrollHeight]);
      const text = `${size.width} x ${size.height}: ${seen} of ${all} px, ${JSON.stringify(box)}`;
      await page.screenshot({ path: join(PICTURES, `message-${size.width}x${size.height}.png`) });
      assert(all > 60 && seen >= all && box.y >= 0 && box.y + box.height <= size.height, text);
      const output = await page.locator("#pg-output").evaluate((each) => each.clientHeight);
      assert(output > 60, `${size.width} x ${size.height}: ${output} px of what was printed`);
    }
    await page.setViewportSize(DESKTOP.viewport);
  });
  await check("errors of programs are none of the page", () => quiet(told));
  await told.close();
}

async function checkKeys() {
  const told = await open("/playground/", DESKTOP);
  const { page } = told;
  const printed = () => page.locator("#pg-output").innerText();
  await isRunning(page);
  await check("keys and clicks reach the program, and nothing else", async () => {
    await type(
      page,
      `function love.keypressed(key) print("pressed " .. key) end
function love.keyreleased(key) print("released " .. key) end
function love.mousepressed(x, y, button) print(("button %d at %d"):format(button, x)) end
function love.update() if love.keyboard.isDown("d") then print("held") end end
`,
    );
    await isRunning(page);
    await page.locator("#pg-canvas").click({ position: { x: 10, y: 10 } });
    for (const key of ["ArrowRight", "s", "Space", "Shift", "f"]) await page.keyboard.press(key, { delay: 30 });
    await page.keyboard.down("d");
    await until(async () => /held/.test(await printed()), printed);
    await page.keyboard.up("d");
    await until(async () => /released d/.test(await printed()), printed);
    const text = (await printed()).split("\n").filter((each) => each !== "held").join(", ");
    const keys = ["right", "s", "space", "lshift", "f", "d"].flatMap((key) => [`pressed ${key}`, `released ${key}`]);
    assert(/^button 1 at 1\d, /.test(text), text);
    assert(text.endsWith(keys.join(", ")), text);
    assert(!(await page.locator("#__search").isChecked()), "a key of the program opened the search");
    return text;
  });
  await check("no errors while keys are pressed", () => quiet(told));
  await told.close();
}

async function checkSharing() {
  const told = await open("/playground/", DESKTOP);
  const { page } = told;
  const codeOf = (page) => page.evaluate(() => window.playground.editor.state.doc.toString());
  const code = FALLING.replace("gravity = 400", "gravity = 500") + "-- ä ☃ 😀\n";
  await isRunning(page);
  await check("the address holds the program", async () => {
    await type(page, code);
    await until(() => page.url().includes("#code="), () => page.url());
    const address = page.url().slice(site.length);
    const other = await open(address, DESKTOP);
    await isRunning(other.page);
    const found = await codeOf(other.page);
    await other.close();
    quiet(other);
    assert(found === code, found);
    return `${code.length} letters in ${address.length}`;
  });
  await check("a snippet has its name in the address", async () => {
    await page.locator("#pg-snippets").selectOption("lift");
    await until(() => page.url().endsWith("#snippet=lift"), () => page.url());
  });
  await check("an address that is cut off is told of", async () => {
    const other = await open("/playground/#code=abcd", DESKTOP);
    await until(async () => /cannot be read/.test(await problemOf(other.page)), "no word of it");
    await other.close();
    quiet(other);
  });
  await check("no errors while programs are shared", () => quiet(told));
  await told.close();
}

// The hash of each snippet in LÖVE.
function playInLove(names) {
  const command = ["-a", "timeout", "-k", "2", "120", "love", "web/playground/in_love", String(STEPS), KEYS, ...names];
  const text = execFileSync("xvfb-run", command, { encoding: "utf8" });
  return Object.fromEntries(text.trim().split("\n").map((each) => each.split(" ")));
}

async function checkPrograms(programs) {
  await check("pages lead to the playground", () => {
    assert(programs.size > 0, "there is no program in any page");
    return `${programs.size} programs`;
  });
  const step = process.argv.includes("--all") ? 1 : 3;
  for (const [address, name] of [...programs].filter((_, n) => n % step === 0)) {
    await check(`${name}: its program of ${address.length} letters runs in the playground`, async () => {
      const told = await open(address.slice(site.length), DESKTOP);
      const find = async () => (await stateOf(told.page)) === "failed" || (await stepOf(told.page)) > 30;
      await until(find, "it does not go on");
      assert(!(await told.page.locator("#pg-problem").isVisible()), await problemOf(told.page));
      const status = await told.page.locator("#pg-status").innerText();
      assert(/· [1-9]\d* objects/.test(status), status);
      await told.close();
      quiet(told);
    });
  }
}

async function checkSnippet(page, name, inLove) {
  await check(`${name}: ${STEPS} steps as in LuaJIT and in LÖVE, to the bit`, async () => {
    await page.locator("#pg-snippets").selectOption(name);
    await isRunning(page);
    await page.locator("#pg-pause").click();
    await page.locator("#pg-reset").click();
    await until(async () => (await stepOf(page)) === 0, "no reset");
    const play = ([steps, keys]) => window.playground.play(steps, keys);
    const hash = await page.evaluate(play, [STEPS, KEYS]);
    await until(async () => (await stepOf(page)) === STEPS, async () => `step ${await stepOf(page)}`);
    const file = join(SNIPPETS, `${name}.lua`);
    const native = execFileSync("luajit", ["web/playground/native.lua", file, String(STEPS), KEYS], { encoding: "utf8" });
    assert(native === `hash ${hash}\n`, `${hash} in the browser, ${native} in LuaJIT`);
    assert(inLove[name] === hash, `${hash} in the browser, ${inLove[name]} in LÖVE`);
    await page.locator("#pg-canvas").screenshot({ path: join(PICTURES, `snippet-${name}.png`) });
    return hash;
  });
}

async function checkSnippets() {
  const told = await open("/playground/", DESKTOP);
  await isRunning(told.page);
  const names = await told.page.evaluate(() => window.playground.snippets);
  await check("every file of a snippet is in the list", () => {
    const found = readdirSync(SNIPPETS).map((name) => basename(name, ".lua"));
    assert(found.sort().join() === [...names].sort().join(), `${found} instead of ${names}`);
    return `${names.length}`;
  });
  let inLove = {};
  await check("the snippets run in LÖVE, too", () => {
    inLove = playInLove(names);
  });
  for (const name of names) await checkSnippet(told.page, name, inLove);
  await check("no errors in the snippets", () => quiet(told));
  await told.close();
}

async function checkLayout() {
  for (const [kind, options] of Object.entries({ desktop: DESKTOP, phone: PHONE })) {
    for (const colorScheme of ["light", "dark"]) {
      await check(`the playground fits a ${kind}, ${colorScheme}`, async () => {
        const told = await open("/playground/#snippet=platformer", { ...options, colorScheme });
        const { page } = told;
        await isRunning(page);
        await page.screenshot({ path: join(PICTURES, `playground-${kind}-${colorScheme}.png`) });
        const { width, height } = options.viewport;
        const box = await page.locator("#pg-canvas").boundingBox();
        const sideways = await scrollsSideways(page);
        const isPadThere = await page.locator("#pg-pad").isVisible();
        if (kind === "phone") {
          const before = await placeOfBox(page, "pad-before");
          await page.locator('[data-key="right"]').dispatchEvent("pointerdown", { pointerId: 1 });
          await until(async () => (await placeOfBox(page, "pad-after")).x > before.x + 2, "the button moves nothing");
        }
        await told.close();
        quiet(told);
        const text = JSON.stringify(box);
        assert(!sideways, "it scrolls sideways");
        assert(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, text);
        assert(Math.abs(box.width / box.height - 4 / 3) < 0.02, text);
        assert(isPadThere === (kind === "phone"), "buttons in place of keys are for phones only");
        return `${Math.round(box.width)} x ${Math.round(box.height)}`;
      });
    }
  }
}

await check("the site is there", () => assert(existsSync(join(SITE, "index.html")), SITE));
await checkLinks();
const programs = await checkArticles();
await checkColors();
await checkReading();
await checkMenu();
await checkFields();
await checkLost();
await checkSearch();
await checkFront();
await checkExamples();
await checkTyping();
await checkErrors();
await checkKeys();
await checkSharing();
await checkPrograms(programs);
await checkSnippets();
await checkLayout();

console.log(`The pictures are in ${PICTURES}/`);
await finish();
