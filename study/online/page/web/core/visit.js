// A visit as the window has it (study/visit/visit.h): everything a participant meets, from consent to thanks, as a value.
// What must be stored comes out in `pending`, and nothing goes on until it is stored.
//
// script: {form, instruction_pages, training: [trial with right_index], pace}
// One thing is the page's own: a visit that was opened again goes on behind a pause, and does not repeat what was done.
import { faultOf } from "./form.js";
import { beginSession, nextSession } from "./session.js";
import { currentTrial, plannedTrials } from "./trials.js";

const PAUSABLE = ["instructions", "training", "feedback", "ready", "trial", "break", "briefing"];
const LAST = ["thanks", "declined", "ended", "stopped"];

function beginTraining(script, trained) {
  return beginSession(plannedTrials(script.training, trained), { ...script.pace, break_every_trials: 0, briefs: false });
}

/** The visit of a newcomer: at the consent. */
export function beginVisit(script) {
  return {
    script,
    form_done: false,
    resumed: false,
    training: beginTraining(script, 0),
    session: null,
    screen: { name: "consent" },
    pending: null,
  };
}

/** The visit of somebody who comes again: `known` is {form_done, trained, trials, begun}. */
export function resumeVisit(script, known) {
  const visit = {
    ...beginVisit(script),
    form_done: known.form_done,
    resumed: true,
    begun: known.begun,
    training: beginTraining(script, known.trained),
    session: beginSession(known.trials, script.pace),
  };
  if (visit.session.phase.name === "done") return showSession(visit);
  return { ...visit, screen: afterConsent(visit) };
}

const afterConsent = (visit) =>
  visit.form_done || visit.script.form.length === 0 ? { name: "display" } : { name: "form", problems: [] };

const trainingOrReady = (visit) => (visit.training.phase.name === "done" ? { name: "ready" } : { name: "training" });

function afterDisplay(visit) {
  const first =
    visit.script.instruction_pages > 0 ? { name: "instructions", page: 0 } : trainingOrReady(visit);
  if (!visit.resumed) return first;
  const goesOn = visit.session.phase.name === "briefing" ? { name: "briefing" } : { name: "trial" };
  if (visit.session.trials.answered > 0 || visit.begun) return { name: "pause", below: goesOn };
  if (visit.training.trials.answered > 0) return { name: "pause", below: trainingOrReady(visit) };
  return first;
}

/** The screen of the session's phase; asks for the completion after the last trial. */
function showSession(visit) {
  const phase = visit.session.phase.name;
  if (phase === "break" || phase === "briefing") return { ...visit, screen: { name: phase } };
  const pending = visit.session.phase.name === "done" ? { kind: "completion" } : null;
  return { ...visit, screen: { name: "trial" }, pending };
}

function afterStored(visit, record, event) {
  switch (record.kind) {
    case "decline":
      return { ...visit, screen: { name: "declined" } };
    case "form":
      return { ...visit, form_done: true, screen: { name: "display" } };
    case "display":
      return { ...visit, screen: afterDisplay(visit) };
    case "training":
      return {
        ...visit,
        training: nextSession(visit.training, { type: "answer_stored" }),
        screen: { name: "feedback", trial: record.trial, chosen_index: record.answer.chosen_index },
      };
    case "answer":
      return showSession({
        ...visit,
        session: nextSession(visit.session, { type: "answer_stored", next: event.next }),
      });
    default:
      return { ...visit, screen: { name: "thanks" } }; // completion
  }
}

function afterRecord(visit, event) {
  const record = visit.pending;
  if (record.kind === "consent") {
    if (event.type !== "enrolled") return visit;
    const enrolled = { ...visit, pending: null, session: beginSession(event.trials, visit.script.pace) };
    return { ...enrolled, screen: afterConsent(enrolled) };
  }
  return event.type === "record_stored" ? afterStored({ ...visit, pending: null }, record, event) : visit;
}

function onTraining(visit, event) {
  const training = nextSession(visit.training, event);
  if (training.phase.name !== "storing") return training === visit.training ? visit : { ...visit, training };
  const trial = currentTrial(training.trials);
  return { ...visit, training, pending: { kind: "training", trial, answer: training.phase.answer } };
}

