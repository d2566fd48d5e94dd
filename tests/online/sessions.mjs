// Whole sessions by real clicks and keys, on the three hosts that a page can have.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fakeServe, onTheWayTo, realServe, staticHost } from "./hosts.mjs";
import { jatosHost } from "./jatos.mjs";
import { actUntil, look, openBrowser } from "./person.mjs";
import { checkWhole, messagesOf } from "./stream.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const folderOf = (study) => join(work, study); // and the kind of its host behind it
const orderOf = (study, slot) =>
  JSON.parse(readFileSync(join(folderOf(study) + "-serve", "orders", String(slot).padStart(4, "0") + ".json"), "utf8"));

/** A browser of its own for a visit; fails when the page complained or asked anybody else for anything. */
async function visiting(address, work_with, options = {}) {
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), options);
  const complaints = [];
  try {
    const page = browser.pages()[0] ?? (await browser.newPage());
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("console", (message) => {
      const expected = /Failed to load resource/.test(message.text()); // host.json of a static host, failures of a bad one
      if (message.type() === "error" && !expected) complaints.push(message.text());
    });
    page.on("request", (request) => {
      if (!request.url().startsWith(new URL(address).origin) && !request.url().startsWith("blob:")) complaints.push(request.url());
    });
    page.on("dialog", (dialog) => dialog.accept());
    await page.goto(address);
    const result = await work_with(page, browser);
    assert.deepEqual(complaints, []);
    return result;
  } finally {
    await browser.close();
  }
}

/** `seamline import` takes a file of lines, once, and says that nothing is missing; twice changes nothing. */
function importLines(lines) {
  const folder = mkdtempSync(join(work, "import-"));
  const file = join(folder, "lines.jsonl");
  writeFileSync(file, lines.join("\n") + "\n");
  const log = join(folder, "log.sqlite");
  const run = () => execFileSync(process.env.SEAMLINE_PROGRAM, ["import", log, file, "--set", join(work, "tiny-set")], { encoding: "utf8" });
  const said = run();
  run();
  const status = execFileSync(process.env.SEAMLINE_PROGRAM, ["log", "status", log], { encoding: "utf8" });
  return { said, status };
}

