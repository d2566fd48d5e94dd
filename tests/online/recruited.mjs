// People from a panel: matched, screened, counted, sent back with a code. The panel is a stand-in that does what
// Prolific's public documentation says of its own: it fills {{%PROLIFIC_PID%}}, {{%STUDY_ID%}} and {{%SESSION_ID%}} into
// the study's address, and takes people back at /submissions/complete?cc=CODE, where the code decides what becomes of
// the submission. Screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { listening } from "./hosts.mjs";
import { tryLaws } from "./try_laws.mjs";
import { actUntil, axeSource, look, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });

const ACTIONS = { "SEAM-OK": "approved", "SEAM-NO": "returned", "SEAM-OUT": "screened out", "SEAM-FULL": "full", "SEAM-FAIL": "rejected" };

/** The panel. `study` is the study's address with the documented places in it. */
async function panelOf(study) {
  const submissions = new Map();
  const host = await listening((request, response, path) => {
    const query = new URL(request.url, "http://x").searchParams;
    if (path === "/open") {
      const pid = query.get("pid");
      if (!submissions.has(pid)) submissions.set(pid, "active");
      const address = study().replace("{{%PROLIFIC_PID%}}", pid).replace("{{%STUDY_ID%}}", "study-1").replace("{{%SESSION_ID%}}", "session-" + pid);
      response.writeHead(302, { Location: address, "Set-Cookie": "pid=" + pid + "; Path=/" }).end();
    } else if (path === "/submissions/complete") {
      const pid = /pid=([^;]+)/.exec(request.headers.cookie ?? "")?.[1];
      submissions.set(pid, ACTIONS[query.get("cc")] ?? "unknown code");
      host.referers.push(request.headers.referer ?? null);
      response.writeHead(200, { "Content-Type": "text/html" }).end("<h1>Back at the panel</h1>");
    } else response.writeHead(404).end();
  });
  return Object.assign(host, { submissions, referers: [] });
}

async function violations(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return violations.map(({ id, nodes }) => id + ": " + nodes.map((node) => node.html).join(" | "));
}

/** Serves the set, and says its address; `say` has every line. */
async function served(folder, log, more = []) {
  const process = spawn(program, ["serve", join(folder, "page"), "--log", log, "--set", join(folder, "set"), "--port", "0", ...more], { stdio: ["ignore", "pipe", "inherit"] });
  const said = [];
  const address = await new Promise((resolve, reject) => {
    process.stdout.on("data", (bytes) => {
      said.push(String(bytes));
      const found = /at (http:\S+)/.exec(said.join(""));
      if (found) resolve(found[1]);
    });
    process.on("exit", () => reject(new Error("the server ended: " + said.join(""))));
  });
  return { address, said, stop: () => new Promise((resolve) => (process.on("exit", resolve), process.kill("SIGTERM"))) };
}

const folder = mkdtempSync(join(work, "recruited-"));
const log = join(folder, "log.sqlite");
let server;
const panel = await panelOf(() => server.address + "?PROLIFIC_PID={{%PROLIFIC_PID%}}&STUDY_ID={{%STUDY_ID%}}&SESSION_ID={{%SESSION_ID%}}");
cpSync(join(work, "tiny-set"), join(folder, "set"), { recursive: true });
const file = join(folder, "set", "study.toml");
writeFileSync(file, readFileSync(file, "utf8") + `
[recruitment]
identifiers = ["PROLIFIC_PID", "STUDY_ID", "SESSION_ID"]
return_link = "http://localhost:${new URL(panel.address).port}/submissions/complete?cc={code}"
least_attention = 1
most_people = 7
[recruitment.codes]
finished = "SEAM-OK"
declined = "SEAM-NO"
screened_out = "SEAM-OUT"
full = "SEAM-FULL"
failed_attention = "SEAM-FAIL"
[[recruitment.screen]]
field = "age"
least = 18
most = 65
[[recruitment.quota]]
field = "technical_background"
answers = ["yes"]
most_people = 1
`);
execFileSync(program, ["export", "web", join(folder, "set"), join(folder, "page"), "--serve"]);
const secretFile = join(folder, "secret");
server = await served(folder, log, ["--watch", secretFile]);

const answers = (choice) => ({ answer: () => ({ choice, rating: 2 }) });

/** Somebody the panel sends; `visit` gets the page at the consent. */
async function sent(pid, visit) {
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
  try {
    const page = browser.pages()[0];
    await page.goto(panel.address + "open?pid=" + pid);
    return await visit(page);
  } finally {
    await browser.close();
  }
}

async function arrive(page, label) {
  await page.waitForSelector("#completion");
  await page.waitForTimeout(150);
  writeFileSync(join(shots, "recruited-" + label + ".png"), await page.screenshot());
  assert.deepEqual(await violations(page), [], label);
  await page.keyboard.press("Enter"); // the way back has the focus
  await page.waitForSelector("h1:has-text('Back at the panel')");
}

/** The form by hand: an age, and the last or the first answer of the last question. */
async function fill(page, age, last) {
  await actUntil(page, ["form"]);
  await page.locator("#study input.number").first().fill(String(age));
  const groups = await page.locator("#study fieldset").all();
  for (const group of groups) await group.locator("label.option").first().click();
  const options = await groups.at(-1).locator("label.option").all();
  await options.at(last ? -1 : 0).click();
  await page.click("#submit");
}

