// Within the first page, before everything else: a script or a style that does not arrive, for whatever reason, is asked for again until it
// does, while the words of #wait stand. What the study itself asks for is asked for again by the study.
(() => {
  "use strict";
  const FIRST_WAIT_MS = 400;
  const LONGEST_WAIT_MS = 15000;
  const brought = []; // promises of the parts that were missing
  const second = new Set(); // elements of ours

  function copyOf(lost) {
    const part = document.createElement(lost.localName);
    for (const { name, value } of lost.attributes) part.setAttribute(name, value);
    part.async = false;
    second.add(part);
    return part;
  }

  /** Whatever comes in the place of a script or a style (a login page) loads as well, and sets nothing and has no rules. */
  const isItself = (part) =>
    part.localName === "script" ? !part.dataset.sets || part.dataset.sets in globalThis : (part.sheet?.cssRules.length ?? 0) > 0;

  async function bring(lost) {
    for (let failures = 0; ; ++failures) {
      const wait_ms = Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** failures) * (0.5 + Math.random());
      await new Promise((resolve) => setTimeout(resolve, wait_ms));
      // Past the browser's cache, which also keeps refusals (410 for good).
      const answer = await fetch(lost.src || lost.href, { cache: "reload" }).catch(() => null);
      if (!answer?.ok) continue;
      const part = copyOf(lost);
      const isThere = await new Promise((resolve) => {
        part.onload = () => resolve(true);
        part.onerror = () => resolve(false);
        document.head.append(part);
      });
      if (isThere && isItself(part)) return;
      part.remove();
    }
  }

  /** Resolves when every part that was missing is there. */
  globalThis.seamlineParts = () => Promise.all(brought);

  const isPart = (target) =>
    (target instanceof HTMLScriptElement || (target instanceof HTMLLinkElement && target.rel === "stylesheet")) &&
    !second.has(target) && target.closest("head") && !globalThis.seamline;
  addEventListener("error", ({ target }) => void (isPart(target) && brought.push(bring(target))), true);
  document.addEventListener("load", ({ target }) => void (isPart(target) && !isItself(target) && brought.push(bring(target))), true);
})();
