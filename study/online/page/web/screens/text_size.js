// How large all texts are: chosen on pages where it does not disturb.
import { radioGroup } from "./dom.js";
import { placeTrial } from "../core/place.js";

const SIZES = [1, 1.25, 1.5, 2];
const BODY_CSS_PX = 18;

/** The size of the type in pixels of the screen, for the person's choice. */
export const emOf = (app, scale) => BODY_CSS_PX * app.study.text_scale * scale * devicePixelRatio;

export function setTextSize(app, scale) {
  app.textScale = scale;
  document.documentElement.style.fontSize = BODY_CSS_PX * app.study.text_scale * scale + "px";
}

/** Those with which the questions still fit below the pictures; nothing where that is one alone. */
export function textSizes(app) {
  const fits = (scale) => scale === 1 || placeTrial(app.screen.size(), app.study.picture, emOf(app, scale)).fits;
  const sizes = SIZES.filter((scale, at) => SIZES.slice(0, at + 1).every(fits));
  if (sizes.length < 2) return null;
  return radioGroup({
    legend: app.phrase("text_size"),
    options: sizes.map((scale) => Math.round(scale * 100) + " %"),
    chosen: sizes.indexOf(app.textScale),
    change: (index) => {
      setTextSize(app, sizes[index]);
      app.keepTextSize(sizes[index]);
    },
  });
}
