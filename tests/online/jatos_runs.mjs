// Runs in JATOS: from the study link to JATOS's own end page.   jatos_runs.mjs [FOLDER]
// FOLDER is JATOS's own scripts (modules/publix/public of github.com/JATOS/JATOS): then they are what the page loads, else the
// stand-in of jatos.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { jatosHost } from "./jatos.mjs";
import { actUntil, openBrowser } from "./person.mjs";
import { checkWhole, messagesOf } from "./stream.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const library = process.argv[2];
const folder = join(work, "tiny");
const orderOf = (slot) => JSON.parse(readFileSync(join(folder + "-jatos", "orders", String(slot).padStart(4, "0") + ".json"), "utf8"));
const linesOf = (run) => run.components.flatMap(({ data }) => data.split("\n").filter((line) => line !== ""));

/** What the policy forbade, and what nobody caught, in all pages of the browser. */
function complaintsOf(browser) {
  const complaints = [];
  const listen = (page) => {
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("console", (message) => /Content Security Policy|Refused to/.test(message.text()) && complaints.push(message.text()));
    page.on("dialog", (dialog) => dialog.accept().catch(() => {}));
  };
  browser.on("page", listen);
  browser.pages().forEach(listen);
  return complaints;
}

async function inJatos(visit, { trouble = 0, ...options } = {}) {
  const host = await jatosHost(folder, trouble, { library, ...options });
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")));
  try {
    const complaints = complaintsOf(browser);
    await visit(host, browser.pages()[0], browser);
    assert.deepEqual(complaints, []);
  } finally {
    await browser.close();
    await host.stop();
  }
}

/** Answers until JATOS has the page; the code of whoever it was. */
async function toTheEnd(page, where, options = {}) {
  let participant = "";
  const isAway = () => page.url().includes(where);
  const each = (seen) => void (participant = seen.participant || participant);
  const end = Date.now() + 180000;
  while (!isAway()) {
    assert.ok(Date.now() < end, "never at " + where + ", but at " + page.url());
    // The page may be gone between two looks.
    await actUntil(page, ["thanks"], { patience_ms: 3000, each, ...options }).catch(() => {});
    await page.waitForTimeout(50);
  }
  return participant;
}

function imported(host, ...more) {
  const here = mkdtempSync(join(work, "import-"));
  const file = join(here, "results.txt");
  writeFileSync(file, host.runs().map((run) => run.components.map(({ data }) => data).join("\n")).join("\n"));
  return execFileSync(process.env.SEAMLINE_PROGRAM, ["import", join(here, "log.sqlite"), file, "--set", join(work, "tiny-set"), ...more], { encoding: "utf8" });
}

