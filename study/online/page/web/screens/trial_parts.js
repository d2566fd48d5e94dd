// What the trials of every task share: progress, answers as events, the row of numbered answers, late frames.
import { nanoseconds } from "../core/messages.js";
import { element } from "./dom.js";

/** Says how far the practice or the study is. */
export function showProgress(app, node, { answered, most }, isPractice) {
  if (isPractice) {
    const words = app.phrase("training_hint", { done: answered + 1, all: most });
    node.append(element("p", { class: "practice" }, words));
    return;
  }
  const bar = element("div", { class: "progress", "aria-hidden": "true" }, element("div"));
  bar.firstChild.style.width = (most > 0 ? (100 * answered) / most : 0) + "%";
  node.append(bar, element("p", { class: "progress-words" }, app.phrase("progress", { done: answered, all: most })));
}

/** What a task asks and says: its own words, where conditions ask differently, else the study's. */
export const askedBy = (app, task) => ({
  question: task.question ?? app.study.question,
  hint: task.hint ?? app.phrase(task.chooses ? "choice_hint" : "rating_hint"),
  rating_hint: task.rating_hint ?? app.phrase("rating_hint"),
  feedback_right: task.feedback_right ?? app.study.feedback_right,
  feedback_wrong: task.feedback_wrong ?? app.study.feedback_wrong,
});

/** Width and height of what a trial shows at a time; the study's is that of the widest. */
export const shownSize = (app, task) =>
  app.study.tasks && task.kind !== "pair" ? { ...app.study.picture, width: app.study.width_px } : app.study.picture;

/** Choices and ratings as events of the session, noted where they changed something. */
export function answering(app, session, isPractice) {
  const detail = isPractice ? "practice" : "";
  return {
    choose(index, event) {
      const before = session();
      app.step({ type: "object_chosen", index, now_ns: nanoseconds(event.timeStamp) });
      if (session() !== before) app.note("choice", (detail + " " + index).trim(), event.timeStamp);
    },
    slide(position, event) {
      const before = session();
      app.step({ type: "rating_given", position, now_ns: nanoseconds(event.timeStamp) });
      if (session() !== before || app.visit.pending) app.note("rating", (detail + " " + position).trim(), event.timeStamp);
    },
    rate(rating, event) {
      const before = session();
      app.step({ type: "rating_given", rating, now_ns: nanoseconds(event.timeStamp) });
      if (session() !== before || app.visit.pending) app.note("rating", (detail + " " + rating).trim(), event.timeStamp);
    },
  };
}

/**
 * A line on a stage with a place from 0 to 100, two labels at its ends or five over its fifths, and a button that ends it; the
 * place comes with the first press. `take(position, event)` hears where it stands in the end.
 */
export function sliderRow(app, stage, labels, take) {
  const line = element("input", { type: "range", id: "slider", class: labels.length === 5 ? "unset fifths" : "unset", min: 0, max: 100, step: 1, "aria-labelledby": "title" });
  const done = element("button", { type: "button", id: "slider-done", disabled: true, onclick: (event) => take(Number(line.value), event) }, app.phrase("continue"));
  const say = () => {
    const at = labels.length === 5 ? Math.min(4, Math.floor(Number(line.value) / 20)) : Number(line.value) < 50 ? 0 : 1;
    line.setAttribute("aria-valuetext", line.value + ", " + labels[at]);
  };
  const begin = () => {
    line.classList.remove("unset");
    done.disabled = false;
    say();
  };
  line.addEventListener("input", begin);
  line.addEventListener("pointerdown", begin);
  line.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && !event.repeat && !done.disabled) take(Number(line.value), event);
  });
  const words = labels.map((label) => element("span", {}, label));
  const ends = element("div", { class: "slider-labels" + (labels.length === 2 ? " ends" : ""), "aria-hidden": "true" }, ...words);
  stage.answers.replaceChildren(element("div", { class: "slider" }, element("div", { class: "slider-line" }, ends, line), done));
  stage.questions.hidden = false;
  app.focus(line);
}

/** A row of numbered answers on a stage; `take(number from 1, event)` hears which. Its buttons. */
export function answerRow(stage, name, labels, take) {
  const buttons = labels.map((label, at) =>
    element(
      "button",
      { type: "button", class: "rating", id: name + "-" + (at + 1), onclick: (event) => take(at + 1, event) },
      at + 1 + "\u2002" + label
    )
  );
  const group = element("div", { class: "ratings", role: "group", "aria-labelledby": "title" }, ...buttons);
  stage.answers.replaceChildren(group);
  tightenRow(stage);
  return buttons;
}

/** Labels that are too long for one line get two, in the small type. */
export function tightenRow(stage) {
  const group = stage.answers.querySelector(".ratings");
  if (!group) return;
  stage.questions.hidden = false;
  group.classList.remove("tight");
  group.classList.toggle("tight", group.scrollWidth > group.clientWidth);
}

/** Counts frames that come late, until the picture is shown. */
export function lateFrames(app) {
  let late = 0;
  let last = null;
  return {
    see(now) {
      const period = 1000 / (app.screen.refreshHz() || 60);
      if (last !== null && now - last > 1.5 * period && now - last < 1000) ++late;
      last = now;
    },
    tell(now) {
      if (late > 0) app.note("late_frames", String(late), now);
      late = 0;
      last = null;
    },
  };
}

/** Counts for how many refreshes of the screen a task's pictures or masks stand there, and notes each that ended by itself. */
export function exposures(app, kind, time_ns, detail) {
  let seen = -1;
  let since = 0;
  return {
    /** A frame that begins at `now` shows a picture, from 0, or none (-1). */
    see(visible, now) {
      if (time_ns === 0 || visible === seen) return;
      const period = 1000 / (app.screen.refreshHz() || 60);
      const frames = Math.round((now - since) / period);
      const wanted = Math.max(1, Math.round(time_ns / 1e6 / period));
      if (seen >= 0) app.note(kind, (detail + ` picture ${seen + 1} frames ${frames} wanted ${wanted}`).trim(), now);
      seen = visible;
      since = now;
    },
    /** An answer or a pause ended it. */
    forget() {
      seen = -1;
    },
  };
}
