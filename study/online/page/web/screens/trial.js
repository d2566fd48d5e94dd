// A picture, and what is asked about it: trials of practice and of the study, and the feedback on practice.
import { bracketBars, objectAt, placeTrial } from "../core/place.js";
import { currentTrial, trialsAhead } from "../core/trials.js";
import { nanoseconds } from "../core/messages.js";
import * as looking from "../core/looking.js";
import { taskOf } from "../core/session.js";
import { drawTaskFeedback, drawTaskTrial } from "./task_trial.js";
import { element, svg } from "./dom.js";
import { answerRow, answering, askedBy, lateFrames, showProgress, shownSize, tightenRow } from "./trial_parts.js";

const SIDES = ["left_object", "middle_object", "right_object"];

/** The stage of a picture: everything is placed in pixels of the screen. */
function makeStage(app, display, size_px) {
  const fixation = svg("path", { class: "fixation" });
  const mark = svg("path", { class: "mark" });
  const overlay = svg("svg", { class: "overlay", "aria-hidden": "true" }, fixation, mark);
  const question = element("h1", { id: "title" });
  const hint = element("p", { class: "hint" });
  const answers = element("div", { class: "answers" });
  const questions = element("div", { class: "questions" }, question, hint, answers);
  const objects = element("div", { class: "objects", role: "group", "aria-labelledby": "title" });
  const node = element("div", { class: "stage" }, overlay, objects, questions);
  display.append(node);
  const stage = { node, overlay, fixation, mark, question, hint, answers, questions, objects, image: null, place: null };

  /** Puts everything where it belongs; the picture at whole pixels of the screen, as large as it is. */
  stage.layOut = () => {
    const ratio = devicePixelRatio;
    const size = app.screen.size();
    const place = placeTrial(size, size_px, app.em());
    stage.place = place;
    overlay.setAttribute("viewBox", "0 0 " + size.width + " " + size.height);
    const x = place.x + Math.round(place.width / 2);
    const y = place.y + Math.round(place.height / 2);
    fixation.setAttribute("d", `M${x - 12} ${y - 1}h24v2h-24zM${x - 1} ${y - 12}h2v24h-2z`);
    mark.setAttribute("d", `M${x - 7} ${y}h14M${x} ${y - 7}v14`);
    questions.style.top = place.questions_y / ratio + "px";
    if (stage.image) {
      stage.image.style.left = place.x / ratio + "px";
      stage.image.style.top = place.y / ratio + "px";
      stage.image.style.width = place.width / ratio + "px";
      stage.image.style.height = place.height / ratio + "px";
    }
  };

  stage.put = (image) => {
    if (stage.image === image) return;
    stage.image?.remove();
    stage.image = image;
    image.className = "picture";
    image.alt = "";
    image.draggable = false;
    node.prepend(image);
    stage.layOut();
    app.screen.watchPicture(image);
  };

  const bars = [];
  /** Corners around frames of the picture, bolder around the chosen one; the same for every object, so they give nothing away. */
  stage.bracket = (frames, chosen = null) => {
    const wanted = JSON.stringify([frames, chosen]);
    if (bars.wanted === wanted) return;
    bars.wanted = wanted;
    bars.splice(0).forEach((bar) => bar.remove());
    for (const frame of chosen ? [...frames, chosen] : frames)
      for (const edge of [1, 0]) {
        const onScreen = {
          x: stage.place.x + frame.x_px,
          y: stage.place.y + frame.y_px,
          width: frame.width_px,
          height: frame.height_px,
        };
        for (const [x, y, width, height] of bracketBars(onScreen, frame === chosen))
          bars.push(
            svg("rect", {
              class: edge ? "edge" : "bar",
              x: String(x - edge),
              y: String(y - edge),
              width: String(width + 2 * edge),
              height: String(height + 2 * edge),
            })
          );
      }
    overlay.append(...bars);
  };
  return stage;
}

const TURNS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const ZOOMS = { "+": 1, "=": 1, "-": -1 };

