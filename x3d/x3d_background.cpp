#include "x3d/x3d_background.h"

#include <fmt/format.h>

#include <cmath>

#include "support/files/atomic_file.h"
#include "support/text/html.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

constexpr const char* whole_window =
    "<indexedTriangleSet solid=\"false\" index=\"0 1 2 0 2 3\"><coordinate point=\"-1 -1 0 1 -1 0 1 1 0 -1 1 "
    "0\"></coordinate></indexedTriangleSet></shape>\n";

/// What a sun sees, so that a shader can read it: depths from a little before the nearest on.
struct CodedMap {
  ByteImage picture;
  Eigen::Vector2d corner_m{-1, -1}, size_m{2, 2}, depth_m{0, 1};
};

CodedMap coded(const ShadowMap& map) {
  constexpr float before_m = 0.01F;  // code 0 is a hole
  const float first_m = std::isfinite(map.nearest_m) ? map.nearest_m - before_m : 0.0F;
  std::vector<float> beyond_m = map.depth.depth_m;
  for (float& depth_m : beyond_m) depth_m -= first_m;
  const double range_m = depth_range_m(beyond_m);
  return {.picture = depth_codes(beyond_m, map.depth.width_px, map.depth.height_px, range_m),
          .corner_m = map.view.corner.matrix().cast<double>(),
          .size_m = map.view.size.matrix().cast<double>(),
          .depth_m = {static_cast<double>(first_m), range_m}};
}

CodedMap no_map() {
  return {.picture = {.width_px = 1, .height_px = 1, .channels = 3, .values = {0, 0, 0}}};
}

std::string map_fields(const std::string& name, const CodedMap& map) {
  return shader_field((name + "_corner_m").c_str(), "SFVec2f", field_text(map.corner_m)) +
         shader_field((name + "_size_m").c_str(), "SFVec2f", field_text(map.size_m)) +
         shader_field((name + "_depth_m").c_str(), "SFVec2f", field_text(map.depth_m));
}

ByteImage mask_picture(const X3dPage& page) {
  if (page.user == nullptr) return {.width_px = 1, .height_px = 1, .channels = 3, .values = {0, 0, 0}};
  ByteImage mask{.width_px = page.photograph.width_px,
                 .height_px = page.photograph.height_px,
                 .channels = 3,
                 .values = {}};
  for (const std::uint8_t one : page.user->mask)
    mask.values.insert(mask.values.end(), 3, one != 0 ? std::uint8_t{255} : std::uint8_t{0});
  return mask;
}

/// Of the objects and of the real world.
std::pair<CodedMap, CodedMap> coded_maps(const X3dPage& page) {
  if (page.sun == nullptr) return {no_map(), no_map()};
  return {coded(page.sun->object), coded(page.sun->real)};
}

}  // namespace

std::string shader_parts(const std::filesystem::path& folder, const std::string& name,
                         const std::string& constants) {
  return "<shaderPart type=\"VERTEX\">" + element_text(read_file(folder / (name + ".vert"))) +
         "</shaderPart>\n<shaderPart type=\"FRAGMENT\">" +
         element_text(read_file(folder / "light.frag") + constants + read_file(folder / (name + ".frag"))) +
         "</shaderPart>";
}

std::string light_fields(const X3dPage& page) {
  std::string text = shader_field("shades", "SFFloat", page.sun != nullptr ? "1" : "0");
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (page.sun != nullptr) axes = page.sun->object.view.axes.cast<double>();
  text += shader_field("sun_right", "SFVec3f", field_text(Eigen::Vector3d(axes.row(0))));
  text += shader_field("sun_down", "SFVec3f", field_text(Eigen::Vector3d(axes.row(1))));
  text += shader_field("sun_forward", "SFVec3f", field_text(Eigen::Vector3d(axes.row(2))));
  const auto [object, real] = coded_maps(page);
  text += map_fields("object", object) + map_fields("real", real);
  text += shader_field("sun_w_m2", "SFVec3f",
                       field_text(page.sun != nullptr ? page.sun->sun_w_m2 : Eigen::Vector3d::Zero().eval()));
  text += shader_field("sky_w_m2", "SFVec3f", field_text(sky_of(page)));
  return text + shader_field("moved_m", "SFVec3f", "0 0 0");
}

