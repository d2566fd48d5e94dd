// The display check: a bank card gives millimetres a pixel, then the distance, then whether the screen's curve is sRGB's.
import { buttonRow, card, element, paragraphs, uniqueId } from "./dom.js";

// ISO/IEC 7810 ID-1.
const CARD = { width_mm: 85.6, height_mm: 53.98, corner_mm: 3.18 };
const LEAST_CARD_PX = 150; // of the screen's pixels at ratio 1
const NEAREST_CM = 20;
const FARTHEST_CM = 500;

export const pixelsPerDegree = (mm_per_px, distance_mm) =>
  (2 * distance_mm * Math.tan(Math.PI / 360)) / mm_per_px;

/** Screens differ by their pixels and by how a browser scales them. */
export const screenKey = () => [screen.width, screen.height, devicePixelRatio].join("x");

/** What is told of the screen; `profile` is {mm_per_px, viewing_distance_mm, gamma_confirmed}. */
export function displayFacts(app, profile) {
  const { width, height } = app.screen.size();
  return {
    screen_width_px: Math.round(screen.width * devicePixelRatio),
    screen_height_px: Math.round(screen.height * devicePixelRatio),
    device_pixel_ratio: devicePixelRatio,
    viewport_width_px: width,
    viewport_height_px: height,
    mm_per_px: profile.mm_per_px,
    viewing_distance_mm: profile.viewing_distance_mm,
    pixels_per_degree: pixelsPerDegree(profile.mm_per_px, profile.viewing_distance_mm),
    refresh_hz: app.screen.refreshHz(),
    gamma_confirmed: profile.gamma_confirmed,
    image_scale: 1,
  };
}

function cardStep(app, draft, done) {
  const ratio = devicePixelRatio;
  const em = app.em();
  const least = Math.round(LEAST_CARD_PX * Math.max(1, ratio));
  const most = Math.max(least + 1, Math.round(Math.min(34 * em, app.screen.size().width - 6 * em)));
  draft.card_px ??= Math.min(most, Math.max(least, Math.round((CARD.width_mm / 25.4) * 96 * ratio)));
  const frame = element("div", { class: "bank-card" });
  const room = element("div", { class: "card-room", "aria-hidden": "true" }, frame);
  const size = element("bdi", { dir: "ltr" });
  const slider = element("input", {
    type: "range",
    id: "card",
    min: String(least),
    max: String(most),
    step: "1",
    "aria-label": app.phrase("display_card"),
    oninput: () => show(Number(slider.value)),
  });
  const show = (card_px) => {
    draft.card_px = card_px;
    const pxOfMm = card_px / CARD.width_mm / ratio;
    frame.style.width = card_px / ratio + "px";
    frame.style.height = CARD.height_mm * pxOfMm + "px";
    frame.style.borderRadius = CARD.corner_mm * pxOfMm + "px";
    size.textContent = card_px + " px = 85.60 mm";
    slider.setAttribute("aria-valuetext", size.textContent);
  };
  // Room for the largest card, as far as the slider stays in sight: so the page does not move while the frame grows.
  const tallest = (most * CARD.height_mm) / CARD.width_mm;
  room.style.minHeight = Math.min(tallest, Math.max(app.screen.size().height - 20 * em, 120 * ratio)) / ratio + "px";
  slider.value = String(draft.card_px);
  show(draft.card_px);
  return [
    ...paragraphs(app.phrase("display_card")),
    room,
    slider,
    element("p", { class: "note" }, size),
    buttonRow([{ text: app.phrase("continue"), id: "continue", leading: true, action: done }]),
  ];
}

function distanceStep(app, draft, done) {
  const id = uniqueId("distance");
  const problem = element("p", { class: "problem", id: id + "-problem", hidden: true });
  const input = element("input", {
    id,
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    maxlength: "8",
    class: "number",
    oninput: () => {
      problem.hidden = true;
      input.removeAttribute("aria-invalid");
    },
  });
  const submit = (event) => {
    event.preventDefault();
    const cm = /^\d+(\.\d*)?$/.test(input.value.trim()) ? Number(input.value.trim()) : NaN;
    if (cm >= NEAREST_CM && cm <= FARTHEST_CM) {
      draft.distance_mm = cm * 10;
      return done();
    }
    problem.textContent = app.phrase("form_out_of_range", { least: NEAREST_CM, most: FARTHEST_CM });
    problem.hidden = false;
    input.setAttribute("aria-invalid", "true");
    input.setAttribute("aria-describedby", problem.id);
    app.say(problem.textContent);
    app.focus(input);
  };
  const label = element("label", { for: id }, app.phrase("display_distance"));
  const button = element("button", { type: "submit", id: "continue", class: "leading" }, app.phrase("continue"));
  return [
    element(
      "form",
      { novalidate: true, onsubmit: submit },
      element("div", { class: "field" }, label, input, problem),
      element("div", { class: "buttons" }, button)
    ),
  ];
}

/** One-pixel stripes of black and white send half of white's light; so does code 188 where the curve is sRGB's. */
function stripes() {
  const width = 560;
  const height = 180;
  const canvas = element("canvas", { width: String(width), height: String(height), class: "stripes", "aria-hidden": "true" });
  canvas.style.width = width / devicePixelRatio + "px";
  canvas.style.height = height / devicePixelRatio + "px";
  const paint = canvas.getContext("2d");
  paint.fillStyle = "rgb(188 188 188)";
  paint.fillRect(0, 0, width, height);
  for (const left of [0, width / 2])
    for (let y = 0; y < height; ++y) {
      paint.fillStyle = y % 2 === 0 ? "rgb(255 255 255)" : "rgb(0 0 0)";
      paint.fillRect(left, y, width / 4, 1);
    }
  return canvas;
}

function gammaStep(app, done) {
  return [
    ...paragraphs(app.phrase("display_gamma")),
    stripes(),
    buttonRow([
      { text: app.phrase("display_differ"), id: "differ", action: () => done(false) },
      { text: app.phrase("display_confirm"), id: "same", leading: true, action: () => done(true) },
    ]),
  ];
}

export function drawDisplay(app, display) {
  const draft = {};
  const finish = (same) => {
    const profile = {
      mm_per_px: CARD.width_mm / draft.card_px,
      viewing_distance_mm: draft.distance_mm,
      gamma_confirmed: same,
    };
    app.keepProfile(screenKey(), profile);
    app.step({ type: "display_confirmed", facts: displayFacts(app, profile) });
  };
  const show = (children, focus) => {
    display.replaceChildren(card(app.phrase("display_title"), "middle", ...children));
    app.arrived(display);
    if (focus) app.focus(focus);
  };
  const gamma = () => show(gammaStep(app, finish), null);
  const distance = () => show(distanceStep(app, draft, gamma), "input");
  show(cardStep(app, draft, distance), "#card");
}
