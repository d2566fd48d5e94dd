// JATOS (3.7.6 and later), through its own jatos.js.
import { NotNow, Refused, verdict } from "./verdict.js";

const START_PATIENCE_MS = 60000; // its scripts, its data and its batch channel
const SEND_PATIENCE_MS = 45000; // longer than jatos.httpTimeout

/** The run that the page's address names, as jatos.js finds it (/publix/RUN/COMPONENT/start); null elsewhere. */
export function runOf(path) {
  const parts = path.split("/").reverse();
  return parts.includes("publix") && parts.length > 3 ? parts[2] : null;
}

/**
 * jQuery puts scripts of the page's own origin into the page as text, which the page's policy forbids, unless they are to
 * have attributes: then it loads them by their address, as it does all others. jatos.js asks its own jQuery for its other
 * parts as soon as that is there; one that comes late, of a load that was given up, is no exception.
 */
export function loadPartsByAddress() {
  let loaded = globalThis.jQuery;
  Object.defineProperty(globalThis, "jQuery", {
    configurable: true,
    enumerable: true,
    get: () => loaded,
    set(jQuery) {
      loaded = jQuery;
      jQuery?.ajaxSetup({ scriptAttrs: {} });
    },
  });
}

function within(milliseconds, promise, otherwise = () => {}) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => {
      otherwise();
      reject(new Error("JATOS did not answer"));
    }, milliseconds);
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** Rejects as soon as one of its parts is lost: it would wait for it for good. */
function loadScript() {
  const listening = new AbortController();
  return new Promise((resolve, reject) => {
    const lost = ({ target }) => target.src?.includes("/jatos-publix/") && reject(new Error(target.src + " did not arrive"));
    addEventListener("error", lost, { capture: true, signal: listening.signal });
    const script = document.createElement("script");
    script.src = "jatos.js";
    script.onload = () => {
      if (!globalThis.jatos) return reject(new NotNow("jatos.js: an answer, but not JATOS's"));
      globalThis.jatos.onLoad(() => resolve(globalThis.jatos));
    };
    script.onerror = () => reject(new Error("jatos.js did not arrive"));
    document.body.append(script); // what is lost of the head start.js brings again
  }).finally(() => listening.abort());
}

/** Throws where a file is refused. The browser asks for it anew. */
async function requireFile(file, cache) {
  const response = await fetch(file, { cache, signal: AbortSignal.timeout(START_PATIENCE_MS) });
  const no = verdict(response.status, { of: file });
  if (no) throw no;
}

let loads = 0;

/** JATOS's own script, with what it knows of the run. Whatever else answers, it is waited for. */
export async function loadJatos() {
  await requireFile("jatos.js", "no-cache");
  // The browser keeps some refusals (410) for good, and would give jatos.js the one of the load before.
  if (loads++ > 0) await requireFile("initData", "reload");
  loadPartsByAddress();
  const jatos = await within(START_PATIENCE_MS, loadScript());
  if (jatos.studyLength === null) throw new NotNow("JATOS: no data of this run");
  return jatos;
}

/**
 * What a failure of jatos.js means. Its sentence is "METHOD to ADDRESS failed: STATUS, STATUS'S NAME, ANSWER", with the last
 * three also by themselves since 3.10. JATOS's own answers are plain text; HTML is somebody else's, on the way to it.
 */
export function faultOf(sentence, status, _name, answer) {
  const said = String(sentence ?? "");
  if (/run is invalid/.test(said)) return new Refused(said);
  const [, code, words] = / failed: (\d{3})(?:, (.*))?$/s.exec(said) ?? [];
  const number = Number(status || code || 0);
  if (number === 0) return new Error(said || "JATOS did not answer");
  const own = answer ?? words?.split(", ").slice(1).join(", ");
  return verdict(number, { sentence: own && !own.includes("<") ? own : null, of: "JATOS" }) ?? new Error(said);
}

/**
 * Appends to the run's results. The page tries again by itself, and says so meanwhile, so jatos.js tries once. Where it says
 * nothing at all its worker did not arrive, which it never notices: the page is loaded again, and goes on.
 */
export async function append(jatos, text) {
  const { httpRetry } = jatos;
  jatos.httpRetry = 0;
  const sent = jatos.appendResultData(text);
  jatos.httpRetry = httpRetry;
  const said = new Promise((resolve, reject) => sent.then(resolve, (...fault) => reject(faultOf(...fault))));
  return within(SEND_PATIENCE_MS, said, () => location.reload());
}

/**
 * The run's end. Whoever answered everything comes to JATOS's end page, or to where the study's settings lead; whoever
 * declined has failed the run, and stays.
 */
export function leave(jatos, screen) {
  if (screen === "thanks") jatos.endStudy(true);
  if (screen === "declined") jatos.endStudy(false, "declined", false);
}
