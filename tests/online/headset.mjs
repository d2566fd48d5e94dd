// A headset that is emulated (npm iwer) through a whole visit, practice and its feedback without the headset included: what both
// eyes were shown at known turns of the head beside an independent resampling (panorama_view.py), choices by what the cross is
// on, ratings on the board, and the imported log's poses and answers beside those that were set.
// Pictures to look at: WORK/shots/headset-*.png.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, axeFindings, look, openBrowser, panoramaFiles } from "./person.mjs";

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

const around = (deg) => ((((deg + 180) % 360) + 360) % 360) - 180;
let front_deg = 0; // where the emulated head faced when the trial began: yaw 0 of the panorama, which is the study's start
const asOrientation = ([yaw_deg, pitch_deg]) => {
  const [a, p] = [(-yaw_deg * Math.PI) / 360, (pitch_deg * Math.PI) / 360];
  // First up, then to the right: q = yaw x pitch.
  return [Math.cos(a) * Math.sin(p), Math.sin(a) * Math.cos(p), -Math.sin(a) * Math.sin(p), Math.cos(a) * Math.cos(p)];
};

/** Turns the head to a yaw and pitch of the panorama, and waits until the page has seen it: poses come some frames later. */
async function turn(yaw_deg, pitch_deg) {
  await page.evaluate((q) => globalThis.device.quaternion.set(...q), asOrientation([front_deg + yaw_deg, pitch_deg]));
  const wait = ([yaw, pitch]) => {
    const pose = globalThis.seamline.headset.pose();
    return Math.abs(((((pose.yaw_deg - yaw) % 360) + 540) % 360) - 180) < 0.01 && Math.abs(pose.pitch_deg - pitch) < 0.01;
  };
  await page.waitForFunction(wait, [yaw_deg, pitch_deg], { timeout: 10000 }).catch(async () => {
    throw new Error("the head was turned to " + [yaw_deg, pitch_deg] + ", the page has " + JSON.stringify(await page.evaluate(() => globalThis.seamline.headset?.pose())));
  });
}

/**
 * Puts the headset on, level and facing 0. The emulator makes its "local" space of the head's last pose with all its tilt, where
 * a headset's is upright: the pose is made level before.
 */
async function putOn() {
  await shot("before");
  await page.evaluate(() => {
    const { device } = globalThis;
    device.quaternion.set(0, 0, 0, 1);
    const { viewerSpace } = device;
    const inner = Object.getOwnPropertySymbols(viewerSpace).map((symbol) => viewerSpace[symbol]).find((one) => one?.offsetMatrix);
    inner.offsetMatrix.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  });
  front_deg = 0;
  await page.click("#wear");
  await page.waitForFunction(() => globalThis.seamline.headset !== null);
}

async function trigger() {
  const press = (value) => page.evaluate((to) => globalThis.device.controllers.right.updateButtonValue("trigger", to), value);
  const frames = () => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(resolve)))));
  await press(1);
  await frames();
  await press(0);
  await frames();
}
const taken = new Set();
const shot = async (name) => {
  if (taken.has(name)) return;
  taken.add(name);
  writeFileSync(join(shots, "headset-" + name + ".png"), await page.screenshot());
  // Later the emulator's own layer lies over the page.
  if (name === "before") assert.deepEqual(await axeFindings(page), [], "axe: " + name);
};

/** Where the middle of an object is from the start. */
const objectAt = (picture, object) =>
  page.evaluate(
    async ([picture, object]) => {
      const app = globalThis.seamline;
      const frame = (await app.pictures.ready(picture)).map.frames[object - 1];
      const { width, height } = app.view.size();
      return { yaw_deg: ((frame.x_px + frame.width_px / 2) / width - 0.5) * 360, pitch_deg: (0.5 - (frame.y_px + frame.height_px / 2) / height) * 180 };
    },
    [picture, object]
  );

/** What both eyes see now beside the independent program: {text, worst} in codes. */
async function readEyes(picture) {
  const eyes = await page.evaluate(() => globalThis.seamline.headset.read());
  assert.equal(eyes.length, 2);
  const poses = eyes.map(({ codes: text, pose, half, middle, width, height, panorama }, at) => {
    writeFileSync(join(codes, at + ".rgba"), Buffer.from(text, "base64"));
    return { ...pose, half, middle, size: [width, height], panorama };
  });
  writeFileSync(join(codes, "poses.json"), JSON.stringify({ ...panoramaFiles(folder, picture), set: join(work, "head-set"), poses }));
  const text = execFileSync("/usr/bin/python3", [join(import.meta.dirname, "panorama_view.py"), codes], { encoding: "utf8" }).trim();
  return { text, poses, eyes: poses.map((pose) => pose.panorama), worst: Number(/difference ([0-9.]+)/.exec(text)[1]) };
}

