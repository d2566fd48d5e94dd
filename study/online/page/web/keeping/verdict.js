// What an answer from the network means: the only place that looks at a status.

/** The host itself will not have it, now or later. */
export class Refused extends Error {}

/** Somebody answered, but not with what was asked for: it is asked for again, and meanwhile `message` is shown. */
export class NotNow extends Error {}

/** HTTP's own "later" among its refusals: timeout (RFC 9110), too early (RFC 8470), too many requests (RFC 6585). */
const LATER = [408, 425, 429];

/**
 * Null for a success, else the error to throw. `sentence` is what the host says of its refusal in a form that only it
 * has. Without one it may have been somebody on the way (a proxy, a firewall, a login page) or a host that is being
 * set up, and that passes. `of` names what was asked for.
 */
export function verdict(status, { sentence = null, of = "" } = {}) {
  if (status >= 200 && status < 300) return null;
  const isFinal = sentence !== null && status >= 400 && status < 500 && !LATER.includes(status);
  return isFinal ? new Refused(sentence) : new NotNow(sentence ?? (of ? of + ": " : "") + "HTTP " + status);
}
