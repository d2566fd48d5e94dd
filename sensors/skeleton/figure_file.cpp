#include "sensors/skeleton/figure_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::sensors {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr int float_numbers = 5126, deepest_nesting = 200;

static_assert(std::endian::native == std::endian::little, "glTF is little endian");

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}
void put_word(std::uint32_t word, std::string& out) {
  out.append(reinterpret_cast<const char*>(&word), sizeof word);
}
void put_chunk(std::uint32_t kind, std::string text, char filler, std::string& out) {
  text.resize((text.size() + 3) / 4 * 4, filler);
  put_word(static_cast<std::uint32_t>(text.size()), out);
  put_word(kind, out);
  out += text;
}

/// Numbers of a node, as many as wanted; empty where it has none.
std::vector<double> numbers_of(const Json& node, const char* key, std::size_t count, const std::string& file,
                               const std::string& where) {
  if (!node.contains(key)) return {};
  const Json& list = node[key];
  const bool good = list.is_array() && list.size() == count &&
                    std::all_of(list.begin(), list.end(), [](const Json& one) { return one.is_number(); });
  if (!good)
    throw input_error({.file = file,
                       .field = where + "." + key,
                       .wanted = fmt::format("{} numbers", count),
                       .found = "something else"});
  return list.get<std::vector<double>>();
}

/// A node's own transform, and the rotation in it.
std::pair<Eigen::Affine3d, Eigen::Quaterniond> own_transform(const Json& node, const std::string& file,
                                                             const std::string& where) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const auto matrix = numbers_of(node, "matrix", 16, file, where); !matrix.empty()) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    return {transform, Eigen::Quaterniond(transform.rotation())};
  }
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  if (const auto at = numbers_of(node, "translation", 3, file, where); !at.empty())
    transform.translate(Eigen::Vector3d(at.data()));
  if (const auto xyzw = numbers_of(node, "rotation", 4, file, where); !xyzw.empty())
    turned = Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]).normalized();
  transform.rotate(turned);
  if (const auto by = numbers_of(node, "scale", 3, file, where); !by.empty())
    transform.scale(Eigen::Vector3d(by.data()));
  return {transform, turned};
}

}  // namespace

FigureFile::FigureFile(const std::filesystem::path& path) : file_(path.string()) {
  const std::string bytes = read_file(path, limits::largest_scene_file_bytes);
  const auto bad = [&](const std::string& found) {
    return input_error({.file = file_, .wanted = "a .glb file (glTF 2.0)", .found = found});
  };
  if (bytes.size() < header_bytes + chunk_header_bytes || word_at(bytes, 0) != magic ||
      word_at(bytes, 4) != 2)
    throw bad("another file");
  std::string text;
  for (std::size_t at = header_bytes; at + chunk_header_bytes <= bytes.size();) {
    const std::size_t size = word_at(bytes, at);
    const std::uint32_t kind = word_at(bytes, at + 4);
    at += chunk_header_bytes;
    if (size > bytes.size() - at) throw bad("a file that was cut off");
    if (kind == json_chunk && text.empty())
      text = bytes.substr(at, size);
    else if (kind == binary_chunk && binary_.empty())
      binary_ = bytes.substr(at, size);
    else
      other_chunks_ += bytes.substr(at - chunk_header_bytes, chunk_header_bytes + size);
    at += size;
  }
  int depth = 0;
  json_ = Json::parse(
      text,
      [&](int now, Json::parse_event_t, Json&) {
        depth = std::max(depth, now);
        if (depth > deepest_nesting) throw bad("JSON nested too deep");
        return true;
      },
      false);
  if (!json_.is_object()) throw bad("JSON that cannot be read");
  if (!binary_.empty() &&
      !(json_.contains("buffers") && json_["buffers"].is_array() && !json_["buffers"].empty() &&
        json_["buffers"][0].is_object() && !json_["buffers"][0].contains("uri")))
    throw bad("bytes that no buffer names");
  read_nodes();
}

void FigureFile::read_nodes() {
  const auto bad = [&](const std::string& field, const std::string& wanted, const std::string& found) {
    return input_error({.file = file_, .field = field, .wanted = wanted, .found = found});
  };
  if (!json_.contains("nodes") || !json_["nodes"].is_array() || json_["nodes"].empty())
    throw bad("nodes", "nodes", "none");
  const Json& nodes = json_["nodes"];
  nodes_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string where = fmt::format("nodes[{}]", i);
    if (!nodes[i].is_object()) throw bad(where, "an object", "something else");
    if (nodes[i].contains("name") && nodes[i]["name"].is_string()) nodes_[i].name = nodes[i]["name"];
    if (!nodes[i].contains("children") || !nodes[i]["children"].is_array()) continue;
    for (const Json& child : nodes[i]["children"]) {
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size())
        throw bad(where + ".children", "nodes that exist", child.dump());
      FigureNode& of_child = nodes_[child.get<std::size_t>()];
      if (of_child.parent >= 0) throw bad(where + ".children", "one parent of each node", child.dump());
      of_child.parent = static_cast<int>(i);
    }
  }
  // Parents first: from the roots all are reached but those that go round in a circle.
  std::vector<std::vector<std::size_t>> children(nodes_.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    (nodes_[i].parent < 0 ? order : children[nodes_[i].parent]).push_back(i);
  for (std::size_t k = 0; k < order.size(); ++k) {
    FigureNode& node = nodes_[order[k]];
    std::tie(node.own, node.turned) =
        own_transform(nodes[order[k]], file_, fmt::format("nodes[{}]", order[k]));
    node.world = node.own;
    if (node.parent >= 0) {
      const FigureNode& parent = nodes_[node.parent];
      node.world = parent.world * node.own, node.turned = parent.turned * node.turned;
    }
    order.insert(order.end(), children[order[k]].begin(), children[order[k]].end());
  }
  if (order.size() < nodes_.size()) throw bad("nodes", "no node that is its own ancestor", "one");
}

