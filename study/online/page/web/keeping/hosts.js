// Who hosts the page, which its export said, and how a message is acknowledged there. A host is
//   {kind, enrol(message) -> {participant, slot, secret?}, decline(message), send(messages) -> number acknowledged,
//    where() -> facts or null, nextTrial() -> trial or null, leave(screen)}
// and throws Refused for what will never be accepted; any other error means: try again.
import { drawCode, drawSlot } from "../core/messages.js";
import { fillIn } from "../core/texts.js";
import { append, leave, loadJatos } from "./jatos.js";
import { NotNow, Refused, verdict } from "./verdict.js";

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
  const answer = await response.json().catch((error) => {
    if (error instanceof SyntaxError) return null; // not our server: a login page, say
    throw error;
  });
  const sentence = typeof answer?.error === "string" ? answer.error : null;
  const no = verdict(response.status, { sentence, of: path });
  if (no) throw Object.assign(no, { reason: answer?.reason, end: answer?.end });
  return expect(path, answer !== null && typeof answer === "object", answer);
}

/** An answer of success counts when it is one of `seamline serve`: only that says that something is stored. */
function expect(path, isOurs, answer) {
  if (!isOurs) throw new NotNow(path + ": an answer, but not of the study's server");
  return answer;
}

/** `seamline serve`. `identity` holds {token, identifiers, secret}; the secret comes with the enrolment. */
function serveHost(identity) {
  const { token, identifiers } = identity;
  const withMessage = (message) => JSON.stringify({ token, ...(identifiers ? { identifiers } : {}), message });
  return {
    kind: "serve",
    async enrol(message) {
      const given = await ask("api/enrol", null, withMessage(message));
      return expect("api/enrol", given.participant && given.secret && Number.isInteger(given.slot), given);
    },
    decline: (message) => ask("api/enrol", null, withMessage(message)),
    async send(messages) {
      const answer = await ask("api/messages", identity.secret, lines(messages));
      const { stored } = expect("api/messages", Array.isArray(answer.stored), answer);
      const known = new Set(stored);
      const first = messages.findIndex((message) => !known.has(message.id));
      return first < 0 ? messages.length : first;
    },
    async where() {
      const at = await ask("api/where", identity.secret);
      return expect("api/where", Number.isInteger(at.next_sequence), at);
    },
    /** How the visit ended, {outcome, code, link}; null: it has not. */
    async end() {
      const at = await ask("api/end", identity.secret);
      return expect("api/end", "outcome" in at, at.outcome === null ? null : at);
    },
    async nextTrial() {
      const answer = await ask("api/next", identity.secret, "");
      const { trial } = expect("api/next", answer.trial || answer.done === true, answer);
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

/** JATOS: appended, awaited, and sent again when that fails. What arrives twice is recognised by its id. */
function jatosHost(study, jatos) {
  return {
    kind: "jatos",
    drawn: () => drawnEnrolment(study.slots),
    enrol: async (message) => ({ participant: message.participant, slot: message.body.slot }),
    decline: (message) => append(jatos, lines([message])),
    async send(messages) {
      await append(jatos, lines(messages));
      return messages.length;
    },
    where: async () => null,
    nextTrial: async () => null,
    leave: (screen) => leave(jatos, screen),
  };
}

/** How a person knows a host: for words about the wrong one. */
const NAMES = { serve: "seamline serve", jatos: "JATOS", static: "a host of files" };

/** Why answers of a visit that was begun at one kind of host must not go to another, with the study's words; or null. */
export function wrongHost(study, begun, here) {
  if (begun === here) return null;
  const words = { wanted: NAMES[begun] ?? begun, found: NAMES[here] ?? here };
  return new Refused(fillIn(study.texts.online_host, words));
}

/** The host that the page was exported for, and no other. JATOS serves everything below /publix/. */
export async function findHost(study, identity) {
  if (study.host === "serve") return serveHost(identity);
  if (study.host === "jatos") return jatosHost(study, await loadJatos());
  if (location.pathname.includes("/publix/")) throw wrongHost(study, "static", "jatos");
  return staticHost(study);
}
