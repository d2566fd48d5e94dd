// The trials of a participant: all of them, as the program planned them, or one by one as a server places them.

/** {order: [trial], answered, most}: the whole order is known. */
export const plannedTrials = (order, answered = 0) => ({ order, answered, most: order.length });

/** {due, answered, most}: `due` is the trial that the server placed, or null when the session is over. */
export const placedTrials = (due, answered, most) => ({ due, answered, most });

/** The trial that is due, or null. */
export function currentTrial(trials) {
  if (trials.order) return trials.order[trials.answered] ?? null;
  return trials.due;
}

/** Those that come after it, as far as they are known. */
export function trialsAhead(trials) {
  return trials.order ? trials.order.slice(trials.answered) : trials.due ? [trials.due] : [];
}

/** Once the trial that was due is answered; `next` is what the server places after it. */
export function afterAnswer(trials, next) {
  const answered = trials.answered + 1;
  return trials.order ? { ...trials, answered } : { ...trials, answered, due: next ?? null };
}
