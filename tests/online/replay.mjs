// Replays the window's visits in the page's own state machine, and compares after every event.
//   replay.mjs WEB_FOLDER VISITS.json     (tests/online/web_visit_test.cpp writes them)
import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { webcrypto } from "node:crypto";

globalThis.crypto ??= webcrypto; // Debian 12's Node 18 has it under this name only; browsers have it everywhere

let copied = null;
/** One of the page's modules, where Node takes .js for modules. */
export async function importPart(web, name) {
  if (copied === null) {
    copied = mkdtempSync(join(tmpdir(), "seamline-page-"));
    writeFileSync(join(copied, "package.json"), '{"type":"module"}');
    cpSync(web, copied, { recursive: true });
  }
  return import(pathToFileURL(join(copied, name)));
}
export const importCore = (web, name) => importPart(web, join("core", name));

function nameOfScreen({ name, page, problems, chosen_index }) {
  if (name === "form") return "form " + problems.length;
  if (name === "instructions") return "instructions " + page;
  return name === "feedback" ? "feedback " + chosen_index : name;
}

function nameOfPhase(phase) {
  const { name, answer } = phase;
  if (name === "rating") return ["rating", phase.chosen_index, phase.choice_ns].join(" ");
  if (name !== "storing") return name;
  return ["storing", answer.trial_index, answer.chosen_index, answer.rating, answer.choice_ns, answer.rating_ns, answer.position ?? -1].join(" ");
}

function nameOfRecord(record) {
  if (record === null) return "nothing";
  return record.kind === "form" ? "form " + record.answers.length : record.kind;
}

function stateOf({ screen, pending, training, session }) {
  const own = session === null ? "none" : nameOfPhase(session.phase) + " " + session.trials.answered;
  const practice = nameOfPhase(training.phase) + " " + training.trials.answered;
  return [nameOfScreen(screen), nameOfRecord(pending), practice, own].join(" | ");
}

if (process.argv[1].endsWith("replay.mjs")) {
  const [, , web, file] = process.argv;
  const { beginVisit, next } = await importCore(web, "visit.js");
  const { script, trials, briefings, visits } = JSON.parse(readFileSync(file, "utf8"));
  const order = Array.from({ length: trials }, (_, at) => ({ stimulus_id: String(at), ...(briefings[at] >= 0 ? { briefing: briefings[at] } : {}) }));
  let events = 0;
  for (const steps of visits) {
    let visit = beginVisit(script);
    steps.forEach(([event, state], at) => {
      const whole = event.type === "enrolled" ? { ...event, trials: { order, answered: 0, most: trials } } : event;
      visit = next(visit, whole);
      ++events;
      assert.equal(stateOf(visit), state, "after event " + at + ": " + JSON.stringify(event));
    });
  }
  console.log("%d visits, %d events", visits.length, events);
}
