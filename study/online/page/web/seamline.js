// The study in a browser: what the window does with a visit, done by a page.
//
// What follows from what happens is core/visit.js's business, what is kept the courier's; here they are put together,
// and jsPsych shows one screen after the other.
import { placedTrials, plannedTrials } from "./core/trials.js";
import { chooseLanguage, direction, fillIn } from "./core/texts.js";
import { FORMAT, makeMessage, nanoseconds, progressOf } from "./core/messages.js";
import { beginVisit, next, resumeVisit, sessionOnScreen } from "./core/visit.js";
import { makeCourier } from "./keeping/courier.js";
import { findHost, wrongHost } from "./keeping/hosts.js";
import { runOf } from "./keeping/jatos.js";
import { onlyTab } from "./keeping/one_tab.js";
import { cacheAfter, fetchFile, fetchJson, notTheFile, persistently } from "./keeping/patience.js";
import { askForPersistence, openStore } from "./keeping/store.js";
import { NotNow, Refused } from "./keeping/verdict.js";
import { makePictures } from "./pictures.js";
import { enterHeadset, headsetIsThere } from "./headset.js";
import { largestFault, makeView, MOST_FAULT } from "./panorama.js";
import { canBeExact, watchScreen } from "./exact.js";
import { makeGuard } from "./guard.js";
import { watchAttention } from "./watch.js";
import { displayFacts, drawDisplay, screenKey } from "./screens/display.js";
import { drawForm } from "./screens/form.js";
import * as pages from "./screens/pages.js";
import { screenPlugin } from "./screens/plugin.js";
import { emOf, setTextSize } from "./screens/text_size.js";
import { drawFeedback, drawStudyTrial, drawTraining } from "./screens/trial.js";
import { card, element, paragraphs } from "./screens/dom.js";

globalThis.seamlineBegan = true; // start.js sees by it that this script is this script

const addressed = new URLSearchParams(location.search + "&" + location.hash.slice(1));
const token = addressed.get("token");
const USER_AGENT = navigator.userAgent.replace(/[^ -~]/g, "?").slice(0, 512); // as a message may have it
const statusLine = document.getElementById("status");
const spoken = document.getElementById("spoken");

/** What the link says of whoever came, by the names that the study asks for; null: it asks for none. */
const identifiersOf = (study) =>
  study.recruitment
    ? Object.fromEntries(study.recruitment.identifiers.map((name) => [name, addressed.get(name) ?? ""]).filter(([, value]) => value !== ""))
    : null;

/** What to say while `problem` is waited out: somebody answers, or nobody does. */
const waitingWords = (texts, problem) =>
  problem instanceof NotNow ? fillIn(texts.online_refusing, { message: problem.message }) : texts.online_away;

/** Words in place of the study, for good. */
function refuse(study, text) {
  document.getElementById("study").replaceChildren(card(study.texts.online_refused_title, "middle", ...paragraphs(text)));
}

/** Why this device cannot take part, or null. */
function unfit(study) {
  const words = (name, values) => fillIn(study.texts[name], values);
  const phone = navigator.userAgentData?.mobile || /Mobi|iPhone/.test(navigator.userAgent);
  const tablet = /Android|iPad/.test(navigator.userAgent) || (matchMedia("(any-pointer: coarse)").matches && !matchMedia("(any-pointer: fine)").matches);
  if (phone || (tablet && !study.touch)) return words("online_touch");
  if (!canBeExact()) return words("online_browser", { message: "devicePixelContentBox" });
  if (study.clip && !("DecompressionStream" in globalThis)) return words("online_browser", { message: "DecompressionStream" });
  const found = { width: Math.round(screen.width * devicePixelRatio), height: Math.round(screen.height * devicePixelRatio) };
  if (found.width < study.picture.width || found.height < study.picture.height)
    return words("online_small", {
      wanted: study.picture.width + " x " + study.picture.height,
      found: found.width + " x " + found.height,
    });
  return null;
}

/** study.json as the page uses it. */
function readStudy(json) {
  if (json.format !== FORMAT) throw new Error("study.json is of another version");
  const sizes = json.looks?.map((look) => look.view_px) ?? [[json.width_px, json.height_px]];
  const largest = (side) => Math.max(...sizes.map((size) => size[side]));
  const pair = [json.task, ...(json.tasks ?? [])].find((task) => task?.kind === "pair");
  const width = pair ? 2 * json.width_px + pair.pair_gap_px : largest(0);
  // Whoever looks round needs a mouse or a headset, and the paper's study a computer.
  const touch = Boolean(json.task) && !json.looks;
  return { ...json, touch, picture: { width, height: largest(1) } };
}

