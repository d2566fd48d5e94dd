#include "laboratory/person/person_scene.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "support/arithmetic/shortest_turn.h"
#include "support/arithmetic/units.h"
#include "support/files/gltf_writing.h"

namespace seamline::renderer {
namespace {

using sensors::PlacedJoint;
using sensors::Skeleton;

constexpr int limb_corners = 28, rings = 8;  ///< of a limb, and of each of its round ends
constexpr const char* light_extension = "KHR_lights_punctual";

/// Triangles of one colour.
struct PersonPart {
  std::string name;
  std::array<double, 3> albedo = {0.5, 0.5, 0.5};
  std::vector<Eigen::Vector3f> positions_m = {}, normals = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {};

  std::uint32_t add(const Eigen::Vector3d& place_m, const Eigen::Vector3d& normal) {
    positions_m.push_back(place_m.cast<float>());
    normals.push_back(normal.cast<float>());
    return static_cast<std::uint32_t>(positions_m.size() - 1);
  }
};

/// A limb from one ball to another.
void add_limb(PersonPart& part, const Eigen::Vector3d& from_m, double from_radius_m,
              const Eigen::Vector3d& to_m, double to_radius_m) {
  const Eigen::Vector3d along = to_m == from_m ? Eigen::Vector3d::UnitY() : (to_m - from_m).normalized();
  const Eigen::Vector3d right = along.unitOrthogonal(), up = along.cross(right);
  const auto first = static_cast<std::uint32_t>(part.positions_m.size());
  constexpr int rows = 2 * rings + 2;
  for (int row = 0; row < rows; ++row) {
    const bool at_end = row > rings;
    // Half a ball behind the start, half a ball beyond the end.
    const double height = -0.5 * std::numbers::pi + 0.5 * std::numbers::pi * (at_end ? row - 1 : row) / rings;
    const Eigen::Vector3d centre_m = at_end ? to_m : from_m;
    const double radius_m = at_end ? to_radius_m : from_radius_m;
    for (int i = 0; i < limb_corners; ++i) {
      const double turn = 2 * std::numbers::pi * i / limb_corners;
      const Eigen::Vector3d normal =
          std::cos(height) * (std::cos(turn) * right + std::sin(turn) * up) + std::sin(height) * along;
      part.add(centre_m + radius_m * normal, normal);
    }
  }
  for (int row = 0; row + 1 < rows; ++row)
    for (int i = 0; i < limb_corners; ++i) {
      const auto at = [&](int r, int column) {
        return first + static_cast<std::uint32_t>(r * limb_corners + column % limb_corners);
      };
      part.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      part.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
}

void add_box(PersonPart& part, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) {
  const Eigen::Vector3d middle_m = 0.5 * (low_m + high_m), half_m = 0.5 * (high_m - low_m);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero(), u = normal, v = normal;
      normal[axis] = side;
      u[(axis + 1) % 3] = side * half_m[(axis + 1) % 3];
      v[(axis + 2) % 3] = half_m[(axis + 2) % 3];
      const Eigen::Vector3d face_m = middle_m + normal.cwiseProduct(half_m);
      const std::uint32_t first = part.add(face_m - u - v, normal);
      part.add(face_m + u - v, normal);
      part.add(face_m + u + v, normal);
      part.add(face_m - u + v, normal);
      part.triangles.push_back({first, first + 1, first + 2});
      part.triangles.push_back({first, first + 2, first + 3});
    }
}

/// Radii at both ends of the bone that leads to a joint.
std::pair<double, double> radii_m(const std::string& joint) {
  static const std::map<std::string, std::pair<double, double>> known = {
      {"neck", {0.145, 0.11}},           {"head", {0.055, 0.11}},        {"left_shoulder", {0.12, 0.065}},
      {"right_shoulder", {0.12, 0.065}}, {"left_elbow", {0.062, 0.046}}, {"right_elbow", {0.062, 0.046}},
      {"left_hand", {0.046, 0.044}},     {"right_hand", {0.046, 0.044}}, {"left_hip", {0.14, 0.105}},
      {"right_hip", {0.14, 0.105}},      {"left_knee", {0.092, 0.06}},   {"right_knee", {0.092, 0.06}},
      {"left_foot", {0.06, 0.045}},      {"right_foot", {0.06, 0.045}}};
  const auto found = known.find(joint);
  return found == known.end() ? std::pair(0.05, 0.05) : found->second;
}

PersonPart figure_of(const PersonScene& person) {
  const std::vector<PlacedJoint> placed = sensors::place_joints(person.skeleton, person.pose);
  PersonPart figure{.name = "person", .albedo = {0.36, 0.22, 0.2}};
  for (std::size_t i = 1; i < placed.size(); ++i) {
    const sensors::Joint& joint = person.skeleton.joints[i];
    const PlacedJoint& start = placed[joint.parent];
    const auto [from_m, to_m] = radii_m(joint.name);
    add_limb(figure, start.position_m, from_m, placed[i].position_m, to_m);
    if (!joint.name.ends_with("foot")) continue;
    const Eigen::Vector3d toe_m = placed[i].position_m + start.orientation * Eigen::Vector3d(0, -0.02, 0.16);
    add_limb(figure, placed[i].position_m, 0.045, toe_m, 0.035);
  }
  return figure;
}

std::vector<PersonPart> room() {
  constexpr double floor_m = -1.3, wall_m = -4.2, side_m = 2.2, ceiling_m = 1.5, thick_m = 0.1;
  PersonPart floor{.name = "floor", .albedo = {0.45, 0.38, 0.3}};
  add_box(floor, {-side_m, floor_m - thick_m, wall_m}, {side_m, floor_m, 1});
  PersonPart walls{.name = "walls", .albedo = {0.62, 0.64, 0.6}};
  add_box(walls, {-side_m, floor_m, wall_m - thick_m}, {side_m, ceiling_m, wall_m});
  add_box(walls, {-side_m - thick_m, floor_m, wall_m}, {-side_m, ceiling_m, -2.6});
  PersonPart table{.name = "table", .albedo = {0.3, 0.18, 0.09}};
  add_box(table, {0.35, -0.62, -2.35}, {1.35, -0.57, -1.75});
  for (const double x : {0.4, 1.25})
    for (const double z : {-2.3, -1.85}) add_box(table, {x, floor_m, z}, {x + 0.05, -0.62, z + 0.05});
  PersonPart box{.name = "box", .albedo = {0.12, 0.3, 0.45}};
  add_box(box, {0.85, -0.57, -2.2}, {1.15, -0.3, -1.95});
  return {floor, walls, table, box};
}

int add_vectors(tinygltf::Model& model, const std::vector<Eigen::Vector3f>& vectors, bool with_bounds) {
  const int accessor =
      add_accessor(model, std::as_bytes(std::span(vectors)),
                   {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER});
  if (!with_bounds) return accessor;
  Eigen::Vector3f least = vectors.front(), most = vectors.front();
  for (const Eigen::Vector3f& v : vectors) {
    least = least.cwiseMin(v);
    most = most.cwiseMax(v);
  }
  model.accessors.back().minValues = {least.x(), least.y(), least.z()};
  model.accessors.back().maxValues = {most.x(), most.y(), most.z()};
  return accessor;
}

void add_node(tinygltf::Model& model, const tinygltf::Node& node) {
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(node);
}

void add_part(tinygltf::Model& model, const PersonPart& part) {
  tinygltf::Material material;
  material.name = part.name;
  material.pbrMetallicRoughness.baseColorFactor = {part.albedo[0], part.albedo[1], part.albedo[2], 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.doubleSided = true;
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material);
  primitive.attributes["POSITION"] = add_vectors(model, part.positions_m, true);
  primitive.attributes["NORMAL"] = add_vectors(model, part.normals, false);
  primitive.indices = add_accessor(
      model, std::as_bytes(std::span(part.triangles)),
      {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(model.meshes.size());
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
  add_node(model, node);
}

void add_camera(tinygltf::Model& model) {
  tinygltf::Camera camera;
  camera.type = "perspective";
  camera.perspective.aspectRatio = 4.0 / 3;
  camera.perspective.yfov = 0.86;
  camera.perspective.znear = 0.01;
  model.cameras.push_back(camera);
  tinygltf::Node node;
  node.name = "camera";
  node.camera = 0;
  add_node(model, node);
}

/// From the upper left, behind the camera: lights shine along their node's -z.
void add_sun(tinygltf::Model& model) {
  tinygltf::Light light;
  light.name = "sun";
  light.type = "directional";
  light.color = {1, 1, 1};
  light.intensity = lux_per_w_m2 * 2.4;
  model.lights.push_back(light);
  tinygltf::Node node;
  node.name = "sun";
  const auto turn = shortest_turn(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d(0.75, -1.0, -0.8));
  node.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
  node.extensions[light_extension] = tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(0)}});
  add_node(model, node);
}

void set_angle(PersonScene& person, const std::string& joint, std::size_t hinge, double angle_rad) {
  std::size_t at = hinge;
  for (const sensors::Joint& one : person.skeleton.joints) {
    if (one.name == joint) break;
    at += one.hinges.size();
  }
  person.pose.angles_rad.at(at) = angle_rad;
}

}  // namespace

