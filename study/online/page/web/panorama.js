// A perspective view of a panorama, drawn by WebGL 2: one fragment shader, codes between the codes of four neighbours, and
// nothing else that changes them.
import { axesOf, directionAt, halfTangents, placeOf } from "./core/looking.js";

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;

// The window draws by the same (study/app/pictures/panorama_view.cpp), but for the rows, which are one eye's: the eyes' panoramas
// stand one above the other, the left eye's on top.
const FRAGMENT = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D panorama;
uniform mat3 axes;
uniform vec2 half_tangents, middle, corner_px, view_px;
uniform int first_row, rows;
out vec4 colour;
vec3 code(ivec2 at, ivec2 size) {
  return texelFetch(panorama, ivec2((at.x + size.x) % size.x, first_row + clamp(at.y, 0, size.y - 1)), 0).rgb;
}
void main() {
  vec3 d = axes * vec3(((gl_FragCoord.xy - corner_px) / view_px * 2.0 - 1.0) * half_tangents + middle, -1.0);
  ivec2 size = ivec2(textureSize(panorama, 0).x, rows);
  vec2 turns = vec2(atan(d.x, -d.z) * 0.15915494309189535 + 0.5, 0.5 - atan(d.y, length(d.xz)) * 0.3183098861837907);
  vec2 p = turns * vec2(size) - 0.5, f = fract(p);
  ivec2 at = ivec2(floor(p));
  vec3 upper = mix(code(at, size), code(at + ivec2(1, 0), size), f.x);
  vec3 lower = mix(code(at + ivec2(0, 1), size), code(at + ivec2(1, 1), size), f.x);
  colour = vec4(mix(upper, lower, f.y), 1);
}`;

// Panoramas of a scene share most of their codes: a file may hold what is added to those of another, modulo 256.
const SUM = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D base, difference;
out vec4 colour;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 sum = floor(255.0 * texelFetch(base, at, 0).rgb + 0.5) + floor(255.0 * texelFetch(difference, at, 0).rgb + 0.5);
  colour = vec4((sum - 256.0 * step(255.5, sum)) / 255.0, 1);
}`;

function programOf(gl, vertex = VERTEX, fragment = FRAGMENT) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error("WebGL 2: " + gl.getProgramInfoLog(program));
  return program;
}

/** The mean of four neighbours' codes at a place of an eye's panorama, as the shader makes it, in double precision. */
function codeAt(panorama, { x, y }, channel, eye) {
  const rows = panorama.width / 2;
  const left = Math.floor(x - 0.5);
  const top = Math.floor(y - 0.5);
  const [s, t] = [x - 0.5 - left, y - 0.5 - top];
  const code = (column, row) =>
    panorama.data[4 * ((eye * rows + Math.min(rows - 1, Math.max(0, row))) * panorama.width + ((column + panorama.width) % panorama.width)) + channel];
  return (1 - t) * ((1 - s) * code(left, top) + s * code(left + 1, top)) + t * ((1 - s) * code(left, top + 1) + s * code(left + 1, top + 1));
}

/**
 * A canvas that shows views of panoramas; `lost` is called when the browser takes its graphics away. Throws where there is no
 * WebGL 2.
 */
