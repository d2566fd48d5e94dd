// Every status from 400 to 599 once on every file and request of a visit, in the place of each kind of host, and on every kind of
// file for some time: nobody is stuck without a word, and nobody is told that an answer is stored that is not.
//   statuses.mjs FROM TO WORD     which ones (default 400 to 599), of the visits whose name has WORD
import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { join } from "node:path";
import { fakeServe, onTheWayTo, realServe, staticHost } from "./hosts.mjs";
import { jatosHost } from "./jatos.mjs";
import { act, chromium, look } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const folder = join(work, "tiny");
const [from, to] = [Number(process.argv[2] ?? 400), Number(process.argv[3] ?? 599)];
const AT_ONCE = 6;
const IN_A_ROW = 10; // statuses that a request is refused with before it passes
const PATIENCE_MS = 240000; // without any change on the screen
const STRANGER = "<!doctype html><title>Network login</title><p>Please log in to the network.";
const SENTENCE = "the host's own word";
/** 407: for a browser without a proxy of its own that is a broken connection. */
const LATER = [407, 408, 425, 429];
const isFinal = (status) => status < 500 && !LATER.includes(status);

const HOSTS = {
  static: () => staticHost(folder),
  jatos: () => jatosHost(folder, 0),
  serve: async () => {
    const log = join(mkdtempSync(join(work, "log-")), "log.sqlite");
    return process.env.SEAMLINE_PROGRAM ? onTheWayTo(await realServe(process.env.SEAMLINE_PROGRAM, folder, join(work, "tiny-set"), log)) : fakeServe(folder, { trouble: 0 });
  },
};

/** Waits of the page are a fiftieth as long, for there are twelve thousand of them. */
const HURRY = `{ const later = setTimeout; globalThis.setTimeout = (what, ms, ...more) => later(what, ms > 100 ? ms / 50 : ms, ...more); }`;

const words = (page) => page.evaluate(() => document.body?.innerText.trim() ?? "");
const kept = (page) => page.evaluate(async () => (await globalThis.seamline.store.messages()).map(({ kind, id }) => ({ kind, id })));

/** The ids of answers that the host has: of a static host, the browser's own disk. */
async function storedAnswers(host, page) {
  const answers = (messages) => messages.filter(({ kind }) => kind === "answer").length;
  if (host.where) return (await host.where(await page.evaluate(() => globalThis.seamline.host.identity.secret))).answered.length;
  if (host.lines) {
    const mine = new Set((await kept(page)).map(({ id }) => id));
    return new Set(host.lines.map((line) => JSON.parse(line)).filter(({ kind, id }) => kind === "answer" && mine.has(id)).map(({ id }) => id)).size;
  }
  return answers(await kept(page));
}

