// Carries messages: numbered, on this computer's disk first, then to the host until it has acknowledged them.
import { makeMessage } from "../core/messages.js";
import { Refused } from "./hosts.js";

const MOST_AT_ONCE = 64;
const FIRST_WAIT_MS = 400;
const LONGEST_WAIT_MS = 15000;
const EVENTS_AFTER_MS = 8000;

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

/** Tries until it works or is Refused; `away(true)` after the first failure, `away(false)` once it worked. */
export async function persistently(work, away) {
  let failures = 0;
  for (;;) {
    try {
      const result = await work();
      if (failures > 0) away(false);
      return result;
    } catch (error) {
      if (error instanceof Refused) throw error;
      if (failures === 0) away(true);
      await pauseFor(Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** failures));
      ++failures;
    }
  }
}

/**
 * `stream` is {study_hash, set_hash, participant}; `messages` those that are kept already; `acknowledged` how many of
 * them, from the first on, the host has. `away` is called with whether the host is out of reach.
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
      const group = unsent.slice(0, MOST_AT_ONCE);
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
