// Pictures and clips: loaded one after another ahead of need, their hashes checked, decoded before they are due.
import { cacheAfter, fetchFile, fetchJson, persistently } from "./keeping/patience.js";
import { NotNow } from "./keeping/verdict.js";
import { unpackMap } from "./core/place.js";
import { openClip } from "./clips.js";
import { sha256 } from "./hash.js";

const FEWEST_DECODED = 6; // a trial may show two, and the next one two others

async function isRight(bytes, wanted) {
  if (bytes.byteLength !== wanted.bytes) return false;
  const found = await sha256(bytes);
  return found === null || found === wanted.sha256;
}

/** Throws when it is not what was exported: then it is tried again. */
async function fetchChecked(wanted, cache) {
  const bytes = await fetchFile(wanted.file, (response) => response.arrayBuffer(), cache);
  if (await isRight(bytes, wanted)) return bytes;
  throw new NotNow(wanted.file + ": not the picture that was exported");
}

async function decode(blob) {
  const image = new Image();
  const address = URL.createObjectURL(blob);
  image.src = address;
  await image.decode();
  image.release = () => URL.revokeObjectURL(address);
  return image;
}

/**
 * `known` lists the study's pictures, `plays` how its clips are shown, where these are clips; `away` hears of one that cannot be
 * reached, `progress` how many are here, `failed` of a clip that cannot be decoded.
 */
export function makePictures(known, plays, { away, progress, failed }) {
  const facts = new Map(known.map((picture) => [picture.file, picture]));
  const bytes = new Map(); // as they came, compressed: blobs, which a browser need not hold in memory
  const decoded = new Map(); // in the order of their use, the latest last
  const maps = new Map(); // of a clip a packed one of each frame
  let queue = [];
  let loading = null;

  let most = FEWEST_DECODED;
  const coming = new Map(); // those on their way: nothing is fetched twice

  function load(file) {
    if (!coming.has(file)) coming.set(file, fetchAll(file).finally(() => coming.delete(file)));
    return coming.get(file);
  }

  async function fetchAll(file) {
    const patiently = (ask) => persistently((failures) => ask(cacheAfter(failures)), away);
    if (!bytes.has(file)) {
      const found = await patiently((cache) => fetchChecked(facts.get(file), cache));
      bytes.set(file, new Blob([found], plays ? {} : { type: "image/png" }));
    }
    const { map: mapFile, base } = facts.get(file);
    if (base) await load(base);
    if (!maps.has(mapFile)) {
      const packed = await patiently((cache) => fetchJson(mapFile, { cache, isIt: (json) => (plays ? json?.[0] : json)?.frames }));
      maps.set(mapFile, plays ? packed : unpackMap(packed));
    }
    progress(bytes.size, facts.size);
  }

  async function loadAll() {
    while (queue.length > 0) {
      const file = queue.shift();
      if (!bytes.has(file) || !maps.has(facts.get(file).map)) await load(file);
    }
    loading = null;
  }

  function use(file, image) {
    decoded.delete(file);
    decoded.set(file, image);
    for (const [oldest, old] of decoded) {
      if (decoded.size <= most) break;
      old.release();
      decoded.delete(oldest);
    }
    return image;
  }

  async function readyClip(file) {
    await load(file);
    const clip = openClip(new Uint8Array(await bytes.get(file).arrayBuffer()), plays, failed);
    const packed = maps.get(facts.get(file).map);
    const mapOf = (frame) => unpackMap(packed[frame]);
    return { image: clip.canvas, map: mapOf(0), clip, mapOf };
  }

  /**
   * The decoded picture and the map of its objects. Of a clip its canvas, `clip` that plays it, and `mapOf` its frames. Of a difference
   * the image that it is added to, as `image.base`.
   */
  async function ready(file) {
    if (plays) return readyClip(file);
    if (decoded.has(file)) return { image: use(file, decoded.get(file)), map: maps.get(facts.get(file).map) };
    await load(file);
    const image = await decode(bytes.get(file));
    const { base } = facts.get(file);
    if (base) image.base = (await ready(base)).image;
    return { image: use(file, image), map: maps.get(facts.get(file).map) };
  }

  return {
    /** What is needed from now on, the most urgent first. */
    want(files) {
      queue = [...new Set([...files, ...queue])].filter((file) => facts.has(file) && !bytes.has(file));
      loading ??= loadAll();
    },
    ready,
    /** Trials of so many pictures: those of one and of the next stay decoded. */
    keep(count) {
      most = Math.max(most, 2 * count);
    },
    isDecoded: (file) => decoded.has(file),
    count: () => ({ done: bytes.size, all: facts.size }),
  };
}
