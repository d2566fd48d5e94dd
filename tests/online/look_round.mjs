// Looking round in a browser: the codes of twenty poses of every view beside an independent resampling (panorama_view.py), and
// a whole visit by mouse, in which the object behind the start is found, through reloads and a killed browser (Chromium; Firefox
// is only loaded anew). Pictures to look at: WORK/shots/look-*.png.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readlinkSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { staticHost } from "./hosts.mjs";
import { act, actUntil, axeFindings, inFirefox, look, openBrowser, panoramaFiles } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const shots = join(work, "shots");
const codes = join(work, "look-codes");
for (const folder of [shots, codes]) mkdirSync(folder, { recursive: true });
const folder = join(work, "look-static");

const host = await staticHost(join(work, "look"));
const profile = mkdtempSync(join(work, "browser-"));
let browser;
let page;
async function open() {
  browser = await openBrowser(profile, { width: 1100, height: 800 });
  page = browser.pages()[0];
  page.on("dialog", (dialog) => dialog.accept());
  page.on("pageerror", (error) => console.error(error));
  await page.goto(host.address);
}
await open();
const prefix = inFirefox ? "look-firefox-" : "look-";
const shown = new Set();
/** A picture to look at; axe has nothing to say of what it shows. */
const shot = async (name) => {
  writeFileSync(join(shots, prefix + name + ".png"), await page.screenshot());
  if (shown.has(name)) return;
  shown.add(name);
  assert.deepEqual(await axeFindings(page), [], "axe: " + name);
};

/** The browser's own process ends as by a crash, found by its profile's lock; it is opened again. */
async function kill() {
  const pid = Number(readlinkSync(join(profile, "SingletonLock")).split("-").pop());
  process.kill(pid, "SIGKILL");
  await browser.close().catch(() => {});
  await new Promise((resolve) => setTimeout(resolve, 500));
  await open();
}
const disruptions = new Map(); // by "ANSWERED PHASE", each once
disruptions.set("2 choosing", () => page.reload()).set("5 rating", () => page.reload());
disruptions.set("8 rating", inFirefox ? () => page.reload() : kill);

/** What another program says of views of a trial's panorama that were drawn: how far they are apart. */
function compareCodes(trial, texts, { view_px, horizontal_fov_deg }, poses) {
  texts.forEach((text, i) => writeFileSync(join(codes, i + ".rgba"), Buffer.from(text, "base64")));
  writeFileSync(join(codes, "poses.json"), JSON.stringify({ ...panoramaFiles(folder, trial.picture), view_px, horizontal_fov_deg, poses }));
  const words = execFileSync("/usr/bin/python3", [join(import.meta.dirname, "panorama_view.py"), codes], { encoding: "utf8" }).trim();
  assert.ok(Number(/difference ([0-9.]+)/.exec(words)[1]) <= 1, words);
  return words;
}

/** Twenty poses of a trial's panorama, as the graphics draw them, against the resampling of another program. */
async function comparePoses(trial) {
  const poses = Array.from({ length: 20 }, (_, i) => ({ yaw_deg: -180 + 18.3 * i, pitch_deg: i === 0 ? 0 : -85 + ((i * 61) % 171) }));
  poses[1] = { yaw_deg: 0, pitch_deg: 0 };
  const drawn = await page.evaluate(
    ([stimulus, poses]) => {
      const app = globalThis.seamline;
      const one = app.study.looks[app.study.look_of[stimulus]];
      const texts = poses.map((pose) => {
        app.view.draw(one, pose);
        let text = "";
        const bytes = app.view.read();
        for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
        return btoa(text);
      });
      return { look: one, texts };
    },
    [trial.stimulus_id, poses]
  );
  console.log(compareCodes(trial, drawn.texts, drawn.look, poses));
}

const middleOf = async () => {
  const box = await page.locator("canvas.picture").boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};