export function makeView(lost = () => {}) {
  const canvas = document.createElement("canvas");
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true });
  if (!gl) throw new Error("WebGL 2");
  canvas.addEventListener("webglcontextlost", lost);
  const program = programOf(gl);
  gl.disable(gl.DITHER);
  const at = (name) => gl.getUniformLocation(program, name);
  const uniforms = { axes: at("axes"), half: at("half_tangents"), middle: at("middle"), corner: at("corner_px"), view: at("view_px"), first: at("first_row"), rows: at("rows") };
  const makeTexture = () => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    return texture;
  };
  const shown = makeTexture();
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  let size = null; // of one eye's panorama, which is twice as wide as high
  let eyes = 1;
  const take = (width, height) => {
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (Math.max(width, height) > most) throw new Error("WebGL 2: pictures of " + Math.max(width, height) + " pixels, of which it can show " + most);
    eyes = Math.max(1, Math.round((2 * height) / width));
    size = { width, height: height / eyes };
  };
  const fill = (texture, image) => {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
  };
  let sum = null; // made when the first difference is shown
  /** Draws the sum of an image and its base into the texture that is shown; the base, which most images share, stays in memory. */
  function addUp(image, width, height) {
    sum ??= { program: programOf(gl, VERTEX, SUM), base: makeTexture(), difference: makeTexture(), target: gl.createFramebuffer(), holds: null };
    if (sum.holds !== image.base) fill(sum.base, image.base);
    sum.holds = image.base;
    fill(sum.difference, image);
    gl.bindTexture(gl.TEXTURE_2D, shown);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, sum.target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, shown, 0);
    gl.viewport(0, 0, width, height);
    gl.useProgram(sum.program);
    for (const [unit, name] of [[1, "base"], [2, "difference"]]) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, sum[name]);
      gl.uniform1i(gl.getUniformLocation(sum.program, name), unit);
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.activeTexture(gl.TEXTURE0);
    fill(sum.difference, new ImageData(1, 1));
    gl.bindTexture(gl.TEXTURE_2D, shown);
  }
  const view = {
    canvas,
    gl,
    programOf: (vertex, fragment) => programOf(gl, vertex, fragment),
    size: () => size,
    eyes: () => eyes,
    /** The panorama that is shown from now on: an image, or ImageData; with `base` what it differs by from that. */
    put(panorama) {
      const [width, height] = [panorama.naturalWidth ?? panorama.width, panorama.naturalHeight ?? panorama.height];
      take(width, height);
      if (panorama.base) addUp(panorama, width, height);
      else fill(shown, panorama);
    },
    draw(look, pose, eye = 0) {
      const [width, height] = look.view_px;
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      canvas.naturalWidth = width; // as an image says it
      canvas.naturalHeight = height;
      view.paint({ x: 0, y: 0, width, height }, axesOf(pose), halfTangents(look), [0, 0], eye);
    },
    /** Into a part of the framebuffer: `middle` are the tangents of the direction in its middle, `eye` counts from the left. */
    paint({ x, y, width, height }, axes, half, middle = [0, 0], eye = 0) {
      gl.viewport(x, y, width, height);
      gl.useProgram(program);
      gl.uniformMatrix3fv(uniforms.axes, false, axes);
      gl.uniform2fv(uniforms.half, half);
      gl.uniform2fv(uniforms.middle, middle);
      gl.uniform2f(uniforms.corner, x, y);
      gl.uniform2f(uniforms.view, width, height);
      gl.uniform1i(uniforms.first, eye * size.height);
      gl.uniform1i(uniforms.rows, size.height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    },
    /** The codes that stand in the canvas, RGBA, the lowest row first. */
    read() {
      const codes = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, codes);
      return codes;
    },
  };
  return view;
}

/**
 * Draws views of two eyes' small panoramas whose codes are known, whole and as the difference from others, and reads them back: how
 * far they are from double precision at most, in codes. The poses look all round, up and down, and across the seam.
 */
export function largestFault(view) {
  const panorama = new ImageData(64, 64);
  for (let i = 0; i < 64 * 64; ++i) panorama.data.set([(i * 37) & 255, 4 * (i % 64), 4 * Math.floor(i / 64), 255], 4 * i);
  const difference = new ImageData(64, 64);
  difference.base = new ImageData(64, 64);
  for (let i = 0; i < difference.data.length; ++i) {
    difference.base.data[i] = i % 4 === 3 ? 255 : (i * 101) & 255;
    difference.data[i] = i % 4 === 3 ? 255 : (panorama.data[i] - difference.base.data[i]) & 255;
  }
  const look = { view_px: [48, 27], horizontal_fov_deg: 60 };
  let worst = 0;
  for (const [put, eye] of [[panorama, 0], [panorama, 1], [difference, 0], [difference, 1]]) {
    view.put(put);
    for (const [yaw_deg, pitch_deg] of [[0, 0], [90, 20], [180, -35], [-135, 60], [17, 88], [-179.5, -85]]) {
      view.draw(look, { yaw_deg, pitch_deg }, eye);
      const codes = view.read();
      for (let y = 0; y < 27; ++y)
        for (let x = 0; x < 48; ++x) {
          const place = placeOf(view.size(), directionAt(look, { yaw_deg, pitch_deg }, x + 0.5, y + 0.5));
          for (let c = 0; c < 3; ++c)
            worst = Math.max(worst, Math.abs(codes[4 * ((26 - y) * 48 + x) + c] - codeAt(panorama, place, c, eye)));
        }
    }
  }
  return worst;
}

/** The greatest difference that is no fault: rounding, and what single precision makes of codes that differ by 200 between neighbours. */
export const MOST_FAULT = 1;
