// Pairs and a match by touches alone, on a tablet as Chromium emulates one: what was touched is in the log, a pinch is waited out, and the
// paper's study refuses the tablet and every study a phone. Sets lie in WORK/tiny-set, WORK/pair-set and WORK/match-set; screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { realServe } from "./hosts.mjs";
import { tryLaws } from "./try_laws.mjs";
import { axeSource, chromium, look } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });
const TABLET = "Mozilla/5.0 (Linux; Android 14; SM-X710) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/130.0.0.0 Safari/537.36";

/** A screen of 1280 x 800 that only fingers reach. */
async function onTablet(address, visit, userAgent = TABLET) {
  const browser = await chromium.launchPersistentContext(mkdtempSync(join(work, "browser-")), {
    executablePath: process.env.SEAMLINE_CHROMIUM, headless: true, userAgent,
    hasTouch: true, viewport: { width: 1280, height: 800 }, screen: { width: 1280, height: 800 }, deviceScaleFactor: 1,
  });
  try {
    const page = browser.pages()[0];
    page.on("pageerror", (error) => assert.fail(String(error)));
    page.on("dialog", (dialog) => dialog.accept());
    await page.goto(address);
    return await visit(page);
  } finally {
    await browser.close();
  }
}

async function served(kind) {
  const folder = mkdtempSync(join(work, "touch-"));
  const set = join(work, kind + "-set");
  execFileSync(program, ["export", "web", set, join(folder, "page-serve"), "--serve"]);
  const log = join(folder, "log.sqlite");
  const server = await realServe(program, join(folder, "page"), set, log);
  const rows = (file) => {
    if (!existsSync(join(folder, "csv"))) execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
    const [head, ...lines] = readFileSync(join(folder, "csv", file), "utf8").trim().split("\n").map((line) => line.split(","));
    return lines.map((line) => Object.fromEntries(line.map((value, at) => [head[at], value])));
  };
  return { server, rows };
}

/** One thing that a finger does on a page of words. */
async function tapOn(page, seen) {
  if (seen.screen === "consent") return page.tap("#accept");
  if (seen.screen === "form") {
    for (const input of await page.locator("#study input.number").all()) await input.fill("33"); // the screen's own keyboard
    for (const group of await page.locator("#study fieldset").all()) await group.locator("label.option").first().tap();
    return page.tap("#submit");
  }
  if (seen.screen === "display") {
    for (const id of ["#same", "#continue"]) if (await page.locator(id).isVisible()) {
      if (await page.locator("#study input.number").isVisible()) await page.locator("#study input.number").fill("60");
      return page.tap(id);
    }
    return;
  }
  if (await page.locator("#comfort-2").isVisible()) return page.tap("#comfort-2");
  if (await page.locator("#continue").isVisible()) return page.tap("#continue");
}

/** Until the end; `answer(page, seen)` touches what a trial shows. */
async function through(page, label, answer) {
  let looked = false;
  for (const end = Date.now() + 60000; Date.now() < end; await page.waitForTimeout(20)) {
    const seen = await look(page);
    if (seen.screen === "thanks") return;
    assert.notEqual(seen.screen, "refused", seen.words);
    if (seen.pending || seen.guard || seen.screen === "loading") continue;
    if (!["training", "trial"].includes(seen.screen)) {
      await tapOn(page, seen);
      continue;
    }
    if (!seen.asks || !["choosing", "rating"].includes(seen.phase)) continue;
    if (!looked && seen.screen === "trial") {
      looked = true;
      writeFileSync(join(shots, "touch-" + label + ".png"), await page.screenshot());
      await page.evaluate(axeSource);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(violations.map(({ id }) => id), [], label);
    }
    await answer(page, seen);
  }
  assert.fail("never at the end: " + JSON.stringify(await look(page)));
}

const laws = {
  async "pairs: every second one by touching the picture, the others by the answer below"() {
    const { server, rows } = await served("pair");
    const given = new Map();
    await onTablet(server.address, (page) =>
      through(page, "pair", async (page, seen) => {
        const choice = 1 + (seen.answered % 2);
        if (seen.screen === "trial") given.set(String(seen.answered), String(choice));
        if (seen.answered % 4 < 2) return page.tap("#answer-" + choice);
        const boxes = await Promise.all((await page.locator(".picture.visible").all()).map((picture) => picture.boundingBox()));
        const box = boxes.sort((a, b) => a.x - b.x)[choice - 1];
        return page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
      })
    );
    await server.stop();
    const found = [...rows("answers.csv"), ...rows("catch_answers.csv")];
    assert.equal(found.length, 8);
    for (const row of found) assert.equal(row.chosen_index, given.get(row.trial_index), "trial " + row.trial_index);
  },
  async "a match by its buttons"() {
    const { server, rows } = await served("match");
    const levels = [64, 128, 256, 512];
    const wanted = new Map();
    await onTablet(server.address, (page) =>
      through(page, "match", async (page, seen) => {
        if (seen.screen !== "trial") return page.tap("#answer-3");
        if (wanted.has(seen.answered)) return;
        let rung = seen.trial.start;
        for (const step of [1, 1, -1].slice(0, 1 + (seen.answered % 3))) {
          await page.waitForTimeout(150);
          await page.tap(step < 0 ? "#answer-1" : "#answer-2");
          rung = Math.min(levels.length - 1, Math.max(0, rung + step));
        }
        wanted.set(seen.answered, levels[rung]);
        await page.tap("#answer-3");
      })
    );
    await server.stop();
    const found = rows("matches.csv");
    assert.equal(found.length, 6);
    for (const row of found) assert.equal(Number(row.matched_level), wanted.get(Number(row.trial_index)));
  },
  async "the paper's study refuses a tablet, a study of pairs a phone"() {
    const phone = TABLET.replace("Safari", "Mobile Safari");
    for (const [kind, agent] of [["tiny", TABLET], ["pair", phone]]) {
      const { server } = await served(kind);
      await onTablet(server.address, async (page) => {
        await page.waitForSelector("#study .card");
        assert.match(await page.textContent("#study"), /needs a computer/, kind);
      }, agent);
      await server.stop();
    }
  },
};

await tryLaws(laws);