/** How far, in pixels of the view's middle, the middle of an object is from the cross. */
const wayTo = (picture, object) =>
  page.evaluate(
    async ([picture, object]) => {
      const app = globalThis.seamline;
      const frame = (await app.pictures.ready(picture)).map.frames[object - 1];
      const { width, height } = app.view.size();
      const there = {
        yaw_deg: ((frame.x_px + frame.width_px / 2) / width - 0.5) * 360,
        pitch_deg: (0.5 - (frame.y_px + frame.height_px / 2) / height) * 180,
      };
      const here = app.looking.pose();
      const right = ((there.yaw_deg - here.yaw_deg + 540) % 360) - 180;
      return { x: right / app.looking.degreesPerPixel, y: -(there.pitch_deg - here.pitch_deg) / app.looking.degreesPerPixel };
    },
    [picture, object]
  );

/** Drags until the object with this number is in the middle of what is seen, then clicks it. */
async function findAndClick(picture, object, name) {
  const at = await middleOf();
  for (let i = 0; i < 60; ++i) {
    const way = await wayTo(picture, object);
    if (Math.hypot(way.x, way.y) < 3) break;
    const step = Math.min(1, 200 / Math.hypot(way.x, way.y));
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x - way.x * step, at.y - way.y * step, { steps: 5 });
    await page.mouse.up();
  }
  await shot(name);
  await page.mouse.click(at.x, at.y);
}

const asked = () => page.waitForFunction(() => !document.querySelector(".questions")?.hidden && document.querySelector("canvas.visible"));
const turns = () => page.evaluate(() => globalThis.seamline.looking.turns);

await actUntil(page, ["training"]);
await asked();
await shot("practice");
await comparePoses((await look(page)).trial);
await page.evaluate(() => globalThis.seamline.looking.turn(0, 0)); // the view of the trial again

// A phone that is turned turns the view with it: upright, then by 30 degrees to the right and 10 up (CDP: of Chromium only).
if (!inFirefox) {
  const device = await page.context().newCDPSession(page);
  const held = (alpha, beta, gamma) => device.send("DeviceOrientation.setDeviceOrientationOverride", { alpha, beta, gamma });
  const poseOf = () => page.evaluate(() => globalThis.seamline.looking.pose());
  await held(20, 90, 0);
  await page.waitForTimeout(300);
  const before = await poseOf();
  await held(350, 100, 0);
  await page.waitForFunction(({ yaw_deg }) => Math.abs(globalThis.seamline.looking.pose().yaw_deg - yaw_deg) > 1, before);
  const after = await poseOf();
  assert.ok(Math.abs(after.yaw_deg - before.yaw_deg - 30) < 0.1 && Math.abs(after.pitch_deg - before.pitch_deg - 10) < 0.1, JSON.stringify([before, after]));
  await device.send("DeviceOrientation.clearDeviceOrientationOverride");
  console.log("a phone turned by 30 degrees to the right and 10 up turns the view so far");
}

// The keys + and - change the field of view by 5 degrees, within the study's limits.
const fieldAfter = async (key, times) => {
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
  return page.evaluate(() => globalThis.seamline.looking.pose().fov_deg);
};
assert.equal(await fieldAfter("-", 7), 90, "no wider than 90");
assert.equal(await fieldAfter("+", 11), 40, "no nearer than 40");
assert.equal(await fieldAfter("-", 3), 55);
const zoomed = await page.evaluate(() => {
  const { view, looking, study } = globalThis.seamline;
  let text = "";
  const bytes = view.read();
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return { text: btoa(text), pose: looking.pose(), view_px: study.looks.find(({ kind }) => kind === "mouse").view_px };
});
console.log("at a field of 55 degrees: " + compareCodes((await look(page)).trial, [zoomed.text], { ...zoomed, horizontal_fov_deg: 55 }, [zoomed.pose]));

// Practice by keys: the arrows turn, Enter takes what is under the cross.
const practised = (await look(page)).trial;
for (let i = 0; i < 400 && (await look(page)).phase === "choosing"; ++i) {
  const way = await wayTo(practised.picture, practised.right_index);
  const key = Math.abs(way.x) > 12 ? (way.x > 0 ? "ArrowRight" : "ArrowLeft") : Math.abs(way.y) > 12 ? (way.y > 0 ? "ArrowDown" : "ArrowUp") : "Enter";
  await page.keyboard.press(key);
}
assert.equal((await look(page)).phase, "rating");
await page.keyboard.press("3");
await page.waitForSelector("#continue");
await shot("feedback");
await page.click("#continue");

