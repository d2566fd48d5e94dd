// Pages of words: consent, instructions, ready, break, pause, and the last ones.
import { currentTrial } from "../core/trials.js";
import { buttonRow, card, element, paragraphs } from "./dom.js";
import { textSizes } from "./text_size.js";

/** Nothing has the focus at first, and Enter alone agrees to nothing. */
export function drawConsent(app, display) {
  const { consent } = app.study;
  display.append(
    card(
      app.phrase("consent_title"),
      "wide",
      ...paragraphs(consent.text),
      buttonRow([
        { text: consent.decline, id: "decline", action: () => app.step({ type: "consent_refused" }) },
        {
          text: consent.accept,
          id: "accept",
          leading: true,
          action: () => app.step({ type: "consent_given", unix_s: Math.floor(Date.now() / 1000) }),
        },
      ]),
      textSizes(app),
      ...languageChoice(app)
    )
  );
}

/** The languages of the study, each in its own words. The choice holds until the consent. */
function languageChoice(app) {
  const { languages, language, texts } = app.study;
  if (!languages) return [];
  const nameOf = (tag) => new Intl.DisplayNames([tag], { type: "language" }).of(tag);
  const buttons = languages.map(({ tag }) =>
    element("button", { type: "button", lang: tag, dir: "auto", "aria-pressed": String(tag === language), onclick: () => app.useLanguage(tag) }, nameOf(tag))
  );
  return [element("div", { class: "languages", role: "group", "aria-label": texts.language }, ...buttons)];
}

export function drawInstructions(app, display) {
  const { page } = app.visit.screen;
  const pages = app.study.instructions;
  const { text, pictures } = pages[page];
  const go = (type) => () => app.step({ type });
  const buttons = [{ text: app.phrase("continue"), id: "continue", leading: true, action: go("continued") }];
  if (page > 0) buttons.unshift({ text: app.phrase("back"), id: "back", action: go("went_back") });
  display.append(
    card(
      app.phrase("instructions_title"),
      pictures.length > 0 ? "wide" : "middle",
      ...paragraphs(text),
      ...pictures.map((file) => app.shown(file, text ? "" : app.phrase("page_of", pageWords(page, pages)))),
      element("p", { class: "note" }, app.phrase("page_of", pageWords(page, pages))),
      buttonRow(buttons)
    )
  );
  app.focus("#continue");
}

const pageWords = (page, pages) => ({ page: page + 1, pages: pages.length });

function drawPage(app, display, { title, text, button, more = [] }) {
  const leading = { text: button, id: "continue", leading: true, action: () => app.step({ type: "continued" }) };
  display.append(card(title, "middle", ...paragraphs(text), buttonRow([leading]), ...more));
  app.focus("#continue");
}

/** A page that ends with an answer to how people feel, which is noted with the number of pictures that they have seen. */
function drawComfort(app, display, { title, text, more }, answered) {
  const { question, labels } = app.study.comfort;
  const buttons = labels.map((label, at) => ({
    text: label,
    id: "comfort-" + (at + 1),
    action: () => {
      app.note("comfort", at + 1 + " " + answered);
      app.step({ type: "continued" });
    },
  }));
  display.append(card(title, "wide", ...paragraphs(text + "\n\n" + question), buttonRow(buttons), ...more));
}

export const drawReady = (app, display) =>
  drawPage(app, display, {
    title: app.phrase("ready_title"),
    text: app.phrase("ready_text"),
    button: app.phrase("ready_button"),
  });

/** The instructions of the block of trials that begins. */
export const drawBriefing = (app, display) =>
  drawPage(app, display, {
    title: app.phrase("instructions_title"),
    text: app.study.briefings[currentTrial(app.visit.session.trials).briefing],
    button: app.phrase("continue"),
  });

export function drawBreak(app, display) {
  const { answered, most } = app.visit.session.trials;
  const page = {
    title: app.phrase("break_title"),
    text: app.phrase("break_text", { done: answered, all: most }),
    button: app.phrase("continue"),
    more: [...codeWords(app), ...saveWords(app)],
  };
  if (app.study.comfort) drawComfort(app, display, page, answered);
  else drawPage(app, display, page);
}

/** By which a participant's answers are found when they want them deleted; nothing before they have one. */
export const codeWords = (app) =>
  app.stream.participant === ""
    ? []
    : [element("p", { class: "note", id: "code" }, app.phrase("online_code", { code: app.stream.participant }))];