PersonScene greeting_person() {
  PersonScene person;
  person.pose = sensors::rest_pose(person.skeleton);
  person.pose.root_m = {-0.35, -0.16, -2.6};
  set_angle(person, "torso", 0, 0.2);
  set_angle(person, "left_shoulder", 0, 1.7);
  set_angle(person, "left_shoulder", 1, 0.1);
  set_angle(person, "left_shoulder", 2, 1.5);
  set_angle(person, "left_elbow", 0, -1.5);
  set_angle(person, "right_shoulder", 0, -0.7);
  set_angle(person, "right_shoulder", 2, 1.2);
  set_angle(person, "right_elbow", 0, -1.7);
  set_angle(person, "left_hip", 0, -0.25);
  set_angle(person, "left_hip", 1, 0.2);
  set_angle(person, "left_knee", 0, 0.3);
  set_angle(person, "right_hip", 1, -0.15);
  return person;
}

sensors::RecordedUser user_of(const PersonScene& person) {
  sensors::RecordedUser user;
  for (const PlacedJoint& joint : sensors::place_joints(person.skeleton, person.pose))
    user.joints_m.emplace_back(joint.position_m);
  return user;
}

void write_person_scene(const std::filesystem::path& path, const PersonScene& person) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "seamline";
  model.extensionsUsed.push_back(light_extension);
  model.buffers.emplace_back();
  model.scenes.emplace_back();
  model.defaultScene = 0;
  for (const PersonPart& part : room()) add_part(model, part);
  add_part(model, figure_of(person));
  add_camera(model);
  add_sun(model);
  write_glb_file(path, model);
}

}  // namespace seamline::renderer
