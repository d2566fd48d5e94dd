#include "support/codec/picture_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline {
namespace {

std::string small_letters(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

/// What follows a name's last dot.
std::string last_word(const std::string& layer) {
  const std::size_t dot = layer.rfind('.');
  return small_letters(dot == std::string::npos ? layer : layer.substr(dot + 1));
}

const NamedChannel* find_channel(const std::vector<NamedChannel>& channels, const std::string& layer,
                                 int part, std::initializer_list<std::string_view> names) {
  for (const NamedChannel& channel : channels)
    if (channel.layer == layer && channel.part == part &&
        std::find(names.begin(), names.end(), small_letters(channel.name)) != names.end())
      return &channel;
  return nullptr;
}

std::string names_text(const std::vector<std::string>& names) {
  constexpr std::size_t most = 24;
  const std::size_t shown = std::min(most, names.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i ? ", " : "") + printable(names[i]);
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string all_names_text(const std::vector<NamedChannel>& channels) {
  std::vector<std::string> names;
  names.reserve(channels.size());
  for (const NamedChannel& channel : channels) names.push_back(channel.full());
  return "the channels " + names_text(names);
}

/// A layer with red, green and blue.
struct ColourLayer {
  std::string name;
  ChosenChannels channels;
};

std::vector<ColourLayer> colour_layers(const std::vector<NamedChannel>& channels) {
  std::vector<ColourLayer> layers;
  for (const NamedChannel& channel : channels) {
    const bool known = std::any_of(layers.begin(), layers.end(), [&](const ColourLayer& layer) {
      return layer.name == channel.layer && layer.channels.part == channel.part;
    });
    if (known) continue;
    const auto* red = find_channel(channels, channel.layer, channel.part, {"r", "red"});
    const auto* green = find_channel(channels, channel.layer, channel.part, {"g", "green"});
    const auto* blue = find_channel(channels, channel.layer, channel.part, {"b", "blue"});
    if (!red || !green || !blue) continue;
    const auto* alpha = find_channel(channels, channel.layer, channel.part, {"a", "alpha"});
    layers.push_back(
        {channel.layer,
         {channel.part, {red->index, green->index, blue->index}, alpha ? alpha->index : -1, {}}});
  }
  return layers;
}

const ColourLayer* usual_layer(const std::vector<ColourLayer>& layers) {
  constexpr std::array usual = {"combined", "beauty",    "rgba",  "rgb",  "color", "colour",
                                "image",    "composite", "final", "main", "master"};
  for (const char* name : usual)
    for (const ColourLayer& layer : layers)
      if (last_word(layer.name) == name) return &layer;
  return nullptr;
}

std::string layers_text(const std::vector<ColourLayer>& layers) {
  std::vector<std::string> names;
  names.reserve(layers.size());
  for (const ColourLayer& layer : layers) names.push_back(layer.name.empty() ? "(unnamed)" : layer.name);
  return names_text(names);
}

bool is_vector(const std::vector<NamedChannel>& channels, const NamedChannel& channel) {
  return find_channel(channels, channel.layer, channel.part, {"x"}) &&
         find_channel(channels, channel.layer, channel.part, {"y"});
}

/// How surely a channel is depth: 0 surely, none: not.
int depth_rank(const std::vector<NamedChannel>& channels, const NamedChannel& channel) {
  const std::string name = small_letters(channel.name), layer = last_word(channel.layer);
  const auto is_one_of = [](const std::string& word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool in_depth = layer.starts_with("depth") || is_one_of(layer, {"z", "zdepth", "distance"});
  if (name == "z" && is_vector(channels, channel)) return -1;
  if (in_depth && is_one_of(name, {"z", "v", "y", "depth", "distance"})) return 0;
  if (is_one_of(name, {"z", "depth", "distance"})) return channel.layer.empty() ? 1 : 2;
  if (channel.layer.empty() && is_one_of(name, {"v", "d"})) return 3;
  if (channel.layer.empty() && name == "y" && !is_vector(channels, channel)) return 4;
  return -1;
}

}  // namespace

void append_channels(const std::vector<std::string>& names, const std::string& part_name, int part,
                     std::vector<NamedChannel>& channels) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t dot = names[i].rfind('.');
    const bool layered = dot != std::string::npos && dot + 1 < names[i].size();
    NamedChannel channel{layered ? names[i].substr(0, dot) : std::string(),
                         layered ? names[i].substr(dot + 1) : names[i], part, static_cast<int>(i)};
    if (!channel.layer.starts_with(part_name))
      channel.layer = channel.layer.empty() ? part_name : part_name + "." + channel.layer;
    channels.push_back(std::move(channel));
  }
}

ChosenChannels colour_channels(const std::vector<NamedChannel>& channels, const std::string& layer,
                               const std::string& file) {
  const std::vector<ColourLayer> layers = colour_layers(channels);
  const bool one_part = channels.empty() || channels.back().part == 0;
  if (!layer.empty()) {
    for (const ColourLayer& found : layers)
      if (found.name == layer) return found.channels;
    throw input_error({.file = file,
                       .field = request_name("layer"),
                       .wanted = layers.empty() ? "a layer with the channels R, G and B"
                                                : "one of the layers " + layers_text(layers),
                       .found = layers.empty() ? all_names_text(channels) : printable(layer)});
  }
  if (layers.empty()) {
    ChosenChannels all;
    const bool luminance = find_channel(channels, "", 0, {"ry"}) && find_channel(channels, "", 0, {"by"});
    const bool few = channels.size() < 3 && one_part;
    if (!few)
      throw input_error(
          {.file = file,
           .wanted = luminance ? "the channels R, G and B (convert it to these)" : "the channels R, G and B",
           .found = luminance ? "luminance and chroma, Y, RY and BY" : all_names_text(channels)});
    for (const NamedChannel& channel : channels) all.indices.push_back(channel.index);
    return all;
  }
  const ColourLayer* chosen = nullptr;
  for (const ColourLayer& found : layers)
    if (found.name.empty()) chosen = &found;
  if (!chosen && layers.size() == 1) chosen = layers.data();
  if (!chosen) chosen = usual_layer(layers);
  if (!chosen && !one_part) chosen = layers.data();
  if (!chosen)
    throw input_error({.file = file,
                       .field = request_name("layer"),
                       .wanted = "which of its layers is the picture",
                       .found = "the layers " + layers_text(layers)});
  ChosenChannels out = chosen->channels;
  if (layers.size() > 1)
    out.notes.push_back(fmt::format(
        "of its layers {} the picture is {} ({} names another)", layers_text(layers),
        chosen->name.empty() ? "the unnamed one" : printable(chosen->name), request_name("layer")));
  else if (!chosen->name.empty())
    out.notes.push_back(fmt::format("its picture is the layer {}", printable(chosen->name)));
  return out;
}

ChosenChannels depth_channel(const std::vector<NamedChannel>& channels, const std::string& named,
                             const std::string& file) {
  const auto one = [&](const NamedChannel& channel) {
    ChosenChannels chosen{channel.part, {channel.index}, -1, {}};
    if (channels.size() > 1)
      chosen.notes.push_back(fmt::format("depth is its channel {}", printable(channel.full())));
    return chosen;
  };
  if (!named.empty()) {
    for (const NamedChannel& channel : channels)
      if (channel.full() == named) return one(channel);
    throw input_error({.file = file,
                       .field = request_name("depth_channel"),
                       .wanted = "one of its channels",
                       .found = fmt::format("{} beside {}", printable(named), all_names_text(channels))});
  }
  if (channels.size() == 1) return one(channels.front());
  const NamedChannel* best = nullptr;
  int best_rank = -1;
  bool several = false;
  for (const NamedChannel& channel : channels) {
    const int rank = depth_rank(channels, channel);
    if (rank < 0 || (best && rank > best_rank)) continue;
    several = best && rank == best_rank;
    best = &channel;
    best_rank = rank;
  }
  if (best && !several) return one(*best);
  const std::vector<ColourLayer> layers = colour_layers(channels);
  if (!best && layers.size() == 1) return layers.front().channels;
  throw input_error({.file = file,
                     .field = request_name("depth_channel"),
                     .wanted = "the name of its channel of depth",
                     .found = all_names_text(channels)});
}

}  // namespace seamline
