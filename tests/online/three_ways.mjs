// Each task by the same people three ways: in the window (keys on a virtual screen), in a browser at `serve`, and on a page without
// a server whose saved files are imported. `thresholds.json` of the three logs is the same, byte for byte but for people's names.
// In Firefox, whose driver saves no files, two ways: the window, and the browser at `serve`.
//   run PROGRAM WORK three_ways [firefox] [TASK...]
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { realServe, staticHost } from "./hosts.mjs";
import { actUntil, inFirefox, openBrowser } from "./person.mjs";

const work = process.env.SEAMLINE_ONLINE_WORK;
const program = process.env.SEAMLINE_PROGRAM;
const PEOPLE = 3;
const LEVELS = [64, 128, 256, 512];
const SCREEN = { width: 1024, height: 768 };
const rest = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const run = (...args) => execFileSync(program, args, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

const TASKS = {
  paper: { tables: "" },
  object2: { file: "two", tables: '[task]\nkind = "object"\nobjects = 2\n' },
  object5: { file: "five", tables: '[task]\nkind = "object"\nobjects = 5\n' },
  pair: { tables: '[task]\nkind = "pair"\nsecond_question = true\n' },
  interval: { tables: '[task]\nkind = "interval"\nexposure_s = 0.1\ngap_s = 0.05\n' },
  yes_no: { references: 8, tables: '[task]\nkind = "yes_no"\n' },
  rating: { references: 8, tables: '[task]\nkind = "rating"\n' },
  masked: { tables: '[task]\nkind = "interval"\nexposure_s = 0.1\ngap_s = 0.15\nmask = "scrambled"\nmask_s = 0.1\n' },
  slider: { references: 8, tables: '[task]\nkind = "rating"\nscale = "slider"\n' },
  briefed: {
    references: 8,
    kinds: { turn: "masked", seen: "slider" },
    tables: `[[condition]]
name = "turn"
instructions = "Two pictures, one after another."
task = { kind = "interval", exposure_s = 0.1, gap_s = 0.15, mask = "noise", mask_s = 0.05 }
[[condition]]
name = "seen"
instructions = "Now one picture, and a line."
task = { kind = "rating", scale = "slider", labels = ["nothing", "very much"] }
`,
  },
  same: { references: 8, tables: '[task]\nkind = "pair"\nasks = "same"\n' },
  conditions: {
    references: 12,
    kinds: { which: "paper", turn: "interval", beside: "pair", seen: "yes_no" },
    tables: `[[condition]]
name = "which"
[[condition]]
name = "turn"
task = { kind = "interval", exposure_s = 0.1, gap_s = 0.05 }
[[condition]]
name = "beside"
task = { kind = "pair", second_question = true }
[[condition]]
name = "seen"
task = { kind = "yes_no" }
`,
  },
  clip: {
    references: 4,
    levels: [64],
    tables: '[clip]\nframes = 6\nframes_per_s = 12\nplays = "once"\nquestion = "after"\n[task]\nkind = "rating"\nrepetitions = 2\n',
    scene: (text) => text.replace("position_m = [-1.7, 0.0, -4.35]", '$&\n  path = { kind = "line", to_m = [-1.5, 0.0, -4.1], speed_m_s = 0.3 }'),
  },
  match: { references: 0, tables: '[task]\nkind = "match"\nrepetitions = 2\n' },
};

/** A small study: nothing but consent and trials, and one order for everybody. */
function studyText(name, { file, tables, references = 2, levels = LEVELS, scene: change = (text) => text }) {
  const five = readFileSync(join(import.meta.dirname, "five_objects.toml"), "utf8");
  const three = readFileSync(join(import.meta.dirname, "tiny.toml"), "utf8");
  let scene = (file ? five : three).replace(/^[^]*?(?=\[\[scene\]\])/, "");
  if (file === "two") scene = scene.replace(/# Three more[^]*$/, "");
  scene = change(scene);
  const catches = references > 0 ? `[catch]\nreference = ${references}\n` : "";
  return `format = "seamline study 1"
name = "three ways ${name}"
width_px = 400
height_px = 240
samples_per_pixel = 2
seed = 5
depth_width_px = [${levels}]
participant_form = false
[session]
orders = 1
break_every_trials = 1000
inter_trial_s = 0.05
${catches}${name === "match" ? "" : "[training]\ntrials = 0\n"}[consent]
text = "Small pictures."
[[instructions.page]]
text = "Press a digit."
${tables}
${scene}`;
}

const query = (log, sql) =>
  JSON.parse(
    execFileSync(
      "/usr/bin/python3",
      ["-c", "import json, sqlite3, sys; print(json.dumps(sqlite3.connect(sys.argv[1]).execute(sys.argv[2]).fetchall()))", log, sql],
      { encoding: "utf8" }
    )
  );

/** Of each trial of the one order: its kind, its level, and what is right; as the log of a simulated person has them. */
function plannedTrials(set, folder, kind) {
  const log = join(folder, "planned.sqlite");
  run("study", set, "--log", log, "--observer", "perfect", "--count", "1", "--seed", "1");
  const right = kind === "paper" ? "0" : "right_index";
  const rows = query(log, `SELECT trial_index, kind, level, object_index, ${right}, condition FROM trials JOIN stimuli USING (stimulus) ORDER BY trial_index`);
  return rows.map(([, trial, level, object, drawn, condition]) => ({ kind: trial, level, condition, right: drawn !== 0 ? drawn : trial === "reference" ? 0 : object }));
}

/** A number in [0, 1) that is always the same for a person, a trial and a question. */
function chance(person, trial, question) {
  let hash = 2166136261;
  for (const value of [person, trial, question, 47]) hash = Math.imul(hash ^ (value + 1), 16777619) >>> 0;
  return (Math.imul(hash ^ (hash >>> 15), 2246822519) >>> 0) / 2 ** 32;
}

/** What a person does in a trial: sees the coarse levels more often than the fine ones. */
function deedOf(kind, alternatives, trial, person, at) {
  if (kind === "match") return { steps: Math.floor(chance(person, at, 3) * 7) - 3 };
  const seen = trial.kind === "stimulus" && chance(person, at, 1) < { 64: 0.95, 128: 0.75, 256: 0.4, 512: 0.15 }[trial.level];
  const rating = 1 + Math.floor(chance(person, at, 2) * 4);
  if (kind === "slider") {
    const position = (seen ? 20 * rating : 0) + Math.floor(chance(person, at, 6) * 20);
    return { position: position === 50 ? 51 : position }; // in the middle no key would be pressed
  }
  if (kind === "rating" || kind === "clip") return { rating: seen ? 1 + rating : 1 };
  if (kind === "yes_no" || kind === "same") return { choice: seen || chance(person, at, 4) < 0.1 ? 1 : 2 };
  const guess = 1 + Math.floor(chance(person, at, 5) * alternatives);
  return { choice: seen ? trial.right : guess, rating: seen ? rating : 1 };
}

/** The keys of a trial's phase. */
function keysOf(deed, phase) {
  if (deed.steps !== undefined) return [...Array(Math.abs(deed.steps)).fill(deed.steps < 0 ? "Left" : "Right"), "Return"];
  if (deed.position !== undefined) {
    const tens = Math.trunc((deed.position - 50) / 10);
    const ones = deed.position - 50 - 10 * tens;
    const keys = (count, more, less) => Array(Math.abs(count)).fill(count > 0 ? more : less);
    return [...keys(tens, "Prior", "Next"), ...keys(ones, "Right", "Left"), "Return"];
  }
  return [String(phase === "choosing" ? deed.choice : deed.rating)];
}

/** A screen without a monitor. */
async function openScreen() {
  const server = spawn("Xvfb", ["-displayfd", "1", "-screen", "0", `${SCREEN.width}x${SCREEN.height}x24`, "-nolisten", "tcp"], { stdio: ["ignore", "pipe", "ignore"] });
  const number = await new Promise((resolve, reject) => {
    server.stdout.once("data", (bytes) => resolve(String(bytes).trim()));
    server.on("error", reject);
  });
  return { display: ":" + number, close: () => server.kill("SIGTERM") };
}

/** A sitting in the window, by keys. */
async function inWindow({ display }, set, log, folder, person, deed, kindOf) {
  const config = join(folder, "config", "seamline");
  mkdirSync(config, { recursive: true });
  const profile = { mm_per_px: 0.25, viewing_distance_mm: 600, gamma_confirmed: true };
  writeFileSync(
    join(config, "display.json"),
    JSON.stringify({ format: "seamline display", version: 1, screens: { [`screen ${SCREEN.width}x${SCREEN.height} ${SCREEN.width}`]: profile } })
  );
  const trace = join(folder, "trace-" + person);
  const env = { ...process.env, DISPLAY: display, XDG_CONFIG_HOME: join(folder, "config"), LIBGL_ALWAYS_SOFTWARE: "1" };
  delete env.WAYLAND_DISPLAY;
  const child = spawn(program, ["study", set, "--log", log, "--participant", "p" + person, "--trace", trace], { env, stdio: "ignore" });
  const over = new Promise((resolve) => child.on("exit", resolve));
  const press = (...keys) => execFileSync("xdotool", ["key", "--delay", "40", ...keys], { env });
  const pressed = new Map(); // when: what a clip that still plays does not hear is pressed again
  try {
    for (const end = Date.now() + 180000; ; await rest(20)) {
      assert.ok(Date.now() < end && child.exitCode === null, "the sitting in the window did not end");
      const lines = existsSync(trace) ? readFileSync(trace, "utf8").split("\n") : [];
      const line = lines.length > 1 ? JSON.parse(lines.at(-2)) : {};
      if (line.screen === "thanks") break;
      if (line.screen === "consent") press("Tab", "Tab", "Return");
      if (["instructions", "ready", "break", "briefing"].includes(line.screen)) press("Return");
      const asked = line.trial + line.phase;
      const wait_ms = kindOf(line.trial) === "clip" ? 1000 : Infinity;
      if (!["choosing", "rating"].includes(line.phase) || Date.now() - pressed.get(asked) < wait_ms) continue;
      await rest(120);
      pressed.set(asked, Date.now());
      press(...keysOf(deed(line.trial), line.phase));
    }
    press("Return");
    await Promise.race([over, rest(1000)]);
  } finally {
    child.kill("SIGKILL");
    await over;
  }
}

/** A sitting in a browser, by keys. `end(page)` once all is answered. */
async function inBrowser(address, deed, end = async () => {}) {
  const browser = await openBrowser(mkdtempSync(join(work, "browser-")), { width: 1100, height: 800 });
  const done = new Set();
  try {
    const page = browser.pages()[0];
    await page.goto(address);
    await actUntil(page, ["thanks"], {
      patience_ms: 180000,
      each: async (seen) => {
        const asked = seen.answered + seen.phase;
        if (seen.screen !== "trial" || !seen.asks || !["choosing", "rating"].includes(seen.phase) || done.has(asked)) return;
        done.add(asked);
        await page.waitForTimeout(30);
        for (const key of keysOf(deed(seen.answered), seen.phase)) await page.keyboard.press({ Left: "ArrowLeft", Right: "ArrowRight", Return: "Enter", Prior: "PageUp", Next: "PageDown" }[key] ?? key);
        await page.waitForFunction(
          ([answered, phase]) => {
            const { visit } = globalThis.seamline;
            return visit.session.trials.answered > answered || visit.session.phase.name !== phase;
          },
          [seen.answered, seen.phase]
        );
      },
      answer: () => ({ choice: 0, rating: 9 }), // keys that answer nothing: the deeds are in `each`
    });
    await end(page);
  } finally {
    await browser.close();
  }
}

/**
 * Ways give people different names: here they are "1", "2", ... in the order in which they took part. How many frames of clips came late is
 * each screen's own, and left out.
 */
const thresholdsOf = (log, out) => {
  run("analyze", log, "--out", out, "--bootstrap", "100");
  const names = [];
  const text = readFileSync(join(out, "thresholds.json"), "utf8").replace(/\s*"Of \d+ frames of clips [^"]*",?/g, "").replace(/,(\s*\])/g, "$1");
  return text.replace(/("participant": )"([^"]*)"/g, (all, key, name) => {
    if (!names.includes(name)) names.push(name);
    return `${key}"${names.indexOf(name) + 1}"`;
  });
};

