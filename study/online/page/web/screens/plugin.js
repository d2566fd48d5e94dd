// A screen of the visit as a plugin of jsPsych: drawn when its turn comes, over when the visit is elsewhere.

/** What one jsPsych trial is: a page, or one picture of a session. */
export function placeOf(visit) {
  const { name, page } = visit.screen;
  if (name === "instructions") return name + page;
  if (name === "training") return name + visit.training.trials.answered;
  if (name === "trial") return name + visit.session.trials.answered;
  return name;
}

/**
 * `draw(app, display)` builds the screen and returns nothing, or {update(), close()}: update is called whenever the
 * visit changed and is still here, close when it is not.
 */
export function screenPlugin(app, name, draw) {
  class Screen {
    trial(display, trial, onLoad) {
      const here = placeOf(app.visit);
      const drawn = draw(app, display) ?? {};
      app.arrived(display);
      onLoad();
      return new Promise((resolve) => {
        const stop = app.onChange(() => {
          if (placeOf(app.visit) === here) return drawn.update?.();
          stop();
          drawn.close?.();
          resolve({ screen: name });
        });
      });
    }
  }
  Screen.info = { name: "seamline-" + name, version: "1", parameters: {}, data: {} };
  return Screen;
}
