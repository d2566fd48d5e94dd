// A headset that the browser knows (WebXR, immersive-vr): the panorama all round, the same for both eyes or one for each, a cross
// where the head points, and a board with question and answers below it. What is chosen is what the cross is on when the
// controller's trigger is pulled. Where two eyes have panoramas of their own, the left eye alone sees the cross: at any one
// distance both would see it double (a one-eyed cursor: Teather and Stuerzlinger 2013).
import { axesOf } from "./core/looking.js";

const DEGREE = Math.PI / 180;
const BOARD_PX = { width: 1024, height: 384 };
const BOARD = { distance: 2, pitch_deg: -27, width: 1.7, height: (1.7 * BOARD_PX.height) / BOARD_PX.width };

const VERTEX = `#version 300 es
uniform mat4 projection;
uniform mat3 view_from_world;
uniform vec3 middle, right, up;
out vec2 at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  at = vec2(corner.x, 1.0 - corner.y);
  vec2 s = corner * 2.0 - 1.0;
  gl_Position = projection * vec4(view_from_world * (middle + s.x * right + s.y * up), 1);
}`;
const FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D board;
in vec2 at;
out vec4 colour;
void main() { colour = texture(board, at); }`;

export const headsetIsThere = async () => (await navigator.xr?.isSessionSupported("immersive-vr").catch(() => false)) ?? false;

/** The axes right, up, back of a rotation, turned to the right by degrees about the vertical. */
function axesOfQuaternion({ x, y, z, w }, right_deg) {
  const columns = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
  const [sine, cosine] = [Math.sin(right_deg * DEGREE), Math.cos(right_deg * DEGREE)];
  return columns.flatMap(([a, b, c]) => [a * cosine - c * sine, b, a * sine + c * cosine]);
}

/** A vector, turned likewise. */
function turnedVector({ x, y, z }, right_deg) {
  const [sine, cosine] = [Math.sin(right_deg * DEGREE), Math.cos(right_deg * DEGREE)];
  return [x * cosine - z * sine, y, x * sine + z * cosine];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Which of so many panoramas each view is shown, by its place from the left to the right. */
export function panoramasOf(offsets, panoramas) {
  const order = offsets.map((offset, at) => at).sort((a, b) => offsets[a] - offsets[b]);
  const last = Math.max(1, offsets.length - 1);
  return offsets.map((offset, at) => Math.round((order.indexOf(at) * (panoramas - 1)) / last));
}

const poseOf = (axes) => ({
  yaw_deg: Math.atan2(-axes[6], axes[8]) / DEGREE,
  pitch_deg: Math.asin(Math.max(-1, Math.min(1, -axes[7]))) / DEGREE,
});

const transposed = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

/** Lines of a text within a width. */
function broken(paint, text, width) {
  const lines = [""];
  for (const word of text.split(" ")) {
    const longer = (lines.at(-1) + " " + word).trim();
    if (paint.measureText(longer).width > width && lines.at(-1) !== "") lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines;
}

/** Boxes of the answers on the board, in its pixels. */
const boxesOf = (answers) =>
  answers.map((text, at) => ({ text, x: 16 + (at * (BOARD_PX.width - 16)) / answers.length, y: 200, width: (BOARD_PX.width - 16) / answers.length - 16, height: 150 }));

/** Puts somebody into the panorama that `view` holds. Must be called by a click; rejects where there is no headset. */
export async function enterHeadset(view, ended) {
  const { gl } = view;
  const session = await navigator.xr.requestSession("immersive-vr");
  await gl.makeXRCompatible();
  gl.canvas.remove(); // from a page of feedback, with its layout
  gl.canvas.removeAttribute("style");
  gl.canvas.className = "";
  const layer = new XRWebGLLayer(session, gl, { antialias: false });
  session.updateRenderState({ baseLayer: layer });
  const space = await session.requestReferenceSpace("local");
  const program = view.programOf(VERTEX, FRAGMENT);
  const at = (name) => gl.getUniformLocation(program, name);
  const paint = document.createElement("canvas").getContext("2d");
  Object.assign(paint.canvas, BOARD_PX);
  const textures = { board: gl.createTexture(), mark: gl.createTexture() };
  const fill = (texture, source) => {
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, source);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.LINEAR);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    gl.activeTexture(gl.TEXTURE0);
  };
  const mark = document.createElement("canvas").getContext("2d");
  [mark.canvas.width, mark.canvas.height] = [32, 32];
  for (const [style, edge] of [["black", 2], ["white", 0]]) {
    mark.fillStyle = style;
    mark.fillRect(2, 14 - edge, 28, 4 + 2 * edge);
    mark.fillRect(14 - edge, 2, 4 + 2 * edge, 28);
  }
  fill(textures.mark, mark.canvas);

  let right_deg = 0; // by which the headset's own space is turned
  let axes = axesOf({ yaw_deg: 0, pitch_deg: 0 });
  let reader = null;
  let start = null; // the yaw that is to be in front
  let board = { yaw_deg: 0, drawn: "", asked: "", boxes: [] };
  const head = {
    /** What is seen: {panorama, words: null | {question, hint, answers}}. */
    scene: { panorama: false, words: null },
    once: null,
    moved: null,
    selected: null,
    pose: () => poseOf(axes),
    /** The yaw that the head's next pose stands for. */
    begin(yaw_deg) {
      start = yaw_deg;
    },
    /** The answer on the board that the cross is on, from 1; 0: none. */
    answer() {
      const place = onBoard();
      if (!place) return 0;
      return board.boxes.findIndex((box) => place.x >= box.x && place.x < box.x + box.width && place.y >= box.y && place.y < box.y + box.height) + 1;
    },
    boardYaw: () => board.yaw_deg,
    /** For tests: what each eye is shown in the next frame without board and cross, and how it looks. */
    read: () => new Promise((resolve) => (reader = resolve)),
    end: () => session.end().catch(() => {}),
    /** Resolves when it is taken off. */
    over: new Promise((resolve) => session.addEventListener("end", () => setTimeout(resolve, 0))),
  };

  /** The board's middle, and its half axes. */
  function boardPlace() {
    const a = axesOf({ yaw_deg: board.yaw_deg, pitch_deg: BOARD.pitch_deg });
    return {
      middle: [6, 7, 8].map((i) => -BOARD.distance * a[i]),
      right: [0, 1, 2].map((i) => (BOARD.width / 2) * a[i]),
      up: [3, 4, 5].map((i) => (BOARD.height / 2) * a[i]),
    };
  }
  let sight = [0, 0, 0]; // the place of the eye that sees the cross
  function onBoard() {
    if (!head.scene.words) return null;
    const { middle, right, up } = boardPlace();
    const ahead = [-axes[6], -axes[7], -axes[8]];
    const along = dot(ahead, middle);
    if (along <= 0) return null;
    const far = (BOARD.distance * BOARD.distance - dot(sight, middle)) / along;
    const hit = ahead.map((value, i) => sight[i] + value * far - middle[i]);
    const [s, t] = [dot(hit, right) / dot(right, right), dot(hit, up) / dot(up, up)];
    if (Math.abs(s) > 1 || Math.abs(t) > 1) return null;
    return { x: ((s + 1) / 2) * BOARD_PX.width, y: ((1 - t) / 2) * BOARD_PX.height };
  }
  function writeBoard() {
    const { question, hint, answers } = head.scene.words;
    // Each question comes in front of the head, wherever it has turned.
    if (board.asked !== question) board.yaw_deg = head.pose().yaw_deg;
    board.asked = question;
    const looked = head.answer();
    const wanted = JSON.stringify([question, hint, answers, looked]);
    if (board.drawn === wanted) return;
    board.drawn = wanted;
    board.boxes = boxesOf(answers);
    paint.fillStyle = "rgb(238 238 238)";
    paint.fillRect(0, 0, BOARD_PX.width, BOARD_PX.height);
    paint.fillStyle = "rgb(28 28 28)";
    paint.textAlign = "center";
    const write = (text, size, middle, top, width) => {
      paint.font = size + "px system-ui, sans-serif";
      broken(paint, text, width).forEach((line, i) => paint.fillText(line, middle, top + i * size * 1.25));
    };
    write(question, 44, BOARD_PX.width / 2, 64, BOARD_PX.width - 40);
    write(hint, 30, BOARD_PX.width / 2, answers.length > 0 ? 170 : 220, BOARD_PX.width - 40);
    board.boxes.forEach((box, i) => {
      paint.fillStyle = i + 1 === looked ? "rgb(190 190 190)" : "rgb(252 252 252)";
      paint.fillRect(box.x, box.y, box.width, box.height);
      paint.strokeStyle = "rgb(104 104 104)";
      paint.strokeRect(box.x, box.y, box.width, box.height);
      paint.fillStyle = "rgb(28 28 28)";
      write(box.text, 30, box.x + box.width / 2, box.y + 60, box.width - 16);
    });
    fill(textures.board, paint.canvas);
  }

  /** `place`: of the eye beside the head; the panoramas of one place are infinitely far, and so is what stands before them. */
  function drawQuad(texture, eye, { axes: eyeAxes, place }, { middle, right, up }) {
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.uniform1i(at("board"), 1);
    gl.uniformMatrix4fv(at("projection"), false, eye.projectionMatrix);
    gl.uniformMatrix3fv(at("view_from_world"), false, transposed(eyeAxes));
    gl.uniform3fv(at("middle"), middle.map((value, i) => value - place[i]));
    gl.uniform3fv(at("right"), right);
    gl.uniform3fv(at("up"), up);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.disable(gl.BLEND);
  }

  function drawEyes(pose) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
    gl.clearColor(128 / 255, 128 / 255, 128 / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    if (head.scene.words) writeBoard();
    else board.asked = "";
    const eyes = [];
    const [r, u, b] = [0, 3, 6].map((i) => axes.slice(i, i + 3));
    const from = pose.transform.position;
    const places = pose.views.map(({ transform: { position } }) => turnedVector({ x: position.x - from.x, y: position.y - from.y, z: position.z - from.z }, right_deg));
    sight = view.eyes() === 2 && places.length === 2 ? places.reduce((left, place) => (dot(place, r) < dot(left, r) ? place : left)) : [0, 0, 0];
    const panoramas = panoramasOf(places.map((place) => dot(place, r)), view.eyes());
    pose.views.forEach((eye, i) => {
      const place = layer.getViewport(eye);
      const p = eye.projectionMatrix;
      const seen = { axes: axesOfQuaternion(eye.transform.orientation, right_deg), place: view.eyes() > 1 ? places[i] : [0, 0, 0] };
      if (head.scene.panorama) view.paint(place, seen.axes, [1 / p[0], 1 / p[5]], [p[8] / p[0], p[9] / p[5]], panoramas[i]);
      if (reader) eyes.push({ ...readEye(place, p, seen.axes), panorama: panoramas[i] });
      gl.viewport(place.x, place.y, place.width, place.height);
      if (head.scene.words) drawQuad(textures.board, eye, seen, boardPlace());
      const seesNoCross = view.eyes() === 2 && pose.views.length === 2 && panoramas[i] > 0;
      if (!seesNoCross) drawQuad(textures.mark, eye, { axes: seen.axes, place: [0, 0, 0] }, { middle: b.map((v) => -2 * v), right: r.map((v) => 0.025 * v), up: u.map((v) => 0.025 * v) });
    });
    if (reader && head.scene.panorama) {
      reader(eyes);
      reader = null;
    }
  }

  function readEye({ x, y, width, height }, p, eyeAxes) {
    const bytes = new Uint8Array(4 * width * height);
    gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let text = "";
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return { codes: btoa(text), width, height, half: [1 / p[0], 1 / p[5]], middle: [p[8] / p[0], p[9] / p[5]], pose: poseOf(eyeAxes) };
  }

  function onFrame(now, frame) {
    session.requestAnimationFrame(onFrame);
    const pose = frame.getViewerPose(space);
    if (!pose) return;
    if (start !== null) {
      right_deg = start - poseOf(axesOfQuaternion(pose.transform.orientation, 0)).yaw_deg;
      start = null;
    }
    axes = axesOfQuaternion(pose.transform.orientation, right_deg);
    head.moved?.(now);
    const due = head.once;
    head.once = null;
    due?.(now);
    drawEyes(pose);
  }
  session.addEventListener("select", (event) => head.selected?.(event));
  session.addEventListener("end", () => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    ended();
  });
  session.requestAnimationFrame(onFrame);
  return head;
}

