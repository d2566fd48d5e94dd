// Where a trial's picture and its questions go (study/app/pictures/picture_place.h). Everything in pixels of the screen.

export const QUESTIONS_EM = 6;

/** {x, y, width, height, questions_y, fits} for a screen and a picture of {width, height}; em is the size of the type. */
export function placeTrial(screen, picture, em) {
  const strip = Math.ceil(QUESTIONS_EM * em);
  return {
    x: Math.floor((screen.width - picture.width) / 2),
    y: Math.floor(Math.max(0, screen.height - picture.height - strip) / 2),
    width: picture.width,
    height: picture.height,
    questions_y: Math.floor(Math.max(0, screen.height - picture.height - strip) / 2) + picture.height,
    needed: { width: picture.width, height: picture.height + strip },
    fits: screen.width >= picture.width && screen.height >= picture.height + strip,
  };
}

/** A map of a scene's objects, unpacked: {width_px, height_px, frames, nearest}. */
export function unpackMap(packed) {
  const nearest = new Uint8Array(packed.width_px * packed.height_px);
  let at = 0;
  for (let run = 0; run + 1 < packed.runs.length; run += 2) {
    nearest.fill(packed.runs[run + 1], at, at + packed.runs[run]);
    at += packed.runs[run];
  }
  return { width_px: packed.width_px, height_px: packed.height_px, frames: packed.frames, nearest };
}

/** The object at a place of the picture, from 1 on the left, or 0. */
export function objectAt(map, x_px, y_px) {
  if (x_px < 0 || y_px < 0 || x_px >= map.width_px || y_px >= map.height_px) return 0;
  return map.nearest[Math.floor(y_px) * map.width_px + Math.floor(x_px)];
}

/** The bars of the corners around a frame, [x, y, width, height] each, bolder where it is chosen: as the window draws them. */
export function bracketBars(frame, isChosen = false) {
  if (!(frame.width > 0)) return [];
  const arm = Math.round(Math.min(24, frame.width / 3, frame.height / 3));
  const across = isChosen ? 7 : 3;
  const right = frame.x + frame.width;
  const bottom = frame.y + frame.height;
  const corner = (x, y, toRight, toBottom) => [
    [toRight ? x : x - arm, toBottom ? y : y - across, arm, across],
    [toRight ? x : x - across, toBottom ? y : y - arm, across, arm],
  ];
  return [
    ...corner(frame.x, frame.y, true, true),
    ...corner(right, frame.y, false, true),
    ...corner(frame.x, bottom, true, false),
    ...corner(right, bottom, false, false),
  ];
}
