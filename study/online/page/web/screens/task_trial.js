// Trials of tasks other than the paper's: pairs, intervals, yes or no, ratings (study/app/screens/screen_task.cpp).
import { placeTrial } from "../core/place.js";
import { isMaskSeen, isPictureSeen, taskOf } from "../core/session.js";
import { currentTrial, trialsAhead } from "../core/trials.js";
import { nanoseconds } from "../core/messages.js";
import { element, svg } from "./dom.js";
import { answerRow, answering, askedBy, exposures, lateFrames, showProgress, shownSize, sliderRow, tightenRow } from "./trial_parts.js";

/** The stage of a picture: everything is placed in pixels of the screen. */
function makeStage(app, display, task) {
  const fixation = svg("path", { class: "fixation" });
  const overlay = svg("svg", { class: "overlay", "aria-hidden": "true" }, fixation);
  const question = element("h1", { id: "title" });
  const hint = element("p", { class: "hint" });
  const answers = element("div", { class: "answers" });
  const questions = element("div", { class: "questions" }, question, hint, answers);
  const node = element("div", { class: "stage" }, overlay, questions);
  const isPair = task.kind === "pair";
  display.append(node);
  const stage = { node, overlay, fixation, question, hint, answers, questions, images: [], masksFrom: 0, place: null };

  /** Puts everything where it belongs; the picture at whole pixels of the screen, as large as it is. */
  stage.layOut = () => {
    const ratio = devicePixelRatio;
    const size = app.screen.size();
    const place = placeTrial(size, shownSize(app, task), app.em());
    stage.place = place;
    overlay.setAttribute("viewBox", "0 0 " + size.width + " " + size.height);
    const x = place.x + Math.round(place.width / 2);
    const y = place.y + Math.round(place.height / 2);
    fixation.setAttribute("d", `M${x - 12} ${y - 1}h24v2h-24zM${x - 1} ${y - 12}h2v24h-2z`);
    questions.style.top = place.questions_y / ratio + "px";
    stage.images.forEach((image, at) => {
      image.style.left = (place.x + (isPair ? (at % 2) * (place.width - app.study.width_px) : 0)) / ratio + "px";
      image.style.top = place.y / ratio + "px";
      image.style.width = app.study.width_px / ratio + "px";
      image.style.height = place.height / ratio + "px";
    });
  };

  /** The pictures of a trial: side by side in a pair, else one over the other. */
  stage.put = (images, mask = null) => {
    stage.images.forEach((image) => image.remove());
    stage.masksFrom = images.length;
    if (mask) images = [...images, mask, ...(isPair ? [mask] : [])];
    // A picture that is shown twice needs an element for each.
    stage.images = images.map((image, at) => (images.indexOf(image) === at ? image : image.cloneNode()));
    for (const image of stage.images) {
      image.className = "picture";
      image.alt = "";
      image.draggable = false;
      node.prepend(image);
    }
    stage.layOut();
    app.screen.watchPicture(stage.images[0]);
  };

  /** Shows one of the pictures that stand over each other, or both of a pair, or the mask in their place; -1: none. */
  stage.show = (which, masked = false) =>
    stage.images.forEach((image, at) => {
      const seen = at >= stage.masksFrom ? masked : which >= 0 && (isPair || at === which);
      image.classList.toggle("visible", seen);
    });

  return stage;
}

const WHEEL_REST_MS = 120; // a touchpad sends many turns of the wheel for one stroke
// What a key of a match does: 1 clearer, 2 fainter, 3 it is just seen.
const STEPS = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: 2, ArrowDown: 2, Enter: 3, " ": 3 };

/** The files that a trial shows: one, or several side by side or one after another. */
const picturesOf = (trial) => trial.pictures ?? [trial.picture];
const filesOf = (trial) => [...picturesOf(trial), ...(trial.mask ? [trial.mask] : [])];
const picturesReady = (app, trial) => Promise.all(filesOf(trial).map((file) => app.pictures.ready(file)));
/** Puts what is ready of a trial on its stage. */
function putReady(stage, trial, ready) {
  const images = ready.map((one) => one.image);
  const count = picturesOf(trial).length;
  stage.put(images.slice(0, count), images[count] ?? null);
}

