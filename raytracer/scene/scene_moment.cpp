#include "raytracer/scene/scene_moment.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "raytracer/scene/gltf/gltf_accessor.h"
#include "raytracer/scene/gltf/gltf_pose.h"
#include "support/arithmetic/units.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"
#include "support/text/suggest.h"

namespace seamline::renderer {
namespace {

using Values = std::vector<double>;

enum class Interpolation { step, linear, cubic_spline };

/// Keys of a channel: at each time `size` numbers, or three times as many of a cubic spline (tangent in,
/// value, tangent out).
struct ChannelKeys {
  Values times_s = {}, numbers = {};
  std::size_t size = 0;
  Interpolation by = Interpolation::linear;
  bool turns = false;  ///< quaternions

  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> at(std::size_t key, std::size_t part) const {
    const std::size_t parts = by == Interpolation::cubic_spline ? 3 : 1;
    return {numbers.data() + (key * parts + part) * size, static_cast<Eigen::Index>(size)};
  }
  [[nodiscard]] Eigen::VectorXd value(std::size_t key) const {
    return at(key, by == Interpolation::cubic_spline ? 1 : 0);
  }
};

Eigen::VectorXd turned_between(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double share) {
  const Eigen::Quaterniond a(from[3], from[0], from[1], from[2]), b(to[3], to[0], to[1], to[2]);
  return a.normalized().slerp(share, b.normalized()).coeffs();  // x, y, z, w, the shorter way
}

Eigen::VectorXd on_spline(const ChannelKeys& keys, std::size_t key, double share) {
  const double between_s = keys.times_s[key + 1] - keys.times_s[key];
  const double t = share, t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * keys.value(key) + between_s * (t3 - 2 * t2 + t) * keys.at(key, 2) +
         (3 * t2 - 2 * t3) * keys.value(key + 1) + between_s * (t3 - t2) * keys.at(key + 1, 0);
}

Eigen::VectorXd value_at(const ChannelKeys& keys, double time_s) {
  const auto after = std::upper_bound(keys.times_s.begin(), keys.times_s.end(), time_s);
  if (after == keys.times_s.begin()) return keys.value(0);
  const auto key = static_cast<std::size_t>(after - keys.times_s.begin()) - 1;
  if (after == keys.times_s.end() || keys.by == Interpolation::step) return keys.value(key);
  const double share = (time_s - keys.times_s[key]) / (keys.times_s[key + 1] - keys.times_s[key]);
  if (keys.by == Interpolation::cubic_spline) return on_spline(keys, key, share);
  const Eigen::VectorXd from = keys.value(key), to = keys.value(key + 1);
  return keys.turns ? turned_between(from, to, share) : Eigen::VectorXd(from + share * (to - from));
}

/// What moves a node.
struct Channel {
  std::int64_t node = 0;
  std::string path, where;
  ChannelKeys keys;
};

InputError bad_channel(const std::string& file, const std::string& field, const std::string& wanted,
                       const std::string& found) {
  return input_error({.file = file, .field = field, .wanted = wanted, .found = found});
}

void move(const Channel& channel, const std::string& file, double time_s, tinygltf::Model& model) {
  tinygltf::Node& node = model.nodes[static_cast<std::size_t>(channel.node)];
  const Eigen::VectorXd value = value_at(channel.keys, time_s);
  if (!value.allFinite()) throw bad_channel(file, channel.where, "finite values between its keys", "others");
  const Values numbers(value.begin(), value.end());
  if (channel.path == "weights") {
    node.weights = numbers;
    return;
  }
  if (!node.matrix.empty())
    throw bad_channel(file, fmt::format("nodes[{}]", channel.node),
                      "translation, rotation and scale, because it is animated", "a matrix");
  (channel.path == "translation" ? node.translation
   : channel.path == "rotation"  ? node.rotation
                                 : node.scale) = numbers;
}

/// Reads the channels of one animation.
class ChannelReader {
 public:
  ChannelReader(const std::string& file, const tinygltf::Model& model, LeftOut& left_out)
      : file_(file), model_(model), reader_(model, file), left_out_(left_out) {}

