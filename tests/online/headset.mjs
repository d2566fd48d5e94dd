// A headset that is emulated (npm iwer) through a whole visit: what both eyes were shown at known turns of the head beside an
// independent resampling (panorama_view.py), choices by what the cross is on, and the log's poses beside those that were set.
// Pictures to look at: WORK/shots/headset-*.png.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, look, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const shots = join(work, "shots");
const codes = join(work, "headset-codes");
for (const folder of [shots, codes]) mkdirSync(folder, { recursive: true });
const folder = join(work, "head-static");
const host = await staticHost(join(work, "head"));
const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 });
await browser.addInitScript({ path: process.env.SEAMLINE_IWER });
await browser.addInitScript(() => {
  const device = new globalThis.IWER.XRDevice(globalThis.IWER.metaQuest3);
  device.installRuntime({ forceInstall: true });
  device.stereoEnabled = true;
  globalThis.device = device;
});
const page = browser.pages()[0];
page.on("pageerror", (error) => console.error(error));
page.on("dialog", (dialog) => dialog.accept());
await page.goto(host.address);

/** Turns the head, and waits for two frames. */
const turn = (yaw_deg, pitch_deg) =>
  page.evaluate(
    async ([yaw, pitch]) => {
      const [a, p] = [(-yaw * Math.PI) / 360, (pitch * Math.PI) / 360];
      // First up, then to the right: q = yaw x pitch.
      globalThis.device.quaternion.set(Math.cos(a) * Math.sin(p), Math.sin(a) * Math.cos(p), -Math.sin(a) * Math.sin(p), Math.cos(a) * Math.cos(p));
      const frames = (count) => new Promise((resolve) => (count === 0 ? resolve() : requestAnimationFrame(() => frames(count - 1).then(resolve))));
      await frames(6);
    },
    [yaw_deg, pitch_deg]
  );
const trigger = () =>
  page.evaluate(async () => {
    const controller = globalThis.device.controllers.right;
    controller.updateButtonValue("trigger", 1);
    await new Promise((resolve) => setTimeout(resolve, 120));
    controller.updateButtonValue("trigger", 0);
    await new Promise((resolve) => setTimeout(resolve, 120));
  });
const shot = async (name) => writeFileSync(join(shots, "headset-" + name + ".png"), await page.screenshot());

/** Where the middle of an object is from the start, and where the head is. */
const objectAt = (picture, object) =>
  page.evaluate(
    async ([picture, object]) => {
      const app = globalThis.seamline;
      const frame = (await app.pictures.ready(picture)).map.frames[object - 1];
      const { width, height } = app.view.size();
      return { yaw_deg: ((frame.x_px + frame.width_px / 2) / width - 0.5) * 360, pitch_deg: (0.5 - (frame.y_px + frame.height_px / 2) / height) * 180, pose: app.looking.pose() };
    },
    [picture, object]
  );

/** What both eyes see now, and where each looks: read in the frame after it was drawn. */
async function readEyes(trial) {
  const eyes = await page.evaluate(() => globalThis.seamline.headset.read());
  const poses = [];
  for (const eye of eyes) {
    writeFileSync(join(codes, poses.length + ".rgba"), Buffer.from(eye.codes, "base64"));
    poses.push({ ...eye.pose, half: eye.half, middle: eye.middle, size: [eye.width, eye.height] });
  }
  writeFileSync(join(codes, "poses.json"), JSON.stringify({ panorama: join(folder, trial.picture), eyes: true, poses }));
  return execFileSync("/usr/bin/python3", [join(import.meta.dirname, "panorama_view.py"), codes], { encoding: "utf8" }).trim();
}

const CREATURE = 3;
let trials = 0;
let compared = 0;
const set = new Map(); // the head's last turn, by trial
for (let now = await look(page); !["thanks", "stopped"].includes(now.screen); now = await look(page)) {
  if (!["trial", "training"].includes(now.screen)) await act(page, now, { mouse: true });
  else if (await page.locator("#wear").isVisible()) {
    await turn(0, 0);
    await page.click("#wear");
    await page.waitForFunction(() => globalThis.seamline.headset !== null);
  } else if (now.trial && (await page.evaluate(() => globalThis.seamline.headset?.scene.words !== null && globalThis.seamline.headset !== null))) {
    const where = await objectAt(now.trial.picture, CREATURE);
    if (now.phase === "choosing") {
      // The head is at 0 when a trial begins, so that the start's yaw, 0, is in front.
      if (compared++ === 0) {
        for (const [yaw, pitch] of [[0, 0], [75, 30], [-160, -40]]) {
          await turn(yaw, pitch);
          console.log("both eyes at yaw " + yaw + ", pitch " + pitch + ": " + (await readEyes(now.trial)));
        }
        await turn(0, -10);
        await shot("question");
      }
      await turn(where.yaw_deg, where.pitch_deg);
      await shot("object");
      await trigger();
      const after = await look(page);
      if (after.phase === "rating") set.set(now.screen + now.answered, where);
    } else if (now.phase === "rating") {
      const board = await page.evaluate(() => globalThis.seamline.headset.boardYaw());
      await turn(board - 8, -30);
      await shot("rating");
      await page.waitForFunction(() => globalThis.seamline.headset?.answer() > 0); // poses come some frames later
      await trigger();
      const after = await look(page);
      if (after.answered > now.answered) ++trials;
      await turn(0, 0);
      await page.waitForTimeout(50);
    }
  }
  await page.waitForTimeout(10);
}
const end = await look(page);
assert.equal(end.screen, "thanks", end.message ?? "");
const messages = await page.evaluate(() => globalThis.seamline.store.messages());
const answers = messages.filter(({ kind }) => kind === "answer").map(({ body }) => body);
const looks = messages.filter(({ kind, body }) => kind === "event" && body.kind === "look").map(({ body }) => body);
let worst = 0;
for (const answer of answers) {
  const wanted = set.get("trial" + answer.trial_index);
  const poses = looks.filter((one) => one.trial_index === answer.trial_index).flatMap(({ detail }) => detail.split(";").map((pose) => pose.split(" ").map(Number)));
  const off = Math.min(...poses.map(([, yaw, pitch]) => Math.hypot(((yaw - wanted.yaw_deg + 540) % 360) - 180, pitch - wanted.pitch_deg)));
  worst = Math.max(worst, off);
}
assert.ok(worst < 0.1, "poses in the log are those that were set: " + worst);
console.log(answers.length + " trials in an emulated headset, " + answers.filter((a) => a.chosen_index === CREATURE).length + " times the object under the cross was chosen; poses in the log within " + worst.toFixed(3) + " degrees of those that were set");
await browser.close();
await host.stop();