const tests = {
  async "a run: JATOS's parameters and channel are there, every answer arrives, and its end page says the study's thanks"() {
    await inJatos(async (host, page) => {
      await page.goto(host.address + "?PROLIFIC_PID=abc%20123");
      await actUntil(page, ["consent"]);
      assert.deepEqual(await page.evaluate(() => globalThis.jatos.urlQueryParameters), { PROLIFIC_PID: "abc 123" });
      assert.equal(host.runs()[0].channels, 1);
      const participant = await toTheEnd(page, "/final/endPage.html");
      const [run] = host.runs();
      assert.equal(run.state, "FINISHED");
      const messages = messagesOf(linesOf(run), participant);
      assert.equal(messages[0].body.origin, "jatos");
      checkWhole(messages, orderOf(messages[0].body.slot));
      const study = JSON.parse(readFileSync(join(folder + "-jatos", "study.json"), "utf8"));
      assert.match(await page.textContent("main"), new RegExp(study.texts.thanks_title));
      assert.equal(await page.title(), study.texts.thanks_title);
      assert.match(imported(host), /1 participant complete, 0 incomplete/);
    });
  },

  async "the end leads to where the study's settings say, with the link's own parameters"() {
    await inJatos(
      async (host, page) => {
        await page.route("https://elsewhere.example/**", (route) => route.fulfill({ contentType: "text/html", body: "elsewhere" }));
        await page.goto(host.address + "?PROLIFIC_PID=a%26b");
        await toTheEnd(page, "elsewhere.example");
        assert.equal(page.url(), "https://elsewhere.example/done?id=a%26b");
      },
      { endRedirectUrl: "https://elsewhere.example/done?id=[PROLIFIC_PID]" }
    );
  },

  async "results that fail at random arrive all the same, each once for the log"() {
    await inJatos(
      async (host, page) => {
        await page.goto(host.address);
        const participant = await toTheEnd(page, "/final/endPage.html");
        const messages = messagesOf(linesOf(host.runs()[0]), participant);
        checkWhole(messages, orderOf(messages[0].body.slot));
        console.log("  %d lines appended for %d messages", linesOf(host.runs()[0]).length, messages.length);
        assert.match(imported(host), /1 participant complete, 0 incomplete/);
      },
      { trouble: 0.3 }
    );
  },

  async "the next person in the same browser has a run of their own; a reload goes on in one's own"() {
    await inJatos(async (host, page) => {
      const people = [];
      for (let i = 0; i < 2; ++i) {
        await page.goto(host.address);
        assert.equal((await actUntil(page, ["consent", "thanks"], {})).screen, "consent");
        const begun = await actUntil(page, ["trial"]);
        await page.reload();
        assert.equal((await actUntil(page, ["trial"])).participant, begun.participant);
        people.push(await toTheEnd(page, "/final/endPage.html"));
      }
      assert.notEqual(people[0], people[1]);
      host.runs().forEach((run, at) => {
        assert.equal(run.state, "FINISHED");
        assert.equal(run.components.length, 2);
        checkWhole(messagesOf(linesOf(run), people[at]), null);
      });
      assert.match(imported(host), /2 participants complete, 0 incomplete/);
    });
  },

  async "who declines ends the run as failed, reads the study's words, and is counted"() {
    await inJatos(async (host, page) => {
      await page.goto(host.address);
      await actUntil(page, ["consent"]);
      await page.click("#decline");
      await page.waitForFunction(() => globalThis.seamline.visit.screen.name === "declined");
      const [run] = host.runs();
      for (let i = 0; i < 100 && run.state !== "FAIL"; ++i) await page.waitForTimeout(50);
      assert.deepEqual([run.state, run.message], ["FAIL", "declined"]);
      assert.ok(page.url().endsWith("/start"));
      assert.match(imported(host), /1 declined/);
    });
  },

  async "what JATOS will not have ends the study in words, with the answers as a file; whatever else passes"() {
    const final = [
      { status: 400, body: "A study result 12 doesn't exist.", type: "text/plain" },
      { status: 403, body: "Study run is already finished (study result 12)", type: "text/plain" },
      { status: 413, body: "Result data size exceeds allowed 5 MB. Consider using result files instead.", type: "text/plain" },
    ];
    const passing = [400, 401, 403, 404, 408, 413, 429].map((status) => ({ status, body: "<html>a proxy</html>", type: "text/html" }));
    passing.push({ status: 500, body: "JATOS error", type: "text/plain" }, { status: 502, body: "", type: "text/html" }, { status: 503, body: "busy", type: "text/plain" });
    for (const instead of [...final, ...passing])
      await inJatos(async (host, page) => {
        await page.goto(host.address);
        await actUntil(page, ["trial"]);
        let asked = 0;
        host.instead = (method, path) => (method === "POST" && path.endsWith("/resultData") && ++asked ? instead : null);
        const isFinal = final.includes(instead);
        if (isFinal) {
          await actUntil(page, ["stopped"], { patience_ms: 30000 });
          assert.ok((await page.textContent("#study")).includes(instead.body), await page.textContent("#study"));
          assert.ok(await page.locator("#save").isVisible());
          return;
        }
        const end = Date.now() + 30000;
        while (asked < 3) {
          assert.ok(Date.now() < end, "not asked again after " + instead.status);
          await actUntil(page, ["stopped"], { patience_ms: 300 }).then(() => assert.fail("stopped at " + instead.status), () => {});
        }
        assert.ok(await page.locator("#status").isVisible(), String(instead.status));
        host.instead = null;
        await toTheEnd(page, "/final/endPage.html");
        checkWhole(messagesOf(linesOf(host.runs()[0]), host.lines.map((line) => JSON.parse(line).participant)[0]), null);
      });
  },

  async "whatever the network loses of JATOS's scripts, the page comes, and answers arrive"() {
    const ours = ["jquery.js", "parts.js"];
    const scripts = library ? readdirSync(join(library, "javascripts")).filter((name) => /^jquery-|min\.js$|^(httpLoop|heartbeat)\.js$/.test(name) && !/(httpLoop|heartbeat)\.min/.test(name)) : ours;
    for (const file of ["jatos.js", "initData", "study.json", ...scripts])
      await inJatos(async (host, page) => {
        let lost = 0;
        await page.route("**/" + file, (route) => (lost++ === 0 ? route.abort("internetdisconnected") : route.continue()));
        await page.goto(host.address);
        await actUntil(page, ["display"], { patience_ms: 90000, strict: false });
        assert.ok(lost >= (file === "heartbeat.js" ? 1 : 2), file + " " + lost);
      });
  },
};

let failed = 0;
const wanted = process.argv[3] ?? "";
for (const [name, test] of Object.entries(tests)) {
  if (!name.includes(wanted)) continue;
  const begun = Date.now();
  try {
    await test();
    console.log("ok      %s (%s s)", name, ((Date.now() - begun) / 1000).toFixed(1));
  } catch (error) {
    ++failed;
    console.log("FAILED  %s\n%s", name, error.stack);
  }
}
process.exit(failed === 0 ? 0 : 1);
