#include "raytracer/scene/animation_times.h"

#include <string>
#include <utility>

namespace seamline::renderer {
namespace {

constexpr int steps_a_second = 60, most_steps = 3600 * steps_a_second;  ///< after that, keys alone

/// The targets of its channels that place nodes, each with the channel.
std::vector<std::pair<const GltfJson*, const GltfJson*>> placing_channels(const GltfJson& animation) {
  std::vector<std::pair<const GltfJson*, const GltfJson*>> out;
  const GltfJson* channels = member(animation, "channels");
  if (channels == nullptr || !channels->is_array()) return out;
  for (const GltfJson& channel : *channels) {
    const GltfJson* target = member(channel, "target");
    if (target == nullptr || !target->is_object()) continue;
    const std::string path = text_of(*target, "path");
    if (path == "translation" || path == "rotation" || path == "scale") out.emplace_back(target, &channel);
  }
  return out;
}

}  // namespace

std::set<std::int64_t> animated_nodes(const GltfJson& animation) {
  std::set<std::int64_t> nodes;
  for (const auto& [target, channel] : placing_channels(animation))
    nodes.insert(whole_number(*target, "node", -1));
  return nodes;
}

std::vector<double> animation_times_s(const GltfJson& animation, const GltfReader& reader) {
  std::set<double> times_s;
  bool bends = false;
  const GltfJson* samplers = member(animation, "samplers");
  for (const auto& [target, channel] : placing_channels(animation)) {
    const std::int64_t number = whole_number(*channel, "sampler", -1);
    if (samplers == nullptr || number < 0 || !std::cmp_less(number, samplers->size())) continue;
    const GltfJson& sampler = (*samplers)[static_cast<std::size_t>(number)];
    const std::string by = text_of(sampler, "interpolation");
    bends = bends || by == "STEP" || by == "CUBICSPLINE";
    const std::int64_t input = whole_number(sampler, "input", -1);
    for (const double time_s :
         reader.numbers(std::in_range<int>(input) ? static_cast<int>(input) : -1, 1, "animation"))
      times_s.insert(time_s);
  }
  if (bends && times_s.size() > 1) {
    const double first_s = *times_s.begin(), last_s = *times_s.rbegin();
    for (int i = 1; i < most_steps && first_s + static_cast<double>(i) / steps_a_second < last_s; ++i)
      times_s.insert(first_s + static_cast<double>(i) / steps_a_second);
  }
  return {times_s.begin(), times_s.end()};
}

}  // namespace seamline::renderer