/** How a trial's picture is seen: whole, or a view of a panorama that may turn. Places are pixels of what is seen. */
function viewOf(app, trial) {
  let look = looking.lookOf(app.study, trial.stimulus_id);
  if (look === null)
    return {
      size_px: shownSize(app, taskOf(app.script.pace, trial)),
      turns: false,
      worn: false,
      poses: { add() {}, take: () => [] },
      pose: () => null,
      shown: (image) => image,
      lookAt() {},
      frames: (map) => map.frames,
      objectAt: (map, at) => objectAt(map, at.x, at.y),
    };
  let pose = looking.startPose(look, trial.stimulus_id + " " + (trial.trial_index ?? ""));
  const size = () => app.view.size();
  return {
    size_px: { width: look.view_px[0], height: look.view_px[1] },
    turns: look.kind === "mouse",
    followsDevice: look.follows_device === true,
    worn: look.kind === "head",
    follow(next) {
      pose = next;
    },
    hint: look.kind === "fixed" ? null : look.hint,
    get degreesPerPixel() {
      return looking.degreesPerPixel(look);
    },
    poses: looking.makePoses(),
    pose: () => (look.fov_limits_deg ? { ...pose, fov_deg: look.horizontal_fov_deg } : pose),
    /** What stands on the screen for the panorama. */
    shown(image) {
      app.view.put(image);
      if (app.headset === null) app.view.draw(look, pose); // else the headset draws, and the canvas is not to change its size
      return app.view.canvas;
    },
    turn(right_deg, up_deg) {
      const next = looking.turned(look, pose, right_deg, up_deg);
      if (next.yaw_deg === pose.yaw_deg && next.pitch_deg === pose.pitch_deg) return false;
      pose = next;
      app.view.draw(look, pose);
      return true;
    },
    zoom(steps_nearer) {
      const next = looking.zoomed(look, steps_nearer);
      if (next.horizontal_fov_deg === look.horizontal_fov_deg) return false;
      look = next;
      app.view.draw(look, pose);
      return true;
    },
    /** Towards a frame of the panorama, whatever the limits, unless the view is fixed. */
    lookAt(frame) {
      if (look.kind === "fixed") return;
      pose = looking.poseTowards(size(), frame.x_px + frame.width_px / 2, frame.y_px + frame.height_px / 2);
      app.view.draw(look, pose);
    },
    frames: (map) => map.frames.map((frame) => looking.frameInView(look, pose, size(), frame)),
    objectTowards(map, yaw_deg, pitch_deg) {
      const { width, height } = size();
      const column = (((yaw_deg / 360 + 0.5) % 1) + 1) % 1;
      return objectAt(map, Math.min(width - 1, column * width), Math.min(height - 1, (0.5 - pitch_deg / 180) * height));
    },
    objectAt(map, { x, y }) {
      if (x < 0 || y < 0 || x >= look.view_px[0] || y >= look.view_px[1]) return 0;
      const place = looking.placeOf(size(), looking.directionAt(look, pose, x, y));
      return objectAt(map, place.x, Math.min(place.y, map.height_px - 1));
    },
  };
}

/** What an object is called: by its side where there are three, else as the study says. */
const objectName = (app, task, index) => task.answers?.[index - 1] ?? app.phrase(SIDES[index - 1]);

/** What lies below the objects for keyboards and screen readers: it sees no mouse. */
function objectButtons(app, stage, map, task, choose) {
  const buttons = map.frames.map((frame, at) =>
    element("button", {
      type: "button",
      class: "object",
      id: "object-" + (at + 1),
      "aria-label": at + 1 + " " + objectName(app, task, at + 1),
      onclick: (event) => choose(at + 1, event),
    })
  );
  stage.objects.replaceChildren(...buttons);
  let frames = map.frames;
  /** `moved`: where the objects are from now on. */
  const place = (moved = frames) => {
    const ratio = devicePixelRatio;
    frames = moved;
    frames.forEach((frame, at) => {
      buttons[at].hidden = frame === null;
      if (frame === null) return;
      buttons[at].style.left = (stage.place.x + frame.x_px) / ratio + "px";
      buttons[at].style.top = (stage.place.y + frame.y_px) / ratio + "px";
      buttons[at].style.width = frame.width_px / ratio + "px";
      buttons[at].style.height = frame.height_px / ratio + "px";
    });
  };
  return { buttons, place };
}

