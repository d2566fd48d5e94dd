// Clips: decoded ahead, each frame's hash checked, drawn at its time, and counted as the window counts (study/app/pictures/clip_player.h).
import { addChange, dueAt, frameFor, readClipHeader } from "./core/clip_file.js";
import { sha256 } from "./hash.js";

const MOST_AHEAD = 16; // frames that are decoded and not yet drawn

async function inflated(stream) {
  const change = new Blob([stream]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(change).arrayBuffer());
}

/** The frames of a clip as ImageData, in order and without end; `spare` are some that are drawn already. */
function makeDecoder(bytes, { width_px, height_px, frames }, spare) {
  const codes = new Uint8Array(3 * width_px * height_px);
  let next = 0;
  return async () => {
    const { begin, end, sha256: wanted } = frames[next];
    const change = await inflated(bytes.subarray(begin, end));
    if (change.length !== codes.length) throw new Error("frame " + next + " of a clip is damaged");
    if (next === 0) codes.fill(0);
    const image = spare.pop() ?? new ImageData(width_px, height_px);
    // Views of bytes wrap around where they are added to; ImageData's own would stop at 255.
    addChange(codes, change, new Uint8Array(image.data.buffer));
    const found = await sha256(codes);
    if (found !== null && found !== wanted) throw new Error("frame " + next + " of a clip has other codes than were exported");
    next = (next + 1) % frames.length;
    return image;
  };
}

/**
 * A clip of a study ({frames_per_s, loops}) on a canvas of its own, at its first frame. `failed` hears of a frame that cannot be
 * decoded. Frames are counted on through repetitions.
 */
export function openClip(bytes, { frames_per_s, loops }, failed) {
  const header = readClipHeader(bytes);
  const count = header.frames.length;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.naturalWidth = header.width_px; // as an image says it
  canvas.height = canvas.naturalHeight = header.height_px;
  const context = canvas.getContext("2d", { alpha: false });
  const spare = [];
  let ahead, onScreen, isNew, counts; // isNew: drawn, and no refresh has shown it yet
  let run = 0; // of decoding; another one has begun where it differs
  let wake = () => {};

  function draw(image) {
    context.putImageData(image, 0, 0);
    spare.push(image);
  }

  async function decodeAhead(mine) {
    const next = makeDecoder(bytes, header, spare);
    for (let frame = 0; loops || frame < count; ++frame) {
      while (mine === run && ahead.length >= MOST_AHEAD) await new Promise((resolve) => (wake = resolve));
      if (mine !== run) return;
      const image = await next();
      if (mine !== run) return;
      if (frame === 0) draw(image);
      else ahead.push(image);
    }
  }

  const clip = {
    canvas,
    /** Back to the first frame, unless it stands there; what was counted is forgotten. Whether it was elsewhere. */
    rewind() {
      if (ahead && onScreen === 0) return false;
      clip.stop();
      ahead = [];
      onScreen = 0;
      isNew = false;
      counts = { shown: 1, late: 0, dropped: 0 };
      decodeAhead(run).catch(failed);
      return true;
    },
    /** Whether it may begin: as many frames are decoded as are held. */
    isReady: () => ahead !== null && ahead.length >= (loops ? MOST_AHEAD : Math.min(MOST_AHEAD, count - 1)),
    /** At a frame of the page, after the onset: counts what the screen shows by now, draws what it is to show next. Whether that changed. */
    play(elapsed_ms, period_ms) {
      if (isNew) {
        isNew = false;
        ++counts.shown;
        if (elapsed_ms - dueAt(onScreen, frames_per_s) > 2 * period_ms) ++counts.late;
      }
      let wanted = frameFor(elapsed_ms, period_ms, frames_per_s);
      if (!loops) wanted = Math.min(wanted, count - 1);
      let newest = null;
      while (onScreen < wanted && ahead.length > 0) {
        if (newest) {
          ++counts.dropped;
          spare.push(newest);
        }
        newest = ahead.shift();
        ++onScreen;
      }
      if (!newest) return false;
      draw(newest);
      isNew = true;
      wake();
      return true;
    },
    /** Whether anything is still to be drawn or counted. */
    isPlaying: () => loops || isNew || onScreen < count - 1,
    frame: () => onScreen % count,
    /** As the log has it. */
    showing: () => "shown " + counts.shown + " late " + counts.late + " dropped " + counts.dropped,
    /** Nothing is decoded from now on. */
    stop() {
      ++run;
      ahead = null;
      wake();
    },
  };
  clip.rewind();
  return clip;
}
