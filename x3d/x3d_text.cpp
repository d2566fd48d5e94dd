#include "x3d/x3d_text.h"

#include <fmt/format.h>

#include <iterator>

namespace seamline::renderer {
namespace {

void append_vectors(std::span<const Eigen::Vector3f> vectors, std::string& text) {
  for (const Eigen::Vector3f& v : vectors)
    fmt::format_to(std::back_inserter(text), "{:.6g} {:.6g} {:.6g} ", v.x(), v.y(), v.z());
}

}  // namespace

std::string field_text(double value) {
  return fmt::format("{:.8g}", value);
}

std::string field_text(const Eigen::Vector2d& v) {
  return field_text(v.x()) + " " + field_text(v.y());
}

std::string field_text(const Eigen::Vector3d& v) {
  return field_text(v.x()) + " " + field_text(v.y()) + " " + field_text(v.z());
}

std::string element_text(std::string_view text) {
  std::string out;
  for (const char letter : text) switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        out += letter;
    }
  return out;
}

std::string triangle_set(std::span<const Eigen::Vector3f> positions_m, const VertexValues& values,
                         std::span<const Triangle> triangles) {
  std::string text = "<indexedTriangleSet solid=\"false\" ";
  text += values.normals.empty() ? "normalPerVertex=\"false\" index=\"" : "index=\"";
  for (const Triangle& corners : triangles)
    fmt::format_to(std::back_inserter(text), "{} {} {} ", corners[0], corners[1], corners[2]);
  text += "\"><coordinate point=\"";
  append_vectors(positions_m, text);
  text += "\"></coordinate>";
  if (!values.normals.empty()) {
    text += "<normal vector=\"";
    append_vectors(values.normals, text);
    text += "\"></normal>";
  }
  if (!values.colours.empty()) {
    text += "<color color=\"";
    append_vectors(values.colours, text);
    text += "\"></color>";
  }
  return text + "</indexedTriangleSet>";
}

std::string shader_field(const char* name, const char* type, const std::string& value) {
  return fmt::format("<field name=\"{0}\" type=\"{1}\" value=\"{2}\"></field>\n", name, type, value);
}

}  // namespace seamline::renderer
