// What happens around the pictures, for the log: focus, hidden tabs, sleep.

const LOOK_EVERY_MS = 2000;
const SLEEP_MS = 20000;

export function watchAttention(note) {
  addEventListener("blur", (event) => note("focus_lost", "", event.timeStamp));
  addEventListener("focus", (event) => note("focus_gained", "", event.timeStamp));
  document.addEventListener("visibilitychange", (event) =>
    note(document.hidden ? "hidden" : "visible", "", event.timeStamp)
  );
  // Timers of hidden tabs come once a minute at the least, those of a sleeping computer not at all.
  let last = Date.now();
  setInterval(() => {
    const now = Date.now();
    if (now - last > (document.hidden ? 90000 : SLEEP_MS)) note("sleep", String(Math.round((now - last) / 1000)));
    last = now;
  }, LOOK_EVERY_MS);
}
