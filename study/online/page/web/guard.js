// Stands before the study while a picture could not be shown exactly: says why, and gives way by itself.
import { placeTrial } from "./core/place.js";
import { sessionOnScreen } from "./core/visit.js";
import { buttonRow, element, paragraphs } from "./screens/dom.js";

/** Pages of words need no exact picture. */
const NEEDED_ON = ["training", "feedback", "trial", "display", "instructions", "ready"];

export function makeGuard(app, node) {
  let problem = null;

  function find() {
    if (app.headset) return null; // which has pixels of its own
    if (!app.visit || !NEEDED_ON.includes(app.visit.screen.name)) return null;
    if (!placeTrial(app.screen.size(), app.study.picture, app.em()).fits) return "small";
    return app.screen.exact() ? null : "zoom";
  }

  function words() {
    if (problem === "zoom") return app.phrase("online_zoom");
    const { needed } = placeTrial(app.screen.size(), app.study.picture, app.em());
    const { width, height } = app.screen.size();
    return app.phrase("online_small", {
      wanted: Math.ceil(needed.width) + " x " + Math.ceil(needed.height),
      found: width + " x " + height,
    });
  }

  const fullScreen = () => document.documentElement.requestFullscreen?.().catch(() => {});

  function show() {
    const study = document.getElementById("study");
    const buttons = document.fullscreenEnabled
      ? buttonRow([{ text: app.phrase("online_full_screen"), id: "full-screen", leading: true, action: fullScreen }])
      : null;
    const text = element("div", { id: "guard-words" }, ...paragraphs(words()));
    const box = element("section", { class: "card middle" }, ...[text, buttons].filter((part) => part !== null));
    node.replaceChildren(box);
    node.hidden = false;
    study.inert = true;
    node.querySelector("button")?.focus();
  }

  function hide() {
    node.hidden = true;
    node.replaceChildren();
    document.getElementById("study").inert = false;
  }

  const guard = {
    problem: () => problem,
    look() {
      const found = find();
      if (found === problem) {
        if (problem === "small") node.querySelector("p").textContent = words();
        return;
      }
      const before = problem;
      problem = found;
      if (problem === null) return hide();
      show();
      if (before === null && sessionOnScreen(app.visit)) {
        app.note("picture_taken", problem);
        app.step({ type: "picture_taken" });
      }
    },
  };
  app.screen.onChange(() => guard.look());
  return guard;
}
