// Two and five objects, pairs, intervals, yes or no, ratings, matches and a staircase in a real browser: one sitting each, by keys (of objects by the mouse, too), at `serve`. Sets of
// these tasks lie in WORK/KIND-set. What the page sent must be what the log holds. Screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { actUntil, axeSource, inFirefox, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
const shotOf = (name) => join(shots, "task-" + (inFirefox ? "firefox-" : "") + name + ".png");
mkdirSync(shots, { recursive: true });

/** No error of the page. Screenshots of the driver add a style, which the page's policy refuses: Firefox calls that one. */
function expectNoErrors(page, kind) {
  const ofDriver = (error) => inFirefox && /Content-Security-Policy.*inline style/.test(String(error));
  page.on("pageerror", (error) => ofDriver(error) || assert.fail(kind + ": " + error));
}

async function served(page, set, log) {
  const server = spawn(program, ["serve", page, "--log", log, "--set", set, "--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
  const said = [];
  const address = await new Promise((resolve, reject) => {
    server.stdout.on("data", (bytes) => {
      said.push(String(bytes));
      const found = /at (http:\S+)/.exec(said.join(""));
      if (found) resolve(found[1]);
    });
    server.on("exit", () => reject(new Error("the server ended: " + said.join(""))));
  });
  return { address, stop: () => new Promise((resolve) => (server.on("exit", resolve), server.kill("SIGTERM"))) };
}

const ALTERNATIVES = { object2: 2, object5: 5, "object5 by mouse": 5, pair: 2, interval: 2, yes_no: 2, rating: 0 };

for (const [kind, alternatives] of Object.entries(ALTERNATIVES)) {
  const folder = mkdtempSync(join(work, kind.replaceAll(" ", "-") + "-"));
  const byMouse = kind.endsWith(" by mouse");
  const isObject = kind.startsWith("object");
  const set = join(work, kind.split(" ")[0] + "-set");
  const pageFolder = join(folder, "page");
  const log = join(folder, "log.sqlite");
  execFileSync(program, ["export", "web", set, pageFolder, "--serve"]);
  const server = await served(pageFolder, set, log);
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1900, height: 1000 });
  const given = new Map();
  let looked = false;
  try {
    const page = browser.pages()[0];
    expectNoErrors(page, kind);
    await page.goto(server.address);
    await actUntil(page, ["thanks"], {
      patience_ms: 120000,
      mouse: byMouse,
      answer: (seen) => {
        const at = seen.answered;
        const choice = alternatives > 0 ? 1 + ((at * 7 + 3) % alternatives) : 0;
        const rating = 1 + ((at * 3 + 2) % (isObject ? 4 : 5));
        if (seen.screen === "trial") given.set(at, { choice, rating: rating - 1 });
        return { choice, rating };
      },
      each: async (seen) => {
        if (looked || seen.screen !== "trial" || !seen.asks) return;
        looked = true;
        await page.waitForTimeout(200);
        writeFileSync(shotOf(kind.replaceAll(" ", "-")), await page.screenshot());
        if (isObject) {
          const names = await page.$$eval("button.object", (buttons) => buttons.map((button) => button.getAttribute("aria-label")));
          assert.equal(names.length, alternatives, kind);
          assert.equal(names[1], alternatives === 2 ? "2 on the right" : "2 second from the left", kind);
        }
        await page.evaluate(axeSource);
        const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
        assert.deepEqual(violations.map(({ id }) => id), [], kind);
      },
    });
  } finally {
    await browser.close();
    await server.stop();
  }
  assert.ok(looked, kind + ": no trial was looked at");
  execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
  let found = 0;
  for (const file of ["answers.csv", "catch_answers.csv"]) {
    const [head, ...rows] = readFileSync(join(folder, "csv", file), "utf8").trim().split("\n").map((line) => line.split(","));
    const column = (name) => head.indexOf(name);
    for (const row of rows) {
      const wanted = given.get(Number(row[column("trial_index")]));
      if (isObject) assert.equal(Number(row[column("rating")]), wanted.rating + 1, kind);
      if (alternatives > 0) assert.equal(Number(row[column("chosen_index")]), wanted.choice, kind);
      else {
        // The lowest label is "nothing seen", choice 2; the others are ratings of something seen.
        assert.equal(Number(row[column("chosen_index")]), wanted.rating === 0 ? 2 : 1, kind);
        if (wanted.rating > 0) assert.equal(Number(row[column("rating")]), wanted.rating, kind);
      }
      ++found;
    }
  }
  assert.equal(found, given.size, kind + ": answers in the log and given");
  console.log(kind + ": " + found + " answers are in the log as they were given");
}