const tests = {
  async "a static host: by the mouse, and the answers as a file"() {
    const host = await staticHost(folderOf("tiny"));
    await visiting(host.address, async (page) => {
      const seen = await actUntil(page, ["thanks"], { mouse: true });
      const asked = await page.textContent("#study");
      assert.match(asked, /on this computer only. Save them/);
      assert.doesNotMatch(asked, /are stored|experimenter/, "nobody has the answers yet");
      const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
      assert.equal(download.suggestedFilename(), seen.participant + ".jsonl");
      await page.getByText("Please tell the experimenter").waitFor(); // once they are saved
      assert.match(seen.participant, /^w-[a-z2-7]{16}$/);
      const messages = messagesOf(readFileSync(await download.path(), "utf8").trimEnd().split("\n"), seen.participant);
      assert.equal(messages[0].body.origin, "static");
      checkWhole(messages, orderOf("tiny", messages[0].body.slot));
      console.log("  " + importLines(messages.map((message) => JSON.stringify(message))).status.trim().split("\n").join("\n  "));
      // Reopened, it is still over, and the answers can still be saved.
      await page.reload();
      await actUntil(page, ["thanks"]);
      assert.ok(await page.locator("#save").isVisible());
    });
    await host.stop();
  },

  async "a server that fails at random: by keys alone"() {
    const host = await fakeServe(folderOf("tiny"), { trouble: 0.3 });
    await visiting(host.address, async (page) => {
      const seen = await actUntil(page, ["thanks"], { patience_ms: 120000 });
      assert.equal(seen.participant, "s-1");
      checkWhole(messagesOf(host.lines, "s-1"), orderOf("tiny", 0));
    });
    await host.stop();
  },

  async "seamline serve itself, and an adaptive study that it places"() {
    for (const study of ["tiny", "adaptive"]) {
      const host = await realServe(process.env.SEAMLINE_PROGRAM, folderOf(study), join(work, study + "-set"), join(mkdtempSync(join(work, "log-")), "log.sqlite"));
      await visiting(host.address, async (page) => {
        await actUntil(page, ["trial"], { patience_ms: 120000 });
        await page.reload();
        await actUntil(page, ["thanks"], { patience_ms: 120000, mouse: true });
        const lines = await page.evaluate(async () => (await globalThis.seamline.store.messages()).map((one) => JSON.stringify(one)));
        const secret = await page.evaluate(() => globalThis.seamline.host.identity.secret);
        const { participant, slot, completed, answered } = await host.where(secret);
        const messages = lines.map((line) => JSON.parse(line)).map((one, at) => (at === 0 ? { ...one, participant } : one));
        const answers = checkWhole(messages, study === "tiny" ? orderOf(study, slot) : null);
        assert.equal(completed, true);
        assert.deepEqual(answered, answers.map((answer) => answer.trial_index));
        assert.deepEqual(await host.health(), { status: "ok", participants: 1, answers: answers.length });
      });
      await host.stop();
    }
  },

  async "an adaptive study: the server places the trials"() {
    const next = (answers, study) => {
      const { id, file } = study.stimuli[(answers.length * 5) % study.stimuli.length];
      return answers.length < 7 ? { trial_index: answers.length, kind: "stimulus", stimulus_id: id, picture: file } : null;
    };
    const host = await fakeServe(folderOf("adaptive"), { trouble: 0.2, next });
    await visiting(host.address, async (page) => {
      await actUntil(page, ["thanks"], { patience_ms: 120000 });
      assert.equal(checkWhole(messagesOf(host.lines, "s-1"), null).length, 7);
    });
    await host.stop();
  },

  async "who declines leaves nothing behind"() {
    const host = await fakeServe(folderOf("tiny"), { trouble: 0 });
    await visiting(host.address, async (page) => {
      await actUntil(page, ["consent"], {});
      await page.click("#decline");
      await page.waitForFunction(() => globalThis.seamline.visit.screen.name === "declined");
      assert.equal(host.lines.length, 0);
      await page.reload();
      await actUntil(page, ["consent"], {});
    });
    await host.stop();
  },

  async "Enter alone agrees to nothing; wrong answers of the form are said and stay"() {
    const host = await staticHost(folderOf("tiny"));
    await visiting(host.address, async (page) => {
      await actUntil(page, ["consent"], {});
      await page.keyboard.press("Enter");
      await page.waitForTimeout(200);
      assert.equal((await look(page)).screen, "consent");
      await page.click("#accept");
      await actUntil(page, ["form"], {});
      await page.locator("#study input.number").fill("seven");
      await page.click("#submit");
      await page.waitForTimeout(100);
      assert.equal((await look(page)).screen, "form");
      const said = await page.locator(".problem:visible").allTextContents();
      assert.equal(said.length, 4);
      assert.match(said[0], /number/);
      await page.locator("#study input.number").fill("12");
      assert.match(await page.locator(".problem").first().textContent(), /from 18 to 120/);
      await page.locator("#study input.number").fill("33");
      assert.ok(await page.locator(".problem").first().isHidden());
    });
    await host.stop();
  },

  async "whatever file the network loses, the page comes"() {
    for (const kind of ["static", "jatos"]) {
      const host = kind === "static" ? await staticHost(folderOf("tiny")) : await jatosHost(folderOf("tiny"), 0);
      const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
      const files = ["jspsych.js", "seamline.js", "seamline.css", "study.json"];
      for (const file of kind === "jatos" ? ["jatos.js", "study.json"] : files) {
        const page = await browser.newPage();
        let lost = 0;
        await page.route("**/" + file, (route) => (lost++ === 0 ? route.abort("internetdisconnected") : route.continue()));
        await page.goto(host.address);
        for (let i = 0; lost < 2; ++i) {
          assert.ok(i < 200, file + " is not asked for again");
          await page.waitForTimeout(100);
        }
        await page.waitForSelector("#accept", { timeout: 20000 });
        assert.equal(await page.evaluate(() => globalThis.seamline.host.kind), kind, "without " + file);
        assert.equal(await page.evaluate(() => getComputedStyle(document.body).margin), "0px", "styled without " + file);
        await page.close();
      }
      await browser.close();
      await host.stop();
    }
  },

  async "whatever file a login page stands in for, the page comes"() {
    const host = await staticHost(folderOf("tiny"));
    const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
    for (const [file, instead] of [["jspsych.js"], ["seamline.js"], ["seamline.css"], ["study.json"], ["study.json", "{}"], ["orders/*.json", "{}"], ["maps/*.json", "{}"]]) {
      const page = await browser.newPage();
      const other = instead ? { body: instead, contentType: "application/json" } : { body: "<!doctype html><title>Login</title>Please log in.", contentType: "text/html" };
      let asked = 0;
      await page.route("**/" + file, (route) => (asked++ === 0 ? route.fulfill({ status: 200, ...other }) : route.continue()));
      await page.goto(host.address);
      await actUntil(page, [file.includes("/") ? "trial" : "consent"], {});
      assert.ok(asked >= 2, file + " is not asked for again");
      assert.equal(await page.evaluate(() => getComputedStyle(document.body).margin), "0px", "styled without " + file);
      await page.evaluate(() => indexedDB.databases().then((all) => all.forEach(({ name }) => indexedDB.deleteDatabase(name))));
      await page.close();
    }
    await browser.close();
    await host.stop();
  },

  async "a visit that was begun at another kind of host does not go on, says so, and can be saved"() {
    const host = await fakeServe(folderOf("tiny"), { trouble: 0 });
    await visiting(host.address, async (page) => {
      const { participant } = await actUntil(page, ["trial"], {});
      const study = await page.evaluate(async () => (await fetch("study.json")).json());
      const other = JSON.stringify({ ...study, host: "static" });
      host.instead = (method, path) => (path === "/study.json" ? { status: 200, type: "application/json", body: other } : null);
      const before = host.lines.length;
      await page.reload();
      await actUntil(page, ["stopped"], {});
      assert.match(await page.textContent("#study"), /wanted seamline serve, found a host of files/);
      const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
      assert.equal(download.suggestedFilename(), participant + ".jsonl");
      const saved = messagesOf(readFileSync(await download.path(), "utf8").trimEnd().split("\n"), participant);
      assert.ok(saved.length > 2 && saved.every((message) => message.kind !== "enrol"), "a server has the enrolments of its own");
      assert.equal(host.lines.length, before);
      host.instead = null;
      await page.reload();
      await actUntil(page, ["thanks"], {});
    });
    await host.stop();
  },

  async "what a server would not have arrives by the file that its page saves"() {
    const log = join(mkdtempSync(join(work, "log-")), "log.sqlite");
    const set = join(work, "tiny-set");
    const host = await onTheWayTo(await realServe(process.env.SEAMLINE_PROGRAM, folderOf("tiny"), set, log));
    const file = join(mkdtempSync(join(work, "import-")), "saved.jsonl");
    let participant;
    await visiting(host.address, async (page) => {
      await actUntil(page, ["trial"], {});
      const refusal = { status: 409, type: "application/json", body: '{"error":"not this one"}' };
      host.instead = (method, path) => (path === "/api/messages" ? refusal : null);
      ({ participant } = await actUntil(page, ["stopped"], {}));
      const said = await page.textContent("#study");
      assert.match(said, /not this one/);
      assert.doesNotMatch(said, /safe|are stored/);
      const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
      await download.saveAs(file);
    });
    await host.stop();
    const ask = (...words) => execFileSync(process.env.SEAMLINE_PROGRAM, words, { encoding: "utf8" });
    assert.match(ask("log", "status", log), / 0 of +6/);
    console.log("  " + ask("import", log, file, "--set", set).trim().split("\n").join("\n  "));
    const status = ask("log", "status", log);
    assert.ok(status.includes(participant) && / 1 of +6/.test(status), status);
  },

  async "a page for a host of files says that it stands at JATOS"() {
    const host = await jatosHost(folderOf("tiny"), 0);
    const study = JSON.parse(readFileSync(join(folderOf("tiny") + "-static", "study.json"), "utf8"));
    host.instead = (method, path) => (path.endsWith("/study.json") ? { status: 200, type: "application/json", body: JSON.stringify(study) } : null);
    await visiting(host.address, async (page) => {
      await page.waitForSelector("#study .card");
      assert.match(await page.textContent("#study"), /wanted a host of files, found JATOS/);
    });
    await host.stop();
  },

  async "a second tab says that there is a first"() {
    const host = await staticHost(folderOf("tiny"));
    await visiting(host.address, async (page, browser) => {
      await actUntil(page, ["form"], {});
      const second = await browser.newPage();
      await second.goto(host.address);
      await second.waitForSelector("#study .card", { timeout: 10000 });
      assert.match(await second.textContent("#study"), /another tab/);
      await page.close();
      await second.reload();
      await actUntil(second, ["form"], {});
    });
    await host.stop();
  },

  async "without https: no locks and no hashes, and all the same one tab and no answer lost"() {
    const host = await fakeServe(folderOf("tiny"), { trouble: 0.1 });
    const address = host.address.replace("localhost", "lab.test");
    const args = ["--host-resolver-rules=MAP lab.test 127.0.0.1"];
    await visiting(address, async (page, browser) => {
      assert.equal(await page.evaluate(() => isSecureContext), false);
      await actUntil(page, ["trial"], { patience_ms: 120000 });
      const second = await browser.newPage();
      await second.goto(address);
      await second.waitForSelector("#study .card", { timeout: 10000 });
      assert.match(await second.textContent("#study"), /another tab/);
      await second.close();
      await page.reload();
      await actUntil(page, ["thanks"], { patience_ms: 120000 });
      const messages = messagesOf(host.lines, "s-1");
      checkWhole(messages, orderOf("tiny", 0));
      assert.equal(messages.filter((message) => message.kind === "begin").length, 1);
    }, { args });
    await host.stop();
  },

  async "a window too small, or magnified, takes the picture away, says why, and gives it back"() {
    const host = await staticHost(folderOf("tiny"));
    await visiting(host.address, async (page, browser) => {
      await actUntil(page, ["trial"], {});
      const choosing = () => page.waitForFunction(() => globalThis.seamline.visit.session.phase.name === "choosing");
      const guarded = (is) => page.waitForFunction((is) => document.querySelector("#guard").hidden !== is, is);
      await choosing();
      const devtools = await browser.newCDPSession(page);
      const { windowId, bounds } = await devtools.send("Browser.getWindowForTarget");
      const trouble = {
        small: [
          () => devtools.send("Browser.setWindowBounds", { windowId, bounds: { width: bounds.width, height: 360 } }),
          () => devtools.send("Browser.setWindowBounds", { windowId, bounds: { width: bounds.width, height: bounds.height } }),
          /The pictures and the questions below them need/,
        ],
        zoom: [
          () => devtools.send("Emulation.setPageScaleFactor", { pageScaleFactor: 1.5 }),
          () => devtools.send("Emulation.setPageScaleFactor", { pageScaleFactor: 1 }),
          /zoom/,
        ],
      };
      for (const [name, [begin, end, words]] of Object.entries(trouble)) {
        await begin();
        await guarded(true);
        assert.match(await page.textContent("#guard"), words, name);
        await page.keyboard.press("2");
        assert.notEqual((await look(page)).phase, "rating", name);
        await end();
        await guarded(false);
        await choosing();
      }
      const kept = await page.evaluate(async () => (await globalThis.seamline.store.messages()).map(({ body }) => body.kind + " " + body.detail));
      assert.ok(kept.includes("picture_taken small") && kept.includes("picture_taken zoom"), kept.join("; "));
      await actUntil(page, ["thanks"], {});
    });
    await host.stop();
  },

  async "a pause takes the picture away, and gives it back with a new onset"() {
    const host = await staticHost(folderOf("tiny"));
    await visiting(host.address, async (page) => {
      await actUntil(page, ["trial"], {});
      await page.waitForFunction(() => globalThis.seamline.visit.session.phase.name === "choosing");
      await page.keyboard.press("2");
      await page.keyboard.press("Escape");
      assert.equal((await look(page)).screen, "pause");
      await page.click("#leave");
      assert.match(await page.textContent("#study"), /may close this page/);
      await page.keyboard.press("Escape");
      await page.waitForFunction(() => globalThis.seamline.visit.session.phase.name === "choosing");
      assert.equal((await look(page)).answered, 0);
    });
    await host.stop();
  },
};

let failed = 0;
let passed = 0;
const wanted = process.argv[2] ?? "";
for (const [name, test] of Object.entries(tests)) {
  if (!name.includes(wanted)) continue;
  const begun = Date.now();
  try {
    await test();
    ++passed;
    console.log("ok      %s (%s s)", name, ((Date.now() - begun) / 1000).toFixed(1));
  } catch (error) {
    ++failed;
    console.log("FAILED  %s\n%s", name, error.stack);
  }
}
console.log("%d passed, %d failed", passed, failed);
process.exit(failed === 0 ? 0 : 1);
