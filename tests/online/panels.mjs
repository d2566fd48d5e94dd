// SONA and MTurk, by stand-ins. SONA's does what our recipe says (no public documentation of it was found), MTurk's opens a tab
// where MTurk itself shows a frame. SONA puts a number into the study's address where it says
// %SURVEY_CODE%, and gives credit to the number with which webstudy_credit.aspx is called. MTurk appends assignmentId, hitId, workerId and
// turkSubmitTo, without a workerId in a preview, and takes a code that the worker copies. Screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { listening, realServe } from "./hosts.mjs";
import { tryLaws } from "./try_laws.mjs";
import { actUntil, axeSource, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });

/** A study served with a [recruitment] of its own; `identifiers()` is what the log says of people, the head first. */
async function servedWith(recruitment) {
  const folder = mkdtempSync(join(work, "panels-"));
  const set = join(folder, "set");
  cpSync(join(work, "tiny-set"), set, { recursive: true });
  writeFileSync(join(set, "study.toml"), readFileSync(join(set, "study.toml"), "utf8") + "\n[recruitment]\n" + recruitment);
  execFileSync(program, ["export", "web", set, join(folder, "page-serve"), "--serve"]);
  const log = join(folder, "log.sqlite");
  const server = await realServe(program, join(folder, "page"), set, log);
  const identifiers = () => {
    execFileSync(program, ["log", "identifiers", log, join(folder, "ids.csv")]);
    return readFileSync(join(folder, "ids.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  };
  return { server, identifiers };
}

async function inBrowser(address, visit) {
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
  try {
    const page = browser.pages()[0];
    await page.goto(address);
    return await visit(page);
  } finally {
    await browser.close();
  }
}

async function atTheEnd(page, label) {
  await actUntil(page, ["thanks"], { patience_ms: 120000 });
  await page.waitForSelector("#completion");
  writeFileSync(join(shots, "panels-" + label + ".png"), await page.screenshot());
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  assert.deepEqual(violations.map(({ id }) => id), [], label);
  return page.textContent("#completion");
}

async function sona() {
  const credited = [];
  const host = await listening((request, response, path) => {
    const query = new URL(request.url, "http://x").searchParams;
    if (path === "/webstudy_credit.aspx" && query.get("experiment_id") === "17" && query.get("credit_token") === "T0KEN") credited.push(query.get("survey_code"));
    response.writeHead(200, { "Content-Type": "text/html" }).end("<h1>SONA</h1>");
  });
  const back = `http://localhost:${new URL(host.address).port}/webstudy_credit.aspx?experiment_id=17&credit_token=T0KEN&survey_code={survey_code}`;
  const { server, identifiers } = await servedWith(`identifiers = ["survey_code"]\nreturn_link = "${back}"\n[recruitment.codes]\nfinished = "done"\n`);
  await inBrowser((server.address + "?survey_code=%SURVEY_CODE%").replace("%SURVEY_CODE%", "48151"), async (page) => {
    await atTheEnd(page, "sona");
    await page.keyboard.press("Enter");
    await page.waitForSelector("h1:has-text('SONA')");
  });
  await server.stop();
  await host.stop();
  assert.deepEqual(credited, ["48151"]);
  const [head, ...rows] = identifiers();
  assert.deepEqual(rows.map((row) => [row[head.indexOf("survey_code")], row[head.indexOf("outcome")]]), [["48151", "finished"]]);
}

async function mturk() {
  const { server, identifiers } = await servedWith(`identifiers = ["workerId", "assignmentId"]\n[recruitment.codes]\nfinished = "SEAM-{random}"\n`);
  const appended = (more) => server.address + "?" + new URLSearchParams({ hitId: "HIT1", turkSubmitTo: "https://www.mturk.com/", ...more });
  await inBrowser(appended({ assignmentId: "ASSIGNMENT_ID_NOT_AVAILABLE" }), async (page) => {
    await page.waitForSelector("#study .card");
    assert.match(await page.textContent("#study"), /workerId is missing/);
  });
  const codes = {};
  for (const workerId of ["WORKER1", "WORKER2"])
    codes[workerId] = await inBrowser(appended({ workerId, assignmentId: "A-" + workerId }), (page) => atTheEnd(page, "mturk"));
  await server.stop();
  const [head, ...rows] = identifiers();
  const value = (row, name) => row[head.indexOf(name)];
  assert.equal(new Set(rows.map((row) => value(row, "completion_code"))).size, 2, "each has a code of their own");
  for (const row of rows) {
    assert.match(value(row, "completion_code"), /^SEAM-[A-Za-z0-9]{8}$/);
    assert.ok(codes[value(row, "workerId")].includes(value(row, "completion_code")), codes[value(row, "workerId")]);
    assert.equal(value(row, "assignmentId"), "A-" + value(row, "workerId"));
  }
}

const laws = { sona, mturk };
await tryLaws(process.argv[2] ? { [process.argv[2]]: laws[process.argv[2]] } : laws);