/** Draws the trial that is due, of the practice or of the study, from the grey before it to its answer. */
function drawTrial(app, display, isPractice) {
  const session = () => (isPractice ? app.visit.training : app.visit.session);
  const trial = currentTrial(session().trials);
  if (trial === null) return {}; // all are answered, and the completion is being stored
  const view = viewOf(app, trial);
  const task = taskOf(session().pace, trial);
  const texts = askedBy(app, task);
  app.looking = view; // for tests, and for who looks
  const stage = makeStage(app, display, view.size_px);
  const detail = isPractice ? "practice" : "";
  let picture = null; // {image, map} once it is decoded; of a clip `map` is that of the frame on the screen
  let pointer = null; // where the mouse is in the picture
  let controls = null;
  let ratings = [];
  let hovered = 0;
  let moved = false;
  let shownWith = null; // the frame that shows the picture has begun
  let frame = null;
  const lateness = lateFrames(app);
  let open = true;
  let grabbed = null; // where the view was taken hold of, and whether it has moved since

  showProgress(app, stage.node, session().trials, isPractice);

  const step = (event) => app.step(event);
  const answers = answering(app, session, isPractice);
  /** What was noted while the trial was looked at, before its last answer. */
  const noteLooking = (last, event) => {
    if (phase().name !== last) return;
    if (!isPractice) view.poses.take().forEach((poses) => app.note("look", poses));
    if (picture?.clip) app.note("clip", (detail + " " + picture.clip.showing()).trim(), event.timeStamp);
  };
  const choose = (index, event) => {
    if (!task.rates) noteLooking("choosing", event);
    answers.choose(index, event);
  };
  const rate = (rating, event) => {
    noteLooking("rating", event);
    answers.rate(rating, event);
  };

  const phase = () => session().phase;
  /** The next frame of who shows it: the headset, which has frames of its own, or the page. */
  const nextFrame = () => {
    if (!view.worn || !app.headset) return requestAnimationFrame(onFrame);
    app.headset.once = onFrame;
    return -1;
  };
  const isSeen = () => !view.worn || app.headset !== null;
  const isOpen = (now) => now >= phase().onset_ns + session().pace.minimum_viewing_ns;

  function drawBrackets() {
    const now = phase();
    const indices = new Set();
    const focused = controls ? controls.buttons.indexOf(document.activeElement) + 1 : 0;
    const chosen = now.name === "rating" ? now.chosen_index : 0;
    if (now.name === "rating" || now.name === "choosing") {
      if (hovered > 0 && moved) indices.add(hovered);
      else if (focused > 0 && (now.name === "rating" || !stage.questions.hidden)) indices.add(focused);
    }
    indices.delete(chosen);
    const frames = picture ? view.frames(picture.map) : [];
    const there = [...indices].map((index) => frames[index - 1]).filter((frame) => frame);
    stage.bracket(picture ? there : [], frames[chosen - 1]);
  }

  function showQuestion() {
    stage.question.textContent = texts.question;
    stage.hint.textContent = view.hint ?? texts.hint;
    stage.answers.replaceChildren();
    ratings = [];
  }

  function showRatings() {
    if (ratings.length > 0) return;
    stage.question.textContent = app.study.rating_question;
    stage.hint.textContent = texts.rating_hint;
    ratings = answerRow(stage, "rating", app.study.rating_labels, rate);
    app.say(app.study.rating_question);
  }

  /** What the phase shows. */
  function update() {
    const now = phase();
    const visible = ["choosing", "rating"].includes(now.name) || shownWith !== null;
    if (stage.image) stage.image.classList.toggle("visible", visible);
    stage.fixation.classList.toggle("visible", !visible && ["grey", "awaiting"].includes(now.name));
    const asking = now.name === "rating" || (now.name === "choosing" && isOpen(nanoseconds(performance.now())));
    if (asking && now.name === "choosing" && (stage.questions.hidden || ratings.length > 0)) {
      showQuestion();
      app.say(texts.question);
    }
    if (now.name === "rating") showRatings();
    stage.questions.hidden = !asking;
    stage.objects.hidden = !asking;
    stage.mark.classList.toggle("visible", view.turns && asking);
    if (now.name === "grey" || now.name === "awaiting") {
      ratings = [];
      moved = false;
      if (picture?.clip?.rewind()) followObjects();
    }
    drawBrackets();
    const plays = ["choosing", "rating"].includes(now.name) && picture?.clip?.isPlaying();
    if (open && frame === null && (["grey", "awaiting"].includes(now.name) || (now.name === "choosing" && !asking) || plays))
      frame = nextFrame();
    if (view.worn) wearing(now, visible, asking);
  }

  /** What the headset shows, or, while nobody wears it, how to put it on. */
  let worn = null;
  function wearing(now, visible, asking) {
    if (worn !== app.headset) {
      worn = app.headset;
      if (frame === -1) frame = null;
      if (worn) {
        worn.begin(view.pose().yaw_deg);
        worn.moved = (time) => {
          view.follow(worn.pose());
          if (["choosing", "rating"].includes(phase().name)) view.poses.add((nanoseconds(time) - phase().onset_ns) / 1e6, view.pose());
        };
        worn.selected = select;
        requestAnimationFrame(() => open && update());
      } else app.step({ type: "picture_taken" });
    }
    if (!worn) {
      stage.questions.hidden = false;
      stage.question.textContent = "";
      stage.hint.textContent = view.hint;
      if (!stage.answers.querySelector("#wear"))
        stage.answers.replaceChildren(
          element("button", { type: "button", id: "wear", class: "leading", onclick: () => app.wear().catch((error) => (stage.hint.textContent = error.message)) }, app.phrase("continue"))
        );
      return;
    }
    stage.answers.querySelector("#wear")?.remove();
    const rating = now.name === "rating";
    worn.scene = {
      panorama: visible,
      words: !asking
        ? null
        : {
            question: rating ? app.study.rating_question : app.study.question,
            hint: rating ? "" : view.hint,
            answers: rating ? app.study.rating_labels : [],
          },
    };
  }
  /** The trigger: what the cross is on. */
  function select(event) {
    const now = phase();
    if (app.guard.problem() !== null || !picture) return;
    if (now.name === "rating") {
      const rating = worn.answer();
      if (rating > 0) return rate(rating, event);
    }
    const { yaw_deg, pitch_deg } = view.pose();
    const object = view.objectTowards(picture.map, yaw_deg, pitch_deg);
    const isAsked = now.name === "rating" || (now.name === "choosing" && isOpen(nanoseconds(event.timeStamp)));
    if (object > 0 && isAsked) choose(object, event);
  }

  /** Runs while something changes by itself: grey, the picture's first frame, the least time of viewing. */
  function onFrame(now) {
    frame = null;
    if (!open) return;
    lateness.see(now);
    if (phase().name === "grey") step({ type: "tick", now_ns: nanoseconds(now) });
    if (phase().name === "awaiting") {
      if (shownWith !== null) {
        // The frame before this one had the picture, so it is on the screen now.
        shownWith = null;
        app.note("shown", detail, now);
        lateness.tell(now);
        view.poses.add(0, view.pose());
        step({ type: "image_shown", now_ns: nanoseconds(now) });
      } else if (picture && (picture.clip?.isReady() ?? true) && isSeen() && app.guard.problem() === null) {
        shownWith = now;
      }
    }
    if (phase().name !== "awaiting") shownWith = null;
    if (picture?.clip && ["choosing", "rating"].includes(phase().name))
      if (picture.clip.play(now - phase().onset_ns / 1e6, 1000 / (app.screen.refreshHz() || 60))) followObjects();
    if (open) update();
  }

  /** Corners and clicks are where the objects are in the clip's frame. */
  function followObjects() {
    picture.map = picture.mapOf(picture.clip.frame());
    controls.place(view.frames(picture.map));
    if (pointer !== null) hovered = view.objectAt(picture.map, pointer);
  }

  const onMove = (event) => {
    if (!picture || !stage.place) return;
    const ratio = devicePixelRatio;
    moved = true;
    const at = (pointer = { x: event.clientX * ratio - stage.place.x, y: event.clientY * ratio - stage.place.y });
    if (grabbed && event.type === "pointermove") drag(event);
    hovered = grabbed?.moved ? 0 : view.objectAt(picture.map, at);
    stage.node.classList.toggle("over-object", hovered > 0 && !stage.questions.hidden);
    drawBrackets();
  };
  const onPress = (event) => {
    if (event.button !== 0 || event.target.closest("button") || app.guard.problem() !== null) return;
    onMove(event);
    if (view.turns) return void (grabbed = { x: event.clientX, y: event.clientY, moved: false });
    if (hovered > 0 && !stage.questions.hidden) choose(hovered, event);
  };
  /** A view that can be dragged is clicked where it is let go without having moved. */
  const onRelease = (event) => {
    const held = grabbed;
    grabbed = null;
    stage.node.classList.remove("grabbed");
    if (!held || held.moved || event.type !== "pointerup") return;
    onMove(event);
    if (hovered > 0 && !stage.questions.hidden) choose(hovered, event);
  };

  /** Turns the view by degrees, or zooms it, and notes whither. */
  const turn = (right_deg, up_deg, event) => change(() => view.turn(right_deg, up_deg), event);
  function change(make, event) {
    const now = phase();
    if (!["choosing", "rating"].includes(now.name) || app.guard.problem() !== null) return;
    if (!make()) return;
    view.poses.add((nanoseconds(event.timeStamp) - now.onset_ns) / 1e6, view.pose());
    drawBrackets();
  }
  /** As far as the device has been turned since it last said where its back looks. */
  let aimed = null;
  const onDevice = (event) => {
    const now = looking.deviceDirection(event);
    if (now && aimed) turn(((now.yaw_deg - aimed.yaw_deg + 540) % 360) - 180, now.pitch_deg - aimed.pitch_deg, event);
    aimed = now;
  };
  const SLACK_PX = 4; // that a click may move
  function drag(event) {
    const [right, down] = [event.clientX - grabbed.x, event.clientY - grabbed.y];
    if (!grabbed.moved && Math.hypot(right, down) < SLACK_PX) return;
    stage.node.classList.add("grabbed");
    const degrees = view.degreesPerPixel * devicePixelRatio;
    turn(-right * degrees, down * degrees, event);
    grabbed = { x: event.clientX, y: event.clientY, moved: true };
  }

  /** Arrows go round the ratings, then the objects. */
  function moveFocus(back) {
    const places = [...ratings, ...controls.buttons].filter((place) => !place.hidden);
    if (places.length === 0) return;
    const at = places.indexOf(document.activeElement);
    const next = at < 0 ? (back ? places.length - 1 : 0) : (at + (back ? places.length - 1 : 1)) % places.length;
    places[next].focus();
  }
  const onKey = (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || app.guard.problem() !== null) return;
    if (view.turns && TURNS[event.key]) {
      const step_deg = event.shiftKey ? 15 : 3;
      turn(TURNS[event.key][0] * step_deg, TURNS[event.key][1] * step_deg, event);
      return event.preventDefault();
    }
    if (view.turns && ZOOMS[event.key]) {
      change(() => view.zoom(ZOOMS[event.key]), event);
      return event.preventDefault();
    }
    if (event.repeat || stage.questions.hidden) return;
    if (view.turns && phase().name === "choosing") {
      if (event.key !== " " && event.key !== "Enter") return;
      const middle = view.objectAt(picture.map, { x: view.size_px.width / 2, y: view.size_px.height / 2 });
      if (middle > 0) choose(middle, event);
      return event.preventDefault();
    }
    const digit = /^[1-9]$/.test(event.key) ? Number(event.key) : 0;
    const back = event.key === "ArrowLeft" || event.key === "ArrowUp";
    if (digit > 0 && phase().name === "choosing") choose(digit, event);
    else if (digit > 0 && phase().name === "rating") rate(digit, event);
    else if (controls && (back || event.key === "ArrowRight" || event.key === "ArrowDown")) moveFocus(back);
    else return;
    event.preventDefault();
  };

  const layOut = () => {
    stage.layOut();
    controls?.place();
    if (ratings.length > 0) tightenRow(stage);
    stage.bracket([]);
    drawBrackets();
  };
  stage.node.addEventListener("pointermove", onMove);
  stage.node.addEventListener("pointerdown", onPress);
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) stage.node.addEventListener(end, onRelease);
  stage.node.addEventListener("focusin", drawBrackets);
  stage.node.addEventListener("focusout", () => queueMicrotask(drawBrackets));
  document.addEventListener("keydown", onKey);
  if (view.followsDevice) addEventListener("deviceorientation", onDevice);
  const stopWatching = app.screen.onChange(layOut);
  stage.questions.hidden = stage.objects.hidden = true;
  stage.layOut();

  const ahead = trialsAhead(session().trials);
  app.pictures.want([...ahead, ...(isPractice ? trialsAhead(app.visit.session.trials) : [])].map((one) => one.picture));
  const loadingWords = setTimeout(() => app.showLoading(true), 400);
  app.pictures.ready(trial.picture).then((ready) => {
    clearTimeout(loadingWords);
    app.showLoading(false);
    if (!open) return ready.clip?.stop();
    picture = ready;
    const shown = view.shown(ready.image);
    if (!view.worn) stage.put(shown);
    controls = objectButtons(app, stage, view.turns || view.worn ? { frames: [] } : { frames: view.frames(ready.map) }, task, choose);
    controls.place();
    update();
    const next = ahead[1];
    if (next && !ready.clip) app.pictures.ready(next.picture).catch(() => {}); // decoded while this one is looked at
  }, app.failed);
  update();

  return {
    update,
    close() {
      open = false;
      picture?.clip?.stop();
      clearTimeout(loadingWords);
      app.showLoading(false);
      if (frame !== null && frame !== -1) cancelAnimationFrame(frame);
      if (worn) {
        worn.once = worn.moved = worn.selected = null;
        worn.scene = { panorama: false, words: null };
      }
      document.removeEventListener("keydown", onKey);
      removeEventListener("deviceorientation", onDevice);
      stopWatching();
      app.screen.watchPicture(null);
    },
  };
}