const wanted = process.argv.slice(2);
const screen = await openScreen();
let failed = 0;
for (const [kind, task] of Object.entries(TASKS)) {
  if (wanted.length > 0 && !wanted.includes(kind)) continue;
  const folder = mkdtempSync(join(work, "ways-" + kind + "-"));
  const file = join(folder, "study.toml");
  const set = join(folder, "set");
  writeFileSync(file, studyText(kind, task));
  run("render", file, "--out", set, "--estimator", "fast");
  run("export", "web", set, join(folder, "page-serve"), "--serve");
  run("export", "web", set, join(folder, "page-static"), "--slots", "1");
  const trials = kind === "match" ? [] : plannedTrials(set, folder, kind);
  const alternatives = { paper: 3, object2: 2, object5: 5 };
  const kindAt = (at) => task.kinds?.[trials[at].condition] ?? kind;
  const deed = (person) => (at) => deedOf(kindAt(at), alternatives[kindAt(at)] ?? 2, trials[at], person, at);
  const logs = Object.fromEntries((inFirefox ? ["window", "browser"] : ["window", "browser", "import"]).map((way) => [way, join(folder, way + ".sqlite")]));
  const server = await realServe(program, join(folder, "page"), set, logs.browser);
  const host = await staticHost(join(folder, "page"));
  const saved = [];
  try {
    for (let person = 0; person < PEOPLE; ++person) {
      await inWindow(screen, set, logs.window, folder, person, deed(person), kindAt);
      await inBrowser(server.address, deed(person));
      if (inFirefox) continue;
      await inBrowser(host.address, deed(person), async (page) => {
        const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
        saved.push(join(folder, "person-" + person + ".jsonl"));
        await download.saveAs(saved.at(-1));
      });
    }
  } finally {
    await server.stop();
    await host.stop();
  }
  if (!inFirefox) run("import", logs.import, ...saved, "--set", set);
  const texts = Object.entries(logs).map(([way, log]) => thresholdsOf(log, join(folder, way)));
  const answers = Object.values(logs).map((log) => query(log, `SELECT trial_index, chosen_index, rating, (SELECT detail FROM events WHERE kind = 'slid' AND events.session = answers.session
     AND events.trial_index = answers.trial_index) FROM answers ORDER BY participant, trial_index`));
  assert.ok(answers[0].length > 0);
  const same = texts.every((text) => text === texts[0]) && answers.every((one) => JSON.stringify(one) === JSON.stringify(answers[0]));
  if (!same) ++failed;
  console.log(`${kind}: ${answers[0].length} answers of ${PEOPLE} people; thresholds.json of ${Object.keys(logs).join(", ")} ${same ? "is the same" : "DIFFERS: " + folder} (${texts[0].length} bytes)`);
}
screen.close();
assert.equal(failed, 0);
