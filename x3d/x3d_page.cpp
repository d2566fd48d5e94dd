#include "x3d/x3d_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "support/text/html.h"
#include "x3d/x3d_background.h"
#include "x3d/x3d_humanoid.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

Eigen::Vector3d x3d_from(const X3dSubject& subject, const Eigen::Vector3f& world) {
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
    if (&sun != mapped) add(x3d_from(subject, sun.to_sun), 0, sun.irradiance_w_m2);
  for (const Lamp& lamp : subject.light.lamps)
    add(x3d_from(subject, lamp.position_m), 1, lamp.intensity_w_sr);
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

/// Lights of X3D's own: suns, lamps, and the sky as what comes from everywhere. Where a shader draws the
/// objects they are read by other systems alone.
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
        field_text(Eigen::Vector3d(-x3d_from(subject, sun.to_sun))),
        colour_and("intensity", sun.irradiance_w_m2, lambert * shown));
  for (const Lamp& lamp : subject.light.lamps)
    text += fmt::format(
        "<pointLight class=\"light\" global=\"true\" location=\"{}\" attenuation=\"0 0 1\" radius=\"1000\" "
        "{}></pointLight>\n",
        field_text(x3d_from(subject, lamp.position_m)),
        colour_and("intensity", lamp.intensity_w_sr, lambert * shown));
  return text;
}

/// The virtual objects: diffuse, in the mean colour of each mesh, and less of the sky where they hide it
/// themselves (`openness`). With WebGL 2 a shader lights them, which knows both shadows (001, section 5.3)
/// and reads the maps of `depth_background`; without it X3DOM does, without shadows. `folder`: where the
/// shaders are.
std::string x3d_objects(const X3dPage& page, const std::filesystem::path& folder) {
  std::string text = "<transform id=\"object\" translation=\"0 0 0\">\n";
  if (page.subject.figure)
    text += x3d_humanoid(page, [&](std::size_t i) { return object_appearance(page, i, folder); });
  else
    for (std::size_t i = 0; i < page.subject.objects.size(); ++i) text += object_shape(page, i, folder);
  return text + "</transform>\n";
}

/// Nothing from outside. X3DOM reads textures that are data by requests of its own, and shows them by blobs.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src data:; "
    "base-uri 'none'; form-action 'none'";

/// What the user is put into when the real world is left out (001, section 5.1): a ground below their lowest
/// joint, under a sky.
std::string virtual_scene(const X3dPage& page) {
  if (page.user == nullptr) return {};
  const Eigen::Vector3d up = x3d_from(page.subject, Eigen::Vector3f::UnitY()),
                        right = x3d_from(page.subject, Eigen::Vector3f::UnitX()),
                        back = x3d_from(page.subject, Eigen::Vector3f::UnitZ());
  Eigen::Vector3d lowest_m = *page.user->joints_m.front();
  for (const auto& place_m : page.user->joints_m)
    if (place_m && place_m->dot(up) < lowest_m.dot(up)) lowest_m = *place_m;
  const Eigen::Vector3d middle_m = lowest_m - 0.06 * up;
  std::string points;
  for (const auto& [x, z] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}})
    points += field_text(Eigen::Vector3d(middle_m + 20.0 * (x * right + z * back))) + " ";
  return "<switch id=\"virtual_scene\" whichChoice=\"-1\"><group><shape><appearance><material "
         "diffuseColor=\"0.1 0.22 0.08\" emissiveColor=\"0.03 0.08 0.02\"></material></appearance>"
         "<indexedTriangleSet solid=\"false\" normalPerVertex=\"false\" index=\"0 1 2 0 2 3\"><coordinate "
         "point=\"" +
         points + "\"></coordinate></indexedTriangleSet></shape></group></switch>\n";
}