/** What draws views of panoramas, proved by what it draws; null where the study has none. Throws where it cannot. */
function checkedView(study) {
  if (!study.looks) return null;
  // Without its graphics a page is opened again, and the visit goes on where it was.
  const view = makeView(() => location.reload());
  const fault = largestFault(view);
  if (!(fault <= MOST_FAULT)) throw new Error("WebGL 2: views are wrong by " + fault.toFixed(1) + " codes");
  return view;
}

/** Whether somebody must put on a headset, and there is none. */
const lacksHeadset = async (study) =>
  (study.looks ?? []).some((look) => look.kind === "head") && !(await headsetIsThere());

/** Some phones tell how they are turned only who was asked by a touch: the first one. */
function askForOrientation(study) {
  const ask = globalThis.DeviceOrientationEvent?.requestPermission;
  if (ask && study.looks?.some((look) => look.follows_device))
    addEventListener("click", () => ask.call(DeviceOrientationEvent).catch(() => {}), { once: true });
}

/** The study in one of its languages. */
async function inLanguage(study, { file }, away) {
  return file ? { ...study, ...(await persistently(() => fetchJson(file, { isIt: (json) => json?.texts }), away)) } : study;
}

async function useFont(study, away) {
  if (!study.font) return;
  const ask = async (failures) => {
    const bytes = await fetchFile(study.font, (response) => response.arrayBuffer(), cacheAfter(failures));
    return new FontFace("study", bytes).load().catch(() => Promise.reject(notTheFile(study.font)));
  };
  document.fonts.add(await persistently(ask, away));
}

function speak(study) {
  document.documentElement.lang = study.language;
  document.documentElement.dir = direction(study.language);
  document.title = study.title;
}

class Study {
  visit = null;
  host = null;
  headset = null;
  courier = null;
  kept = 0; // messages of former visits, and the enrolment
  end = null; // {outcome, code, link}, where people are matched and sent back
  textScale = 1;
  #listeners = new Set();
  #problems = new Set(); // that are waited out
  #loading = false;