/** A visit until an answer is acknowledged, or the study has stopped; `waited(page)` sees the page from time to time. */
async function visit(browser, host, waited = () => {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  try {
    const page = await context.newPage();
    await page.addInitScript(HURRY);
    // What a person does where the browser shows somebody else's page, or its own.
    for (let loads = 0; loads < 4 * IN_A_ROW; ++loads) {
      if (loads === 0) await page.goto(host.address, { waitUntil: "domcontentloaded" }).catch(() => {});
      else await page.reload({ waitUntil: "domcontentloaded" }).catch(() => {});
      if ((await page.locator("#study").count()) > 0) break;
    }
    let last = "";
    let movedAt = Date.now();
    for (;;) {
      const seen = await look(page).catch(() => null); // the page loads itself again
      const now = JSON.stringify([seen?.screen, seen?.phase, seen?.trial?.trial_index ?? seen?.trial?.training_index, seen?.pending]);
      if (now !== last) [last, movedAt] = [now, Date.now()];
      assert.ok(Date.now() < movedAt + PATIENCE_MS, "stuck at " + now);
      if (seen && ["stopped", "refused"].includes(seen.screen)) return { page, context, seen };
      if (seen && seen.answered > 0 && !seen.pending) return { page, context, seen };
      if (seen) await act(page, seen).catch(() => {});
      await waited(page);
      await page.waitForTimeout(20);
    }
  } catch (error) {
    await context.close();
    throw error;
  }
}

/** Once each: whatever the statuses, the visit goes on, at the same host, and what the page counts as answered is there. */
async function once(browser, kind, statuses) {
  const host = await HOSTS[kind]();
  const left = new Map(); // by request
  let refused = 0;
  host.instead = (method, path) => {
    const request = method + " " + path.replace(/[0-9a-f-]{36}/g, "RUN"); // each study link begins a run
    if (!left.has(request)) left.set(request, [...statuses]);
    const status = left.get(request).shift();
    if (status === undefined) return null;
    ++refused;
    return { status, body: STRANGER };
  };
  try {
    const { page, context, seen } = await visit(browser, host);
    assert.equal(seen.screen, "trial", await words(page));
    assert.equal(await page.evaluate(() => globalThis.seamline.host.kind), kind);
    assert.ok((await storedAnswers(host, page)) >= seen.answered, "an answer that the host does not have");
    await context.close();
    return refused;
  } finally {
    await host.stop();
  }
}

/** The server's own refusals, one after another, on a page that is loaded again: final ones are said, and what has not arrived can be saved; others pass. */
async function ownWords(browser, path, statuses) {
  const host = await HOSTS.serve();
  let status = statuses[0];
  host.instead = (method, asked) => (asked === path && status !== null ? { status, type: "application/json", body: JSON.stringify({ error: SENTENCE + " " + status }) } : null);
  try {
    const { page, context } = await visit(browser, host);
    for (status of statuses) {
      await page.reload({ waitUntil: "domcontentloaded" });
      await page.waitForFunction((sentence) => document.body.innerText.includes(sentence), SENTENCE + " " + status, { timeout: PATIENCE_MS });
      const said = await words(page);
      assert.equal((await look(page)).screen, "stopped", said);
      assert.doesNotMatch(said, /\bsafe\b|answers are stored|connection is lost/);
      assert.equal(await page.locator("#save").count(), path === "/api/messages" ? 1 : 0, said);
    }
    status = null;
    await page.reload({ waitUntil: "domcontentloaded" });
    await page.waitForFunction(() => ["form", "display", "instructions"].includes(globalThis.seamline?.visit?.screen.name), null, { timeout: PATIENCE_MS });
    await context.close();
    return statuses.length;
  } finally {
    await host.stop();
  }
}

/** For as long as it lasts it is said, and then the visit goes on. */
async function forAWhile(browser, kind, part, { status, body }) {
  const host = await HOSTS[kind]();
  let saidAt = null;
  let heard = "";
  host.instead = (method, path) => (saidAt === null && path.includes(part) ? { status, body } : null);
  try {
    const { page, context, seen } = await visit(browser, host, async (page) => {
      heard = await words(page).catch(() => "");
      if (/being loaded|network is: .*(HTTP|not )|connection is lost/.test(heard)) saidAt ??= Date.now();
    });
    assert.equal(seen.screen, "trial", await words(page));
    assert.ok(saidAt !== null, "no word while " + part + " was refused: " + heard);
    await context.close();
  } finally {
    await host.stop();
  }
}

const jobs = [];
const wanted = Array.from({ length: to - from + 1 }, (_, at) => from + at);
/** In rows of IN_A_ROW. */
const rows = (statuses) => Array.from({ length: Math.ceil(statuses.length / IN_A_ROW) }, (_, at) => statuses.slice(at * IN_A_ROW, (at + 1) * IN_A_ROW));
for (const statuses of rows(wanted))
  for (const kind of Object.keys(HOSTS)) jobs.push([`${statuses[0]} to ${statuses.at(-1)} on everything, ${kind}`, (browser) => once(browser, kind, statuses)]);
for (const statuses of rows(wanted.filter(isFinal)))
  for (const path of ["/api/enrol", "/api/messages"])
    jobs.push([`${statuses[0]} to ${statuses.at(-1)} by the server itself, ${path}`, (browser) => ownWords(browser, path, statuses)]);
for (const kind of Object.keys(HOSTS)) {
  const parts = ["/jspsych.js", "/seamline.js", "/seamline.css", "/study.json", "/orders/", "/pictures/", "/maps/"];
  if (kind === "jatos") parts.push("/jatos.js", "/resultData");
  if (kind === "serve") parts.push("/api/enrol", "/api/messages");
  for (const part of parts)
    for (const answer of [{ status: 403, body: STRANGER }, { status: 404, body: STRANGER }, { status: 429, body: "" }, { status: 503, body: "" }, { status: 200, body: STRANGER }]) {
      if (answer.status === 200 && /\.(js|css)$|resultData/.test(part)) continue; // a login page in place of a script: the words of the first page stand
      if (answer.status < from || answer.status > to) continue;
      jobs.push([`${answer.status} for a while on ${part}, ${kind}`, (browser) => forAWhile(browser, kind, part, answer)]);
    }
}

const browser = await chromium.launch({ executablePath: process.env.SEAMLINE_CHROMIUM, headless: true });
let failed = 0;
let passed = 0;
let refusals = 0;
async function worker() {
  for (let job = jobs.shift(); job; job = jobs.shift()) {
    const [name, work_on] = job;
    if (!name.includes(process.argv[4] ?? "")) continue;
    try {
      const count = await work_on(browser);
      refusals += count ?? 1;
      ++passed;
      if (passed % 10 === 0) console.log("%d visits so far", passed);
    } catch (error) {
      ++failed;
      console.log("FAILED  %s\n%s", name, error.stack);
    }
  }
}
await Promise.all(Array.from({ length: AT_ONCE }, worker));
await browser.close();
console.log("%d visits came to their answer or to a word, %d did not; %d requests refused", passed, failed, refusals);
process.exit(failed === 0 ? 0 : 1);
