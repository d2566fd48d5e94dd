// How fast views of panoramas are in a browser, and what they cost in memory; a measurement, which asserts no time:
//   tests/online/run PROGRAM WORK look_speed [firefox]     with the rendered set of a [look] study in SEAMLINE_LOOK_SET
// Frames a second while the view turns; from a key to the frame that follows the drawn view; the memory of all the browser's
// processes. Each step ends after its own time, whatever the browser does.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, inFirefox, look, openBrowser } from "./person.mjs";

assert.ok(process.env.SEAMLINE_LOOK_SET, "SEAMLINE_LOOK_SET: the folder of a rendered set of a study with [look]");
const STEP_MS = 60000;
const within = (what, promise, ms = STEP_MS) => {
  let timer;
  const end = new Promise((_, reject) => (timer = setTimeout(() => reject(new Error(what + " took more than " + ms + " ms")), ms)));
  return Promise.race([promise, end]).finally(() => clearTimeout(timer));
};
setTimeout(() => {
  console.error("look_speed took more than five minutes");
  process.exit(1);
}, 300000).unref();

const work = process.env.SEAMLINE_ONLINE_WORK;
const folder = join(work, "speed-static");
rmSync(folder, { recursive: true, force: true });
execFileSync(process.env.SEAMLINE_PROGRAM, ["export", "web", process.env.SEAMLINE_LOOK_SET, folder, "--pilot"], { stdio: "ignore" });
const host = await staticHost(join(work, "speed"));

/** Memory in MB of this process's descendants whose command is the browser's: shared pages are counted by their part. */
function browserMegabytes() {
  const parents = new Map();
  for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name)))
    try {
      parents.set(Number(id), Number(/^PPid:\s+(\d+)/m.exec(readFileSync("/proc/" + id + "/status", "utf8"))[1]));
    } catch {} // it has ended
  const isOurs = (id) => id === process.pid || (parents.has(id) && id > 1 && isOurs(parents.get(id)));
  let kilobytes = 0;
  for (const id of parents.keys())
    if (id !== process.pid && isOurs(id))
      try {
        kilobytes += Number(/^Pss:\s+(\d+)/m.exec(readFileSync("/proc/" + id + "/smaps_rollup", "utf8"))[1]);
      } catch {}
  return Math.round(kilobytes / 1024);
}

const browser = await within("the browser's start", openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 }));
const page = browser.pages()[0];
page.on("pageerror", (error) => console.error(error));
await within("the page", page.goto(host.address));
await within("the first screen", page.waitForFunction(() => globalThis.seamline?.visit));
const before = browserMegabytes();

const turns = () => page.evaluate(() => globalThis.seamline.looking?.turns === true && !document.querySelector(".questions")?.hidden);
const reach = async () => {
  for (let seen = await look(page); !(["training", "trial"].includes(seen.screen) && seen.phase === "choosing" && (await turns())); seen = await look(page)) {
    await act(page, seen, { mouse: true });
    await page.waitForTimeout(20);
  }
};
await within("the first view that turns", reach());

const drawn = await within(
  "drawing",
  page.evaluate(async () => {
    const app = globalThis.seamline;
    const { view } = app;
    const look = app.study.looks.find(({ kind }) => kind === "mouse");
    const { gl } = view;
    const pixel = new Uint8Array(4);
    const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    finish();
    const draws = [];
    for (let i = 0; i < 100 && draws.reduce((a, b) => a + b, 0) < 10000; ++i) {
      const from = performance.now();
      view.draw(look, { yaw_deg: 3.6 * i - 180, pitch_deg: (i % 41) - 20 });
      finish();
      draws.push(performance.now() - from);
    }
    const frames = [];
    const until = performance.now() + 4000;
    await new Promise((resolve) => {
      const next = (now) => {
        frames.push(now);
        view.draw(look, { yaw_deg: frames.length % 180, pitch_deg: 0 });
        if (now < until) requestAnimationFrame(next);
        else resolve();
      };
      requestAnimationFrame(next);
    });
    const size = view.size();
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    return { draws, frames, size, view_px: look.view_px, renderer: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) };
  })
);
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const gaps = drawn.frames.slice(1).map((at, i) => at - drawn.frames[i]);

/** From the event of a key to when its view is drawn, and to the frame after: the first that can show it. */
const latencies = async () => {
  await page.evaluate(() => {
    globalThis.lags = [];
    document.addEventListener("keydown", (event) => {
      const { gl } = globalThis.seamline.view;
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for what was drawn
      const drawn = performance.now() - event.timeStamp;
      requestAnimationFrame(() => requestAnimationFrame(() => globalThis.lags.push([drawn, performance.now() - event.timeStamp])));
    });
  });
  const poseOf = () => page.evaluate(() => globalThis.seamline.looking.pose());
  const from = await poseOf();
  const keys = 40;
  for (let i = 0; i < keys; ++i) {
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(70);
  }
  const to = await poseOf();
  assert.ok(Math.abs(((to.yaw_deg - from.yaw_deg - 3 * keys + 900) % 360) - 180) < 1e-6, "each key turned the view by 3 degrees");
  await page.waitForFunction((count) => globalThis.lags.length >= count, keys);
  return page.evaluate(() => globalThis.lags);
};
const lags = await within("forty keys", latencies());
const during = browserMegabytes();
const { size, view_px } = drawn;
console.log(`${inFirefox ? "Firefox" : "Chromium"}, ${drawn.renderer}; panorama ${size.width} x ${size.height}, view ${view_px.join(" x ")}`);
console.log(`draw and wait: median ${median(drawn.draws).toFixed(1)} ms, longest ${Math.max(...drawn.draws).toFixed(1)}; turning: ${(1000 / (gaps.reduce((a, b) => a + b) / gaps.length)).toFixed(1)} frames a second, longest gap ${Math.max(...gaps).toFixed(0)} ms`);
console.log(`key to drawn view: median ${median(lags.map(([a]) => a)).toFixed(1)} ms; to the second frame after it: median ${median(lags.map(([, b]) => b)).toFixed(1)}, longest ${Math.max(...lags.map(([, b]) => b)).toFixed(1)} ms`);
console.log(`memory of all its processes: ${before} MB at the first screen, ${during} MB with a panorama shown`);
await within("the end", browser.close(), 10000).catch(() => {});
await within("the host's end", host.stop(), 10000).catch(() => {});
process.exit(0);
