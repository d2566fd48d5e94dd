// Asking again until it works.
import { NotNow, Refused, verdict } from "./verdict.js";

const FIRST_WAIT_MS = 400;
const LONGEST_WAIT_MS = 15000;
const FILE_PATIENCE_MS = 120000; // for a whole picture over a slow line

/** Waits, but not past the moment the network comes back. */
function pauseFor(milliseconds) {
  return new Promise((resolve) => {
    const over = () => {
      clearTimeout(timer);
      removeEventListener("online", over);
      resolve();
    };
    const timer = setTimeout(over, milliseconds);
    addEventListener("online", over);
  });
}

/** Half to one and a half times the wait that is due: a class that was sent away together does not come back together. */
const waitAfter = (failures) => Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** failures) * (0.5 + Math.random());

/**
 * Tries `work(failures so far)` until it works or is Refused. `away(before, now)` hears which error is waited out, null:
 * none.
 */
export async function persistently(work, away) {
  let problem = null;
  const tell = (now) => {
    const before = problem;
    problem = now;
    away(before, now);
  };
  try {
    for (let failures = 0; ; ++failures) {
      try {
        return await work(failures);
      } catch (error) {
        if (error instanceof Refused) throw error;
        tell(error);
        await pauseFor(waitAfter(failures));
      }
    }
  } finally {
    if (problem !== null) tell(null);
  }
}

/** Somebody on the way answered in the place of a file: a login page, say. */
export const notTheFile = (file) => new NotNow(file + ": not the file that was exported");

/** A file of the page, read by `read(response)`. Throws NotNow for every answer but the file. */
export async function fetchFile(file, read, cache = "no-cache") {
  const response = await fetch(file, { cache, signal: AbortSignal.timeout(FILE_PATIENCE_MS) });
  const no = verdict(response.status, { of: file });
  if (no) throw no;
  try {
    return await read(response);
  } catch (error) {
    throw error instanceof SyntaxError ? notTheFile(file) : error;
  }
}
/** `isIt(json)`: whether it is that file. */
export async function fetchJson(file, { cache = "no-cache", isIt = () => true } = {}) {
  const json = await fetchFile(file, (response) => response.json(), cache);
  if (!isIt(json)) throw notTheFile(file);
  return json;
}

/** How to ask for a file that the browser may have: it also keeps refusals (410 for good), so from the second time on anew. */
export const cacheAfter = (failures) => (failures === 0 ? "default" : "reload");
