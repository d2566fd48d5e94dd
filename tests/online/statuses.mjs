// Every status from 400 to 599 once on every file and request of a visit, in the place of each kind of host, and on every kind of
// file for some time: nobody is stuck without a word, and nobody is told that an answer is stored that is not.
//   statuses.mjs FROM TO     which ones (default 400 to 599)
import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { join } from "node:path";
import { fakeServe, jatosHost, onTheWayTo, realServe, staticHost } from "./hosts.mjs";
import { act, chromium, look } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const folder = join(work, "tiny");
const [from, to] = [Number(process.argv[2] ?? 400), Number(process.argv[3] ?? 599)];
const AT_ONCE = 6;
const PATIENCE_MS = 120000; // without any change on the screen
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

/** Waits of the page are an eighth as long: two hundred statuses, each on twenty requests. */
const HURRY = `{ const later = setTimeout; globalThis.setTimeout = (what, ms, ...more) => later(what, ms > 300 ? ms / 8 : ms, ...more); }`;

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
    for (let loads = 0; loads < 5; ++loads) {
      await page.goto(host.address, { waitUntil: "domcontentloaded" }).catch(() => {});
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

/** Once each: whatever the status, the visit goes on, at the same host, and what the page counts as answered is there. */
async function once(browser, kind, status) {
  const host = await HOSTS[kind]();
  const refused = new Set();
  host.instead = (method, path) => {
    const request = method + " " + path;
    if (refused.has(request)) return null;
    refused.add(request);
    return { status, body: STRANGER };
  };
  try {
    const { page, context, seen } = await visit(browser, host);
    assert.equal(seen.screen, "trial", await words(page));
    assert.equal(await page.evaluate(() => globalThis.seamline.host.kind), kind);
    assert.ok((await storedAnswers(host, page)) >= seen.answered, "an answer that the host does not have");
    await context.close();
    return refused.size;
  } finally {
    await host.stop();
  }
}

/** The server's own refusal: final ones are said, and what has not arrived can be saved; others pass. */
async function ownWord(browser, path, status) {
  const host = await HOSTS.serve();
  let left = 1;
  // The last request of the list is an answer, so that one can be missing.
  host.instead = (method, asked) => (asked === path && left-- === 1 ? { status, type: "application/json", body: JSON.stringify({ error: SENTENCE }) } : null);
  try {
    const { page, context, seen } = await visit(browser, host);
    const said = await words(page);
    assert.equal(seen.screen, isFinal(status) ? "stopped" : "trial", said);
    if (isFinal(status)) {
      assert.ok(said.includes(SENTENCE), said);
      assert.doesNotMatch(said, /\bsafe\b|answers are stored|connection is lost/);
      assert.equal(await page.locator("#save").count(), path === "/api/messages" ? 1 : 0, said);
    }
    await context.close();
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
for (const kind of Object.keys(HOSTS))
  for (let status = from; status <= to; ++status) jobs.push([`${status} once on everything, ${kind}`, (browser) => once(browser, kind, status)]);
for (const path of ["/api/enrol", "/api/messages"])
  for (let status = from; status <= to; ++status) jobs.push([`${status} by the server itself, ${path}`, (browser) => ownWord(browser, path, status)]);
for (const kind of Object.keys(HOSTS)) {
  const parts = ["/jspsych.js", "/seamline.js", "/seamline.css", "/study.json", "/orders/", "/pictures/", "/maps/"];
  if (kind === "jatos") parts.push("/jatos.js", "/append");
  if (kind === "serve") parts.push("/api/enrol", "/api/messages");
  for (const part of parts)
    for (const answer of [{ status: 403, body: STRANGER }, { status: 404, body: STRANGER }, { status: 429, body: "" }, { status: 503, body: "" }, { status: 200, body: STRANGER }]) {
      if (answer.status === 200 && /\.(js|css)$|append/.test(part)) continue; // a login page in place of a script: the words of the first page stand
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
    try {
      const count = await work_on(browser);
      refusals += count ?? 1;
      ++passed;
      if (passed % 50 === 0) console.log("%d visits so far", passed);
    } catch (error) {
      ++failed;
      console.log("FAILED  %s\n%s", name, error.stack);
    }
  }
}
await Promise.all(Array.from({ length: AT_ONCE }, worker));
await browser.close();
console.log("%d visits came to their answer or to a word, %d did not; %d requests refused once", passed, failed, refusals);
process.exit(failed === 0 ? 0 : 1);
