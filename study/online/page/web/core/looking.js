// Looking round a panorama (stimuli/definition/views/look_definition.h): poses, directions and places, without a screen.
//
// A pose is {yaw_deg, pitch_deg}: to the right of the panorama's middle column, up from the horizon. A direction is
// [x, y, z] with x to the right of the middle column, y up and z backwards. A look is {kind, view_px, horizontal_fov_deg,
// start_deg, yaw_deg, pitch_deg, and fov_limits_deg where keys change the field}.
const DEGREE = Math.PI / 180;

/** How a trial's picture is looked at; null: whole, as it is. */
export const lookOf = (study, stimulus_id) => study.looks?.[study.look_of[stimulus_id]] ?? null;

/**
 * Whither a phone's or tablet's back looks, by the angles of an event `deviceorientation` (Z-X'-Y'' of W3C's DeviceOrientation
 * Event): to the right of where they are zero, up from the horizon. However the screen is turned within itself says nothing to
 * a view that stays level. Null where the device does not say.
 */
export function deviceDirection({ alpha, beta, gamma }) {
  if (typeof alpha !== "number" || typeof beta !== "number" || typeof gamma !== "number") return null;
  const [a, b, c] = [alpha, beta, gamma].map((value) => value * DEGREE);
  const east = -(Math.cos(a) * Math.sin(c) + Math.sin(a) * Math.sin(b) * Math.cos(c));
  const north = -(Math.sin(a) * Math.sin(c) - Math.cos(a) * Math.sin(b) * Math.cos(c));
  const up = -Math.cos(b) * Math.cos(c);
  return { yaw_deg: Math.atan2(east, north) / DEGREE, pitch_deg: Math.atan2(up, Math.hypot(east, north)) / DEGREE };
}

/** Where a trial begins, beside the start by `start_spread_deg` at most; the same for the same words. */
export function startPose(look, words = "") {
  const start = { yaw_deg: look.start_deg[0], pitch_deg: look.start_deg[1] };
  if (!look.start_spread_deg) return start;
  let bits = 2166136261;
  for (const letter of words) bits = Math.imul(bits ^ letter.codePointAt(0), 16777619);
  bits = Math.imul(bits ^ (bits >>> 16), 2246822507); // spread over all bits
  bits = Math.imul(bits ^ (bits >>> 13), 3266489909);
  return turned(look, start, (((bits ^ (bits >>> 16)) >>> 0) / 2 ** 31 - 1) * look.start_spread_deg, 0);
}

/** Tangents of half the view's angles. */
export function halfTangents(look) {
  const across = Math.tan((look.horizontal_fov_deg / 2) * DEGREE);
  return [across, (across * look.view_px[1]) / look.view_px[0]];
}

/** The axes of a view at a pose, one after another: right, up, back. */
export function axesOf({ yaw_deg, pitch_deg }) {
  const [sa, ca] = [Math.sin(yaw_deg * DEGREE), Math.cos(yaw_deg * DEGREE)];
  const [sp, cp] = [Math.sin(pitch_deg * DEGREE), Math.cos(pitch_deg * DEGREE)];
  return [ca, 0, sa, -sp * sa, cp, sp * ca, -cp * sa, -sp, cp * ca];
}

/** The direction that a place of the view shows, x and y in its pixels from the upper left corner. */
export function directionAt(look, pose, x_px, y_px) {
  const [across, down] = halfTangents(look);
  const x = ((2 * x_px) / look.view_px[0] - 1) * across;
  const y = (1 - (2 * y_px) / look.view_px[1]) * down;
  const a = axesOf(pose);
  return [0, 1, 2].map((i) => x * a[i] + y * a[3 + i] - a[6 + i]);
}

/** Where a panorama of {width, height} shows a direction, in its pixels from the upper left corner. */
export function placeOf(size, [x, y, z]) {
  const column = (Math.atan2(x, -z) / (2 * Math.PI) + 0.5) * size.width;
  return { x: column >= size.width ? column - size.width : column, y: (0.5 - Math.atan2(y, Math.hypot(x, z)) / Math.PI) * size.height };
}

/** The direction of a place of a panorama, whose columns go round. */
export function directionOf(size, x_px, y_px) {
  const azimuth = (x_px / size.width - 0.5) * 2 * Math.PI;
  const elevation = (0.5 - y_px / size.height) * Math.PI;
  return [Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), -Math.cos(azimuth) * Math.cos(elevation)];
}

