// A clip's file (stimuli/set/clip_file.h): a line of JSON, then its frames, each a zlib stream, and when each is due.

const MAGIC = "seamline clip 1\n";

/** {width_px, height_px, frames: [{begin, end, sha256}]} of a file's bytes. Throws where they are no clip of three channels. */
export function readClipHeader(bytes) {
  const end = bytes.indexOf(10, MAGIC.length);
  const text = (from, to) => new TextDecoder().decode(bytes.subarray(from, to));
  if (end < 0 || text(0, MAGIC.length) !== MAGIC) throw new Error("no clip");
  const { width_px, height_px, channels, frames: listed } = JSON.parse(text(MAGIC.length, end));
  let at = end + 1;
  const frames = listed.map(({ bytes: size, sha256 }) => ({ begin: at, end: (at += size), sha256 }));
  if (channels !== 3 || frames.length === 0 || at !== bytes.length) throw new Error("no clip of colours");
  return { width_px, height_px, frames };
}

/** Adds a frame's change to the codes of the frame before, modulo 256, and writes them as RGBA. */
export function addChange(codes, change, rgba) {
  for (let from = 0, to = 0; from < codes.length; from += 3, to += 4) {
    rgba[to] = codes[from] += change[from];
    rgba[to + 1] = codes[from + 1] += change[from + 1];
    rgba[to + 2] = codes[from + 2] += change[from + 2];
    rgba[to + 3] = 255;
  }
}

/** When a frame is due, after the onset. */
export const dueAt = (frame, frames_per_s) => (1000 * frame) / frames_per_s;

/** The frame to draw now, so that the refresh that shows it is the nearest to its time: it is seen one period from now. */
export const frameFor = (elapsed_ms, period_ms, frames_per_s) => Math.floor(((elapsed_ms + 1.5 * period_ms) * frames_per_s) / 1000);
