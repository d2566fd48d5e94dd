// The photograph alone, behind everything, for browsers without WebGL 2.
attribute vec3 position;
uniform mat4 modelViewProjectionMatrix;
varying vec2 place;
void main() {
  place = vec2(0.5 * position.x + 0.5, 0.5 - 0.5 * position.y);
  gl_Position = vec4(position.xy, 0.999999, 1.0);
}
