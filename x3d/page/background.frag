uniform sampler2D depth;        // planar metres of the photograph's pixels, 24 bits; 0: a hole
uniform sampler2D colour;       // the photograph
uniform sampler2D user_mask;    // white: the recorded user
uniform vec2 planes_m;          // near, far
uniform float depth_range_m;    // what the largest code is worth
uniform vec2 tangents;          // of half the angles of view, across and up
uniform float occludes;         // 1: the depth is written; 0: the virtual is always in front
uniform float shows_user_only;  // 1: the real world is left out but for the user (5.1, "inversion")

in vec2 place;
out vec4 shown;

vec3 point_of(ivec2 at) {
  vec2 size = vec2(textureSize(depth, 0));
  vec2 window = 2.0 * (vec2(at) + 0.5) / size - 1.0;
  float z_m = read(depth, at, depth_range_m);
  return vec3(window.x * tangents.x * z_m, -window.y * tangents.y * z_m, -z_m);
}

/// From a point to its neighbour on one side or the other, whichever is on the same surface.
vec3 along(ivec2 at, ivec2 aside, vec3 point) {
  ivec2 last = textureSize(depth, 0) - 1;
  vec3 after = point_of(min(at + aside, last)) - point;
  vec3 before = point - point_of(max(at - aside, ivec2(0)));
  bool no_after = any(greaterThan(at + aside, last));
  bool no_before = any(lessThan(at - aside, ivec2(0)));
  return no_before || (!no_after && abs(after.z) < abs(before.z)) ? after : before;
}

void main() {
  ivec2 size = textureSize(depth, 0);
  ivec2 at = clamp(ivec2(floor(vec2(place.x, 1.0 - place.y) * vec2(size))), ivec2(0), size - 1);
  if (shows_user_only > 0.5 && texelFetch(user_mask, min(at, textureSize(user_mask, 0) - 1), 0).r < 0.5) discard;
  float z_m = read(depth, at, depth_range_m);
  vec3 light = texelFetch(colour, at, 0).rgb;
  if (shades > 0.5 && z_m > 0.0) {
    vec3 point = point_of(at);
    vec3 normal = normalize(cross(along(at, ivec2(1, 0), point), along(at, ivec2(0, -1), point)));
    if (dot(normal, point) > 0.0) normal = -normal;
    float cosine = max(-dot(normal, sun_forward), 0.0);
    float tangent = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 0.05);
    float real = arriving(real_map, real_corner_m, real_size_m, real_depth_m, point, tangent);
    float object = arriving(object_map, object_corner_m, object_size_m, object_depth_m, point - moved_m, tangent);
    vec3 before = sky_w_m2 + sun_w_m2 * cosine * real;
    vec3 after = sky_w_m2 + sun_w_m2 * cosine * real * object;
    if (object < 1.0) light = coded(linear(light) * after / max(before, vec3(1e-6)));
  }
  shown = vec4(light, 1.0);
  float window_depth = (1.0 / planes_m.x - 1.0 / max(z_m, 1e-6)) / (1.0 / planes_m.x - 1.0 / planes_m.y);
  gl_FragDepth = z_m > 0.0 && occludes > 0.5 ? clamp(window_depth, 0.0, 1.0) : 1.0;
}