// A match, by arrow keys, wheel, buttons and Enter: where each trial ended is where these lead from where it began.
{
  const levels = [64, 128, 256, 512];
  const folder = mkdtempSync(join(work, "match-"));
  execFileSync(program, ["export", "web", join(work, "match-set"), join(folder, "page"), "--serve"]);
  const log = join(folder, "log.sqlite");
  const server = await served(join(folder, "page"), join(work, "match-set"), log);
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1280, height: 900 });
  const wanted = new Map();
  try {
    const page = browser.pages()[0];
    expectNoErrors(page, "match");
    await page.goto(server.address);
    const by = {
      key: (step) => page.keyboard.press(step < 0 ? "ArrowLeft" : "ArrowRight"),
      digit: (step) => page.keyboard.press(step < 0 ? "1" : "2"),
      button: (step) => page.click(step < 0 ? "#answer-1" : "#answer-2"),
      wheel: async (step) => {
        await page.mouse.move(400, 100);
        await page.mouse.wheel(0, step * 100);
        await page.waitForTimeout(200);
      },
    };
    const ways = Object.values(by);
    await actUntil(page, ["thanks"], {
      patience_ms: 120000,
      each: async (seen) => {
        if (seen.screen !== "trial" || !seen.asks || seen.phase !== "choosing" || wanted.has(seen.answered)) return;
        await page.waitForTimeout(150); // the least time of viewing
        const at = seen.answered;
        const steps = [1, -1, 1, 1, 1, 1, -1].slice(0, at % 8);
        let rung = seen.trial.start;
        for (const step of steps) {
          await ways[at % ways.length](step);
          rung = Math.min(levels.length - 1, Math.max(0, rung + step));
          const visible = await page.evaluate(() => [...document.querySelectorAll(".picture")].filter((image) => image.classList.contains("visible")).length);
          assert.equal(visible, 1, "match: one picture is seen");
        }
        wanted.set(at, { level: levels[rung], start: levels[seen.trial.start], steps: steps.length });
        if (at === 3) {
          writeFileSync(shotOf("match"), await page.screenshot());
          await page.evaluate(axeSource);
          const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
          assert.deepEqual(violations.map(({ id }) => id), [], "match");
        }
        await page.keyboard.press(at % 2 === 0 && ways[at % ways.length] !== by.button ? "Enter" : "3");
        await page.waitForFunction((before) => globalThis.seamline.visit.session.trials.answered > before, at);
      },
      answer: () => ({ choice: 0 }),
    });
  } finally {
    await browser.close();
    await server.stop();
  }
  execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
  const [head, ...rows] = readFileSync(join(folder, "csv", "matches.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const value = (row, name) => Number(row[head.indexOf(name)]);
  for (const row of rows) {
    const one = wanted.get(value(row, "trial_index"));
    assert.deepEqual({ level: value(row, "matched_level"), start: value(row, "start_level"), steps: value(row, "steps") }, one);
  }
  assert.equal(rows.length, 6, "match: three objects twice");
  execFileSync(program, ["analyze", log, "--out", join(folder, "report"), "--include-pilot"]);
  console.log("match: " + rows.length + " matches are in the log as they were made");
}

// A staircase, 1 down and 2 up, loaded anew on the way, of a person who guesses. The levels in the log are those of the rule,
// followed here once more by what was right.
{
  const levels = [64, 128, 256, 512];
  const folder = mkdtempSync(join(work, "staircase-"));
  const log = join(folder, "log.sqlite");
  execFileSync(program, ["export", "web", join(work, "staircase-set"), join(folder, "page"), "--serve"]);
  const server = await served(join(folder, "page"), join(work, "staircase-set"), log);
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1280, height: 900 });
  let reloaded = false;
  try {
    const page = browser.pages()[0];
    expectNoErrors(page, "staircase");
    page.on("dialog", (dialog) => dialog.accept());
    await page.goto(server.address);
    await actUntil(page, ["thanks"], {
      patience_ms: 120000,
      strict: false, // a look may fall into the loading
      each: async (seen) => {
        if (reloaded || seen.answered !== 5 || seen.phase !== "rating") return;
        reloaded = true;
        writeFileSync(shotOf("staircase"), await page.screenshot());
        await page.reload();
      },
      answer: (seen) => ({ choice: 1 + ((seen.answered * 7 + 3) % 3), rating: 2 }),
    });
  } finally {
    await browser.close();
    await server.stop();
  }
  assert.ok(reloaded, "staircase: was not loaded anew");
  execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
  const [head, ...rows] = readFileSync(join(folder, "csv", "answers.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const value = (row, name) => Number(row[head.indexOf(name)]);
  rows.sort((a, b) => value(a, "trial_index") - value(b, "trial_index"));
  let [rung, wrongs, heading] = [0, 0, 0];
  const turns = [];
  for (const row of rows) {
    assert.ok(turns.length < 6, "staircase: it goes on after six reversals");
    assert.equal(value(row, "level"), levels[rung], "staircase: level of trial " + row[head.indexOf("trial_index")]);
    const right = value(row, "chosen_index") === value(row, "object_index");
    assert.equal(value(row, "chosen_index"), 1 + ((value(row, "trial_index") * 7 + 3) % 3), "staircase: answer");
    wrongs = right ? 0 : wrongs + 1;
    const step = right ? 1 : wrongs === 2 ? -1 : 0;
    if (step === 0) continue;
    wrongs = 0;
    if (heading === -step) turns.push(Math.log2(levels[rung]));
    heading = step;
    rung = Math.min(levels.length - 1, Math.max(0, rung + step));
  }
  assert.equal(turns.length, 6, "staircase: reversals");
  const mean_px = Math.round(2 ** (turns.slice(2).reduce((sum, x) => sum + x, 0) / 4));
  const tracks = execFileSync(program, ["log", "tracks", log], { encoding: "utf8" });
  assert.ok(tracks.includes(String(mean_px)), "staircase: mean of the reversals, " + mean_px + ": " + tracks);
  execFileSync(program, ["analyze", log, "--out", join(folder, "report"), "--include-pilot"]);
  console.log("staircase: " + rows.length + " answers follow 1 down, 2 up; six reversals, mean " + mean_px + " px");
}
