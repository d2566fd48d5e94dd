// Who hosts the page, and how a message is acknowledged there. A host is
//   {kind, enrol(message) -> {participant, slot, secret?}, decline(message), send(messages) -> number acknowledged,
//    where() -> facts or null, nextTrial() -> trial or null, leave()}
// and throws Refused for what will never be accepted; any other error means: try again.
import { drawCode, drawSlot } from "../core/messages.js";

/** The host understood, and will not have it. */
export class Refused extends Error {}

const PATIENCE_MS = 20000;
const lines = (messages) => messages.map((message) => JSON.stringify(message) + "\n").join("");

async function ask(path, secret, body) {
  const headers = secret ? { Authorization: "Bearer " + secret } : {};
  if (body !== undefined) headers["Content-Type"] = "application/json";
  const response = await fetch(path, {
    method: body === undefined ? "GET" : "POST",
    headers,
    body,
    cache: "no-store",
    credentials: "same-origin",
    signal: AbortSignal.timeout(PATIENCE_MS),
  });
  const answer = await response.json().catch(() => ({}));
  if (response.ok) return answer;
  const sentence = answer.error ?? "HTTP " + response.status;
  const passing = response.status >= 500 || response.status === 408 || response.status === 429;
  throw passing ? new Error(sentence) : new Refused(sentence);
}

/** `seamline serve`. `identity` holds {token, secret}; the secret comes with the enrolment. */
function serveHost(identity) {
  return {
    kind: "serve",
    enrol: (message) => ask("api/enrol", null, JSON.stringify({ token: identity.token, message })),
    decline: (message) => ask("api/enrol", null, JSON.stringify({ token: identity.token, message })),
    async send(messages) {
      const { stored } = await ask("api/messages", identity.secret, lines(messages));
      const known = new Set(stored);
      const first = messages.findIndex((message) => !known.has(message.id));
      return first < 0 ? messages.length : first;
    },
    where: () => ask("api/where", identity.secret),
    async nextTrial() {
      const { trial } = await ask("api/next", identity.secret, "");
      return trial ?? null;
    },
    leave() {},
  };
}

/** What hosts without a server of ours have in common: the page draws code and slot itself. */
const drawnEnrolment = (slots) => ({ participant: drawCode(), slot: drawSlot(slots) });

/** Any static host: an answer is acknowledged by the disk of this browser, and downloaded at the end. */
function staticHost(study) {
  return {
    kind: "static",
    drawn: () => drawnEnrolment(study.slots),
    enrol: async (message) => ({ participant: message.participant, slot: message.body.slot }),
    decline: async () => {},
    send: async (messages) => messages.length,
    where: async () => null,
    nextTrial: async () => null,
    leave() {},
  };
}

function within(milliseconds, promise) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error("JATOS did not answer")), milliseconds);
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** JATOS: appended, awaited, and sent again when that fails. What arrives twice is recognised by its id. */
function jatosHost(study, jatos) {
  const append = (text) =>
    within(PATIENCE_MS, new Promise((resolve, reject) => jatos.appendResultData(text).then(resolve, reject)));
  return {
    kind: "jatos",
    drawn: () => drawnEnrolment(study.slots),
    enrol: async (message) => ({ participant: message.participant, slot: message.body.slot }),
    decline: (message) => append(lines([message])),
    async send(messages) {
      await append(lines(messages));
      return messages.length;
    },
    where: async () => null,
    nextTrial: async () => null,
    leave() {
      if (jatos.endStudyWithoutRedirect) return jatos.endStudyWithoutRedirect(true);
      return jatos.endStudyAjax?.(true);
    },
  };
}

/** Null where there is none. A network that is cut is not "none": then the answers would stay in the browser. */
async function loadJatos() {
  const response = await fetch("jatos.js", { cache: "no-cache" });
  if (response.status >= 500) throw new Error("jatos.js: HTTP " + response.status);
  if (!response.ok) return null;
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = "jatos.js";
    script.onload = () => (globalThis.jatos ? globalThis.jatos.onLoad(() => resolve(globalThis.jatos)) : resolve(null));
    script.onerror = () => reject(new Error("jatos.js did not arrive"));
    document.head.append(script);
  });
}

/** Asks who is there. JATOS serves everything below /publix/. */
export async function findHost(study, identity) {
  if (location.pathname.includes("/publix/")) {
    const jatos = await loadJatos();
    if (jatos) return jatosHost(study, jatos);
  }
  const response = await fetch("host.json", { cache: "no-store" });
  if (response.ok) {
    const host = await response.json().catch(() => ({}));
    if (host.kind === "serve") return serveHost(identity);
  } else if (response.status >= 500) {
    throw new Error("HTTP " + response.status);
  }
  return staticHost(study);
}
