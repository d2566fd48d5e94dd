// A session as the window has it (study/visit/session.h): a value, and a pure function from an event to the next value.
// Times are monotonic nanoseconds, whole numbers.
import { afterAnswer, currentTrial } from "./trials.js";

// What a trial asks of a study that names no task (stimuli/definition/parts/task_definition.h).
const PAPERS_TASK = { kind: "object", alternatives: 3, pictures: 1, exposure_ns: 0, gap_ns: 0, chooses: true, rates: true };
/** What a trial asks; `pace.tasks` are those of conditions that have their own. */
export const taskOf = (pace, trial) => pace.tasks?.[trial?.task ?? 0] ?? pace.task ?? PAPERS_TASK;
const taskDue = (session) => taskOf(session.pace, currentTrial(session.trials));

/** Where the next picture begins. */
const beforeImage = (pace) =>
  pace.inter_trial_ns > 0 ? { name: "grey", since_ns: null } : { name: "awaiting" };

/** The block of trials that a trial belongs to, where that has instructions of its own. */
const briefedBlock = (trial) => trial?.briefing ?? -1;

function afterGrey(phase, event, pace) {
  if (event.type === "picture_taken") return { name: "grey", since_ns: null };
  if (event.type !== "tick") return phase;
  if (phase.since_ns === null) return { name: "grey", since_ns: event.now_ns };
  return event.now_ns - phase.since_ns < pace.inter_trial_ns ? phase : { name: "awaiting" };
}

function afterShown(event, phase, task) {
  if (task.pictures > 1) return { name: "viewing", onset_ns: event.now_ns, picture: phase.picture ?? 0 };
  if (!task.chooses) return { name: "rating", onset_ns: event.now_ns, chosen_index: 0, choice_ns: 0 };
  return { name: "choosing", onset_ns: event.now_ns };
}

function afterViewing(phase, event, session) {
  const task = taskDue(session);
  if (event.type === "picture_taken") return beforeImage(session.pace);
  if (event.type !== "tick" || event.now_ns - phase.onset_ns < task.exposure_ns) return phase;
  if (phase.picture + 1 === task.pictures) return { name: "choosing", onset_ns: phase.onset_ns };
  return { name: "gap", since_ns: phase.onset_ns + task.exposure_ns, picture: phase.picture + 1 };
}

function afterGap(phase, event, session) {
  if (event.type === "picture_taken") return beforeImage(session.pace);
  if (event.type !== "tick" || event.now_ns - phase.since_ns < taskDue(session).gap_ns) return phase;
  return { name: "awaiting", picture: phase.picture };
}

/** Whether the picture of a trial is seen at a time while the answer is awaited. */
export const isPictureSeen = (task, onset_ns, now_ns) =>
  task.pictures === 1 && (task.exposure_ns === 0 || now_ns - onset_ns < task.exposure_ns);

/** Whether the mask of the picture that came at `onset_ns` is seen at a time. */
export function isMaskSeen(task, onset_ns, now_ns) {
  const since_ns = now_ns - onset_ns - task.exposure_ns;
  return task.exposure_ns > 0 && since_ns >= 0 && since_ns < (task.mask_ns ?? 0);
}

/** Where a slider can stand, and the label of five whose fifth a place is. */
const SLIDER_END = 100;
const ratingAt = (position) => Math.min(4, Math.floor((5 * position) / SLIDER_END));

const isChoice = (event, onset_ns, session) =>
  event.index >= 1 && event.index <= taskDue(session).alternatives && event.now_ns >= onset_ns &&
  event.now_ns - onset_ns >= session.pace.minimum_viewing_ns;

function afterChoice(phase, event, session) {
  const task = taskDue(session);
  if (event.type === "picture_taken") return beforeImage(session.pace);
  if (event.type !== "object_chosen" || !isChoice(event, phase.onset_ns, session)) return phase;
  if (task.adjusts) return afterStep(phase, event, session);
  const chosen = { chosen_index: event.index, choice_ns: event.now_ns - phase.onset_ns };
  if (task.rates) return { name: "rating", onset_ns: phase.onset_ns, ...chosen };
  const answer = { trial_index: session.trials.answered, ...chosen, rating: 1, rating_ns: chosen.choice_ns };
  return { name: "storing", answer };
}

