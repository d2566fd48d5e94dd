// Days that pass (faketime): a study closes while somebody is answering, who may finish while nobody else is let in; and people go on another
// day, in a browser at `serve` and in the window, where they stopped. Sets are those of `run`.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { tryLaws } from "./try_laws.mjs";
import { act, actUntil, look, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });

/** Serves a set from a moment of universal time on; the clock goes on from there. */
async function servedAt(moment, folder, log, port = "0") {
  const env = { ...process.env, TZ: "UTC", FAKETIME_DONT_FAKE_MONOTONIC: "1" };
  const child = spawn("faketime", ["-f", "@" + moment, program, "serve", join(folder, "page"), "--log", log, "--set", join(folder, "set"), "--port", port], { env, stdio: ["ignore", "pipe", "inherit"] });
  let said = "";
  const address = await new Promise((resolve, reject) => {
    child.stdout.on("data", (bytes) => {
      said += bytes;
      const found = /at (http:\S+)/.exec(said);
      if (found) resolve(found[1]);
    });
    child.on("exit", () => reject(new Error("the server ended: " + said)));
  });
  // faketime waits for the program, which is the one that stops.
  const server = Number(execFileSync("pgrep", ["-P", String(child.pid)], { encoding: "utf8" }).trim().split("\n")[0]) || child.pid;
  return { address, stop: () => new Promise((resolve) => (child.on("exit", resolve), process.kill(server, "SIGTERM"))) };
}

function copyOf(recruitment) {
  const folder = mkdtempSync(join(work, "days-"));
  cpSync(join(work, "tiny-set"), join(folder, "set"), { recursive: true });
  const file = join(folder, "set", "study.toml");
  writeFileSync(file, readFileSync(file, "utf8") + recruitment);
  execFileSync(program, ["export", "web", join(folder, "set"), join(folder, "page"), "--serve"]);
  return { folder, log: join(folder, "log.sqlite") };
}

const query = (log, sql) =>
  JSON.parse(execFileSync("/usr/bin/python3", ["-c", "import json, sqlite3, sys; print(json.dumps(sqlite3.connect(sys.argv[1]).execute(sys.argv[2]).fetchall()))", log, sql], { encoding: "utf8" }));
const newFolder = () => mkdtempSync(join(work, "browser-"));
const browserFor = (folder) => openBrowser(folder, { width: 1100, height: 800 });

/** Answers until `count` trials are answered. */
async function answerUntil(page, count) {
  for (const end = Date.now() + 120000; Date.now() < end; await page.waitForTimeout(15)) {
    const seen = await look(page);
    if (seen.answered >= count && !seen.pending) return;
    await act(page, seen);
  }
  throw new Error("fewer answers than " + count);
}

const laws = {
  async "a study that closes lets its people finish, and nobody else in"() {
    const { folder, log } = copyOf('\n[recruitment]\ncloses = "2026-12-31 23:59"\n[recruitment.codes]\nfinished = "DONE"\nfull = "CLOSED"\n');
    const server = await servedAt("2026-12-31 23:58:30", folder, log);
    const closes_ms = Date.now() + 30000;
    const [first, second] = [await browserFor(newFolder()), await browserFor(newFolder())];
    try {
      const [page, late] = [first.pages()[0], second.pages()[0]];
      await page.goto(server.address);
      await answerUntil(page, 2);
      await page.waitForTimeout(Math.max(0, closes_ms + 1000 - Date.now()));
      await late.goto(server.address);
      await late.click("#accept");
      await late.waitForSelector("#completion");
      assert.match(await late.textContent("#study"), /CLOSED/);
      writeFileSync(join(shots, "days-closed.png"), await late.screenshot());
      await page.reload(); // who is in is no newcomer
      await actUntil(page, ["thanks"], { patience_ms: 120000, strict: false });
      await page.waitForSelector("#completion");
      assert.match(await page.textContent("#study"), /DONE/);
    } finally {
      await first.close();
      await second.close();
      await server.stop();
    }
    assert.deepEqual(query(log, "SELECT count(*) FROM participants"), [[1]]);
  },
  async "who comes back in three days goes on at the trial where they stopped"() {
    const { folder, log } = copyOf("");
    const own = newFolder(); // what the browser keeps
    const counts = [];
    let port;
    for (const [day, answers] of [["2026-12-01 10:00:00", 2], ["2026-12-04 18:30:00", 4], ["2027-01-02 09:00:00", 1000]]) {
      const server = await servedAt(day, folder, log, port);
      port = new URL(server.address).port; // what a browser keeps is of its host and port
      const browser = await browserFor(own);
      try {
        const page = browser.pages()[0];
        page.on("dialog", (dialog) => dialog.accept());
        await page.goto(server.address);
        if (answers < 1000) await answerUntil(page, answers);
        else await actUntil(page, ["thanks"], { patience_ms: 120000, strict: false });
        counts.push((await look(page)).answered);
      } finally {
        await browser.close();
        await server.stop();
      }
    }
    assert.deepEqual(counts.slice(0, 2), [2, 4]);
    const [[people, answers, trials]] = query(log, "SELECT (SELECT count(*) FROM participants), count(*), count(DISTINCT trial_index) FROM answers");
    assert.deepEqual([people, answers], [1, trials]);
    assert.equal(answers, counts[2]);
    const days = query(log, "SELECT date(started_unix_s, 'unixepoch') FROM sessions ORDER BY session").flat();
    assert.deepEqual(days, ["2026-12-01", "2026-12-04", "2027-01-02"]);
  },
};

await tryLaws(laws, () => {});
