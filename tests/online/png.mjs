// An 8-bit PNG without interlacing, decoded: {width, height, channels, bytes}.
import { inflateSync } from "node:zlib";

const CHANNELS = { 0: 1, 2: 3, 4: 2, 6: 4 };

function paeth(a, b, c) {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

export function decodePng(file) {
  let header = null;
  const data = [];
  for (let at = 8; at < file.length; ) {
    const length = file.readUInt32BE(at);
    const kind = file.toString("latin1", at + 4, at + 8);
    const body = file.subarray(at + 8, at + 8 + length);
    if (kind === "IHDR") header = { width: body.readUInt32BE(0), height: body.readUInt32BE(4), depth: body[8], colour: body[9], interlaced: body[12] };
    if (kind === "IDAT") data.push(body);
    at += 12 + length;
  }
  if (header.depth !== 8 || header.interlaced !== 0) throw new Error("another kind of PNG");
  const { width, height } = header;
  const channels = CHANNELS[header.colour];
  const raw = inflateSync(Buffer.concat(data));
  const stride = width * channels;
  const bytes = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const left = x >= channels ? bytes[y * stride + x - channels] : 0;
      const up = y > 0 ? bytes[(y - 1) * stride + x] : 0;
      const corner = x >= channels && y > 0 ? bytes[(y - 1) * stride + x - channels] : 0;
      const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      bytes[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return { width, height, channels, bytes };
}

/** How many of a picture's pixels differ from those of a screenshot at a place. */
export function differences(picture, shot, left, top) {
  let count = 0;
  for (let y = 0; y < picture.height; ++y)
    for (let x = 0; x < picture.width; ++x) {
      const one = (y * picture.width + x) * picture.channels;
      const other = ((y + top) * shot.width + x + left) * shot.channels;
      let same = true;
      for (let c = 0; c < 3; ++c)
        same &&= picture.bytes[one + (picture.channels >= 3 ? c : 0)] === shot.bytes[other + c];
      if (!same) ++count;
    }
  return count;
}