/** A match: a step to a picture where more (1) or less (2) is seen, or the end (3), at the picture that is on the screen. */
function afterStep(phase, event, session) {
  const trial = currentTrial(session.trials);
  const at = phase.picture ?? trial.start;
  if (event.index < 3) {
    const moved = at + (event.index === 1 ? -1 : 1);
    return { ...phase, picture: moved >= 0 && moved < trial.pictures.length ? moved : at };
  }
  const choice_ns = event.now_ns - phase.onset_ns;
  const answer = { trial_index: session.trials.answered, chosen_index: event.index, choice_ns, rating: 1, rating_ns: choice_ns };
  return { name: "storing", answer: { ...answer, stimulus_id: trial.names[at] } };
}

/** The answer of a task without a choice: whether anything was seen is the rating's to say. */
function afterOnlyRating(phase, event, session) {
  if (event.type !== "rating_given") return phase;
  const { slides } = taskDue(session);
  const isPlace = event.position >= 0 && event.position <= SLIDER_END;
  const rating = slides ? ratingAt(event.position) : event.rating;
  if (slides ? !isPlace : !(rating >= 0 && rating <= 4)) return phase;
  const rating_ns = event.now_ns - phase.onset_ns;
  if (rating_ns < session.pace.minimum_viewing_ns) return phase;
  const seen = rating > 0;
  return {
    name: "storing",
    answer: {
      trial_index: session.trials.answered,
      chosen_index: seen ? 1 : 2,
      rating: seen ? rating : 1,
      ...(slides ? { position: event.position } : {}),
      choice_ns: rating_ns,
      rating_ns,
    },
  };
}

function afterRating(phase, event, session) {
  if (event.type === "picture_taken") return beforeImage(session.pace);
  if (!taskDue(session).chooses) return afterOnlyRating(phase, event, session);
  if (event.type === "object_chosen") {
    const again = afterChoice({ name: "choosing", onset_ns: phase.onset_ns }, event, session);
    return again.name === "rating" ? again : phase;
  }
  if (event.type !== "rating_given" || !(event.rating >= 1 && event.rating <= 4)) return phase;
  const rating_ns = event.now_ns - phase.onset_ns;
  if (rating_ns < phase.choice_ns) return phase;
  return {
    name: "storing",
    answer: {
      trial_index: session.trials.answered,
      chosen_index: phase.chosen_index,
      rating: event.rating,
      choice_ns: phase.choice_ns,
      rating_ns,
    },
  };
}

/** `before`: the trial that was answered last, or null at the beginning. */
function nextTrial(session, before) {
  const due = currentTrial(session.trials);
  if (!due) return { name: "done" };
  const block = session.pace.briefs ? briefedBlock(due) : -1;
  const briefing = block >= 0 && block !== briefedBlock(before);
  const every = session.pace.break_every_trials;
  if (every > 0 && before && session.trials.answered % every === 0) return { name: "break", briefing };
  return briefing ? { name: "briefing" } : beforeImage(session.pace);
}

/** `event.next` is what a server placed next, for trials that it places one by one. */
function afterStoring(session, event) {
  if (event.type !== "answer_stored") return session;
  const before = currentTrial(session.trials);
  const after = { ...session, trials: afterAnswer(session.trials, event.next) };
  return { ...after, phase: nextTrial(after, before) };
}

/** At the first unanswered trial, or done when there is none. */
export function beginSession(trials, pace) {
  const session = { trials, pace };
  return { ...session, phase: nextTrial(session, null) };
}

/**
 * The session after an event: {type: "tick" | "image_shown" | "object_chosen" | "rating_given" | "answer_stored" |
 * "break_ended" | "picture_taken", now_ns, index, rating, position, next}. What does not belong to the phase changes nothing.
 */
export function nextSession(session, event) {
  const phase = session.phase;
  const becomes = (changed) => (changed === phase ? session : { ...session, phase: changed });
  switch (phase.name) {
    case "grey":
      return becomes(afterGrey(phase, event, session.pace));
    case "awaiting":
      return event.type === "image_shown" ? becomes(afterShown(event, phase, taskDue(session))) : session;
    case "viewing":
      return becomes(afterViewing(phase, event, session));
    case "gap":
      return becomes(afterGap(phase, event, session));
    case "choosing":
      return becomes(afterChoice(phase, event, session));
    case "rating":
      return becomes(afterRating(phase, event, session));
    case "storing":
      return afterStoring(session, event);
    case "break":
      if (event.type !== "break_ended") return session;
      return becomes(phase.briefing ? { name: "briefing" } : beforeImage(session.pace));
    case "briefing":
      return event.type === "break_ended" ? becomes(beforeImage(session.pace)) : session;
    default:
      return session; // done
  }
}
