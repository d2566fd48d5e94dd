#version 300 es
#define varying in
precision highp float;
precision highp int;
precision highp sampler2D;

uniform sampler2D object_map;   // what the sun sees of the virtual object
uniform sampler2D real_map;     // what it sees of the real world, as far as the depth shows it
uniform float shades;           // 1: shadows fall, the object's on the real world and the real world's on it
uniform vec3 sun_right;         // axes of the sun's pictures, in the camera's frame
uniform vec3 sun_down;
uniform vec3 sun_forward;
uniform vec2 object_corner_m;   // the part of the sun's picture plane that a map covers
uniform vec2 object_size_m;
uniform vec2 object_depth_m;    // the depth of code 0, and what the largest code adds
uniform vec2 real_corner_m;
uniform vec2 real_size_m;
uniform vec2 real_depth_m;
uniform vec3 sun_w_m2;          // irradiance of a surface that faces the sun
uniform vec3 sky_w_m2;          // irradiance by everything else
uniform vec3 moved_m;           // how far the object was moved since its map was drawn

float read(sampler2D map, ivec2 at, float range) {
  vec3 code = floor(255.0 * texelFetch(map, at, 0).rgb + 0.5);
  return (65536.0 * code.r + 256.0 * code.g + code.b) / 16777215.0 * range;
}

/// The share of 3 x 3 texels past which the sun's light arrives.
float arriving(sampler2D map, vec2 corner_m, vec2 size_m, vec2 depth_m, vec3 point, float tangent) {
  ivec2 size = textureSize(map, 0);
  vec2 seen = (vec2(dot(sun_right, point), dot(sun_down, point)) - corner_m) / size_m * vec2(size);
  float own_m = dot(sun_forward, point);
  float bias_m = 1.5 * size_m.x / float(size.x) * (1.0 + min(tangent, 8.0));
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 texel = ivec2(floor(seen)) + ivec2(x, y);
      bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
      float found_m = inside ? read(map, texel, depth_m.y) : 0.0;
      lit += found_m > 0.0 && depth_m.x + found_m < own_m - bias_m ? 0.0 : 1.0;
    }
  return lit / 9.0;
}

vec3 linear(vec3 code) {
  return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), step(0.04045, code));
}

vec3 coded(vec3 light) {
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}

