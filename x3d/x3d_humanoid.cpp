#include "x3d/x3d_humanoid.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "support/text/html.h"
#include "x3d/hanim_names.h"
#include "x3d/x3d_figure.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

/// An axis and an angle from 0 to pi.
std::string turn_text(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  if (!(turn.angle() > 1e-7)) return "0 0 1 0";
  return field_text(turn.axis()) + " " + field_text(turn.angle());
}

bool stays(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() < 1e-9;
}

std::string vectors_text(const std::vector<Eigen::Vector3f>& vectors) {
  std::string text;
  for (const Eigen::Vector3f& v : vectors)
    fmt::format_to(std::back_inserter(text), "{:.6g} {:.6g} {:.6g} ", v.x(), v.y(), v.z());
  return text;
}

class HumanoidText {
 public:
  explicit HumanoidText(const X3dFigure& figure)
      : figure_(figure), holds_(figure.joints.size()), children_(figure.joints.size()) {
    for (std::size_t j = 0; j < figure.joints.size(); ++j)
      if (figure.joints[j].parent >= 0) children_[figure.joints[j].parent].push_back(j);
    for (std::size_t v = 0; v < figure.held_by.size(); ++v)
      for (const auto& [joint, weight] : figure.held_by[v]) holds_[joint].emplace_back(v, weight);
  }

  [[nodiscard]] std::string joint(std::size_t number) const {
    const X3dJoint& joint = figure_.joints[number];
    std::string text =
        fmt::format("<HAnimJoint DEF=\"hanim_{0}\" name=\"{0}\" containerField=\"{1}\" center=\"{2}\"",
                    joint.name, joint.parent < 0 ? "skeleton" : "children", field_text(joint.centre_m));
    const X3dJointPose& place = joint.place;
    if (!stays(place.translation_m, Eigen::Vector3d::Zero()))
      text += " translation=\"" + field_text(place.translation_m) + "\"";
    if (const std::string turn = turn_text(place.rotation); turn != "0 0 1 0")
      text += " rotation=\"" + turn + "\"";
    if (!stays(place.scale, Eigen::Vector3d::Ones()) || is_keyed(joint, &X3dJointPose::scale))
      text += " scale=\"" + field_text(place.scale) + "\" scaleOrientation=\"" + turn_text(joint.scale_axes) +
              "\"";
    if (!holds_[number].empty()) {
      std::string index, weight;
      for (const auto& [vertex, share] : holds_[number]) {
        fmt::format_to(std::back_inserter(index), "{} ", vertex);
        fmt::format_to(std::back_inserter(weight), "{:.6g} ", share);
      }
      text += " skinCoordIndex=\"" + index + "\" skinCoordWeight=\"" + weight + "\"";
    }
    text += ">";
    for (const std::size_t child : children_[number]) text += "\n" + this->joint(child);
    if (const std::string segment = hanim_segment(joint.name); !segment.empty())
      text += fmt::format(
          "<HAnimSegment DEF=\"segment_{0}\" name=\"{0}\" containerField=\"children\"></HAnimSegment>",
          segment);
    return text + "</HAnimJoint>";
  }

  [[nodiscard]] std::string uses() const {
    std::string joints, segments;
    for (const X3dJoint& joint : figure_.joints) {
      joints +=
          fmt::format("<HAnimJoint USE=\"hanim_{}\" containerField=\"joints\"></HAnimJoint>\n", joint.name);
      if (const std::string segment = hanim_segment(joint.name); !segment.empty())
        segments += fmt::format(
            "<HAnimSegment USE=\"segment_{}\" containerField=\"segments\"></HAnimSegment>\n", segment);
    }
    return joints + segments;
  }

  [[nodiscard]] std::string motion() const {
    if (figure_.fractions.empty()) return {};
    std::string text = fmt::format(
        "<TimeSensor id=\"figure_clock\" DEF=\"figure_clock\" cycleInterval=\"{}\" loop=\"true\"></TimeSensor>\n",
        field_text(figure_.cycle_s));
    for (const X3dJoint& joint : figure_.joints) {
      if (std::any_of(joint.keys.begin(), joint.keys.end(), [&](const X3dJointPose& key) {
            return key.rotation.angularDistance(joint.place.rotation) > 1e-7;
          }))
        text += moved(joint, "rotation", "Orientation",
                      [](const X3dJointPose& key) { return turn_text(key.rotation); });
      if (is_keyed(joint, &X3dJointPose::translation_m))
        text += moved(joint, "translation", "Position",
                      [](const X3dJointPose& key) { return field_text(key.translation_m); });
      if (is_keyed(joint, &X3dJointPose::scale))
        text +=
            moved(joint, "scale", "Position", [](const X3dJointPose& key) { return field_text(key.scale); });
    }
    return text;
  }