  constructor(study, store, host, view) {
    this.view = view;
    this.study = study;
    this.store = store;
    this.host = host;
    this.stream = { study_hash: study.study_hash, set_hash: study.set_hash, participant: "" };
    this.script = {
      form: study.form,
      instruction_pages: study.instructions.length,
      training: study.training,
      pace: { ...study.pace, task: study.task, tasks: study.tasks, briefs: Boolean(study.briefings) },
    };
    this.screen = watchScreen(document.getElementById("probe"), (kind, detail) => this.note(kind, detail));
    this.pictures = makePictures(study.pictures, study.clip ?? null, { away: this.away, progress: () => this.#showStatus(), failed: (error) => this.failed(error) });
    this.guard = makeGuard(this, document.getElementById("guard"));
    watchAttention((kind, detail, at) => this.note(kind, detail, at));
  }

  // Words.

  phrase = (key, values) => fillIn(this.study.texts[key], values);
  fill = fillIn;
  em = () => emOf(this, this.textScale);
  /** For screen readers: what changed without a change of page. */
  say(text) {
    spoken.textContent = text;
  }
  /** A screen was drawn: screen readers hear its title. */
  arrived(display) {
    this.say(display.querySelector("h1")?.textContent ?? "");
  }
  focus(what) {
    const node = typeof what === "string" ? document.querySelector("#study " + what) : what;
    // After jsPsych has given the focus to its own element.
    setTimeout(() => node?.isConnected && node.focus({ preventScroll: true }), 0);
  }

  /** What the host, or the network, is waited for: as persistently calls it. */
  away = (before, now) => {
    const were = this.#problems.size;
    this.#problems.delete(before);
    if (now !== null) this.#problems.add(now);
    if (were === 0 && now !== null) this.note("network_away", now instanceof NotNow ? now.message : "");
    if (were > 0 && this.#problems.size === 0) this.note("network_back");
    this.#showStatus();
  };
  showLoading(is) {
    this.#loading = is;
    this.#showStatus();
  }
  #showStatus() {
    const loading = this.#loading ? this.phrase("online_loading", this.pictures.count()) : "";
    const [problem] = this.#problems;
    const text = problem ? waitingWords(this.study.texts, problem) : loading;
    if (statusLine.textContent !== text) statusLine.textContent = text;
    statusLine.hidden = text === "";
  }

  /** A picture of the instructions, there as soon as it can be had. */
  shown(file, alt) {
    const image = element("img", { class: "shown", alt });
    const ask = (failures) => fetchFile(file, (response) => response.blob(), cacheAfter(failures));
    persistently(ask, this.away).then((blob) => {
      image.onload = image.onerror = () => URL.revokeObjectURL(image.src);
      image.src = URL.createObjectURL(blob);
    });
    return image;
  }

  // Events.

  onChange(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** By a click: somebody is in the headset from now on, until they take it off or a page of words comes. */
  async wear() {
    this.headset = await enterHeadset(this.view, () => {
      this.headset = null;
      this.note("headset_off");
      this.#tell();
    });
    this.note("headset_on");
    this.#tell();
  }

  step(event) {
    if (this.guard.problem() !== null && ["object_chosen", "rating_given"].includes(event.type)) return;
    const before = this.visit;
    this.visit = next(this.visit, event);
    if (this.visit === before) return;
    if (this.visit.pending && this.visit.pending !== before?.pending) this.#keepPending();
    this.#tell();
  }

  #tell() {
    this.guard.look();
    if (!["trial", "training"].includes(this.visit.screen.name)) this.headset?.end(); // words are read without it
    [...this.#listeners].forEach((listener) => listener());
  }

  failed = (error) => {
    this.end = error?.end ?? this.end;
    this.step({ type: "store_failed", message: error?.message ?? String(error), reason: error?.reason });
  };

  async #keepPending() {
    const record = this.visit.pending;
    document.body.setAttribute("aria-busy", "true");
    try {
      this.step(await this.#keep(record));
    } catch (error) {
      this.failed(error);
    } finally {
      document.body.removeAttribute("aria-busy");
    }
  }

  /** Stores what a visit asks to be stored; resolves to the event that says so. */
  async #keep(record) {
    const courier = this.courier;
    switch (record.kind) {
      case "decline":
        {
          const told = await persistently(() => this.host.decline(makeMessage(this.stream, 0, "decline", {})), this.away);
          if (this.study.recruitment) this.end = told;
        }
        break;
      case "consent":
        return { type: "enrolled", trials: await this.enrol(record.accepted_unix_s) };
      case "form":
        await courier.deliver("form", { answers: record.answers });
        if (await this.#findEnd()) return { type: "ended" };
        break;
      case "display":
        await courier.deliver("display", record.facts);
        break;
      case "training":
        await courier.deliver("training", { training_index: record.answer.trial_index, ...whatWasAnswered(record) });
        break;
      case "answer": {
        const { trial_index } = record.answer;
        await courier.deliver("answer", { trial_index, ...whatWasAnswered(record), image_scale: 1 });
        return { type: "record_stored", next: await this.#placeNext() };
      }
      default:
        await courier.deliver("completion", {});
        await this.#findEnd();
    }
    return { type: "record_stored" };
  }

  /** Where people are matched: whether, and how, this visit has ended. */
  async #findEnd() {
    if (this.study.recruitment) this.end = await persistently(() => this.host.end(), this.away);
    return this.end;
  }

  /** The next trial of an adaptive study, from the server that places it. */
  async #placeNext() {
    return this.study.adaptive ? persistently(() => this.host.nextTrial(), this.away) : undefined;
  }

  note(kind, detail = "", at = performance.now()) {
    if (!this.courier || this.visit === null || ["thanks", "ended", "stopped"].includes(this.visit.screen.name)) return;
    if (this.visit.pending?.kind === "completion") return;
    const trial_index = this.visit.screen.name === "trial" ? this.visit.session.trials.answered : null;
    this.courier.note("event", { monotonic_ns: nanoseconds(at), kind, trial_index, detail: String(detail) });
  }

  // Coming, and coming again.

  /** Before the consent; the page begins anew in it. */
  async useLanguage(tag) {
    await this.store.keepFact("language", tag);
    location.reload();
  }

  /** With every sitting, so that an answer's language is known. */
  #noteLanguage() {
    if (!this.study.languages) return;
    this.courier.note("event", { monotonic_ns: nanoseconds(performance.now()), kind: "language", trial_index: null, detail: this.study.language });
  }

  /** Stores the consent and finds a place: {participant, slot}, and the trials of it. */
  async enrol(accepted_unix_s) {
    const drawn = this.host.drawn?.() ?? { participant: "", slot: -1 };
    const message = makeMessage({ ...this.stream, participant: drawn.participant }, 0, "enrol", {
      slot: drawn.slot,
      consent_sha256: this.study.consent.sha256,
      accepted_unix_s,
      user_agent: USER_AGENT,
      origin: this.host.kind,
      pilot: this.study.pilot,
    });
    await this.store.append(message);
    if (this.study.languages) await this.store.keepFact("language", this.study.language);
    askForPersistence();
    const trials = await this.#takePlace([message]);
    this.#noteLanguage();
    return trials;
  }

  /** With an enrolment that is kept here, and perhaps not yet known to the host. */
  async #takePlace(messages) {
    this.kept = messages.length;
    let identity = await this.store.fact("identity");
    this.stream.participant = identity?.participant ?? messages[0].participant;
    const wrong = wrongHost(this.study, messages[0].body.origin, this.host.kind);
    if (wrong) throw wrong;
    if (!identity) {
      identity = await persistently(() => this.host.enrol(messages[0]), this.away);
      await this.store.keepFact("identity", identity);
    }
    this.host.identity.secret = identity.secret;
    this.stream.participant = identity.participant;
    const served = this.host.kind === "serve";
    const there = served && messages.length > 1 ? await persistently(() => this.host.where(), this.away) : null;
    const known = (await this.store.fact("acknowledged")) ?? (served ? 1 : 0);
    this.courier = makeCourier({
      store: this.store,
      host: this.host,
      stream: this.stream,
      messages,
      acknowledged: there ? Math.min(known, Math.max(1, there.next_sequence)) : known,
      away: this.away,
    });
    await this.courier.send();
    const answered = messages.filter((message) => message.kind === "answer").length;
    if (this.study.adaptive) {
      const due = await this.#placeNext();
      return placedTrials(due, answered, this.study.most_trials);
    }
    const file = "orders/" + String(identity.slot).padStart(4, "0") + ".json";
    return plannedTrials(await persistently(() => fetchJson(file, { isIt: Array.isArray }), this.away), answered);
  }

