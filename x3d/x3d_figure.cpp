#include "x3d/x3d_figure.h"

#include <cmath>

#include "support/text/printable.h"
#include "x3d/hanim_names.h"

namespace seamline::renderer {
namespace {

/// A transform that turns, moves and scales alike in all directions.
struct Similarity {
  Eigen::Affine3d transform;
  Eigen::Quaterniond rotation;
  double scale;
};

std::optional<Similarity> similarity_of(const Eigen::Affine3d& transform) {
  constexpr double tolerance = 1e-3;
  const double determinant = transform.linear().determinant();
  if (!(determinant > 0)) return std::nullopt;
  const double scale = std::cbrt(determinant);
  const Eigen::Matrix3d axes = transform.linear() / scale;
  if (!((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < tolerance))
    return std::nullopt;
  return Similarity{transform, Eigen::Quaterniond(axes).normalized(), scale};
}

/// bound_of_parent * place * bound^-1 as a Transform about the joint's centre.
X3dJointPose x3d_place(const Similarity& parent, const Similarity& bound, const JointPose& place) {
  return {.translation_m = parent.transform * place.translation - bound.transform.translation(),
          .rotation = (parent.rotation * place.rotation * bound.rotation.conjugate()).normalized(),
          .scale = parent.scale / bound.scale * place.scale};
}

void add_mesh(const FigureSkin& skin, const SurfaceMesh& mesh, std::span<const float> open,
              const Eigen::Affine3d& to_x3d, X3dFigure& out) {
  const auto first = static_cast<std::uint32_t>(out.positions_m.size());
  const Eigen::Matrix3d turn = to_x3d.linear().inverse().transpose();
  const auto add = [&](std::uint32_t vertex, const Eigen::Vector3d& normal) {
    out.positions_m.emplace_back((to_x3d * skin.positions[vertex]).cast<float>());
    out.normals.emplace_back((turn * normal).normalized().cast<float>());
    out.colours.emplace_back(open[vertex] * mesh.albedo.matrix());
    out.held_by.push_back(skin.held_by[vertex]);
    return static_cast<std::uint32_t>(out.positions_m.size() - 1);
  };
  std::vector<Triangle>& triangles = out.triangles.emplace_back();
  if (!skin.normals.empty()) {
    for (std::uint32_t v = 0; v < skin.positions.size(); ++v) add(v, skin.normals[v].cast<double>());
    for (const Triangle& corners : mesh.triangles)
      triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
    return;
  }
  for (const Triangle& corners : mesh.triangles) {
    const Eigen::Vector3d from = skin.positions[corners[0]];
    const Eigen::Vector3d normal =
        (skin.positions[corners[1]] - from).cross(skin.positions[corners[2]] - from);
    triangles.push_back({add(corners[0], normal), add(corners[1], normal), add(corners[2], normal)});
  }
}

/// Why a transform is no similarity.
const char* fault_of(const Eigen::Affine3d& transform) {
  const double determinant = transform.linear().determinant();
  return determinant > 0 ? "sheared" : determinant < 0 ? "mirrored" : "flat";
}

}  // namespace

std::string why_no_x3d_figure(const SceneFigure& figure, const Eigen::Affine3d& x3d_from_file) {
  if (const Eigen::Affine3d above = x3d_from_file * figure.above_root; !similarity_of(above))
    return std::string("the nodes above its joints are ") + fault_of(above);
  for (const FigureJoint& joint : figure.joints)
    if (const Eigen::Affine3d bound = x3d_from_file * figure.from_bound * joint.bound; !similarity_of(bound))
      return "its joint \"" + printable(joint.name) + "\" is bound " + fault_of(bound);
  return {};
}

X3dFigure x3d_figure(const X3dSubject& subject, std::span<const std::vector<float>> openness) {
  const SceneFigure& figure = *subject.figure;
  const Eigen::Affine3d to_x3d = subject.x3d_from_figure * figure.from_bound;
  X3dFigure out{.animation = figure.animation};
  std::vector<std::string> names;
  for (const FigureJoint& joint : figure.joints) names.push_back(joint.name);
  names = hanim_joints(names);
  std::vector<Similarity> bound;
  for (const FigureJoint& joint : figure.joints) bound.push_back(*similarity_of(to_x3d * joint.bound));
  for (std::size_t j = 0; j < figure.joints.size(); ++j) {
    const FigureJoint& joint = figure.joints[j];
    const Similarity above =
        joint.parent >= 0 ? bound[joint.parent] : *similarity_of(subject.x3d_from_figure * figure.above_root);
    X3dJoint& to = out.joints.emplace_back();
    to.name = names[j];
    to.parent = joint.parent;
    to.centre_m = bound[j].transform.translation();
    to.scale_axes = bound[j].rotation;
    to.place = x3d_place(above, bound[j], joint.place);
    for (const JointPose& key : joint.keys) to.keys.push_back(x3d_place(above, bound[j], key));
  }
  for (std::size_t m = 0; m < figure.meshes.size(); ++m)
    add_mesh(figure.meshes[m], *subject.objects[m], openness[m], to_x3d, out);
  if (!figure.times_s.empty()) {
    out.cycle_s = figure.times_s.back() - figure.times_s.front();
    for (const double time_s : figure.times_s)
      out.fractions.push_back((time_s - figure.times_s.front()) / out.cycle_s);
  }
  return out;
}

}  // namespace seamline::renderer