 private:
  [[nodiscard]] static bool is_keyed(const X3dJoint& joint, Eigen::Vector3d X3dJointPose::*member) {
    return std::any_of(joint.keys.begin(), joint.keys.end(),
                       [&](const X3dJointPose& key) { return !stays(key.*member, joint.place.*member); });
  }

  [[nodiscard]] std::string moved(const X3dJoint& joint, const char* field, const char* kind,
                                  const std::function<std::string(const X3dJointPose&)>& value) const {
    std::string key, values;
    for (std::size_t i = 0; i < figure_.fractions.size(); ++i) {
      key += field_text(figure_.fractions[i]) + " ";
      values += value(joint.keys[i]) + " ";
    }
    const std::string name = fmt::format("{}_{}", field, joint.name);
    return fmt::format(
        "<{0}Interpolator DEF=\"{1}\" key=\"{2}\" keyValue=\"{3}\"></{0}Interpolator>\n"
        "<ROUTE fromNode=\"figure_clock\" fromField=\"fraction_changed\" toNode=\"{1}\" "
        "toField=\"set_fraction\"></ROUTE>\n"
        "<ROUTE fromNode=\"{1}\" fromField=\"value_changed\" toNode=\"hanim_{4}\" toField=\"{5}\"></ROUTE>\n",
        kind, name, key, values, joint.name, field);
  }

  const X3dFigure& figure_;
  std::vector<std::vector<std::pair<std::size_t, double>>> holds_;  ///< vertices of each joint
  std::vector<std::vector<std::size_t>> children_;                  ///< of each joint
};

}  // namespace

std::string x3d_humanoid(const X3dPage& page, const std::function<std::string(std::size_t)>& appearance) {
  const X3dFigure figure = x3d_figure(page.subject, page.openness);
  const HumanoidText words(figure);
  std::string text =
      "<HAnimHumanoid id=\"figure\" DEF=\"figure\" name=\"figure\" version=\"2.0\">\n" + words.joint(0) +
      "\n" + words.uses() + "<Coordinate DEF=\"figure_points\" containerField=\"skinCoord\" point=\"" +
      vectors_text(figure.positions_m) +
      "\"></Coordinate>\n<Normal DEF=\"figure_normals\" containerField=\"skinNormal\" vector=\"" +
      vectors_text(figure.normals) + "\"></Normal>\n<Group containerField=\"skin\">\n";
  for (std::size_t m = 0; m < figure.triangles.size(); ++m) {
    text += "<Shape>" + appearance(m) + "<IndexedTriangleSet solid=\"false\" index=\"";
    for (const Triangle& corners : figure.triangles[m])
      fmt::format_to(std::back_inserter(text), "{} {} {} ", corners[0], corners[1], corners[2]);
    text += "\"><Coordinate USE=\"figure_points\"></Coordinate><Normal USE=\"figure_normals\"></Normal>";
    text += m == 0 ? "<Color DEF=\"figure_colours\" color=\"" + vectors_text(figure.colours) + "\"></Color>"
                   : "<Color USE=\"figure_colours\"></Color>";
    text += "</IndexedTriangleSet></Shape>\n";
  }
  return text + "</Group></HAnimHumanoid>\n" + words.motion();
}

std::string humanoid_words(const X3dSubject& subject) {
  const SceneFigure& figure = *subject.figure;
  std::string text = fmt::format(
      "<p>The object is an HAnimHumanoid of {} joints; a script of this page bends its skin, because X3DOM's plain "
      "build does not know HAnim.",
      figure.joints.size());
  if (!figure.times_s.empty())
    text += fmt::format(
        " It moves as in the animation {}; meanwhile its shadow is that of the pose in which it was exported.",
        html_escape("\"" + figure.animation + "\""));
  return text + "</p>\n";
}

std::string humanoid_control(const X3dSubject& subject) {
  if (subject.figure->times_s.empty()) return {};
  return "<label><input type=\"checkbox\" id=\"moves\" checked> the figure moves</label>\n";
}

}  // namespace seamline::renderer
