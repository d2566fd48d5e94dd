// What the page says to whoever hosts it: one JSON object a message (documentation/how-to/online_page.md).

export const FORMAT = "seamline-online-1";

const random = (count) => crypto.getRandomValues(new Uint8Array(count));

/** A UUID of version 4; crypto.randomUUID needs a secure context, which a lab network need not have. */
export function drawUuid(bytes = random(16)) {
  bytes[6] = (bytes[6] & 0x0f) | 0x40;
  bytes[8] = (bytes[8] & 0x3f) | 0x80;
  const hex = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return [hex.slice(0, 8), hex.slice(8, 12), hex.slice(12, 16), hex.slice(16, 20), hex.slice(20)].join("-");
}

/** A participant's code where no server gives one: w- and 80 random bits in base 32. */
export function drawCode(bytes = random(16)) {
  const letters = "abcdefghijklmnopqrstuvwxyz234567";
  return "w-" + Array.from(bytes, (byte) => letters[byte & 31]).join("");
}

/** A whole number from 0 to count - 1, each as likely as the others. */
export function drawSlot(count, draw = () => crypto.getRandomValues(new Uint32Array(1))[0]) {
  const limit = Math.floor(2 ** 32 / count) * count;
  for (;;) {
    const number = draw();
    if (number < limit) return number % count;
  }
}

/** Monotonic nanoseconds of a time in the page's milliseconds. */
export const nanoseconds = (milliseconds) => Math.round(milliseconds * 1e6);

/** `stream` is {study_hash, set_hash, participant}. */
export function makeMessage(stream, sequence, kind, body) {
  return {
    format: FORMAT,
    study_hash: stream.study_hash,
    set_hash: stream.set_hash,
    participant: stream.participant,
    sequence,
    id: drawUuid(),
    kind,
    body,
  };
}

/** How far a participant has come, from the messages that are kept. */
export function progressOf(messages) {
  const of = (kind) => messages.filter((message) => message.kind === kind);
  return {
    enrolled: of("enrol").length > 0,
    form_done: of("form").length > 0,
    trained: of("training").length,
    answered: of("answer").length,
    begun: of("event").some((message) => message.body.kind === "shown" && message.body.detail === ""),
    completed: of("completion").length > 0,
  };
}
