// What looking round costs with panoramas of 4096 x 2048: frames and milliseconds from a pose to its picture, frames a second, and
// memory, in Chromium with an emulated headset (npm iwer) and by mouse. A measurement, not a test: it asserts no time. The pages of
// the tests by mouse and in a headset are shown with their pictures enlarged.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, look, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const ENLARGE = `
import sys
from PIL import Image
picture = Image.open(sys.argv[1]).convert("RGB")
picture.resize((4096, 4096 * picture.height // picture.width), Image.BILINEAR).save(sys.argv[1])`;

/** A page's copy with large pictures; of the pictures with so many panoramas only. */
function enlarged(name, panoramas) {
  const folder = join(work, "costs-" + name + "-" + panoramas);
  rmSync(folder, { recursive: true, force: true });
  cpSync(join(work, name + "-static"), folder, { recursive: true });
  const study = JSON.parse(readFileSync(join(folder, "study.json"), "utf8"));
  for (const picture of study.pictures) {
    const path = join(folder, picture.file);
    execFileSync("/usr/bin/python3", ["-c", ENLARGE, path]);
    const bytes = readFileSync(path);
    Object.assign(picture, { bytes: bytes.length, sha256: createHash("sha256").update(bytes).digest("hex") });
    // Maps stay small: their places are shares of the panorama.
  }
  writeFileSync(join(folder, "study.json"), JSON.stringify(study));
  return folder;
}

/** Proportional memory of all processes of the browser, in MB, by the profile that their command lines name. */
function memoryOf(profile) {
  let kilobytes = 0;
  const children = new Map();
  const roots = [];
  for (const pid of readdirSync("/proc").filter((one) => /^\d+$/.test(one)))
    try {
      const parent = readFileSync("/proc/" + pid + "/stat", "utf8").replace(/.*\) /, "").split(" ")[1];
      children.set(parent, [...(children.get(parent) ?? []), pid]);
      if (readFileSync("/proc/" + pid + "/cmdline", "utf8").includes(profile)) roots.push(pid);
    } catch {
      // it has ended
    }
  const all = new Set();
  const add = (pid) => !all.has(pid) && (all.add(pid), (children.get(pid) ?? []).forEach(add));
  roots.forEach(add);
  for (const pid of all)
    try {
      kilobytes += Number(/^Pss:\s+(\d+)/m.exec(readFileSync("/proc/" + pid + "/smaps_rollup", "utf8"))?.[1] ?? 0);
    } catch {
      // it has ended
    }
  return Math.round(kilobytes / 1024);
}

async function measure(name, panoramas) {
  const host = await staticHost(enlarged(name, panoramas));
  const profile = mkdtempSync(join(work, "browser-"));
  const browser = await openBrowser(profile, { width: 1100, height: 800 });
  await browser.addInitScript({ path: process.env.SEAMLINE_IWER });
  await browser.addInitScript(() => {
    const device = new globalThis.IWER.XRDevice(globalThis.IWER.metaQuest3);
    device.installRuntime({ forceInstall: true });
    device.stereoEnabled = true;
    globalThis.device = device;
  });
  const page = browser.pages()[0];
  await page.goto(host.address);
  await page.waitForTimeout(3000);
  const before_mb = memoryOf(profile);
  let seen = await look(page);
  const isThere = async () => seen.screen === "training" && ((await page.locator("#wear").isVisible()) || seen.asks);
  for (; !(await isThere()); seen = await look(page)) {
    if (seen.screen !== "training") await act(page, seen, { mouse: true });
    await page.waitForTimeout(20);
  }
  const worn = await page.locator("#wear").isVisible();
  if (worn) {
    await page.click("#wear");
    await page.waitForFunction(() => globalThis.seamline.headset?.scene.panorama);
  }
  await page.waitForTimeout(3000);
  const found = await page.evaluate(async (worn) => {
    const app = globalThis.seamline;
    const frame = () => new Promise(requestAnimationFrame);
    const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
    const size = app.view.size();
    const gl = app.view.gl;
    const waits = [];
    const frames = [];
    const draws = [];
    for (let i = 0; i < 40; ++i) {
      const yaw = (i % 2 ? 1 : -1) * (5 + i);
      const begun = performance.now();
      if (worn) {
        const half = (-yaw * Math.PI) / 360;
        const before = app.headset.pose().yaw_deg;
        globalThis.device.quaternion.set(0, Math.sin(half), 0, Math.cos(half));
        let count = 0;
        while (Math.abs(app.headset.pose().yaw_deg - before) < 1e-6 && ++count < 20) await frame();
        frames.push(count);
      } else {
        app.looking.turn(yaw, 0);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
        draws.push(performance.now() - begun);
        await frame();
      }
      waits.push(performance.now() - begun);
    }
    const begun = performance.now();
    for (let i = 0; i < 60; ++i) {
      if (!worn) app.looking.turn(1, 0);
      await frame();
    }
    return { size, panoramas: app.view.eyes(), canvas: [gl.canvas.width, gl.canvas.height], frames: median(frames), most_frames: frames.at(-1), draw_ms: median(draws), wait_ms: median(waits), frames_a_s: 60000 / (performance.now() - begun) };
  }, worn);
  console.log(name + ": " + JSON.stringify(found) + "; memory of the browser " + before_mb + " MB before a picture, " + memoryOf(profile) + " MB with it");
  await browser.close();
  await host.stop();
}

for (const [name, panoramas] of [["look", 1], ["head", 2]]) await measure(name, panoramas);
