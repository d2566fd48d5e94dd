// A person at the page: looks at which screen it is, then clicks and types.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { join } from "node:path";

const require = createRequire(join(process.env.SEAMLINE_NODE_MODULES, "x.js"));
export const { chromium } = require("playwright-core");
export const inFirefox = Boolean(process.env.SEAMLINE_FIREFOX);
export const axeSource = require("axe-core").source;

/** Firefox as a distribution has it, by WebDriver BiDi; its storage lasts as long as it runs. */
async function openFirefox(languages) {
  const { firefox } = createRequire(join(process.env.SEAMLINE_FIREFOX_MODULES, "x.js"))("playwright-core");
  const prefs = { "webgl.force-enabled": true, "gfx.webrender.software": true, ...(languages ? { "intl.accept_languages": languages } : {}) };
  const browser = await firefox.launch({ executablePath: process.env.SEAMLINE_FIREFOX, channel: "moz-firefox", headless: true, firefoxUserPrefs: prefs });
  const context = await browser.newContext({ viewport: null });
  await context.newPage();
  context.on("close", () => browser.close());
  return context;
}

/** A browser with its own storage that wishes `languages`; `ratio` is the screen's, as a driver's emulation would not be. */
export function openBrowser(folder, { ratio = 1, width = 1280, height = 900, args = [], languages } = {}) {
  if (inFirefox) return openFirefox(languages);
  return chromium.launchPersistentContext(folder, {
    executablePath: process.env.SEAMLINE_CHROMIUM,
    headless: true,
    viewport: null,
    acceptDownloads: true,
    args: ["--force-device-scale-factor=" + ratio, "--window-size=" + width + "," + height, "--screen-info={" + width + "x" + height + "}", "--force-color-profile=srgb", ...args],
  });
}

/** The files of an exported page that add up to a trial's panorama, as panorama_view.py takes them. */
export function panoramaFiles(folder, picture) {
  const { base } = JSON.parse(readFileSync(join(folder, "study.json"), "utf8")).pictures.find(({ file }) => file === picture);
  return { panorama: join(folder, picture), base: base ? join(folder, base) : null };
}

/** What axe finds wrong with the page as it is. */
export async function axeFindings(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return violations.map(({ id, nodes }) => id + ": " + nodes.map(({ html }) => html.slice(0, 120)).join(", "));
}

/** What is on the screen: read, never written. */
export const look = (page) =>
  page.evaluate(() => {
    const app = globalThis.seamline;
    const words = document.querySelector("h1")?.textContent ?? "";
    if (!app?.visit) return { screen: document.querySelector("#study .card") ? "refused" : "loading", words };
    const { visit } = app;
    const session = visit.screen.name === "training" ? visit.training : visit.screen.name === "trial" ? visit.session : null;
    const trial = session?.trials.order ? session.trials.order[session.trials.answered] : session?.trials.due;
    return {
      screen: visit.screen.name,
      pending: visit.pending?.kind ?? null,
      phase: session?.phase.name ?? null,
      trial: trial ?? null,
      answered: visit.session?.trials.answered ?? 0,
      participant: app.stream.participant,
      guard: app.guard.problem(),
      words,
      asks: session !== null && !document.querySelector(".questions")?.hidden,
      message: visit.screen.message ?? null,
    };
  });

/** What a person answers who always answers alike: {choice, rating}. */
export function usualAnswer(seen) {
  let hash = 7;
  for (const letter of seen.trial.stimulus_id + seen.trial.kind) hash = (hash * 31 + letter.charCodeAt(0)) >>> 0;
  return { choice: 1 + (hash % 3), rating: 1 + ((hash >>> 4) % 4) };
}

async function clickObject(page, index) {
  const box = await page.locator("#object-" + index).boundingBox();
  if (box) await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
}

async function fillForm(page) {
  for (const input of await page.locator("#study input.number").all()) await input.fill("33");
  for (const group of await page.locator("#study fieldset").all()) await group.locator("label.option").first().click();
  await page.click("#submit");
}

async function checkDisplay(page) {
  if (await page.locator("#card").isVisible()) {
    await page.focus("#card");
    for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
    await page.click("#continue");
  } else if (await page.locator("#same").isVisible()) {
    await page.click("#same");
  } else if (await page.locator("#study input.number").isVisible()) {
    await page.locator("#study input.number").fill("60");
    await page.keyboard.press("Enter");
  }
}

/** One thing that a person does about what is on the screen. `mouse`: pictures by clicks, else by keys. */
export async function act(page, seen, { mouse = false, answer = usualAnswer } = {}) {
  if (seen.pending) return;
  switch (seen.screen) {
    case "consent":
      return page.click("#accept");
    case "form":
      return fillForm(page);
    case "display":
      return checkDisplay(page);
    case "training":
    case "trial": {
      if (!seen.asks || !seen.trial) return;
      const { choice, rating } = answer(seen);
      if (seen.phase === "choosing") return mouse ? clickObject(page, choice) : page.keyboard.press(String(choice));
      if (seen.phase === "rating") return mouse ? page.click("#rating-" + rating) : page.keyboard.press(String(rating));
      return;
    }
    case "instructions":
    case "feedback":
    case "ready":
    case "briefing":
    case "break":
      if (await page.locator("#comfort-2").isVisible()) return page.click("#comfort-2");
    // falls through
    case "pause":
      return mouse ? page.click("#continue") : page.keyboard.press("Enter");
  }
}

/** Until the visit is on one of some screens; `each(seen)` sees every look. Throws when nothing happens for long. */
export async function actUntil(page, screens, options = {}) {
  const end = Date.now() + (options.patience_ms ?? 60000);
  while (Date.now() < end) {
    let seen;
    try {
      seen = await look(page);
      await options.each?.(seen);
      if (screens.includes(seen.screen)) return seen;
      await act(page, seen, options);
    } catch (error) {
      if (options.strict !== false) throw error;
    }
    await page.waitForTimeout(options.pace_ms ?? 15);
  }
  throw new Error("the visit did not come to " + screens.join(", ") + "; it is " + JSON.stringify(await look(page)));
}