  /** Begins, or goes on where the kept messages end. */
  async begin() {
    const messages = await this.store.messages();
    setTextSize(this, (await this.store.fact("text_size")) ?? 1);
    const known = progressOf(messages);
    if (!known.enrolled) {
      this.visit = beginVisit(this.script);
      return;
    }
    const trials = await this.#takePlace(messages);
    const end = await this.#findEnd();
    if (end && !known.completed) {
      this.visit = { ...beginVisit(this.script), screen: { name: "ended" } };
      return;
    }
    if (known.completed) {
      this.visit = { ...beginVisit(this.script), screen: { name: "thanks" } };
      return;
    }
    await this.courier.deliver("begin", { user_agent: USER_AGENT });
    this.#noteLanguage();
    this.visit = resumeVisit(this.script, { ...known, trials });
    if (this.visit.pending) this.#keepPending();
    if (this.visit.screen.name === "display") await this.confirmKnownDisplay();
  }

  /** A screen that was measured before is not measured again. */
  async confirmKnownDisplay() {
    const profile = await this.store.fact("display " + screenKey());
    if (!profile) return;
    this.step({ type: "display_confirmed", facts: displayFacts(this, profile) });
    await this.#nothingPending(); // else the page would show the check for a moment
  }

  #nothingPending() {
    return new Promise((resolve) => {
      if (!this.visit.pending) return resolve();
      const stop = this.onChange(() => {
        if (this.visit.pending) return;
        stop();
        resolve();
      });
    });
  }

  keepProfile(key, profile) {
    this.store.keepFact("display " + key, profile).catch(() => {});
  }
  keepTextSize(scale) {
    this.store.keepFact("text_size", scale).catch(() => {});
    this.guard.look();
  }

  // The end.

  /** Whether this browser holds answers that nobody else has, or may. */
  holdsMore() {
    return this.kept > 0 && (this.host.kind === "static" || !this.courier || this.courier.unsent() > 0);
  }

  /** Everything of this visit as a file; returns its name. A server knows its enrolments, and takes none from a file. */
  async saveAnswers() {
    const messages = (await this.store.messages()).filter((message) => message.participant !== "");
    const text = messages.map((message) => JSON.stringify(message) + "\n").join("");
    const name = this.stream.participant + ".jsonl";
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "application/x-ndjson" }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    this.saved = true;
    return name;
  }

  finished() {
    this.host.leave(this.visit.screen.name);
  }
}

const whatWasAnswered = ({ trial, answer }) => ({
  kind: trial.kind,
  stimulus_id: answer.stimulus_id ?? trial.stimulus_id, // of a match, the picture at which it ended
  chosen_index: answer.chosen_index,
  rating: answer.rating,
  ...(answer.position === undefined ? {} : { position: answer.position }),
  choice_ns: answer.choice_ns,
  rating_ns: answer.rating_ns,
});