// The study by mouse: of every picture that turns the creature is chosen, which stands behind the start.
const CREATURE = 3;
let found = 0;
const chosen = new Map(); // by trial
const isOver = ({ screen }) => ["thanks", "stopped"].includes(screen);
for (let now = await look(page); !isOver(now); now = await look(page)) {
  const disrupt = now.screen === "trial" && disruptions.get(now.answered + " " + now.phase);
  if (now.screen === "break") await shot("break");
  if (disrupt) {
    disruptions.delete(now.answered + " " + now.phase);
    await disrupt();
    await page.waitForFunction(() => globalThis.seamline?.visit);
  } else if (now.screen !== "trial") await act(page, now, { mouse: true });
  else if (now.asks && now.phase === "choosing") {
    const turning = await turns();
    if (turning) await page.keyboard.press("+");
    if (turning) await findAndClick(now.trial.picture, CREATURE, "turned");
    else {
      await shot("still");
      const box = await page.locator("#object-1").boundingBox();
      await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    }
    const after = await look(page);
    if (after.phase === "rating") chosen.set(now.answered, turning ? CREATURE : 1);
    if (turning && found++ === 0) await shot("rating");
  } else if (now.asks && now.phase === "rating") await page.click("#rating-2");
  await page.waitForTimeout(10);
}
const messages = await page.evaluate(() => globalThis.seamline.store.messages());
const answers = messages.filter(({ kind }) => kind === "answer").map(({ body }) => body);
const looks = messages.filter(({ kind, body }) => kind === "event" && body.kind === "look").map(({ body }) => body);
assert.equal(answers.length, 12);
const comfort = messages.filter(({ kind, body }) => kind === "event" && body.kind === "comfort").map(({ body }) => body.detail);
assert.deepEqual(comfort, ["2 6"], "how people feel is asked at the break");
const starts = new Set(); // of views that turn
answers.forEach((answer) => assert.equal(answer.chosen_index, chosen.get(answer.trial_index)));
for (const answer of answers) {
  const poses = looks.filter((one) => one.trial_index === answer.trial_index).flatMap(({ detail }) => detail.split(";").map((pose) => pose.split(" ").map(Number)));
  const moving = chosen.get(answer.trial_index) === CREATURE;
  assert.ok(poses.length > 0 && poses[0][0] === 0 && Math.abs(poses[0][1]) <= (moving ? 20 : 0.05), "every trial says where it began");
  if (moving) starts.add(poses[0][1]);
  if (moving) assert.deepEqual([poses[0][3], poses.at(-1)[3]], [70, 65], "the field is with the pose");
  assert.equal(poses.length > 3, moving, "fixed views do not move, the others do");
  if (moving) assert.ok(Math.abs(Math.abs(poses.at(-1)[1]) - 177) < 6, "it ends at the creature, behind the start");
  for (let i = 1; i < poses.length; ++i) assert.ok(poses[i][0] - poses[i - 1][0] >= 32, "at most thirty poses a second");
}
assert.ok(starts.size >= 5, "they begin at different directions: " + [...starts]);
assert.equal(disruptions.size, 0, "the visit was broken off as often as it was to be");
console.log("12 trials by mouse, broken off three times, no answer lost: " + found + " times the object behind the start was found and chosen, its poses are in the log");
writeFileSync(join(work, "look.jsonl"), messages.map((message) => JSON.stringify(message) + "\n").join(""));
await browser.close();
await host.stop();

// The log as it is imported says how the person felt at the break.
const log = join(work, "look.sqlite");
const tables = join(work, "look-tables");
for (const old of [log, log + "-lock", tables]) rmSync(old, { recursive: true, force: true });
execFileSync(process.env.SEAMLINE_PROGRAM, ["import", log, join(work, "look.jsonl"), "--set", join(work, "look-set")]);
execFileSync(process.env.SEAMLINE_PROGRAM, ["export", "tables", log, tables]);
assert.match(readFileSync(join(tables, "comfort.csv"), "utf8"), /^participant,answered,comfort\n[^,]+,6,2\n$/);
