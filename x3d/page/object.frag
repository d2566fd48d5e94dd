uniform vec3 albedo;
uniform float exposure;  // 2 to the stops
uniform float marked;

in vec3 point;
in vec3 facing;
in vec3 open_albedo;
out vec4 shown;

/// Irradiance by a light at `from` (w 1: a place; w 0: a direction towards it), as if nothing stood in its way.
vec3 unblocked(vec4 from, vec3 strength, vec3 normal) {
  vec3 way = from.xyz - from.w * point;
  float distance_m = length(way);
  return strength * max(dot(normal, way) / distance_m, 0.0) / (from.w > 0.5 ? distance_m * distance_m : 1.0);
}

void main() {
  vec3 normal = normalize(facing);
  if (dot(normal, point) > 0.0) normal = -normal;
  float cosine = max(-dot(normal, sun_forward), 0.0);
  float tangent = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 0.05);
  vec3 sun = sun_w_m2 * cosine;
  if (shades > 0.5 && cosine > 0.0)
    sun *= arriving(real_map, real_corner_m, real_size_m, real_depth_m, point, tangent) *
           arriving(object_map, object_corner_m, object_size_m, object_depth_m, point - moved_m, tangent);
  for (int i = 0; i < other_lights; ++i) sun += unblocked(other_from[i], other_strength[i], normal);
  vec3 light = exposure / 3.14159265 * (albedo * sun + open_albedo * sky_w_m2);
  shown = vec4(marked > 0.5 ? vec3(1.0, 0.0, 1.0) : coded(min(light, vec3(1.0))), 1.0);
}
