// Masks, a slider and instructions before each block in a real browser, read in German: what is drawn while a mask is seen is the mask's
// picture to the pixel, each stands for its frames, the slider moves by keys and by mouse, and its place is in the log. A set lies in
// WORK/masks-set; screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { realServe } from "./hosts.mjs";
import { actUntil, axeSource, inFirefox, openBrowser } from "./person.mjs";
import { decodePng } from "./png.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const folder = mkdtempSync(join(work, "masks-"));
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });
const set = join(work, "masks-set");
const log = join(folder, "log.sqlite");
const site = join(folder, "page-serve");
execFileSync(program, ["export", "web", set, site, "--serve"]);
const server = await realServe(program, join(folder, "page"), set, log);
const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 });
const given = new Map();
const briefed = [];
const seenMasks = { interval: 0, yes_no: 0 };
const keep = (page, name) => page.screenshot().then((png) => (writeFileSync(join(shots, "mask-" + (inFirefox ? "firefox-" : "") + name + ".png"), png), png));

/** The pixels of a screenshot where the picture stands, and those of a file of the page. */
function differences(shot, place, file) {
  const [drawn, wanted] = [decodePng(shot), decodePng(readFileSync(join(site, file)))];
  let different = 0;
  for (let y = 0; y < wanted.height; ++y)
    for (let x = 0; x < wanted.width; ++x)
      for (let c = 0; c < 3; ++c)
        if (drawn.bytes[((place.y + y) * drawn.width + place.x + x) * drawn.channels + c] !== wanted.bytes[(y * wanted.width + x) * wanted.channels + c]) ++different;
  return different;
}

/** Waits for the mask of the trial that is due; where it stands. */
const maskSeen = (page) =>
  page.waitForFunction(
    () => {
      const { visit, study } = globalThis.seamline;
      const { phase, trials, pace } = visit.session;
      const task = pace.tasks[trials.order[trials.answered].task];
      const after_ns = performance.now() * 1e6 - (phase.name === "gap" ? phase.since_ns : phase.onset_ns + task.exposure_ns);
      if (!["gap", "choosing"].includes(phase.name) || after_ns < 1e8 || after_ns > 3e8) return false;
      const shown = [...document.querySelectorAll(".picture.visible")];
      if (shown.length !== 1) return false;
      const { x, y } = shown[0].getBoundingClientRect();
      return { x: Math.round(x * devicePixelRatio), y: Math.round(y * devicePixelRatio), phase: phase.name, width: study.width_px };
    },
    null,
    { polling: "raf", timeout: 15000 }
  );

async function axeFinds(page, what) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  assert.deepEqual(violations.map(({ id }) => id), [], what);
}

/** A place of the slider by the mouse, or by keys from its middle. */
async function slide(page, position, byMouse, look = async () => {}) {
  const line = page.locator("#slider");
  const value = () => line.evaluate((node) => Number(node.value));
  assert.equal(await page.locator("#slider-done").isDisabled(), true, "a slider without a place confirms nothing");
  if (byMouse) {
    const box = await line.boundingBox();
    const thumb = 10;
    await page.mouse.click(box.x + thumb / 2 + ((box.width - thumb) * position) / 100, box.y + box.height / 2);
    const found = await value();
    assert.ok(Math.abs(found - position) <= 1, `the mouse put the slider at ${found} for ${position}`);
    await page.click("#slider-done");
    return found;
  }
  const tens = Math.trunc((position - 50) / 10);
  for (let i = 0; i < Math.abs(tens); ++i) await page.keyboard.press(tens > 0 ? "PageUp" : "PageDown");
  const ones = position - 50 - 10 * tens;
  for (let i = 0; i < Math.abs(ones); ++i) await page.keyboard.press(ones > 0 ? "ArrowRight" : "ArrowLeft");
  assert.equal(await value(), position, "the slider's place by keys");
  await look();
  await page.keyboard.press("Enter");
  return position;
}

