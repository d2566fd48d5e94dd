// Before everything else. Where a script or the style did not arrive, because the network was cut, the page is loaded
// again as soon as its host answers. What the study itself asks for is asked for again by the study.
(() => {
  "use strict";
  const WAIT_MS = 1000;
  const MOST_LOADS = 20; // in a row, of a tab: then something else is wrong
  const COUNT = "seamline-loads";
  let isOver = false; // all is there, or is being waited for

  function loads() {
    try {
      return Number(sessionStorage.getItem(COUNT) ?? 0);
    } catch {
      return 0;
    }
  }
  function setLoads(count) {
    try {
      sessionStorage.setItem(COUNT, String(count));
    } catch {
      // Then there is no bound.
    }
  }

  /** seamline.js is there, with everything that it needs. */
  globalThis.seamlineArrived = () => {
    isOver = true;
    setLoads(0);
  };

  async function loadAgain(address) {
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve, WAIT_MS));
      const answer = await fetch(address, { cache: "no-store" }).catch(() => null);
      if (answer === null || answer.status >= 500) continue;
      if (!answer.ok || loads() >= MOST_LOADS) return;
      setLoads(loads() + 1);
      return location.reload();
    }
  }

  addEventListener(
    "error",
    ({ target }) => {
      const address = target instanceof HTMLScriptElement ? target.src : target instanceof HTMLLinkElement ? target.href : "";
      if (isOver || address === "" || target.rel === "icon") return;
      isOver = true;
      loadAgain(address);
    },
    true
  );
})();
