#include "x3d/x3d_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "x3d/x3d_background.h"
#include "x3d/x3d_humanoid.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

Eigen::Vector3d in_x3d(const X3dSubject& subject, const Eigen::Vector3f& world) {
  return (subject.camera.axes.transpose() * world).cast<double>();
}

Eigen::Vector3d colour_of(const Rgb& light) {
  return light.matrix().cast<double>();
}

/// A colour whose largest part is 1, and what it is multiplied with.
std::string colour_and(const char* strength, const Rgb& light, double scale) {
  const float most = std::max(light.maxCoeff(), 1e-30F);
  return fmt::format("color=\"{}\" {}=\"{}\"", field_text(colour_of(light / most)), strength,
                     field_text(static_cast<double>(most) * scale));
}

std::string glsl(const Eigen::Vector3d& v) {
  return fmt::format("{:.8e}, {:.8e}, {:.8e}", v.x(), v.y(), v.z());
}

/// Suns and lamps beside the one that has shadow maps, as constants of the shader.
std::string other_lights(const X3dPage& page) {
  const X3dSubject& subject = page.subject;
  std::string from, strength;
  int count = 0;
  const auto add = [&](const Eigen::Vector3d& where, int is_place, const Rgb& light) {
    const char* comma = count++ > 0 ? ", " : "";
    from += fmt::format("{}vec4({}, {}.0)", comma, glsl(where), is_place);
    strength += fmt::format("{}vec3({})", comma, glsl(colour_of(light)));
  };
  const Sun* mapped = brightest_sun(subject.light);
  for (const Sun& sun : subject.light.suns)
    if (&sun != mapped) add(in_x3d(subject, sun.to_sun), 0, sun.irradiance_w_m2);
  for (const Lamp& lamp : subject.light.lamps) add(in_x3d(subject, lamp.position_m), 1, lamp.intensity_w_sr);
  const int lights = count;
  if (count == 0) add(Eigen::Vector3d::UnitY(), 0, Rgb::Zero());  // an array has one element at least
  return fmt::format(
      "const int other_lights = {0};\nconst vec4 other_from[{1}] = vec4[]({2});  // towards it, 0; or its "
      "place, 1\nconst vec3 other_strength[{1}] = vec3[]({3});  // W/m2, or W/sr\n\n",
      lights, count, from, strength);
}

std::string object_shader(const X3dPage& page, const SurfaceMesh& mesh, const std::filesystem::path& folder) {
  std::string text =
      "<multiTexture class=\"by-shader\"><imageTexture use=\"object_map\"></imageTexture><imageTexture "
      "use=\"real_map\"></imageTexture></multiTexture>\n<composedShader class=\"by-shader\">\n";
  text += shader_field("object_map", "SFInt32", "0") + shader_field("real_map", "SFInt32", "1");
  text += light_fields(page);
  text += shader_field("albedo", "SFVec3f", field_text(colour_of(mesh.albedo)));
  text += shader_field("exposure", "SFFloat", field_text(std::exp2(page.subject.exposure_ev)));
  text += shader_field("marked", "SFFloat", "0");
  return text + shader_parts(folder, "object", other_lights(page)) + "</composedShader>";
}

std::string object_appearance(const X3dPage& page, std::size_t number, const std::filesystem::path& folder) {
  const SurfaceMesh& mesh = *page.subject.objects[number];
  return fmt::format(
      "<appearance><material class=\"object\" diffuseColor=\"{0}\" emissiveColor=\"0 0 0\" "
      "specularColor=\"0 0 0\" shininess=\"0\" ambientIntensity=\"1\"></material>{1}</appearance>",
      field_text(colour_of(mesh.albedo)), object_shader(page, mesh, folder));
}

std::string object_shape(const X3dPage& page, std::size_t number, const std::filesystem::path& folder) {
  const SurfaceMesh& mesh = *page.subject.objects[number];
  const Eigen::Matrix3f x3d_from_world = page.subject.camera.axes.transpose();
  std::vector<Eigen::Vector3f> positions_m, normals, colours;
  for (const Eigen::Vector3f& place_m : mesh.positions_m) positions_m.push_back(x3d_from_world * place_m);
  for (const Eigen::Vector3f& normal : mesh.normals) normals.push_back(x3d_from_world * normal);
  for (const float open : page.openness[number]) colours.emplace_back(open * mesh.albedo.matrix());
  return "<shape>" + object_appearance(page, number, folder) +
         triangle_set(positions_m, {.normals = normals, .colours = colours}, mesh.triangles) + "</shape>\n";
}

}  // namespace

std::string x3d_lights(const X3dPage& page) {
  const X3dSubject& subject = page.subject;
  const double shown = std::exp2(subject.exposure_ev), lambert = 1 / std::numbers::pi;
  std::string text = fmt::format(
      "<directionalLight class=\"light\" global=\"true\" direction=\"0 0 -1\" intensity=\"0\" {}>"
      "</directionalLight>\n",
      colour_and("ambientIntensity", sky_of(page).cast<float>().array(), lambert * shown));
  for (const Sun& sun : subject.light.suns)
    text += fmt::format(
        "<directionalLight class=\"light\" global=\"true\" direction=\"{}\" {}></directionalLight>\n",
        field_text(Eigen::Vector3d(-in_x3d(subject, sun.to_sun))),
        colour_and("intensity", sun.irradiance_w_m2, lambert * shown));
  for (const Lamp& lamp : subject.light.lamps)
    text += fmt::format(
        "<pointLight class=\"light\" global=\"true\" location=\"{}\" attenuation=\"0 0 1\" radius=\"1000\" "
        "{}></pointLight>\n",
        field_text(in_x3d(subject, lamp.position_m)),
        colour_and("intensity", lamp.intensity_w_sr, lambert * shown));
  return text;
}

std::string x3d_objects(const X3dPage& page, const std::filesystem::path& folder) {
  std::string text = "<transform id=\"object\" translation=\"0 0 0\">\n";
  if (page.subject.figure)
    text += x3d_humanoid(page, [&](std::size_t i) { return object_appearance(page, i, folder); });
  else
    for (std::size_t i = 0; i < page.subject.objects.size(); ++i) text += object_shape(page, i, folder);
  return text + "</transform>\n";
}

}  // namespace seamline::renderer
