// The exported page in Chromium with a software WebGL 2.   page.mjs PAGE_FOLDER WORK
// Who is in front is what the program's rays say, by the depth image and by ghosts; nothing is asked of another host; the policy
// of the page forbids nothing that it needs; the shadow darkens; only the user is left when asked for.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { decodePng } from "../online/png.mjs";

const require = createRequire(join(process.env.SEAMLINE_NODE_MODULES, "x.js"));
const { chromium } = require("playwright-core");
const [page_folder, work] = process.argv.slice(2);
const TYPES = { html: "text/html", js: "text/javascript", css: "text/css", png: "image/png", txt: "text/plain" };

const server = createServer((request, response) => {
  const name = basename(new URL(request.url, "http://x").pathname) || "index.html";
  response.writeHead(200, { "Content-Type": TYPES[name.split(".").pop()] }).end(readFileSync(join(page_folder, name)));
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const host = "http://127.0.0.1:" + server.address().port + "/";

const browser = await chromium.launch({
  executablePath: process.env.SEAMLINE_CHROMIUM,
  headless: true,
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb"],
});

/** A page that is drawn, with what it asked for and what it complained about. */
async function open(address) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 1200 } });
  const asked = [], complaints = [];
  page.on("request", (request) => asked.push(request.url()));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  await page.addInitScript(() => {
    globalThis.refused = [];
    addEventListener("securitypolicyviolation", (event) => globalThis.refused.push(event.violatedDirective + " " + event.blockedURI));
  });
  await page.goto(address, { timeout: 180000 });
  await page.waitForSelector("canvas");
  await page.waitForTimeout(5000);
  return { page, asked, complaints };
}

async function shot(page, name) {
  await page.waitForTimeout(800);
  const file = await page.locator("canvas").first().screenshot();
  writeFileSync(join(work, name + ".png"), file);
  return decodePng(file);
}

const in_front = decodePng(readFileSync(join(page_folder, "in_front.png")));

/** Whether a pixel is more of the marked object than of what is behind it: browsers smooth edges. */
function isMarked(marked, without, i) {
  const at = i * marked.channels;
  const far = (colour) => [0, 1, 2].reduce((sum, c) => sum + (marked.bytes[at + c] - colour[c]) ** 2, 0);
  return far([255, 0, 255]) < far([0, 1, 2].map((c) => without.bytes[i * without.channels + c]));
}

/** Shares of the object's pixels on which page and program agree who is in front. */
function agreement(marked, without) {
  assert.deepEqual([marked.width, marked.height], [in_front.width, in_front.height]);
  let object = 0, alike = 0, hidden = 0, hidden_alike = 0, elsewhere = 0;
  for (let i = 0; i < in_front.width * in_front.height; ++i) {
    const wanted = in_front.bytes[i * in_front.channels];
    const found = isMarked(marked, without, i);
    if (wanted === 0) elsewhere += found;
    else {
      ++object;
      alike += found === (wanted === 255);
      hidden += wanted === 128;
      hidden_alike += wanted === 128 && !found;
    }
  }
  return { object, hidden, share: alike / object, hidden_share: hidden_alike / hidden, elsewhere };
}

const report = {};
for (const [way, address, least] of [["depth image", host, 0.985], ["ghosts", host + "?ghosts", 0.95], ["depth image, from a file", "file://" + join(page_folder, "index.html"), 0.985]]) {
  const { page, asked, complaints } = await open(address);
  const status = await page.locator("#status").textContent();
  assert.match(status, way === "ghosts" ? /invisible geometry, drawn before the object/ : /depth image, written fragment by fragment/);
  const name = way.replaceAll(/[ ,]+/g, "-");
  await shot(page, name);
  await page.uncheck("#shown");
  const without = await shot(page, name + "-real");
  await page.check("#shown");
  await page.check("#marked");
  const seen = agreement(await shot(page, name + "-marked"), without);
  report[way] = seen;
  assert.ok(seen.hidden > 500, "nothing real is in front of the object");
  assert.ok(seen.share >= least, way + ": " + seen.share);
  assert.ok(seen.elsewhere < 0.01 * seen.object, way + ": the object is where it should not be");
  await page.uncheck("#occlusion");
  const floating = agreement(await shot(page, name + "-marked-none"), without);
  assert.ok(floating.hidden_share < 0.05, way + ": without occlusion the object is in front of everything, but for " + floating.hidden_share);
  assert.deepEqual(await page.evaluate(() => globalThis.refused), []);
  assert.deepEqual(complaints, []);
  for (const url of asked) {
    const own = url.startsWith("data:") || url.startsWith("blob:") || (address.startsWith("file:") ? url.startsWith("file://" + page_folder) : url.startsWith(host));
    assert.ok(own, "asked for " + url.slice(0, 100));
  }
  await page.close();
}

// The shadow darkens, and nothing else changes.
{
  const { page } = await open(host);
  const lit = await shot(page, "shadow");
  await page.uncheck("#shadow");
  const unlit = await shot(page, "no-shadow");
  await page.uncheck("#occlusion");
  await shot(page, "no-occlusion");
  let darker = 0, brighter = 0;
  for (let i = 0; i < lit.bytes.length; ++i) {
    darker += lit.bytes[i] < unlit.bytes[i] - 8;
    brighter += lit.bytes[i] > unlit.bytes[i] + 1;
  }
  assert.ok(darker > 1000, "no shadow");
  assert.equal(brighter, 0);
  report.shadow_values = darker;
  // Only the user: the room is gone, the user's pixels are the photograph's.
  await page.check("#occlusion");
  await page.check("#user_only");
  const alone = await shot(page, "user-only");
  let kept = 0;
  for (let i = 0; i < alone.width * alone.height; ++i) {
    const at = i * alone.channels;
    kept += [0, 1, 2].every((c) => alone.bytes[at + c] === unlit.bytes[at + c]);
  }
  report.kept_share = kept / (alone.width * alone.height);
  assert.ok(report.kept_share > 0.03 && report.kept_share < 0.4, "kept " + report.kept_share);
  const values = await page.locator("#values").textContent();
  for (const field of ["depthImage", "colorImage", "users", "userMask", "jointPositions", "jointOrientations"]) assert.ok(values.includes(field), field);
  await page.close();
}
await browser.close();
server.close();
console.log(JSON.stringify(report, null, 1));
console.log("the page in X3DOM shows what the program's rays say");
