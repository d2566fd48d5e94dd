// Conditions with tasks of their own in a real browser: one sitting by keys at `serve`. Each condition asks its own question, what the
// page sent is in the log, axe finds nothing. A set lies in WORK/own_tasks-set; screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { realServe } from "./hosts.mjs";
import { actUntil, axeSource, inFirefox, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const QUESTIONS = { object: /Which of the three objects/, interval: /Into which of the pictures/, pair: /Into which of the two pictures/, yes_no: /Was an object inserted/ };
const ALTERNATIVES = { object: 3, interval: 2, pair: 2, yes_no: 2 };
const KIND_OF = { which: "object", turn: "interval", beside: "pair", seen: "yes_no" };
const set = join(work, "own_tasks-set");
const folder = mkdtempSync(join(work, "own-tasks-"));
mkdirSync(join(work, "shots"), { recursive: true });
execFileSync(program, ["export", "web", set, join(folder, "page-serve"), "--serve"]);
const log = join(folder, "log.sqlite");
const server = await realServe(program, join(folder, "page"), set, log);
const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 });
const given = new Map();
const looked = new Set();
try {
  const page = browser.pages()[0];
  // Screenshots of the driver add a style, which the page's policy refuses: Firefox calls that an error.
  const ofDriver = (error) => inFirefox && /Content-Security-Policy.*inline style/.test(String(error));
  page.on("pageerror", (error) => ofDriver(error) || assert.fail(String(error)));
  await page.goto(server.address);
  const dueKind = () =>
    page.evaluate(() => {
      const { trials, pace } = globalThis.seamline.visit.session;
      return pace.tasks[trials.order[trials.answered].task].kind;
    });
  await actUntil(page, ["thanks"], {
    patience_ms: 240000,
    answer: (seen) => {
      const choice = 1 + (seen.answered % 2);
      const rating = 1 + (seen.answered % 4);
      if (seen.screen === "trial") given.set(seen.answered, { choice, rating });
      return { choice, rating };
    },
    each: async (seen) => {
      if (seen.screen !== "trial" || !seen.asks || seen.phase !== "choosing") return;
      const kind = await dueKind();
      if (looked.has(kind)) return;
      looked.add(kind);
      await page.waitForTimeout(200);
      assert.match(await page.textContent("#title"), QUESTIONS[kind]);
      writeFileSync(join(work, "shots", "own-task-" + (inFirefox ? "firefox-" : "") + kind + ".png"), await page.screenshot());
      assert.equal(await page.locator(kind === "object" ? "button.object" : "button.rating").count(), ALTERNATIVES[kind]);
      await page.evaluate(axeSource);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(violations.map(({ id }) => id), [], kind);
    },
  });
} finally {
  await browser.close();
  await server.stop();
}
assert.deepEqual([...looked].sort(), Object.keys(QUESTIONS).sort());
execFileSync(program, ["export", "tables", log, join(folder, "csv")]);
const [head, ...rows] = readFileSync(join(folder, "csv", "answers.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
for (const row of rows) {
  const value = (name) => row[head.indexOf(name)];
  const { choice, rating } = given.get(Number(value("trial_index")));
  assert.equal(value("task"), KIND_OF[value("condition")]);
  assert.equal(Number(value("chosen_index")), choice);
  if (["object", "pair"].includes(value("task"))) assert.equal(Number(value("rating")), rating);
}
assert.ok(rows.length > 0);
console.log(`own tasks: ${rows.length} answers are in the log as they were given, to ${looked.size} questions`);