void FigureFile::need_place_of(const std::filesystem::path& out) const {
  const auto folder = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file).parent_path());
  };
  if (folder(file_) == folder(out)) return;
  for (const char* list : {"buffers", "images"}) {
    if (!json_.contains(list)) continue;
    for (const Json& one : json_[list]) {
      if (!one.is_object() || !one.contains("uri") || !one["uri"].is_string()) continue;
      const auto uri = one["uri"].get<std::string>();
      if (uri.find(':') >= uri.find('/'))  // no "data:" or "https:" before its folders
        throw input_error({.file = file_,
                           .field = list,
                           .wanted = "no files beside it, because the new file is in another folder",
                           .found = "\"" + uri + "\""});
    }
  }
}

int FigureFile::add_numbers(const std::vector<float>& numbers, const char* type, std::size_t parts) {
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  const std::size_t at = binary_.size(), size = numbers.size() * sizeof(float);
  binary_.append(reinterpret_cast<const char*>(numbers.data()), size);
  Json& views = json_["bufferViews"];
  views.push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", size}});
  Json accessor = {{"bufferView", views.size() - 1},
                   {"componentType", float_numbers},
                   {"count", numbers.size() / parts},
                   {"type", type}};
  if (parts == 1) {  // times need their range
    accessor["min"] = {*std::min_element(numbers.begin(), numbers.end())};
    accessor["max"] = {*std::max_element(numbers.begin(), numbers.end())};
  }
  json_["accessors"].push_back(std::move(accessor));
  return static_cast<int>(json_["accessors"].size()) - 1;
}

void FigureFile::add_animation(const std::string& name, const std::vector<double>& times_s,
                               const std::vector<MovedNode>& motions) {
  if (!is_utf8(name)) throw input_error({.field = "the animation's name", .wanted = "UTF-8", .found = name});
  const std::vector<float> keys_s(times_s.begin(), times_s.end());
  const bool rise = std::adjacent_find(keys_s.begin(), keys_s.end(),
                                       [](float one, float next) { return !(next > one); }) == keys_s.end();
  if (!rise || keys_s.empty() || !(keys_s.front() >= 0))
    throw input_error({.field = "the animation's times",
                       .wanted = "times from 0 s that rise in 32 bits",
                       .found = "others"});
  for (const char* list : {"buffers", "bufferViews", "accessors", "animations"}) {
    Json& table = json_[list];
    if (table.is_null()) table = Json::array();
    if (!table.is_array())
      throw input_error({.file = file_, .field = list, .wanted = "a list", .found = "something else"});
  }
  for (const Json& one : json_["animations"])
    if (one.is_object() && one.value("name", Json()) == Json(name))
      throw input_error({.file = file_,
                         .field = "animations",
                         .wanted = "no animation of the name \"" + printable(name) + "\" yet",
                         .found = "one"});
  Json& buffers = json_["buffers"];
  if (binary_.empty()) buffers.insert(buffers.begin(), Json::object());
  if (binary_.empty())
    for (Json& view : json_["bufferViews"]) {
      if (!view.is_object() || !view.contains("buffer") || !view["buffer"].is_number_unsigned())
        throw input_error({.file = file_,
                           .field = "bufferViews",
                           .wanted = "the number of a buffer in each",
                           .found = "something else"});
      view["buffer"] = view["buffer"].get<std::uint64_t>() + 1;
    }
  const int input = add_numbers(keys_s, "SCALAR", 1);
  Json channels = Json::array(), samplers = Json::array();
  const auto move = [&](int node, const char* path, const std::vector<float>& numbers, const char* type,
                        std::size_t parts) {
    if (json_["nodes"][static_cast<std::size_t>(node)].contains("matrix"))
      throw input_error({.file = file_,
                         .field = fmt::format("nodes[{}]", node),
                         .wanted = "translation, rotation and scale, because it is animated",
                         .found = "a matrix"});
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers.push_back({{"input", input}, {"output", add_numbers(numbers, type, parts)}});
  };
  for (const MovedNode& motion : motions) {
    std::vector<float> numbers;
    for (const Eigen::Quaterniond& turned : motion.rotations)
      for (int c = 0; c < 4; ++c) numbers.push_back(static_cast<float>(turned.coeffs()[c]));
    if (!numbers.empty()) move(motion.node, "rotation", numbers, "VEC4", 4);
    numbers.clear();
    for (const Eigen::Vector3d& place_m : motion.translations_m)
      for (int c = 0; c < 3; ++c) numbers.push_back(static_cast<float>(place_m[c]));
    if (!numbers.empty()) move(motion.node, "translation", numbers, "VEC3", 3);
  }
  buffers[0]["byteLength"] = binary_.size();
  json_["animations"].push_back(
      {{"name", name}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}});
}

std::string FigureFile::bytes() const {
  std::string chunks;
  put_chunk(json_chunk, json_.dump(), ' ', chunks);
  if (!binary_.empty()) put_chunk(binary_chunk, binary_, '\0', chunks);
  chunks += other_chunks_;
  std::string out;
  put_word(magic, out);
  put_word(2, out);
  put_word(static_cast<std::uint32_t>(header_bytes + chunks.size()), out);
  return out + chunks;
}

}  // namespace seamline::sensors