/** The picture of a pair at a place: 1 left, 2 right, or 0. */
function sideAt(study, x, y) {
  if (y < 0 || y >= study.picture.height || x < 0 || x >= study.picture.width) return 0;
  if (x < study.width_px) return 1;
  return x >= study.picture.width - study.width_px ? 2 : 0;
}

/** Draws the trial that is due, of the practice or of the study, from the grey before it to its answer. */
export function drawTaskTrial(app, display, isPractice) {
  const session = () => (isPractice ? app.visit.training : app.visit.session);
  const trial = currentTrial(session().trials);
  if (trial === null) return {}; // all are answered, and the completion is being stored
  const task = taskOf(session().pace, trial);
  const texts = askedBy(app, task);
  const stage = makeStage(app, display, task);
  const detail = isPractice ? "practice" : "";
  let picture = null; // what is shown, once it is decoded
  let clip = null; // that plays
  let ratings = []; // the buttons of the row of answers
  let asked = ""; // the phase whose question stands there
  let shownWith = null; // the frame that shows the picture has begun
  let frame = null;
  let frameAt = null; // when the frame began that is being drawn
  const lateness = lateFrames(app);
  const exposed = exposures(app, "exposure", task.exposure_ns, detail);
  const masked = exposures(app, "mask", task.mask_ns ?? 0, detail);
  let open = true;

  showProgress(app, stage.node, session().trials, isPractice);

  const step = (event) => app.step(event);
  const answers = answering(app, session, isPractice);
  /** Answers that end the trial: what its clip showed is noted before them. */
  const ending = (answer) => (value, event) => {
    if (clip) app.note("clip", (detail + " " + clip.showing()).trim(), event.timeStamp);
    answer(value, event);
  };
  const [choose, rate, slide] = [task.rates ? answers.choose : ending(answers.choose), ending(answers.rate), ending(answers.slide)];

  const phase = () => session().phase;
  const isOpen = (now) => now >= phase().onset_ns + session().pace.minimum_viewing_ns;

  function showQuestion() {
    stage.question.textContent = texts.question;
    stage.hint.textContent = texts.hint;
    ratings = answerRow(stage, "answer", task.answers, choose);
  }

  const takeRating = (digit, event) => rate(task.chooses ? digit : digit - 1, event);

  function showSlider() {
    stage.question.textContent = texts.question;
    stage.hint.textContent = texts.hint;
    ratings = [];
    sliderRow(app, stage, task.labels, slide);
    app.say(texts.question);
  }

  function showRatings() {
    if (task.slides) return showSlider();
    const question = task.chooses ? app.study.rating_question : texts.question;
    stage.question.textContent = question;
    stage.hint.textContent = task.chooses ? texts.rating_hint : texts.hint;
    ratings = answerRow(stage, "rating", task.chooses ? app.study.rating_labels : task.labels, takeRating);
    app.say(question);
  }

  /** What is drawn now is seen a frame later, and what is due within half a frame of that is due then. */
  const whenSeen = (now) => nanoseconds(now + 1500 / (app.screen.refreshHz() || 60));

  /** Which of the trial's pictures is seen, from 0; -1: none. */
  function shownPicture(now, answering) {
    if (now.name === "viewing") return now.picture;
    if (now.name === "awaiting" && shownWith !== null) return now.picture ?? trial.start ?? 0;
    if (answering && task.adjusts) return now.picture ?? trial.start;
    if (answering && isPictureSeen(task, now.onset_ns, whenSeen(performance.now()))) return 0;
    return -1;
  }

  /** The picture whose mask is seen in its place, from 0; -1: none. */
  function shownMask(now, answering) {
    const at = whenSeen(performance.now());
    if (now.name === "gap") return at - now.since_ns < (task.mask_ns ?? 0) ? now.picture - 1 : -1;
    return answering && isMaskSeen(task, now.onset_ns, at) ? task.pictures - 1 : -1;
  }

  /** What the phase shows. */
  function update() {
    const now = phase();
    const answering = ["choosing", "rating"].includes(now.name);
    const visible = shownPicture(now, answering);
    const mask = shownMask(now, answering);
    stage.show(visible, mask >= 0);
    if (["grey", "storing"].includes(now.name)) [exposed, masked].forEach((counted) => counted.forget());
    else if (frameAt !== null) {
      exposed.see(visible, frameAt);
      masked.see(mask, frameAt);
    }
    stage.fixation.classList.toggle("visible", visible < 0 && mask < 0 && ["grey", "awaiting", "gap"].includes(now.name));
    const opened = isOpen(nanoseconds(performance.now()));
    const asking = (now.name === "rating" && (task.chooses || opened)) || (now.name === "choosing" && opened);
    if (asking && asked !== now.name) {
      asked = now.name;
      if (now.name === "rating") {
        showRatings();
      } else {
        showQuestion();
        app.say(texts.question);
      }
    }
    stage.questions.hidden = !asking;
    if (["grey", "awaiting", "viewing", "gap"].includes(now.name)) {
      ratings = [];
      asked = "";
    }
    const timed = ["grey", "awaiting", "viewing", "gap"].includes(now.name);
    if (["grey", "awaiting"].includes(now.name)) clip?.rewind();
    const changes = answering && task.exposure_ns > 0 && (visible >= 0 || mask >= 0); // the exposure, or its mask
    if (open && frame === null && (timed || changes || (answering && (!asking || clip?.isPlaying()))))
      frame = requestAnimationFrame(onFrame);
  }

  /** Runs while something changes by itself: grey, the picture's first frame, the least time of viewing. */
  function onFrame(now) {
    frame = null;
    if (!open) return;
    frameAt = now;
    lateness.see(now);
    if (phase().name === "grey") step({ type: "tick", now_ns: nanoseconds(now) });
    if (["viewing", "gap"].includes(phase().name)) step({ type: "tick", now_ns: whenSeen(now) });
    if (phase().name === "awaiting") {
      if (shownWith !== null) {
        // The frame before this one had the picture, so it is on the screen now.
        shownWith = null;
        app.note("shown", detail, now);
        lateness.tell(now);
        step({ type: "image_shown", now_ns: nanoseconds(now) });
      } else if (picture && (clip?.isReady() ?? true) && app.guard.problem() === null) {
        shownWith = now;
      }
    }
    if (phase().name !== "awaiting") shownWith = null;
    if (clip && ["choosing", "rating"].includes(phase().name)) clip.play(now - phase().onset_ns / 1e6, 1000 / (app.screen.refreshHz() || 60));
    if (open) update();
    frameAt = null;
  }

  /** A pair is answered by the picture itself, too. */
  const onPress = (event) => {
    if (event.button !== 0 || event.target.closest("button") || app.guard.problem() !== null) return;
    if (task.kind !== "pair" || task.compares || phase().name !== "choosing" || stage.questions.hidden) return;
    const ratio = devicePixelRatio;
    const side = sideAt(app.study, event.clientX * ratio - stage.place.x, event.clientY * ratio - stage.place.y);
    if (side > 0) choose(side, event);
  };

  /** Arrows go round the answers. */
  function moveFocus(back) {
    const places = ratings;
    if (places.length === 0) return;
    const at = places.indexOf(document.activeElement);
    const next = at < 0 ? (back ? places.length - 1 : 0) : (at + (back ? places.length - 1 : 1)) % places.length;
    places[next].focus();
  }
  /** A match: arrows step (also while they are held down), Enter and Space end it. */
  const stepKey = (key) => STEPS[key] ?? 0;
  const onKey = (event) => {
    const step = task.adjusts && !event.ctrlKey && !event.metaKey && !event.altKey ? stepKey(event.key) : 0;
    const onButton = step === 3 && ratings.includes(document.activeElement); // which then is clicked
    if (step > 0 && !onButton && phase().name === "choosing" && !stage.questions.hidden && app.guard.problem() === null) {
      if (step < 3 || !event.repeat) choose(step, event);
      return event.preventDefault();
    }
    if (event.repeat || event.ctrlKey || event.metaKey || event.altKey || stage.questions.hidden || task.slides) return;
    if (app.guard.problem() !== null) return;
    const digit = /^[1-9]$/.test(event.key) ? Number(event.key) : 0;
    const back = event.key === "ArrowLeft" || event.key === "ArrowUp";
    if (digit > 0 && phase().name === "choosing") choose(digit, event);
    else if (digit > 0 && phase().name === "rating") takeRating(digit, event);
    else if ((back || event.key === "ArrowRight" || event.key === "ArrowDown")) moveFocus(back);
    else return;
    event.preventDefault();
  };

  const layOut = () => {
    stage.layOut();
    if (ratings.length > 0) tightenRow(stage);
  };
  let wheeled_ms = 0;
  /** A match: the wheel steps, towards the person to where less is seen. */
  const onWheel = (event) => {
    if (!task.adjusts || phase().name !== "choosing" || stage.questions.hidden || app.guard.problem() !== null) return;
    if (event.deltaY === 0 || event.ctrlKey || event.timeStamp - wheeled_ms < WHEEL_REST_MS) return;
    wheeled_ms = event.timeStamp;
    choose(event.deltaY < 0 ? 1 : 2, event);
  };
  stage.node.addEventListener("wheel", onWheel, { passive: true });
  stage.node.addEventListener("pointerdown", onPress);
  document.addEventListener("keydown", onKey);
  const stopWatching = app.screen.onChange(layOut);
  stage.questions.hidden = true;
  stage.layOut();

  const ahead = trialsAhead(session().trials);
  const all = [...ahead, ...(isPractice ? trialsAhead(app.visit.session.trials) : [])];
  app.pictures.want(all.flatMap(filesOf));
  app.pictures.keep(filesOf(trial).length);
  const loadingWords = setTimeout(() => app.showLoading(true), 400);
  picturesReady(app, trial).then((ready) => {
    clearTimeout(loadingWords);
    app.showLoading(false);
    if (!open) return ready.forEach((one) => one.clip?.stop());
    picture = ready;
    clip = ready[0].clip ?? null;
    putReady(stage, trial, ready);
    update();
    const next = ahead[1];
    if (next && !clip) picturesReady(app, next).catch(() => {}); // decoded while this one is looked at
  }, app.failed);
  update();

  return {
    update,
    close() {
      open = false;
      clip?.stop();
      clearTimeout(loadingWords);
      app.showLoading(false);
      if (frame !== null) cancelAnimationFrame(frame);
      document.removeEventListener("keydown", onKey);
      stopWatching();
      app.screen.watchPicture(null);
    },
  };
}

