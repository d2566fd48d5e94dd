// Clips in a browser: what stands in the canvas at every frame of the page, beside the clip's file as Node's zlib reads it; a slow
// decoder that is planted; a loop; and the log of a whole visit.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inflateSync } from "node:zlib";
import { staticHost } from "./hosts.mjs";
import { act, inFirefox, look, openBrowser } from "./person.mjs";
import { decodePng } from "./png.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const folder = join(work, "clips-static");
const study = JSON.parse(readFileSync(join(folder, "study.json"), "utf8"));

/** A number for the codes of a picture, RGBA. */
const numberOf = (rgba) => {
  const words = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.byteLength / 4);
  let number = 1;
  for (let i = 0; i < words.length; ++i) number = (Math.imul(number, 31) + words[i]) | 0;
  return number;
};

/** The frames of a clip's file as RGBA, and where its first object stands in each. */
function readClip(file) {
  const bytes = readFileSync(join(folder, file));
  const end = bytes.indexOf("\n", 16);
  const header = JSON.parse(bytes.subarray(16, end));
  let at = end + 1;
  const codes = Buffer.alloc(3 * header.width_px * header.height_px);
  const frames = header.frames.map((frame) => {
    const change = inflateSync(bytes.subarray(at, at + frame.bytes));
    at += frame.bytes;
    for (let i = 0; i < codes.length; ++i) codes[i] = (codes[i] + change[i]) & 255;
    assert.equal(createHash("sha256").update(codes).digest("hex"), frame.sha256);
    const rgba = new Uint8Array(4 * header.width_px * header.height_px).fill(255);
    for (let i = 0; i < codes.length / 3; ++i) rgba.set(codes.subarray(3 * i, 3 * i + 3), 4 * i);
    return rgba;
  });
  const maps = JSON.parse(readFileSync(join(folder, study.pictures.find((one) => one.file === file).map), "utf8"));
  return { frames, numbers: frames.map(numberOf), lefts: maps.map((map) => map.frames[0].x_px), header };
}
const clips = new Map(study.pictures.map(({ file }) => [file, readClip(file)]));
for (const { numbers } of clips.values()) assert.equal(new Set(numbers).size, 48, "frames differ, or their order could not be told");

/** Sees the picture at every frame of the page, from its onset on. */
function watch(numberOf) {
  const number = new Function("return " + numberOf)();
  globalThis.seen = [];
  const every = (now) => {
    const app = globalThis.seamline;
    const canvas = document.querySelector("canvas.picture.visible");
    const name = app?.visit?.screen.name;
    const session = name === "training" ? app.visit.training : app?.visit?.session;
    if (canvas && ["training", "trial"].includes(name) && ["awaiting", "choosing", "rating"].includes(session.phase.name)) {
      const left = parseFloat(document.getElementById("object-1").style.left) * devicePixelRatio - canvas.getBoundingClientRect().left * devicePixelRatio;
      globalThis.seen.push({ now, number: number(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data), left });
    }
    requestAnimationFrame(every);
  };
  requestAnimationFrame(every);
}

function slowDecoder(delay_ms) {
  const Plain = globalThis.DecompressionStream;
  globalThis.DecompressionStream = class {
    constructor(kind) {
      const plain = new Plain(kind);
      const wait = new TransformStream({ flush: () => new Promise((resolve) => setTimeout(resolve, delay_ms)) });
      return { writable: plain.writable, readable: plain.readable.pipeThrough(wait) };
    }
  };
}

/** A visit of the study with some values of its study.json changed. */
async function visit(changes, { init = [], last = 2, ...options } = {}) {
  const host = await staticHost(join(work, "clips"));
  const body = JSON.stringify(changes({ ...study }));
  host.instead = (_, path) => (path === "/study.json" ? { status: 200, type: "application/json", body } : null);
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 900, height: 700 });
  const page = browser.pages()[0];
  page.on("dialog", (dialog) => dialog.accept());
  // Screenshots of the driver add a style, which the page's policy refuses: Firefox calls that an error of the page.
  page.on("pageerror", (error) => (inFirefox && /Content-Security-Policy.*inline style/.test(String(error))) || assert.fail(error));
  await page.addInitScript(watch, numberOf.toString());
  for (const [script, value] of init) await page.addInitScript(script, value);
  await page.goto(host.address);
  const trials = [];
  const isOver = (now) => ["thanks", "stopped"].includes(now.screen) || (now.screen === "trial" && now.answered >= last);
  for (let now = await look(page); !isOver(now); now = await look(page)) {
    if (now.asks && now.phase === "choosing" && now.trial) {
      await options.asked?.(page, now);
    }
    if (now.asks && now.phase === "rating") {
      await options.rates?.(page, now);
      const seen = await page.evaluate(() => globalThis.seen);
      if (now.screen === "trial") trials.push({ trial: now.trial, seen });
    }
    const before = now.phase;
    await act(page, now, { mouse: true });
    if (before === "rating") await page.evaluate(() => (globalThis.seen = []));
    await page.waitForTimeout(10);
  }
  const end = await look(page);
  assert.notEqual(end.screen, "stopped", end.message);
  const messages = await page.evaluate(() => globalThis.seamline.store.messages());
  console.log("a screen of " + (await page.evaluate(() => globalThis.seamline.screen.refreshHz())) + " Hz");
  await browser.close();
  await host.stop();
  const notes = messages.filter(({ kind, body }) => kind === "event" && body.kind === "clip").map(({ body }) => body);
  return { trials, notes, messages };
}

