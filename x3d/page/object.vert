#version 300 es
#define attribute in
#define varying out
uniform mat4 modelViewProjectionMatrix;
uniform mat4 modelViewMatrix;  // the camera stands in the origin: from the object's own place to where it was moved
in vec3 position;
in vec3 normal;
in vec3 color;
out vec3 point;
out vec3 facing;
out vec3 open_albedo;  // albedo times the share of the sky that is seen from here

void main() {
  point = (modelViewMatrix * vec4(position, 1.0)).xyz;
  facing = normal;
  open_albedo = color;
  gl_Position = modelViewProjectionMatrix * vec4(position, 1.0);
}