function onTrial(visit, event) {
  const session = nextSession(visit.session, event);
  if (session.phase.name !== "storing") return session === visit.session ? visit : { ...visit, session };
  const trial = currentTrial(session.trials);
  return { ...visit, session, pending: { kind: "answer", trial, answer: session.phase.answer } };
}

function onForm(visit, event) {
  if (event.type !== "form_submitted") return visit;
  const value = (field) => event.answers.find((answer) => answer.field === field.name)?.value ?? "";
  const problems = visit.script.form
    .map((field) => ({ field: field.name, fault: faultOf(field, value(field)) }))
    .filter((problem) => problem.fault !== null);
  const answers = visit.script.form
    .map((field) => ({ field: field.name, value: value(field) }))
    .filter((answer) => answer.value !== "");
  const pending = problems.length === 0 ? { kind: "form", answers } : null;
  return { ...visit, screen: { name: "form", problems }, pending };
}

function onInstructions(visit, event) {
  const page = visit.screen.page;
  if (event.type === "went_back" && page > 0) return { ...visit, screen: { name: "instructions", page: page - 1 } };
  if (event.type !== "continued") return visit;
  const more = page + 1 < visit.script.instruction_pages;
  return { ...visit, screen: more ? { name: "instructions", page: page + 1 } : trainingOrReady(visit) };
}

function beginPause(visit) {
  const below = visit.screen;
  const taken = { type: "picture_taken" };
  return {
    ...visit,
    training: below.name === "training" ? nextSession(visit.training, taken) : visit.training,
    session: below.name === "trial" ? nextSession(visit.session, taken) : visit.session,
    screen: { name: "pause", below },
  };
}

function onScreen(visit, event) {
  const continued = event.type === "continued";
  switch (visit.screen.name) {
    case "consent":
      if (event.type === "consent_given")
        return { ...visit, pending: { kind: "consent", accepted_unix_s: event.unix_s } };
      return event.type === "consent_refused" ? { ...visit, pending: { kind: "decline" } } : visit;
    case "form":
      return onForm(visit, event);
    case "display":
      return event.type === "display_confirmed"
        ? { ...visit, pending: { kind: "display", facts: event.facts } }
        : visit;
    case "instructions":
      return onInstructions(visit, event);
    case "training":
      return onTraining(visit, event);
    case "feedback":
      return continued ? { ...visit, screen: trainingOrReady(visit) } : visit;
    case "ready":
      return continued ? showSession(visit) : visit;
    case "trial":
      return onTrial(visit, event);
    case "break":
    case "briefing":
      return continued
        ? showSession({ ...visit, session: nextSession(visit.session, { type: "break_ended" }) })
        : visit;
    case "pause":
      return continued ? { ...visit, screen: visit.screen.below } : visit;
    default:
      return visit; // thanks, declined, stopped
  }
}

/**
 * The visit after an event: those of a session (core/session.js), and {type: "consent_given" | "consent_refused" |
 * "form_submitted" | "display_confirmed" | "continued" | "went_back" | "pause_begun" | "record_stored" | "enrolled" |
 * "store_failed", ...}. What does not belong to the screen changes nothing.
 */
export function next(visit, event) {
  if (event.type === "store_failed") {
    const ended = LAST.includes(visit.screen.name);
    return { ...visit, pending: null, screen: ended ? visit.screen : { name: "stopped", message: event.message, reason: event.reason } };
  }
  if (event.type === "ended") return { ...visit, pending: null, screen: { name: "ended" } }; // sent away after the form
  if (visit.pending) return afterRecord(visit, event);
  if (event.type === "pause_begun") return PAUSABLE.includes(visit.screen.name) ? beginPause(visit) : visit;
  return onScreen(visit, event);
}

/** The session whose trial is on the screen, or null. */
export function sessionOnScreen(visit) {
  if (visit.screen.name === "training") return visit.training;
  return visit.screen.name === "trial" ? visit.session : null;
}