/** The pictures of the practice once more. */
export function drawTaskFeedback(app, display) {
  const { trial, chosen_index } = app.visit.screen;
  const task = taskOf(app.script.pace, trial);
  const texts = askedBy(app, task);
  const stage = makeStage(app, display, task);
  const right = trial.right_index;
  const text = chosen_index === right ? texts.feedback_right : texts.feedback_wrong;
  const name = right > 0 ? (task.answers[right - 1] ?? "") : "";
  stage.question.textContent = right > 0 ? app.fill(text, { object: name }) : "";
  const button = element(
    "button",
    { type: "button", id: "continue", class: "leading", onclick: () => app.step({ type: "continued" }) },
    app.phrase("continue")
  );
  stage.answers.append(button);
  stage.hint.remove();
  stage.layOut();
  const stopWatching = app.screen.onChange(() => stage.layOut());
  let over = false;
  let clip = null; // at its first frame
  picturesReady(app, trial).then((ready) => {
    clip = ready[0].clip ?? null;
    if (over) return clip?.stop();
    putReady(stage, trial, ready);
    stage.show(task.pictures > 1 ? Math.max(0, right - 1) : 0);
  }, app.failed);
  app.say(stage.question.textContent);
  app.focus(button);
  return {
    close() {
      over = true;
      clip?.stop();
      stopWatching();
      app.screen.watchPicture(null);
    },
  };
}