/** Where nobody but this browser has the answers: a way to take them out, at any time. */
const saveWords = (app) => (app.host.kind === "static" ? saving(app, "online_save_text") : []);

/** `words` say why; without any, the page says it above, and thanks once they are saved. */
function saving(app, words = "") {
  const said = element("div", { class: "note", role: "status" });
  const save = async () => {
    const file = await app.saveAnswers();
    said.replaceChildren(element("p", {}, app.phrase("online_saved", { file })));
    if (words === "") said.append(...paragraphs(app.phrase("thanks_text")));
  };
  return [
    ...(words === "" ? [] : [element("hr"), element("p", { class: "note" }, app.phrase(words))]),
    buttonRow([{ text: app.phrase("online_save"), id: "save", action: save }]),
    said,
  ];
}

export function drawPause(app, display) {
  const leave = () => {
    display.replaceChildren(
      card(
        app.phrase("pause_title"),
        "middle",
        ...paragraphs(app.phrase("online_left")),
        buttonRow([{ text: app.phrase("pause_continue"), id: "continue", leading: true, action: go }])
      )
    );
    app.focus("#continue");
  };
  const go = () => app.step({ type: "continued" });
  display.append(
    card(
      app.phrase("pause_title"),
      "middle",
      ...paragraphs(app.phrase("pause_text")),
      buttonRow([
        { text: app.phrase("pause_leave"), id: "leave", action: leave },
        { text: app.phrase("pause_continue"), id: "continue", leading: true, action: go },
      ]),
      textSizes(app),
      ...codeWords(app),
      ...saveWords(app)
    )
  );
  app.focus("#continue");
}

function drawLast(app, display, title, text, more = []) {
  display.append(card(title, "middle", ...paragraphs(text), ...more));
  app.finished();
}

/** The code that the panel wants, and the way back to it. */
function endWords(app) {
  const { code, link } = app.end ?? {};
  if (!code) return [];
  const words = element("p", { id: "completion" }, app.phrase("recruitment_code", { code }));
  if (!link) return [words];
  const host = new URL(link).host;
  const back = element("a", { class: "button leading", id: "return", href: link, rel: "noreferrer" }, app.phrase("recruitment_back", { host }));
  return [words, element("div", { class: "buttons" }, back)];
}

function drawEnd(app, display, title) {
  drawLast(app, display, app.phrase(title), app.phrase("recruitment_" + app.end.outcome), [...endWords(app), ...codeWords(app)]);
  app.focus("#return");
}

export const drawEnded = (app, display) => drawEnd(app, display, "recruitment_ended");

export function drawThanks(app, display) {
  if (app.end) return drawEnd(app, display, "thanks_title");
  if (app.host.kind === "static" && !app.saved) {
    // Nobody has the answers yet: the page asks for them first, and thanks once they are saved.
    drawLast(app, display, app.phrase("thanks_title"), app.phrase("online_save_text"), [...codeWords(app), ...saving(app)]);
  } else drawLast(app, display, app.phrase("thanks_title"), app.phrase("thanks_text"), [...codeWords(app), ...saveWords(app)]);
  app.focus("#save");
}

export function drawDeclined(app, display) {
  if (app.end?.code) return drawEnd(app, display, "declined_title");
  drawLast(app, display, app.phrase("declined_title"), app.phrase("declined_text"));
}

export function drawStopped(app, display) {
  const { message, reason } = app.visit.screen;
  const unsent = () => (app.holdsMore() ? saving(app, "online_unsent") : []);
  if (reason === "forgotten") return drawLast(app, display, app.phrase("stopped_title"), app.phrase("online_forgotten"), unsent());
  if (reason === "excluded")
    return drawLast(app, display, app.phrase("stopped_title"), app.phrase("online_excluded"), codeWords(app));
  if (reason === "full" && app.end) return drawEnd(app, display, "recruitment_ended");
  if (reason === "again") return drawLast(app, display, app.phrase("recruitment_ended"), app.phrase("recruitment_again"));
  // Whom the host did not let in has answered nothing.
  if (app.stream.participant === "") return drawLast(app, display, app.phrase("online_refused_title"), message);
  const more = [...codeWords(app), ...unsent()];
  drawLast(app, display, app.phrase("stopped_title"), app.phrase("online_stopped", { message }), more);
}