  /// Calls `take` with one after the other.
  void read(const GltfJson& animation, const std::string& where,
            const std::function<bool(const std::string& path)>& wants,
            const std::function<void(Channel)>& take) {
    const GltfJson *channels = member(animation, "channels"), *samplers = member(animation, "samplers");
    if (channels == nullptr || !channels->is_array() || samplers == nullptr || !samplers->is_array())
      throw bad(where, "channels and samplers", "something else");
    for (std::size_t c = 0; c < channels->size(); ++c)
      if (auto channel = read_one((*channels)[c], *samplers, fmt::format("{}.channels[{}]", where, c), wants))
        take(std::move(*channel));
  }

 private:
  [[nodiscard]] InputError bad(const std::string& field, const std::string& wanted,
                               const std::string& found) const {
    return bad_channel(file_, field, wanted, found);
  }

  std::optional<Channel> read_one(const GltfJson& channel, const GltfJson& samplers, const std::string& where,
                                  const std::function<bool(const std::string& path)>& wants) {
    const GltfJson* target = member(channel, "target");
    if (target == nullptr || !target->is_object()) throw bad(where, "a target", "none");
    const std::string path = text_of(*target, "path");
    if (!wants(path)) return std::nullopt;
    if (path == "pointer") {
      left_out_.insert("animated properties other than places, turns, sizes and morph weights");
      return std::nullopt;
    }
    const std::int64_t index = whole_number(*target, "node", -1);
    if (index < 0) return std::nullopt;  // as the specification wants it
    if (std::cmp_greater_equal(index, model_.nodes.size()))
      throw bad(where + ".target.node", "a node that exists", std::to_string(index));
    const tinygltf::Node& node = model_.nodes[index];
    const std::int64_t sampler = whole_number(channel, "sampler", -1);
    if (sampler < 0 || std::cmp_greater_equal(sampler, samplers.size()))
      throw bad(where + ".sampler", "a sampler that exists", std::to_string(sampler));
    return Channel{
        .node = index, .path = path, .where = where, .keys = keys_of(samplers[sampler], path, node, where)};
  }

  /// How many numbers a channel has at a time.
  [[nodiscard]] std::size_t size_of(const std::string& path, const tinygltf::Node& node,
                                    const std::string& where) const {
    if (path == "translation" || path == "scale") return 3;
    if (path == "rotation") return 4;
    if (path != "weights")
      throw bad(where + ".target.path", "translation, rotation, scale or weights",
                "\"" + printable(path) + "\"");
    std::size_t targets = 0;
    if (node.mesh >= 0 && std::cmp_less(node.mesh, model_.meshes.size()))
      for (const auto& primitive : model_.meshes[node.mesh].primitives)
        targets = std::max(targets, primitive.targets.size());
    if (targets == 0) throw bad(where, "a node whose mesh has morph targets", "none");
    return targets;
  }

  [[nodiscard]] ChannelKeys keys_of(const GltfJson& sampler, const std::string& path,
                                    const tinygltf::Node& node, const std::string& where) const {
    ChannelKeys keys{.size = size_of(path, node, where), .turns = path == "rotation"};
    const std::string by = text_of(sampler, "interpolation");
    if (by == "STEP")
      keys.by = Interpolation::step;
    else if (by == "CUBICSPLINE")
      keys.by = Interpolation::cubic_spline;
    else if (!by.empty() && by != "LINEAR")
      throw bad(where, "LINEAR, STEP or CUBICSPLINE", "\"" + printable(by) + "\"");
    const auto accessor = [&](const char* name) {
      const std::int64_t number = whole_number(sampler, name, -1);
      return std::in_range<int>(number) ? static_cast<int>(number) : -1;
    };
    keys.times_s = reader_.numbers(accessor("input"), 1, where + ".input");
    keys.numbers = reader_.numbers(accessor("output"), path == "weights" ? 1 : static_cast<int>(keys.size),
                                   where + ".output");
    const std::size_t parts = keys.by == Interpolation::cubic_spline ? 3 : 1;
    if (keys.times_s.empty() || keys.numbers.size() != keys.times_s.size() * keys.size * parts)
      throw bad(where + ".output", fmt::format("{} numbers at each of its times", keys.size * parts),
                fmt::format("{} numbers and {} times", keys.numbers.size(), keys.times_s.size()));
    for (std::size_t i = 1; i < keys.times_s.size(); ++i)
      if (!(keys.times_s[i] > keys.times_s[i - 1]))
        throw bad(where + ".input", "times that rise",
                  fmt::format("{:g} s after {:g} s", keys.times_s[i], keys.times_s[i - 1]));
    return keys;
  }