try {
  const page = browser.pages()[0];
  // Screenshots of the driver add a style, which the page's policy refuses: Firefox calls that an error.
  const ofDriver = (error) => inFirefox && /Content-Security-Policy.*inline style/.test(String(error));
  page.on("pageerror", (error) => ofDriver(error) || assert.fail(String(error)));
  await page.goto(server.address + (server.address.includes("?") ? "&" : "?") + "lang=de");
  // Of the trial that was seen: the page may have gone on since, past the last one.
  const kindOf = (trial) => page.evaluate((trial) => { const { trials, pace } = globalThis.seamline.visit.session; return pace.tasks[trials.order[trial].task].kind; }, trial);
  const looked = new Set();
  await actUntil(page, ["thanks"], {
    patience_ms: 300000,
    answer: (seen) => ({ choice: 1 + (seen.answered % 2), rating: 9 }),
    each: async (seen) => {
      if (seen.screen === "briefing") {
        const words = await page.textContent("#study .card p");
        if (briefed.at(-1) === words) return;
        briefed.push(words);
        await axeFinds(page, "instructions of a block");
        await keep(page, "block-" + briefed.length);
      }
      if (seen.screen !== "trial" || given.has(seen.answered) || looked.has(seen.answered + seen.phase)) return;
      const kind = await kindOf(seen.answered);
      if (["interval", "yes_no"].includes(kind) && seenMasks[kind] < 3 && ["awaiting", "viewing", "choosing"].includes(seen.phase) && !looked.has(seen.answered)) {
        looked.add(seen.answered);
        const place = await (await maskSeen(page)).jsonValue();
        const shot = await keep(page, kind + "-" + seenMasks[kind]);
        assert.equal(differences(shot, place, seen.trial.mask), 0, kind + ": the mask as drawn");
        ++seenMasks[kind];
      }
      if (kind === "rating" && seen.asks && seen.phase === "rating") {
        await page.waitForTimeout(150);
        if (given.size === 0) {
          assert.match(await page.textContent("#title"), /beurteilen/);
          await axeFinds(page, "slider");
        }
        const at = seen.answered;
        const position = [0, 20, 93, 19, 59, 60, 80, 51, 37, 100][given.size % 10];
        given.set(at, await slide(page, position, given.size % 2 === 0 && position > 0, () => keep(page, "slider")));
        await page.waitForFunction((answered) => globalThis.seamline.visit.session.trials.answered > answered, at);
      }
    },
  });
} finally {
  await browser.close();
  await server.stop();
}
assert.deepEqual([...briefed].sort(), ["Jetzt eine Linie.", "Ein Bild nach dem anderen.", "Zwei Bilder."].sort());
assert.ok(seenMasks.interval > 0 && seenMasks.yes_no > 0, JSON.stringify(seenMasks));
execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
const [head, ...rows] = readFileSync(join(folder, "csv", "answers.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
const counts = { slid: 0, masks: 0, off: 0 };
for (const row of rows) {
  const value = (name) => row[head.indexOf(name)];
  if (value("task") === "rating") {
    const position = given.get(Number(value("trial_index")));
    assert.equal(Number(value("position")), position);
    const fifth = Math.min(4, Math.floor(position / 20));
    assert.deepEqual([Number(value("chosen_index")), Number(value("rating"))], fifth > 0 ? [1, fifth] : [2, 1]);
    ++counts.slid;
  } else if (value("mask_frames") !== "") {
    ++counts.masks;
    if (value("mask_marked") !== "0") ++counts.off;
  }
}
assert.ok(counts.slid > 0 && counts.masks > 0);
console.log(`masks: ${seenMasks.interval + seenMasks.yes_no} as drawn to the pixel, ${counts.masks} trials counted (${counts.off} with another number of frames); ${counts.slid} places of a slider are in the log as given; ${briefed.length} blocks had their instructions`);
