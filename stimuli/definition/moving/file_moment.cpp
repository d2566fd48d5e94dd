#include "stimuli/definition/moving/file_moment.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace seamline::inline stimuli {
namespace {

constexpr char moment_mark = '#', time_mark = '@';
constexpr char node_mark = '#';                        ///< names of objects have none
constexpr std::string_view builtin_mark = "builtin:";  ///< of scenes, whose names have no ending

bool is_gltf(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name.ends_with(".gltf") || name.ends_with(".glb");
}

/// Takes `#NAME@[x y z pitch yaw roll]` from the front of a text.
std::optional<PlacedNode> take_node(std::string_view& text) {
  const std::size_t at = text.find("@["), end = text.find(']');
  if (!text.starts_with(moment_mark) || at == std::string_view::npos || end == std::string_view::npos ||
      end < at)
    return std::nullopt;
  PlacedNode node{.name = std::string(text.substr(1, at - 1))};
  const char* from = text.data() + at + 2;
  for (int i = 0; i < 6; ++i) {
    double& number = i < 3 ? node.position_m[i] : node.rotation_deg[i - 3];
    const auto [read, error] = std::from_chars(from, text.data() + end, number);
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    from = read + (i < 5 ? 1 : 0);
  }
  if (from != text.data() + end) return std::nullopt;
  text.remove_prefix(end + 1);
  return node;
}

/// What stands behind a file's name; none: it is no moment.
std::optional<FileMoment> moment_of(std::string_view text) {
  FileMoment moment{.is_animated = false};
  while (auto node = take_node(text)) moment.nodes.push_back(std::move(*node));
  if (text.empty() && !moment.nodes.empty()) return moment;
  const std::size_t at = text.rfind(time_mark);
  if (!text.starts_with(moment_mark) || at == std::string_view::npos) return std::nullopt;
  moment.is_animated = true;
  moment.animation = text.substr(1, at - 1);
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data() + at + 1, end, moment.time_s);
  if (error != std::errc() || read != end || !std::isfinite(moment.time_s)) return std::nullopt;
  return moment;
}

std::string text_of(const PlacedNode& node) {
  std::string text = fmt::format("{}{}{}[", moment_mark, node.name, time_mark);
  for (int i = 0; i < 6; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : " ", i < 3 ? node.position_m[i] : node.rotation_deg[i - 3]);
  return text + "]";
}

std::string written_as(const NamedFile& file) {
  std::string text = file.file;
  if (!file.moment) return text;
  for (const PlacedNode& node : file.moment->nodes) text += text_of(node);
  if (file.moment->is_animated)
    text += fmt::format("{}{}{}{}", moment_mark, file.moment->animation, time_mark, file.moment->time_s);
  return text;
}

}  // namespace

NamedFile split_moment(const std::string& written) {
  for (std::size_t mark = written.find(moment_mark); mark != std::string::npos;
       mark = written.find(moment_mark, mark + 1)) {
    if (!is_gltf(written.substr(0, mark)) && !written.starts_with(builtin_mark)) continue;
    if (auto moment = moment_of(std::string_view(written).substr(mark)))
      return {.file = written.substr(0, mark), .moment = std::move(moment)};
  }
  return {.file = written};
}

std::string with_moment(const std::string& written, const FileMoment& moment) {
  NamedFile file = split_moment(written);
  std::vector<PlacedNode> nodes = file.moment ? std::move(file.moment->nodes) : std::vector<PlacedNode>();
  for (const PlacedNode& node : moment.nodes) {
    std::erase_if(nodes, [&](const PlacedNode& one) { return one.name == node.name; });
    if (!node.stands()) nodes.push_back(node);
  }
  file.moment = moment;
  file.moment->nodes = std::move(nodes);
  return written_as(file);
}

std::string with_node(const std::string& written, const PlacedNode& node) {
  FileMoment moment = split_moment(written).moment.value_or(FileMoment{.is_animated = false});
  moment.nodes = {node};
  return with_moment(written, moment);
}

PlacedNode node_of(const std::string& written, const std::string& name) {
  if (const auto moment = split_moment(written).moment)
    for (const PlacedNode& node : moment->nodes)
      if (node.name == name) return node;
  return {.name = name};
}

std::string place_of_node(const std::string& name) {
  return node_mark + name;
}

std::optional<std::string> moved_node(const std::string& place) {
  if (!place.starts_with(node_mark)) return std::nullopt;
  return place.substr(1);
}

}  // namespace seamline::inline stimuli
