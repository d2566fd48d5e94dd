#version 300 es
// The photograph fills the window. X3DOM adds lines of GLSL ES 1.00 to every shader; these two words let them pass.
#define attribute in
#define varying out
uniform mat4 modelViewProjectionMatrix;
in vec3 position;
out vec2 place;

void main() {
  place = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
