// Sessions that are broken off at random instants: reloads, closed tabs, a killed browser, a network that is cut, hosts
// that fail. No acknowledged answer is lost, none is there twice, and a finished stream has no gap.
//   robust.mjs COUNT SEED     disruptions in all (default 60), and which ones (default 1)
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, readlinkSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fakeServe, realServe, staticHost } from "./hosts.mjs";
import { jatosHost } from "./jatos.mjs";
import { act, look, openBrowser } from "./person.mjs";
import { checkWhole, messagesOf } from "./stream.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const folder = join(work, "tiny"); // and the kind of its host behind it
const count = Number(process.argv[2] ?? 60);
const BLANK_MS = 60000;
const PATIENCE_MS = 240000; // without any change on the screen; a busy machine is slow, but never still for so long
const tally = { reload: 0, close: 0, kill: 0, network: 0, host: 0 };
let sessions = 0;
let acknowledged = 0;
let resent = 0;
let by_hand = 0; // pages that stayed empty until somebody loaded them again

const HOSTS = {
  program: () =>
    realServe(process.env.SEAMLINE_PROGRAM, folder, join(work, "tiny-set"), join(mkdtempSync(join(work, "log-")), "log.sqlite")),
  serve: () => fakeServe(folder, { trouble: 0.1 }),
  jatos: () => jatosHost(folder, 0.15),
  static: () => staticHost(folder),
};

/** xorshift32: the same seed, the same disruptions, as far as a browser's own pace lets them be. */
let state = Math.imul(Number(process.argv[3] ?? 1), 2654435761) >>> 0 || 1;
function random() {
  state ^= state << 13;
  state ^= state >>> 17;
  state = (state ^ (state << 5)) >>> 0;
  return state / 2 ** 32;
}

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** What the browser keeps, as lines. */
const kept = (page) =>
  page.evaluate(async () => (await globalThis.seamline.store.messages()).map((message) => JSON.stringify(message)));

/** An enrolment at a server is kept as it was sent: without the code that the server gave. */
function named(line, participant) {
  const message = JSON.parse(line);
  return JSON.stringify(message.participant === "" ? { ...message, participant } : message);
}

async function session(kind) {
  const host = await HOSTS[kind]();
  const profile = mkdtempSync(join(work, "browser-"));
  let browser = await openBrowser(profile);
  let page = browser.pages()[0];
  let most = 0; // answers that the page has shown as acknowledged
  let participant = "";
  let here = 0;
  let address = host.address; // in JATOS a study link begins another run
  const open = async () => {
    page.on("dialog", (dialog) => dialog.accept().catch(() => {}));
    await page.goto(address, { waitUntil: "commit" });
  };

  const disrupt = {
    reload: () => page.reload({ waitUntil: "commit" }),
    async close() {
      const next = await browser.newPage();
      await page.close({ runBeforeUnload: random() < 0.5 });
      page = next;
      await open();
    },
    async kill() {
      // The browser's own process, by its profile's lock: as a crash would end it.
      const before = browser;
      const pid = Number(readlinkSync(join(profile, "SingletonLock")).split("-").pop());
      process.kill(pid, "SIGKILL");
      await before.close().catch(() => {});
      await sleep(300);
      browser = await openBrowser(profile);
      page = browser.pages()[0];
      await open();
    },
    async network() {
      await browser.setOffline(true);
      await sleep(50 + random() * 900);
      await browser.setOffline(false);
    },
    async host() {
      if (host.restart) return host.restart(random() * 700);
      const usual = host.trouble;
      host.trouble = 1;
      await sleep(50 + random() * 700);
      host.trouble = usual;
    },
  };
  const kinds = ["reload", "reload", "reload", "reload", "close", "close", "network", "network"];
  if (kind !== "static") kinds.push("host");
  if (kind === "program") kinds.push("host", "host");
  if (sessions % 4 === 0) kinds.push("kill");

  try {
    await open();
    let dueAt = Date.now() + random() * 700;
    let last = "";
    let movedAt = Date.now();
    for (;;) {
      if (page.url().endsWith("/start")) address = page.url();
      if (page.url().endsWith("/final/endPage.html")) break; // JATOS's own end
      const seen = await look(page).catch(() => null);
      const now = JSON.stringify([seen?.screen, seen?.phase, seen?.trial?.trial_index ?? seen?.trial?.training_index, seen?.pending]);
      if (now !== last) {
        last = now;
        movedAt = Date.now();
      }
      if (seen?.screen === "loading" && Date.now() > movedAt + BLANK_MS) {
        // What a person does with a page that stays empty.
        ++by_hand;
        movedAt = Date.now();
        await page.reload({ waitUntil: "commit" }).catch(() => {});
      }
      assert.ok(Date.now() < movedAt + PATIENCE_MS, "the session does not move: " + JSON.stringify(seen));
      if (seen?.participant) participant = seen.participant;
      if (seen && seen.screen !== "loading") most = Math.max(most, seen.answered);
      if (seen?.screen === "stopped") assert.fail("stopped: " + seen.message);
      if (seen?.screen === "thanks" && kind !== "jatos") break;
      if (Date.now() >= dueAt && here < 14) {
        const what = kinds[Math.floor(random() * kinds.length)];
        ++tally[what];
        ++here;
        await disrupt[what]().catch((error) => {
          if (!/net::|closed|Target|interrupted|ERR_/.test(String(error))) throw error;
        });
        dueAt = Date.now() + 50 + random() * 800;
        continue;
      }
      if (seen) await act(page, seen, { mouse: random() < 0.3 }).catch(() => {});
      await sleep(10);
    }
    const own = kind === "jatos" ? null : await kept(page);
    const lines = kind === "static" || kind === "program" ? own.map((line) => named(line, participant)) : host.lines;
    const messages = messagesOf(lines, participant);
    const there = host.where ? await host.where(await page.evaluate(() => globalThis.seamline.host.identity.secret)) : null;
    const slot = there ? there.slot : messages[0].body.slot;
    const order = JSON.parse(readFileSync(join(folder + "-serve", "orders", String(slot).padStart(4, "0") + ".json"), "utf8"));
    const answers = checkWhole(messages, order);
    assert.ok(answers.length >= most);
    if (there) {
      // What the log has, besides what the browser has.
      assert.deepEqual(there.answered, answers.map((answer) => answer.trial_index));
      assert.ok(there.completed);
      assert.equal(there.next_sequence, messages.length);
    }
    if (own) assert.equal(own.length, messages.length, "kept here and stored there");
    else assert.deepEqual(host.runs().map(({ state }) => state), ["FINISHED"]);
    acknowledged += answers.length;
    resent += lines.length - messages.length;
    ++sessions;
    await browser.close().catch(() => {});
    rmSync(profile, { recursive: true, force: true }); // kept where something is wrong
  } finally {
    await browser.close().catch(() => {});
    await host.stop();
  }
}

const done = () => Object.values(tally).reduce((sum, one) => sum + one, 0);
let failed = 0;
for (let turn = 0; done() < count && failed === 0; ++turn) {
  const kind = Object.keys(HOSTS)[turn % Object.keys(HOSTS).length];
  try {
    await session(kind);
    console.log("ok      %s; %d disruptions so far", kind, done());
  } catch (error) {
    ++failed;
    console.log("FAILED  %s\n%s", kind, error.stack);
  }
}
console.log("%d sessions, %d disruptions (%s), %d answers, %d lines arrived again, %d pages loaded again by hand", sessions, done(), JSON.stringify(tally), acknowledged, resent, by_hand);
process.exit(failed === 0 ? 0 : 1);