const laws = {
  async "who declines goes back with that code, and nothing is kept of them"() {
    await sent("pid-declines", async (page) => {
      await page.click("#decline");
      await arrive(page, "declined");
    });
    assert.equal(panel.submissions.get("pid-declines"), "returned");
  },
  async "who finishes goes back as attentive or not, as the log says"() {
    for (const choice of [2, 3, 1])
      await sent("pid-" + choice, async (page) => {
        await fill(page, 33, true);
        await actUntil(page, ["thanks"], { patience_ms: 120000, ...answers(choice) });
        await page.reload(); // the end stays
        await arrive(page, "finished-" + choice);
      });
    const status = execFileSync(program, ["log", "status", log], { encoding: "utf8" });
    const attentive = [...status.matchAll(/attention 1 of 1/g)].length;
    assert.ok(attentive > 0 && attentive < 3, status);
    const ends = [1, 2, 3].map((choice) => panel.submissions.get("pid-" + choice));
    assert.equal(ends.filter((end) => end === "approved").length, attentive, status);
    assert.equal(ends.filter((end) => end === "rejected").length, 3 - attentive);
  },
  async "whose form does not fit is sent back, also after a reload"() {
    await sent("pid-old", async (page) => {
      await fill(page, 80, true);
      await page.waitForSelector("#completion");
      await page.reload();
      await arrive(page, "screened-out");
    });
    assert.equal(panel.submissions.get("pid-old"), "screened out");
  },
  async "a quota that is reached sends the next one back"() {
    await sent("pid-quota-1", async (page) => {
      await fill(page, 30, false);
      await actUntil(page, ["trial"], { patience_ms: 60000 });
    });
    await sent("pid-quota-2", async (page) => {
      await fill(page, 30, false);
      await arrive(page, "quota");
    });
    assert.equal(panel.submissions.get("pid-quota-2"), "full");
  },
  async "a second browser of the same person is refused, and a link without a number"() {
    await sent("pid-1", async (page) => {
      await page.click("#accept");
      await page.waitForFunction(() => document.querySelector("h1")?.textContent === "The study ends here");
      writeFileSync(join(shots, "recruited-again.png"), await page.screenshot());
      assert.match(await page.textContent("#study"), /taken part already/);
    });
    const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
    const page = browser.pages()[0];
    await page.goto(server.address);
    await page.waitForSelector("#study .card");
    assert.match(await page.textContent("#study"), /PROLIFIC_PID is missing/);
    await browser.close();
  },
  async "the experimenter sees who is on, and no identifier"() {
    const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
    const page = browser.pages()[0];
    await page.goto(server.address + "watch");
    await page.waitForSelector("#secret");
    assert.deepEqual(await violations(page), []);
    await page.fill("#secret", "0".repeat(64));
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.querySelector("#said").textContent.includes("not the secret"));
    await page.fill("#secret", readFileSync(secretFile, "utf8").trim());
    await page.keyboard.press("Enter");
    await page.waitForSelector("#people tbody tr");
    await page.waitForTimeout(200);
    writeFileSync(join(shots, "recruited-watch.png"), await page.screenshot({ fullPage: true }));
    assert.deepEqual(await violations(page), []);
    const words = await page.textContent("main");
    assert.ok(!words.includes("pid-") && words.includes("screened out") && words.includes("401 /api/watch"), words);
    await page.emulateMedia({ colorScheme: "dark" });
    writeFileSync(join(shots, "recruited-watch-dark.png"), await page.screenshot({ fullPage: true }));
    assert.deepEqual(await violations(page), []);
    await browser.close();
  },
  async "enough people: the next one is refused at the door, with the code"() {
    await server.stop();
    writeFileSync(file, readFileSync(file, "utf8").replace("most_people = 7", "most_people = 1").replace("SEAM-FULL", "SEAM-NO"));
    server = await served(folder, log); // a code was changed, and the page is the same
    await sent("pid-late", async (page) => {
      await page.click("#accept");
      await arrive(page, "door");
    });
    assert.equal(panel.submissions.get("pid-late"), "returned");
    await server.stop();
  },
  async "ids are matched, and gone when somebody is forgotten"() {
    const csv = join(folder, "ids.csv");
    execFileSync(program, ["log", "identifiers", log, csv]);
    const lines = readFileSync(csv, "utf8").trim().split("\n").map((line) => line.split(","));
    assert.deepEqual(lines[0], ["participant", "outcome", "completion_code", "PROLIFIC_PID", "SESSION_ID", "STUDY_ID"]);
    const of = (pid) => lines.find((line) => line[3] === pid);
    for (const pid of ["pid-1", "pid-2", "pid-3", "pid-old", "pid-quota-1", "pid-quota-2"]) {
      assert.equal(of(pid)[4], "session-" + pid);
      const word = { approved: "finished", rejected: "failed_attention", "screened out": "screened_out", full: "full", active: "" };
      assert.equal(of(pid)[1], word[panel.submissions.get(pid)]);
    }
    assert.equal(lines.length, 7);
    execFileSync(program, ["log", "forget", log, of("pid-old")[0]]);
    const left = readFileSync(log + "-recruits").toString("latin1") + readFileSync(log).toString("latin1");
    assert.ok(!left.includes("pid-old") && !left.includes(of("pid-old")[0]));
    assert.ok(!readFileSync(log).toString("latin1").includes("pid-"), "no identifier is in the log");
    execFileSync(program, ["log", "forget-identifiers", log]);
    assert.ok(!readFileSync(log + "-recruits").toString("latin1").includes("pid-"));
    assert.ok(panel.referers.every((referer) => referer === null), "the panel is not told where people come from");
  },
};

await tryLaws(laws, () => panel.stop());
