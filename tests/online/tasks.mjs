// Pairs, intervals, yes or no, and ratings in a real browser: one sitting each, by keys, at `serve`. Sets of these tasks lie
// in WORK/KIND-set. What the page sent must be what the log holds. Screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { actUntil, axeSource, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });

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

const ALTERNATIVES = { pair: 2, interval: 2, yes_no: 2, rating: 0 };

for (const [kind, alternatives] of Object.entries(ALTERNATIVES)) {
  const folder = mkdtempSync(join(work, kind + "-"));
  const set = join(work, kind + "-set");
  const pageFolder = join(folder, "page");
  const log = join(folder, "log.sqlite");
  execFileSync(program, ["export", "web", set, pageFolder, "--serve"]);
  const server = await served(pageFolder, set, log);
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1900, height: 1000 });
  const given = new Map();
  let looked = false;
  try {
    const page = browser.pages()[0];
    page.on("pageerror", (error) => assert.fail(kind + ": " + error));
    await page.goto(server.address);
    await actUntil(page, ["thanks"], {
      patience_ms: 120000,
      answer: (seen) => {
        const at = seen.answered;
        const choice = alternatives > 0 ? 1 + ((at * 7 + 3) % alternatives) : 0;
        const rating = 1 + ((at * 3 + 2) % 5);
        if (seen.screen === "trial") given.set(at, { choice, rating: rating - 1 });
        return { choice, rating };
      },
      each: async (seen) => {
        if (looked || seen.screen !== "trial" || !seen.asks) return;
        looked = true;
        await page.waitForTimeout(200);
        writeFileSync(join(shots, "task-" + kind + ".png"), await page.screenshot());
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