async function compareEyes(picture, panoramas) {
  for (const [yaw, pitch] of [[0, 0], [75, 30], [-160, -40]]) {
    await turn(yaw, pitch);
    const { text, poses, eyes, worst } = await readEyes(picture);
    console.log("both eyes of " + panoramas + (panoramas > 1 ? " panoramas" : " panorama") + " at yaw " + yaw + ", pitch " + pitch + ": " + text);
    assert.ok(worst <= 1, "both eyes are right");
    assert.deepEqual(eyes, panoramas > 1 ? [0, 1] : [0, 0], "the left eye sees the left one");
    for (const pose of poses) assert.ok(Math.abs(around(pose.yaw_deg - yaw)) < 0.01 && Math.abs(pose.pitch_deg - pitch) < 0.01, "each looks where the head was turned");
  }
}

const isAsked = () => page.evaluate(() => (globalThis.seamline.headset?.scene.words ?? null) !== null);
const OBJECTS = 3;
const wanted = new Map(); // by trial: {object, rating, head} as they were set
const compared = new Set(); // by the panoramas of a picture
const end = Date.now() + 540000;
let seen = await look(page);
for (; !["thanks", "stopped"].includes(seen.screen); seen = await look(page)) {
  assert.ok(Date.now() < end, "the visit comes to its end: " + JSON.stringify(seen));
  if (!["trial", "training"].includes(seen.screen)) await act(page, seen, { mouse: true });
  else if (await page.locator("#wear").isVisible()) await putOn();
  else if (seen.trial && !seen.pending && (await isAsked())) {
    const object = 1 + (seen.answered % OBJECTS);
    const rating = 1 + (seen.answered % 4);
    const where = await objectAt(seen.trial.picture, object);
    if (seen.phase === "choosing") {
      const panoramas = await page.evaluate(() => globalThis.seamline.view.eyes());
      if (!compared.has(panoramas)) {
        compared.add(panoramas);
        await compareEyes(seen.trial.picture, panoramas);
        await turn(0, -10);
        await shot("question-" + panoramas);
      }
      await turn(where.yaw_deg, where.pitch_deg);
      await shot("object-" + object);
      await trigger();
      assert.equal((await look(page)).phase, "rating", "the trigger chose what the cross was on");
    } else if (seen.phase === "rating") {
      // The board is in front, 27 degrees down; its four answers are 13 degrees apart.
      await page.waitForFunction((yaw) => Math.abs(globalThis.seamline.headset.boardYaw() - yaw) < 0.1, where.yaw_deg);
      const aim = { yaw_deg: where.yaw_deg + 13 * (rating - 2.5), pitch_deg: -30 };
      await turn(aim.yaw_deg, aim.pitch_deg);
      assert.equal(await page.evaluate(() => globalThis.seamline.headset.answer()), rating, "the cross is on the answer");
      await shot("rating");
      if (seen.screen === "trial") wanted.set(seen.answered, { object, rating, head: [where, aim] });
      await trigger();
      front_deg += aim.yaw_deg; // the next trial begins in front of the head as it is now
      await page.waitForFunction(
        ([screen, answered]) => globalThis.seamline.visit.screen.name !== screen || globalThis.seamline.visit.session.trials.answered > answered,
        [seen.screen, seen.answered]
      );
    }
  }
  await page.waitForTimeout(20);
}
assert.equal(seen.screen, "thanks", seen.message ?? "");
assert.deepEqual([...compared].sort(), [1, 2], "pictures of one panorama and of two were seen");
await page.waitForFunction(() => globalThis.seamline.headset === null);
await shot("thanks");

// The log as it is imported, and its tables.
const messages = await page.evaluate(() => globalThis.seamline.store.messages());
writeFileSync(join(work, "head.jsonl"), messages.map((message) => JSON.stringify(message) + "\n").join(""));
await browser.close();
await host.stop();
const log = join(work, "head.sqlite");
const tables = join(work, "head-tables");
for (const old of [log, log + "-lock", tables]) rmSync(old, { recursive: true, force: true });
const run = (...options) => execFileSync(process.env.SEAMLINE_PROGRAM, options, { encoding: "utf8" });
console.log(run("import", log, join(work, "head.jsonl"), "--set", join(work, "head-set")).trim());
run("export", "tables", log, tables);
const rows = (name) => {
  const [head, ...lines] = readFileSync(join(tables, name + ".csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => Object.fromEntries(head.map((key, at) => [key, line[at]])));
};
const answers = rows("answers");
const poses = rows("poses");
assert.equal(answers.length, wanted.size, "every answer is in the log");
let worst_deg = 0;
for (const answer of answers) {
  const set = wanted.get(Number(answer.trial_index));
  assert.equal(Number(answer.chosen_index), set.object);
  assert.equal(Number(answer.rating), set.rating);
  const found = poses.filter((pose) => pose.trial_index === answer.trial_index);
  for (const { yaw_deg, pitch_deg } of set.head)
    worst_deg = Math.max(worst_deg, Math.min(...found.map((pose) => Math.hypot(around(pose.yaw_deg - yaw_deg), pose.pitch_deg - pitch_deg))));
}
assert.ok(worst_deg <= 0.08, "the log's poses are those that were set, but for rounding to 0.1 degrees: " + worst_deg);
console.log(answers.length + " trials in an emulated headset to the end: each object and rating that the cross was on is in the imported log; " + poses.length + " poses, those that were set within " + worst_deg.toFixed(3) + " degrees");
