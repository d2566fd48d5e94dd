// A study in three languages over one set: chosen by link, by browser and by the person; one log. Screenshots go to WORK/shots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { realServe } from "./hosts.mjs";
import { tryLaws } from "./try_laws.mjs";
import { actUntil, axeSource, inFirefox, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const shots = join(work, "shots");
mkdirSync(shots, { recursive: true });
const folder = mkdtempSync(join(work, "languages-"));
const log = join(folder, "log.sqlite");
cpSync(join(work, "tiny-set"), join(folder, "set"), { recursive: true });
const file = join(folder, "set", "study.toml");
const consents = { de: "Sie sind zu einer Studie eingeladen.", ar: "أنت مدعو للمشاركة في دراسة." };
let more = "";
for (const [tag, text] of Object.entries(consents)) {
  more += `\n[[language]]\ntag = "${tag}"\ntexts = ["builtin:${tag}", "own_${tag}.toml"]\n`;
  writeFileSync(join(folder, "set", "own_" + tag + ".toml"), `format = "seamline texts 1"\nlanguage = "${tag}"\n[consent]\ntext = "${text}"\n`);
}
writeFileSync(file, readFileSync(file, "utf8") + more);
const said = execFileSync(program, ["export", "web", join(folder, "set"), join(folder, "page-serve"), "--serve"], { encoding: "utf8" });
assert.match(said, /machine drafts, to be checked by a speaker: de, ar/);
const host = await realServe(program, join(folder, "page"), join(folder, "set"), log);

async function violations(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return violations.map(({ id, nodes }) => id + ": " + nodes.map((node) => node.html).join(" | "));
}
const words = (page) => page.evaluate(() => ({ lang: document.documentElement.lang, dir: document.documentElement.dir, title: document.querySelector("h1").textContent }));
async function look(page, label) {
  await page.waitForTimeout(150);
  writeFileSync(join(shots, (inFirefox ? "firefox-" : "") + "languages-" + label + ".png"), await page.screenshot());
  assert.deepEqual(await violations(page), [], label);
}

/** A visit from consent to thanks; `wish` is the browser's language, `query` of the link. */
async function visit(wish, query, then) {
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { args: ["--lang=" + wish, "--accept-lang=" + wish], languages: wish });
  try {
    const page = browser.pages()[0];
    await page.goto(host.address + query);
    await page.waitForSelector("#accept");
    return await then(page);
  } finally {
    await browser.close();
  }
}

const laws = {
  async "by the link, German"() {
    await visit("en-GB", "?lang=de", async (page) => {
      assert.deepEqual(await words(page), { lang: "de", dir: "ltr", title: "Bevor Sie beginnen" });
      await look(page, "consent-de");
      await actUntil(page, ["form"]);
      await look(page, "form-de");
      await actUntil(page, ["trial"], { patience_ms: 60000 });
      await page.reload();
      await actUntil(page, ["thanks"], { patience_ms: 120000 });
      assert.equal((await words(page)).title, "Vielen Dank");
    });
  },
  async "by the person, Arabic from right to left, which holds against the link"() {
    await visit("en-GB", "?lang=de&visit=2", async (page) => {
      await page.click(".languages button[lang=ar]");
      await page.waitForFunction(() => document.documentElement.lang === "ar" && document.querySelector("#accept"));
      assert.equal((await words(page)).dir, "rtl");
      await look(page, "consent-ar");
      await actUntil(page, ["form"]);
      await look(page, "form-ar");
      await actUntil(page, ["trial"], { patience_ms: 60000 });
      await page.waitForTimeout(700);
      await look(page, "trial-ar");
      await actUntil(page, ["thanks"], { patience_ms: 120000 });
      assert.deepEqual(await words(page), { lang: "ar", dir: "rtl", title: "شكرًا لك" });
    });
  },
  async "by the browser, or the study's own"() {
    await visit("fr-FR,de-AT", "?visit=3", async (page) => assert.equal((await words(page)).lang, "de"));
    await visit("fr-FR", "?visit=4", async (page) => {
      assert.equal((await words(page)).lang, "en");
      await actUntil(page, ["thanks"], { patience_ms: 120000 });
    });
  },
  async "the log holds the study's own options, the consent that was read, and the language of each sitting"() {
    const csv = join(folder, "tables");
    execFileSync(program, ["export", "tables", log, csv]);
    const [head, ...rows] = readFileSync(join(csv, "participants.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
    const at = (name) => head.indexOf(name);
    assert.deepEqual(rows.map((row) => row[at("language")]).sort(), ["ar", "de", "en"]);
    assert.deepEqual([...new Set(rows.map((row) => row[at("form_gender")]))], ["female"]);
    const bytes = readFileSync(log).toString("utf8") + readFileSync(log + "-wal").toString("utf8");
    for (const text of Object.values(consents)) assert.ok(bytes.includes(text), text);
  },
};
await tryLaws(laws, () => host.stop());