const hasAlternatives = (app, trial) => taskOf(app.script.pace, trial).kind !== "object";
function drawAny(app, display, isPractice) {
  const trial = currentTrial((isPractice ? app.visit.training : app.visit.session).trials);
  return (hasAlternatives(app, trial) ? drawTaskTrial : drawTrial)(app, display, isPractice);
}
export const drawTraining = (app, display) => drawAny(app, display, true);
export const drawStudyTrial = (app, display) => drawAny(app, display, false);

/** The practice picture once more, with corners around the object that was inserted. */
export function drawFeedback(app, display) {
  const { trial, chosen_index } = app.visit.screen;
  if (hasAlternatives(app, trial)) return drawTaskFeedback(app, display);
  const task = taskOf(app.script.pace, trial);
  const texts = askedBy(app, task);
  const view = viewOf(app, trial);
  const stage = makeStage(app, display, view.size_px);
  const right = trial.right_index;
  const text = chosen_index === right ? texts.feedback_right : texts.feedback_wrong;
  stage.question.textContent = right > 0 ? app.fill(text, { object: objectName(app, task, right) }) : "";
  const button = element(
    "button",
    { type: "button", id: "continue", class: "leading", onclick: () => app.step({ type: "continued" }) },
    app.phrase("continue")
  );
  stage.answers.append(button);
  stage.objects.remove();
  stage.hint.remove();
  stage.layOut();
  let map = null;
  let clip = null;
  let over = false;
  const layOut = () => {
    stage.layOut();
    stage.bracket([]);
    if (map && right > 0) stage.bracket([view.frames(map)[right - 1]].filter((frame) => frame));
  };
  const stopWatching = app.screen.onChange(layOut);
  app.pictures.ready(trial.picture).then(async (ready) => {
    await app.headset?.over;
    clip = ready.clip; // at its first frame
    if (over) return clip?.stop();
    map = ready.map;
    const shown = view.shown(ready.image);
    if (right > 0) view.lookAt(ready.map.frames[right - 1]);
    stage.put(shown);
    shown.classList.add("visible");
    layOut();
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