std::string scene(const X3dPage& page, X3dTextures& textures, const std::filesystem::path& folder) {
  const X3dSubject& subject = page.subject;
  const Eigen::Vector2d tangents = tangents_of(subject.camera);
  std::string text = fmt::format(
      "<x3d width=\"{0}px\" height=\"{1}px\" showStat=\"false\" showLog=\"false\" showProgress=\"false\" "
      "disableDoubleClick=\"true\" keysEnabled=\"false\"><scene id=\"scene\">\n"
      "<environment frustumCulling=\"false\" gammaCorrectionDefault=\"linear\"></environment>\n"
      "<navigationInfo type='\"NONE\"' headlight=\"false\"></navigationInfo>\n"
      "<background skyColor=\"0.45 0.62 0.85\"></background>\n"
      "<viewpoint position=\"0 0 0\" orientation=\"0 0 1 0\" fieldOfView=\"{2}\" zNear=\"{3}\" zFar=\"{4}\">"
      "</viewpoint>\n",
      subject.camera.width_px, subject.camera.height_px, field_text(2 * std::atan(tangents.minCoeff())),
      field_text(page.frame.planes.near_m), field_text(page.frame.planes.far_m));
  text += depth_background(page, textures, folder) + x3d_lights(page) + virtual_scene(page);
  return text + x3d_objects(page, folder) +
         sensor_prototypes({.depth = page.frame.depth,
                            .colour = page.photograph,
                            .label = subject.title,
                            .user = page.user}) +
         "</scene></x3d>\n";
}

std::string controls(const X3dPage& page) {
  std::string text =
      "<fieldset><label><input type=\"checkbox\" id=\"occlusion\" checked> the real hides the "
      "virtual</label>\n";
  if (page.sun != nullptr)
    text += "<label class=\"needs-depth\"><input type=\"checkbox\" id=\"shadow\" checked> shadows</label>\n";
  if (page.user != nullptr)
    text +=
        "<label class=\"needs-depth\"><input type=\"checkbox\" id=\"user_only\"> only the user, in a virtual "
        "scene</label>\n";
  if (page.subject.figure) text += humanoid_control(page.subject);
  text +=
      "<label><input type=\"checkbox\" id=\"shown\" checked> object</label>\n<label><input type=\"checkbox\" "
      "id=\"marked\"> mark it</label>\n<span>object:";
  for (const auto& [words, axis, sign] : {std::tuple{"left", 0, -1},
                                          {"right", 0, 1},
                                          {"up", 1, 1},
                                          {"down", 1, -1},
                                          {"farther", 2, -1},
                                          {"nearer", 2, 1}})
    text += fmt::format(" <button type=\"button\" data-axis=\"{}\" data-sign=\"{}\">{}</button>", axis, sign,
                        words);
  return text + "</span></fieldset>\n";
}

}  // namespace

std::string x3d_page_text(const X3dPage& page, const std::filesystem::path& folder) {
  X3dTextures textures;
  const std::string title = html_escape(page.subject.title);
  const double step_m = 0.02 * depth_range_m(page.frame.depth.depth_m);
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" href=\"x3dom.css\"><link "
      "rel=\"stylesheet\" href=\"page.css\">\n<script src=\"x3dom.js\" defer></script><script "
      "src=\"page.js\" defer></script>{}</head>\n"
      "<body data-step-m=\"{:.4f}\"><main><h1>{}</h1>\n<div class=\"scene\">",
      content_policy, title, page.subject.figure ? "<script src=\"humanoid.js\" defer></script>" : "", step_m,
      title);
  text += scene(page, textures, folder) + "</div>\n";
  text += "<p><span id=\"status\">This page needs scripts.</span> <a id=\"other_way\" hidden></a></p>\n";
  text += controls(page) + ghost_template(page, textures, folder);
  if (page.subject.figure) text += humanoid_words(page.subject);
  for (const std::string& note : page.subject.notes) text += "<p>" + html_escape(note) + "</p>\n";
  if (page.user != nullptr)
    text += fmt::format(
        "<p>The joints' orientations follow from their positions by cyclic coordinate descent; the fitted "
        "skeleton's joints are {:.1f} mm from the measured ones (root mean square).</p>\n",
        1000 * page.user->rms_m);
  text +=
      "<h2>Recorded values of the sensors</h2>\n<div class=\"sheet\"><table><tbody "
      "id=\"values\"></tbody></table></div>\n"
      "<h2>The program's own picture</h2>\n<p>Traced, with the same depth deciding who is in front: bounce "
      "light is in it, which the scene above does not have.</p>\n"
      "<p><img src=\"program.png\" alt=\"the same, traced\"></p>\n";
  return text + "</main></body></html>\n";
}

}  // namespace seamline::renderer