const SCREENS = {
  consent: pages.drawConsent,
  form: drawForm,
  display: drawDisplay,
  instructions: pages.drawInstructions,
  training: drawTraining,
  feedback: drawFeedback,
  ready: pages.drawReady,
  trial: drawStudyTrial,
  break: pages.drawBreak,
  briefing: pages.drawBriefing,
  pause: pages.drawPause,
  thanks: pages.drawThanks,
  declined: pages.drawDeclined,
  ended: pages.drawEnded,
  stopped: pages.drawStopped,
};

/** One plugin a screen; jsPsych goes round them until the visit is over, which it never says: the last page stays. */
function timelineOf(app) {
  return [
    {
      timeline: Object.entries(SCREENS).map(([name, draw]) => ({
        timeline: [{ type: screenPlugin(app, name, draw) }],
        conditional_function: () => app.visit.screen.name === name,
      })),
      loop_function: () => true,
    },
  ];
}

function listenToKeys(app) {
  // A key that is held down is never an answer.
  document.addEventListener(
    "keydown",
    (event) => {
      if (event.repeat && (event.key === "Enter" || event.key === " ")) event.preventDefault();
      if (event.key !== "Escape" || event.repeat) return;
      if (app.visit.screen.name === "pause") return app.step({ type: "continued" });
      if (sessionOnScreen(app.visit) || ["instructions", "feedback", "ready", "break"].includes(app.visit.screen.name)) {
        app.note("pause", "", event.timeStamp);
        app.step({ type: "pause_begun" });
      }
    },
    true
  );
  addEventListener("beforeunload", (event) => {
    const unsaved = app.host.kind === "static" && app.visit.screen.name === "thanks" && !app.saved;
    if (unsaved) event.preventDefault();
  });
}

async function main() {
  await globalThis.seamlineParts?.(); // a host may forbid scripts within pages
  // The words of the first page stand until the study has its own.
  const isIt = (json) => typeof json?.format === "string";
  const own = readStudy(await persistently(() => fetchJson("study.json", { isIt }), () => {}));
  const languages = own.languages ?? [{ tag: own.language }];
  const wishes = [addressed.get("lang"), ...navigator.languages];
  let study = await inLanguage(own, chooseLanguage(languages, wishes), () => {});
  speak(study);
  const away = (before, now) => {
    statusLine.textContent = now === null ? "" : waitingWords(study.texts, now);
    statusLine.hidden = now === null;
  };
  if (!own.languages) await useFont(study, away);
  const reason = unfit(study);
  if (reason !== null) return refuse(study, reason);
  const identifiers = identifiersOf(study);
  const wanted = study.recruitment?.required ? study.recruitment.identifiers.find((name) => !(name in identifiers)) : undefined;
  if (wanted !== undefined) return refuse(study, fillIn(study.texts.recruitment_link, { wanted }));
  let view;
  try {
    view = checkedView(study);
    if (await lacksHeadset(study)) throw new Error("WebXR, immersive-vr");
    askForOrientation(study);
  } catch (error) {
    return refuse(study, fillIn(study.texts.online_browser, { message: error.message }));
  }

  // In JATOS a run is a visit: the next one is somebody else's.
  const visit = (study.host === "jatos" ? runOf(location.pathname) : null) ?? token ?? Object.values(identifiers ?? {})[0] ?? addressed.get("visit") ?? "";
  const name = ["seamline", study.set_hash.slice(0, 16), study.study_hash.slice(0, 16), visit];
  if (!(await onlyTab(name.join(" ")))) return refuse(study, study.texts.online_tabs);
  let store;
  try {
    store = await openStore(name.join(" "));
  } catch (error) {
    return refuse(study, fillIn(study.texts.online_browser, { message: error.message }));
  }
  if (own.languages) {
    study = await inLanguage(own, chooseLanguage(languages, [await store.fact("language"), ...wishes]), away);
    speak(study);
    await useFont(study, away);
  }
  const identity = { token, identifiers, secret: null };
  let host;
  try {
    host = await persistently(() => findHost(study, identity), away);
  } catch (error) {
    if (error instanceof Refused) return refuse(study, fillIn(study.texts.online_stopped, { message: error.message }));
    throw error;
  }
  host.identity = identity;
  const app = new Study(study, store, host, view);
  globalThis.seamline = app; // for tests, and for who looks
  try {
    await app.begin();
  } catch (error) {
    app.visit ??= beginVisit(app.script);
    app.failed(error);
  }
  listenToKeys(app);
  const jsPsych = globalThis.initJsPsych({ display_element: "study", use_webaudio: false });
  document.getElementById("wait").remove();
  await jsPsych.run(timelineOf(app));
}

main().catch((error) => {
  const wait = document.getElementById("wait");
  if (wait) wait.textContent = "This page could not be loaded: " + error.message;
  else statusLine.textContent = error.message;
  throw error;
});
