// Every screen at several ratios and window sizes: a screenshot to look at (WORK/shots), no violation for axe-core, and
// the pictures' pixels in the screenshot equal to the file's.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, axeSource, inFirefox, look, openBrowser } from "./person.mjs";
import { decodePng, differences } from "./png.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });

const CASES = [
  { name: "1x", study: "tiny", ratio: 1, width: 1280, height: 900 },
  { name: "2x", study: "tiny", ratio: 2, width: 1280, height: 900 },
  { name: "1.25x", study: "tiny", ratio: 1.25, width: 1280, height: 900, quiet: true },
  { name: "1.5x", study: "tiny", ratio: 1.5, width: 1280, height: 900, quiet: true },
  { name: "1.1x", study: "tiny", ratio: 1.1, width: 1283, height: 907, quiet: true },
  { name: "1.75x", study: "tiny", ratio: 1.75, width: 1281, height: 901, quiet: true },
  { name: "small", study: "tiny", ratio: 1, width: 640, height: 560 },
  { name: "too-small", study: "tiny", ratio: 1, width: 500, height: 400 },
  { name: "large", study: "tiny", ratio: 1, width: 1280, height: 900, large: true },
  { name: "arabic", study: "arabic", ratio: 1, width: 1100, height: 800 },
];

async function violations(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return violations.map(({ id, nodes }) => id + ": " + nodes.map((node) => node.html).join(" | "));
}

/** How many pixels of the picture on the screen are not the file's. */
async function wrongPixels(page, folder, trial, shot) {
  const place = await page.evaluate(() => {
    const { left, top } = document.querySelector(".picture.visible").getBoundingClientRect();
    return { left: Math.round(left * devicePixelRatio), top: Math.round(top * devicePixelRatio) };
  });
  const picture = decodePng(readFileSync(join(folder, trial.picture)));
  return differences(picture, decodePng(shot), place.left, place.top);
}

async function walk({ name, study, ratio, width, height, quiet, large }) {
  const folder = join(work, study + "-static");
  const host = await staticHost(join(work, study));
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { ratio, width, height });
  const seenScreens = new Set();
  const found = [];
  let pixels = 0;
  let pictures = 0;
  try {
    const page = browser.pages()[0];
    page.on("dialog", (dialog) => dialog.accept());
    await page.goto(host.address);
    assert.ok(Math.abs((await page.evaluate(() => devicePixelRatio)) - ratio) < 1e-6);
    const lookAt = async (label) => {
      if (seenScreens.has(label)) return;
      seenScreens.add(label);
      await page.waitForTimeout(120);
      if (!quiet) writeFileSync(join(shots, (inFirefox ? "firefox-" : "") + name + "-" + label + ".png"), await page.screenshot());
      if (!quiet) for (const violation of await violations(page)) found.push(label + ": " + violation);
    };
    await page.mouse.move(3, 3);
    for (let turn = 0; turn < 3000; ++turn) {
      const seen = await look(page);
      if (seen.screen === "display") {
        const step = (await page.locator("#card").isVisible()) ? "card" : (await page.locator("#same").isVisible()) ? "gamma" : "distance";
        await lookAt("display-" + step);
      } else if (seen.screen === "training" || seen.screen === "trial") {
        if (seen.asks && seen.phase === "choosing") {
          await page.evaluate(() => new Promise((then) => requestAnimationFrame(() => requestAnimationFrame(then))));
          const shot = await page.screenshot();
          const wrong = await wrongPixels(page, folder, seen.trial, shot);
          pixels += wrong;
          ++pictures;
          await lookAt(seen.screen + "-choosing");
          if (seen.answered === 1 && seen.screen === "trial" && !seenScreens.has("focus")) {
            await page.keyboard.press("Tab");
            await page.keyboard.press("Tab");
            await lookAt("focus");
          }
          if (seen.answered === 2 && !seenScreens.has("pause")) {
            await page.keyboard.press("Escape");
            await lookAt("pause");
            continue;
          }
        }
        if (seen.asks && seen.phase === "rating") await lookAt(seen.screen + "-rating");
      } else if (!["loading"].includes(seen.screen)) {
        if (seen.screen === "form" && !seenScreens.has("form")) {
          await lookAt("form");
          await page.click("#submit");
          await lookAt("form-problems");
        }
        await lookAt(seen.screen + (seen.screen === "instructions" ? seen.words.length : ""));
      }
      if (seen.screen === "consent" && large) await page.locator("label.option").last().click();
      if (seen.screen === "thanks") break;
      if (seen.guard) {
        await lookAt("guard");
        break;
      }
      await act(page, seen);
      await page.waitForTimeout(20);
    }
    assert.ok(seenScreens.has("thanks") || seenScreens.has("guard"), "came to " + JSON.stringify(await look(page)));
    assert.deepEqual(found, []);
    assert.equal(pixels, 0, "pixels that are not the picture's");
    console.log("ok      %s: %d screens, %d pictures exact", name, seenScreens.size, pictures);
  } finally {
    await browser.close();
    await host.stop();
  }
}

/** What is refused, with words. */
async function refusals() {
  const host = await staticHost(join(work, "tiny"));
  const refused = async (label, options, expected, prepare = async () => {}) => {
    const browser = await openBrowser(mkdtempSync(join(work, "browser-")), options);
    try {
      const page = browser.pages()[0];
      await prepare(page, browser);
      await page.goto(host.address);
      await page.waitForSelector("#study .card");
      const words = await page.textContent("#study");
      writeFileSync(join(shots, label + ".png"), await page.screenshot());
      assert.match(words, expected, label);
      assert.deepEqual(await violations(page), [], label);
      console.log("ok      %s", label);
    } finally {
      await browser.close();
    }
  };
  const asMobile = (page) =>
    page.addInitScript(() => Object.defineProperty(navigator, "userAgent", { get: () => "Mozilla/5.0 (Linux; Android 14) Mobile" }));
  await refused("refused-mobile", {}, /needs a computer/, asMobile);
  const without = (page) => page.addInitScript(() => delete ResizeObserverEntry.prototype.devicePixelContentBoxSize);
  await refused("refused-browser", {}, /recent Firefox, Chrome or Edge/, without);
  const nowhere = (page) =>
    page.addInitScript(() => (IDBFactory.prototype.open = () => { throw new Error("no storage"); }));
  await refused("refused-storage", {}, /no storage/, nowhere);
  await host.stop();
}

let failed = 0;
const wanted = process.argv[2] ?? "";
// Firefox has one size of screen here, and refuses what it refuses by the same words.
const cases = inFirefox ? CASES.filter(({ name }) => ["1x", "large", "arabic"].includes(name)) : CASES;
for (const one of [...cases.map((item) => [item.name, () => walk(item)]), ...(inFirefox ? [] : [["refusals", refusals]])]) {
  if (!one[0].startsWith(wanted)) continue;
  try {
    await one[1]();
  } catch (error) {
    ++failed;
    console.log("FAILED  %s\n%s", one[0], error.stack);
  }
}
console.log("%d failed", failed);
process.exit(failed === 0 ? 0 : 1);