std::string X3dTextures::texture(const ByteImage& picture, const std::string& name) {
  const std::filesystem::path file = folder_.path() / fmt::format("{}.png", ++number_);
  write_png(file, picture);
  return "<imageTexture" + (name.empty() ? name : " def=\"" + name + "\"") +
         " scale=\"false\" url=\"data:image/png;base64," + base64(read_file(file)) +
         "\"><textureProperties minificationFilter=\"NEAREST_PIXEL\" magnificationFilter=\"NEAREST_PIXEL\" "
         "boundaryModeS=\"CLAMP_TO_EDGE\" boundaryModeT=\"CLAMP_TO_EDGE\" "
         "generateMipMaps=\"false\"></textureProperties></imageTexture>\n";
}

Eigen::Vector2d tangents_of(const Camera& camera) {
  const double across = camera.tan_half_horizontal;
  return {across, across * camera.height_px / camera.width_px};
}

std::string depth_background(const X3dPage& page, X3dTextures& textures,
                             const std::filesystem::path& folder) {
  const auto& depth = page.frame.depth;
  const double range_m = depth_range_m(depth.depth_m);
  const auto [object, real] = coded_maps(page);
  std::string text =
      "<shape id=\"depth_background\" isPickable=\"false\"><appearance sortKey=\"-2\"><depthMode "
      "depthFunc=\"always\"></depthMode><multiTexture>\n";
  text +=
      textures.texture(depth_codes(depth.depth_m, depth.camera.width_px, depth.camera.height_px, range_m));
  text += textures.texture(page.photograph);
  text += textures.texture(object.picture, "object_map") + textures.texture(real.picture, "real_map");
  text += textures.texture(mask_picture(page));
  text += "</multiTexture><composedShader>\n";
  int unit = 0;
  for (const char* name : {"depth", "colour", "object_map", "real_map", "user_mask"})
    text += shader_field(name, "SFInt32", fmt::format("{}", unit++));
  text += shader_field("planes_m", "SFVec2f",
                       field_text(Eigen::Vector2d(page.frame.planes.near_m, page.frame.planes.far_m)));
  text += shader_field("depth_range_m", "SFFloat", field_text(range_m));
  text += shader_field("tangents", "SFVec2f", field_text(tangents_of(page.subject.camera)));
  text += shader_field("occludes", "SFFloat", "1") + shader_field("shows_user_only", "SFFloat", "0");
  text += light_fields(page);
  return text + shader_parts(folder, "background") + "</composedShader></appearance>" + whole_window;
}

std::string ghost_template(const X3dPage& page, X3dTextures& textures, const std::filesystem::path& folder) {
  std::string text =
      "<template id=\"ghost_template\"><shape isPickable=\"false\"><appearance sortKey=\"-3\"><depthMode "
      "readOnly=\"true\"></depthMode>\n" +
      textures.texture(page.photograph) + "<composedShader>" + shader_field("colour", "SFInt32", "0") +
      "<shaderPart type=\"VERTEX\">" + element_text(read_file(folder / "photograph.vert")) +
      "</shaderPart>\n<shaderPart type=\"FRAGMENT\">" + element_text(read_file(folder / "photograph.frag")) +
      "</shaderPart></composedShader></appearance>" + whole_window;
  if (!page.frame.ghosts.triangles.empty())
    text +=
        "<shape class=\"ghost\" isPickable=\"false\"><appearance sortKey=\"-2\"><material></material>"
        "<colorMaskMode maskR=\"false\" maskG=\"false\" maskB=\"false\" maskA=\"false\"></colorMaskMode>"
        "</appearance>" +
        triangle_set(page.frame.ghosts.vertices_m, {}, page.frame.ghosts.triangles) + "</shape>\n";
  return text + "</template>\n";
}

}  // namespace seamline::renderer