const counted = (note) => {
  const found = /^(practice )?shown (\d+) late (\d+) dropped (\d+)$/.exec(note.detail);
  assert.ok(found, note.detail);
  return { shown: Number(found[2]), late: Number(found[3]), dropped: Number(found[4]) };
};

/** Which frame stood in the canvas at each frame of the page; every one is the file's, code for code. */
function framesOf({ trial, seen }) {
  const { numbers, lefts } = clips.get(trial.picture);
  return seen.map(({ number, left }) => {
    const frame = numbers.indexOf(number);
    assert.ok(frame >= 0, "what stands in the canvas is a frame of the file");
    assert.ok(Math.abs(left - lefts[frame]) < 0.6, "corners stand where the object is: " + left + ", " + lefts[frame]);
    return frame;
  });
}

/** Until a clip that is shown once is over. */
async function over(page, { trial }) {
  await page.waitForFunction((last) => globalThis.seen.at(-1)?.number === last, clips.get(trial.picture).numbers[47]);
  await page.waitForTimeout(100);
}

/** What the screen shows of a clip that is over, beside the file's last frame. */
async function compareScreen(page, { trial }) {
  await page.mouse.move(1, 1);
  await over(page, { trial });
  const clip = await page.locator("canvas.picture").boundingBox();
  const { width, height, channels, bytes } = decodePng(await page.screenshot({ clip }));
  const { frames, header } = clips.get(trial.picture);
  assert.deepEqual([width, height], [header.width_px, header.height_px]);
  for (let i = 0; i < width * height; ++i)
    for (let c = 0; c < 3; ++c) assert.equal(bytes[channels * i + c], frames[47][4 * i + c], "a code of the screen at " + (i % width) + ", " + Math.floor(i / width));
  console.log("the screen shows the last frame, code for code");
}

// Shown once, and the question after it.
for (const frames_per_s of [24, 60]) {
  const changes = (json) => ({ ...json, clip: { ...json.clip, frames_per_s }, pace: { ...json.pace, minimum_viewing_ns: Math.round(48e9 / frames_per_s) } });
  const { trials, notes } = await visit(changes, { last: 6, rates: over, asked: async (page, now) => frames_per_s === 24 && now.screen === "trial" && now.answered === 0 && compareScreen(page, now) });
  let whole = 0;
  for (const [at, trial] of trials.entries()) {
    const frames = framesOf(trial);
    const found = [...new Set(frames)];
    assert.deepEqual(frames, [...frames].sort((a, b) => a - b), "frames are shown in order");
    const said = counted(notes.filter(({ trial_index }) => trial_index !== null)[at]);
    assert.equal(said.shown + said.dropped, 48);
    assert.equal(said.shown, found.length, "the log counts what was seen");
    const playing = frames.slice(frames.lastIndexOf(0), frames.indexOf(47) + 1);
    if (found.length === 48 && said.late === 0 && (frames_per_s < 60 || playing.length === 48)) ++whole;
    console.log("%d frames a second: seen %d of 48 frames in order at %d frames of the page; log: %s", frames_per_s, found.length, playing.length, JSON.stringify(said));
  }
  assert.ok(whole > 0, "no clip was shown whole, each frame at its time and none twice: is the machine busy?");
}

// A slow decoder is seen in the log: a frame every 150 ms, of a clip of 24 a second.
{
  const { trials, notes } = await visit((json) => json, { init: [[slowDecoder, 150]], rates: over, last: 1 });
  const said = counted(notes.at(-1));
  framesOf(trials[0]);
  console.log("a decoder that takes 150 ms a frame: " + JSON.stringify(said));
  assert.ok(said.late >= 10, "late frames are counted");
}

// A loop, asked during it; then a whole visit goes into a log.
{
  const changes = (json) => ({ ...json, clip: { ...json.clip, loops: true }, pace: { ...json.pace, minimum_viewing_ns: 0 } });
  const { trials, notes, messages } = await visit(changes, {
    last: 1000,
    asked: async (page, now) => now.answered === 0 && now.screen === "trial" && page.waitForTimeout(2500),
  });
  const frames = framesOf(trials[0]);
  assert.ok(frames.some((frame, i) => i > 0 && frames[i - 1] > 40 && frame < 8), "it begins anew");
  console.log("loop: " + trials.length + " trials, the first " + JSON.stringify(counted(notes.find(({ trial_index }) => trial_index === 0))));
  const answers = messages.filter(({ kind }) => kind === "answer").length;
  assert.equal(notes.filter(({ trial_index }) => trial_index !== null).length, answers);
  const file = join(work, "clips.jsonl");
  const log = join(work, "clips.sqlite");
  rmSync(log, { force: true });
  writeFileSync(file, messages.filter(({ participant }) => participant !== "").map((message) => JSON.stringify(message) + "\n").join(""));
  execFileSync(process.env.SEAMLINE_PROGRAM, ["import", log, file, "--set", join(work, "clips-set")]);
  const count = "import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute(\"select count(*) from events where kind = 'clip' and detail like '%shown % late % dropped %'\").fetchone()[0])";
  assert.equal(Number(execFileSync("/usr/bin/python3", ["-c", count, log], { encoding: "utf8" })), notes.length);
  console.log("imported: " + notes.length + " events of clips");
}
