// Carries messages: numbered, on this computer's disk first, then to the host until it has acknowledged them.
import { makeMessage } from "../core/messages.js";
import { persistently } from "./patience.js";

const MOST_AT_ONCE = 64;
const MOST_BYTES = 1 << 19; // a letter as UTF-8 has at most three bytes; a host takes a million
const EVENTS_AFTER_MS = 8000;

/** As many messages, from the first on, as one request may carry: a list of its own, for others come meanwhile. */
function groupOf(unsent) {
  let bytes = 0;
  const isWithin = (message, at) => (bytes += JSON.stringify(message).length * 3) <= MOST_BYTES || at === 0;
  const over = unsent.findIndex((message, at) => at >= MOST_AT_ONCE || !isWithin(message, at));
  return unsent.slice(0, over < 0 ? unsent.length : over);
}

/**
 * `stream` is {study_hash, set_hash, participant}; `messages` those that are kept already; `acknowledged` how many of
 * them, from the first on, the host has. `away` as persistently calls it.
 */
export function makeCourier({ store, host, stream, messages, acknowledged, away }) {
  let sequence = messages.length === 0 ? 0 : messages[messages.length - 1].sequence + 1;
  let unsent = messages.filter((message) => message.sequence >= acknowledged);
  let writing = Promise.resolve();
  let sending = null;
  let later = null;

  /** In the order of the calls; a number is given when it is its turn, so that a refused write leaves no gap. */
  function keep(kind, body) {
    const written = writing.then(async () => {
      const message = makeMessage(stream, sequence, kind, body);
      await store.append(message);
      ++sequence;
      unsent.push(message);
      return message;
    });
    writing = written.catch(() => {});
    return written;
  }

  async function sendAll() {
    while (unsent.length > 0) {
      const group = groupOf(unsent);
      const count = await persistently(async () => {
        const stored = await host.send(group);
        if (stored === 0) throw new Error("nothing was stored");
        return stored;
      }, away);
      unsent = unsent.slice(count);
      acknowledged = unsent.length > 0 ? unsent[0].sequence : sequence;
      store.keepFact("acknowledged", acknowledged).catch(() => {}); // else they are sent again, and known by their ids
    }
  }

  /** One at a time: whoever comes while messages are under way waits for them, then sends the rest. */
  function send() {
    sending = (sending ?? Promise.resolve()).catch(() => {}).then(sendAll);
    return sending;
  }

  return {
    stream,
    /** On the disk and acknowledged, when this resolves. Rejects when it cannot be kept, or is Refused. */
    async deliver(kind, body) {
      const message = await keep(kind, body);
      await send();
      return message;
    },
    /** On the disk soon, and with the next message at the host. */
    note(kind, body) {
      keep(kind, body).catch(() => {});
      later ??= setTimeout(() => {
        later = null;
        send().catch(() => {});
      }, EVENTS_AFTER_MS);
    },
    keep,
    send,
    unsent: () => unsent.length,
  };
}
