#include "x3d/x3d_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/text/html.h"
#include "x3d/x3d_background.h"
#include "x3d/x3d_humanoid.h"
#include "x3d/x3d_object.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

/// Nothing from outside. X3DOM reads textures that are data by requests of its own, and shows them by blobs.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src data:; "
    "base-uri 'none'; form-action 'none'";

Eigen::Vector3d x3d_from(const X3dSubject& subject, const Eigen::Vector3f& world) {
  return (subject.camera.axes.transpose() * world).cast<double>();
}

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
