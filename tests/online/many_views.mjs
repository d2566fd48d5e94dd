// A screen without glasses that a browser knows as a headset of many views (Looking Glass' library gives a WebXR session so many
// views on one quilt). None was at hand: npm iwer stands for it, whose two views are replaced by five in tiles of the canvas, each
// with an eye and a frustum of its own. Each tile beside an independent resampling of that eye's panorama (panorama_view.py).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, look, openBrowser, panoramaFiles } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const codes = join(work, "views-codes");
const shots = join(work, "shots");
for (const folder of [codes, shots]) mkdirSync(folder, { recursive: true });
const folder = join(work, "views-static");
const host = await staticHost(join(work, "views"));
const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 });
await browser.addInitScript({ path: process.env.SEAMLINE_IWER });
await browser.addInitScript(() => {
  const device = new globalThis.IWER.XRDevice(globalThis.IWER.metaQuest3);
  device.installRuntime({ forceInstall: true });
  globalThis.device = device;
  const VIEWS = 5;
  const pose = globalThis.XRFrame.prototype.getViewerPose;
  const eyes = []; // the screen gives its views from the right to the left, which the page must not mind
  globalThis.XRFrame.prototype.getViewerPose = function (space) {
    const head = pose.call(this, space);
    if (!head) return head;
    const { position: p, orientation: q } = head.transform;
    eyes.length = 0;
    const views = [...Array(VIEWS).keys()].map((k) => {
      const right_m = 0.02 * (VIEWS - 1 - k - (VIEWS - 1) / 2);
      const right = [1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)];
      const projection = new Float32Array([2.4, 0, 0, 0, 0, 2.8, 0, 0, -0.3 * right_m, 0, -1, -1, 0, 0, -0.2, 0]);
      const transform = { position: { x: p.x + right_m * right[0], y: p.y + right_m * right[1], z: p.z + right_m * right[2] }, orientation: q };
      const view = { eye: "none", projectionMatrix: projection, transform };
      eyes.push(view);
      return view;
    });
    return { transform: head.transform, views };
  };
  globalThis.XRWebGLLayer.prototype.getViewport = (view) => ({ x: 200 * eyes.indexOf(view), y: 20, width: 200, height: 170 });
});
const page = browser.pages()[0];
page.on("pageerror", (error) => console.error(error));
await page.goto(host.address);
const end = Date.now() + 240000;
let seen = await look(page);
for (; seen.screen !== "training" || !(await page.locator("#wear").isVisible()); seen = await look(page)) {
  assert.ok(Date.now() < end, "the practice begins: " + JSON.stringify(seen));
  if (seen.screen !== "training") await act(page, seen, { mouse: true });
  await page.waitForTimeout(20);
}
await page.click("#wear");
await page.waitForFunction(() => globalThis.seamline.headset?.scene.panorama);
const eyes = await page.evaluate(() => globalThis.seamline.headset.read());
writeFileSync(join(shots, "many-views.png"), await page.screenshot());
assert.deepEqual(eyes.map(({ panorama }) => panorama), [4, 3, 2, 1, 0], "each view has the panorama of its place");
const poses = eyes.map(({ codes: text, pose, half, middle, width, height, panorama }, at) => {
  writeFileSync(join(codes, at + ".rgba"), Buffer.from(text, "base64"));
  return { ...pose, half, middle, size: [width, height], panorama };
});
writeFileSync(join(codes, "poses.json"), JSON.stringify({ ...panoramaFiles(folder, seen.trial.picture), set: join(work, "views-set"), poses }));
const text = execFileSync("/usr/bin/python3", [join(import.meta.dirname, "panorama_view.py"), codes], { encoding: "utf8" }).trim();
console.log("five views of one session: " + text);
assert.ok(Number(/difference ([0-9.]+)/.exec(text)[1]) <= 1);
await browser.close();
await host.stop();