/** The pose whose middle is a place of a panorama. */
export const poseTowards = (size, x_px, y_px) => ({
  yaw_deg: ((x_px / size.width - 0.5) * 360 + 540) % 360 - 180,
  pitch_deg: (0.5 - y_px / size.height) * 180,
});

/** Where the view shows a direction, in its pixels; null behind it. */
export function placeInView(look, pose, direction) {
  const a = axesOf(pose);
  const [x, y, z] = [0, 3, 6].map((i) => direction[0] * a[i] + direction[1] * a[i + 1] + direction[2] * a[i + 2]);
  if (z > -1e-3) return null;
  const [across, down] = halfTangents(look);
  return { x: ((x / -z / across + 1) * look.view_px[0]) / 2, y: ((1 - y / -z / down) * look.view_px[1]) / 2 };
}

/** The frame in the view around a frame of the panorama; null where less than half of its outline is in sight. */
export function frameInView(look, pose, size, frame) {
  const places = [];
  const steps = 8;
  for (let i = 0; i <= steps; ++i)
    for (const [s, t] of [[i / steps, 0], [i / steps, 1], [0, i / steps], [1, i / steps]])
      places.push(placeInView(look, pose, directionOf(size, frame.x_px + s * frame.width_px, frame.y_px + t * frame.height_px)));
  const [width, height] = look.view_px;
  const seen = places.filter((p) => p && p.x > -width / 2 && p.y > -height / 2 && p.x < 1.5 * width && p.y < 1.5 * height);
  if (2 * seen.length < places.length) return null;
  const between = (values, most) => [Math.min(...values), Math.max(...values)].map((v) => Math.round(Math.min(most, Math.max(0, v))));
  const [left, right] = between(seen.map((p) => p.x), width);
  const [top, bottom] = between(seen.map((p) => p.y), height);
  return right > left && bottom > top ? { x_px: left, y_px: top, width_px: right - left, height_px: bottom - top } : null;
}

/** A pose turned by so many degrees, within the look's limits. */
export function turned(look, pose, right_deg, up_deg) {
  if (look.kind !== "mouse") return pose;
  const within = (value, [least, most]) => Math.min(most, Math.max(least, value));
  const round = look.yaw_deg[1] - look.yaw_deg[0] >= 360;
  const yaw = pose.yaw_deg + right_deg;
  return {
    yaw_deg: round ? yaw - 360 * Math.floor((yaw + 180) / 360) : within(yaw, look.yaw_deg),
    pitch_deg: within(pose.pitch_deg + up_deg, look.pitch_deg),
  };
}

/** The look after so many steps nearer, of 5 degrees each, within its limits; itself where it has none. */
export function zoomed(look, steps_nearer) {
  if (look.kind !== "mouse" || !look.fov_limits_deg) return look;
  const [least, most] = look.fov_limits_deg;
  return { ...look, horizontal_fov_deg: Math.min(most, Math.max(least, look.horizontal_fov_deg - 5 * steps_nearer)) };
}

/** Degrees that one pixel of the view's middle spans. */
export const degreesPerPixel = (look) => (2 * halfTangents(look)[0]) / look.view_px[0] / DEGREE;

const MOST_DETAIL = 3900; // of an event's 4000 bytes

/**
 * The poses of a trial as the details of events: "MS YAW PITCH;...", at most 30 a second and only what changed; "MS YAW PITCH FIELD"
 * of poses that have a field of view.
 */
export function makePoses() {
  let texts = [];
  let last = null;
  let waiting = null;
  const write = (ms, pose) => {
    const text = [pose.yaw_deg, pose.pitch_deg, pose.fov_deg].filter((value) => value !== undefined).map((value) => value.toFixed(1)).join(" ");
    waiting = null;
    if (last?.text === text) return;
    last = { ms, text };
    const entry = Math.round(ms) + " " + text;
    if (texts.length === 0 || texts.at(-1).length + entry.length + 1 > MOST_DETAIL) texts.push(entry);
    else texts[texts.length - 1] += ";" + entry;
  };
  return {
    /** The pose `ms` after the picture's onset. */
    add(ms, pose) {
      if (waiting && ms - last.ms >= 1000 / 30) write(Math.max(waiting.ms, last.ms + 1000 / 30), waiting.pose);
      if (!last || ms - last.ms >= 1000 / 30) write(ms, pose);
      else waiting = { ms, pose };
    },
    /** All there are; empty again. */
    take() {
      if (waiting) write(Math.max(waiting.ms, last.ms + 1000 / 30), waiting.pose);
      const taken = texts;
      texts = [];
      last = null;
      return taken;
    },
  };
}
