// A skinned figure in the exported page, in Chromium.   figure.mjs PAGE_FOLDER WORK PLACES.json
// At some moments joints and vertices of X3DOM are where NumPy has them; standing still, the figure is where the program's rays
// see it; when it moves, the picture changes.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { decodePng } from "../online/png.mjs";

const require = createRequire(join(process.env.SEAMLINE_NODE_MODULES, "x.js"));
const { chromium } = require("playwright-core");
const [page_folder, work, places_file] = process.argv.slice(2);
const places = JSON.parse(readFileSync(places_file));

const browser = await chromium.launch({
  executablePath: process.env.SEAMLINE_CHROMIUM,
  headless: true,
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb"],
});
const page = await browser.newPage({ viewport: { width: 1000, height: 1400 } });
const complaints = [];
page.on("pageerror", (error) => complaints.push(error.message));
page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
await page.goto("file://" + join(page_folder, "index.html"), { timeout: 180000 });
await page.waitForSelector("canvas");
await page.waitForTimeout(4000);

async function shot(name) {
  await page.waitForTimeout(800);
  const file = await page.locator("canvas").first().screenshot();
  writeFileSync(join(work, name + ".png"), file);
  return decodePng(file);
}

/** Joints (what X3DOM's transform makes of their centres) and the skin's vertices. */
const state = () =>
  page.evaluate(() => {
    const joints = {};
    for (const element of document.querySelectorAll("HAnimJoint[def]")) {
      const node = element._x3domNode, place = node.getCurrentTransform().multMatrixPnt(node._vf.center);
      joints[element.getAttribute("name")] = [place.x, place.y, place.z];
    }
    const points = document.querySelector("HAnimHumanoid > Coordinate")._x3domNode._vf.point;
    return { joints, points: Array.from(points).map((p) => [p.x, p.y, p.z]) };
  });

const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
const HANIM = { pelvis: "humanoid_root", head: "skullbase" };
for (const side of ["left", "right"])
  for (const [own, hanim] of Object.entries({ shoulder: "shoulder", elbow: "elbow", hand: "radiocarpal", hip: "hip", knee: "knee", foot: "talocrural" })) HANIM[side + "_" + own] = side[0] + "_" + hanim;

// It moves by itself.
const first = await state();
await page.waitForTimeout(400);
assert.ok(distance((await state()).points[0], first.points[0]) > 1e-4, "the figure does not move");

const report = {};
await page.evaluate(() => document.getElementById("figure_clock").setAttribute("enabled", "false"));
for (const moment of places.moments) {
  const fraction = (moment.time_s - places.first_s) / (places.last_s - places.first_s);
  await page.evaluate((value) => document.getElementById("figure_clock")._x3domNode.postMessage("fraction_changed", value), fraction);
  await shot(`figure-${moment.time_s}`);
  const found = await state();
  const joints = Object.entries(moment.joints).map(([name, place]) => distance(found.joints[HANIM[name] ?? name], place));
  assert.equal(found.points.length, moment.corners.length);
  const skin = moment.corners.map((corner, i) => distance(corner, found.points[i]));
  report[moment.time_s] = { joints_mm: 1000 * Math.max(...joints), skin_mm: 1000 * Math.max(...skin) };
  assert.ok(Math.max(...joints) < 1e-4 && Math.max(...skin) < 1e-4, JSON.stringify(report));
}

// Standing, it is in the pose that the program traced.
await page.uncheck("#moves");
await page.uncheck("#shown");
const without = await shot("figure-without");
await page.check("#shown");
await page.check("#marked");
const marked = await shot("figure-marked");
const in_front = decodePng(readFileSync(join(page_folder, "in_front.png")));
let object = 0, alike = 0, elsewhere = 0;
for (let i = 0; i < in_front.width * in_front.height; ++i) {
  const far = (colour) => [0, 1, 2].reduce((sum, c) => sum + (marked.bytes[i * marked.channels + c] - colour[c]) ** 2, 0);
  const found = far([255, 0, 255]) < far([0, 1, 2].map((c) => without.bytes[i * without.channels + c]));
  const wanted = in_front.bytes[i * in_front.channels];
  object += wanted !== 0;
  alike += wanted !== 0 && found === (wanted === 255);
  elsewhere += wanted === 0 && found;
}
report.who_is_in_front = alike / object;
assert.ok(object > 1000 && alike / object > 0.95 && elsewhere < 0.03 * object, JSON.stringify({ object, alike, elsewhere }));
await page.uncheck("#marked");
await shot("figure-still");
await page.screenshot({ path: join(work, "figure-page.png"), fullPage: true });
assert.deepEqual(complaints, []);
await browser.close();
console.log(JSON.stringify(report, null, 1));
console.log("the figure in X3DOM is where NumPy has it");