  const std::string& file_;
  const tinygltf::Model& model_;
  GltfReader reader_;
  LeftOut& left_out_;
};

}  // namespace

std::size_t animation_index(const std::string& name, const GltfJson& animations, const std::string& file) {
  if (name.empty() && animations.size() == 1) return 0;
  std::string known;
  for (std::size_t i = 0; i < animations.size(); ++i) {
    const std::string one = text_of(animations[i], "name");
    if (!name.empty() && one == name) return i;
    known +=
        fmt::format("{}\"{}\"", known.empty() ? "" : ", ", one.empty() ? std::to_string(i) : printable(one));
  }
  for (std::size_t i = 0; i < animations.size(); ++i)
    if (name == std::to_string(i)) return i;
  throw input_error({.file = file,
                     .field = "animation \"" + printable(name) + "\"",
                     .wanted = known.empty() ? "a file with animations" : "one of " + known,
                     .found = known.empty() ? "one without" : "another name"});
}

void place_nodes(const std::vector<PlacedNode>& nodes, const std::string& file, tinygltf::Model& model) {
  for (const PlacedNode& moved : nodes) {
    std::vector<std::string> names;
    for (const tinygltf::Node& node : model.nodes) names.push_back(node.name);
    const auto count = std::count(names.begin(), names.end(), moved.name);
    if (count != 1) {
      const std::string nearest = nearest_word(moved.name, names);
      throw input_error({.file = file,
                         .field = "node \"" + printable(moved.name) + "\"",
                         .wanted = "the name of one of its nodes",
                         .found = count > 1 ? fmt::format("{} of that name", count)
                                  : nearest.empty()
                                      ? std::string("none of that name")
                                      : "none of that name; did you mean \"" + printable(nearest) + "\"?"});
    }
    const auto at = std::find(names.begin(), names.end(), moved.name) - names.begin();
    tinygltf::Node& node = model.nodes[static_cast<std::size_t>(at)];
    const Eigen::Vector3d angle = moved.rotation_deg * radians_per_degree;
    Eigen::Affine3d own = GltfPose::local(node);
    own.linear() = (Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()) *
                    Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX()) *
                    Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()))
                       .toRotationMatrix() *
                   own.linear();
    own.translation() += moved.position_m;
    node.translation.clear(), node.rotation.clear(), node.scale.clear();
    node.matrix.assign(own.matrix().data(), own.matrix().data() + 16);
  }
}

void pose_at(const FileMoment& moment, const GltfJson& animations, const std::string& file,
             tinygltf::Model& model, LeftOut& left_out) {
  const std::size_t index = animation_index(moment.animation, animations, file);
  ChannelReader(file, model, left_out)
      .read(
          animations[index], fmt::format("animations[{}]", index), [](const std::string&) { return true; },
          [&](const Channel& channel) { move(channel, file, moment.time_s, model); });
}

NodeMotion node_motion(std::size_t index, const GltfJson& animations, const std::string& file,
                       const tinygltf::Model& model) {
  std::vector<Channel> channels;
  LeftOut unused;
  ChannelReader(file, model, unused)
      .read(
          animations[index], fmt::format("animations[{}]", index),
          [](const std::string& path) {
            return path == "translation" || path == "rotation" || path == "scale";
          },
          [&](Channel channel) { channels.push_back(std::move(channel)); });
  return [channels = std::move(channels), file](tinygltf::Model& moved, double time_s) {
    for (const Channel& channel : channels) move(channel, file, time_s, moved);
  };
}

}  // namespace seamline::renderer
