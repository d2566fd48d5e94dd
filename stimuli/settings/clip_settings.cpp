#include "stimuli/settings/clip_settings.h"

namespace seamline::inline stimuli {
namespace {

std::string motion_text(const ObjectMotion& motion) {
  const auto* keyed = std::get_if<KeyedMotion>(&motion);
  if (keyed == nullptr) return std::visit([](const auto& one) { return settings_text(one); }, motion);
  std::string text = "keys";
  for (const MotionKey& key : keyed->keys) text += settings_text(key) + settings_text(key.pose);
  return text;
}

}  // namespace

std::string_view word(ClipQuestion question) {
  return word_of(question);
}

std::string canonical_text(const ClipDefinition& clip) {
  std::string text = settings_text(clip);
  for (const auto& [object, motion] : clip.motions)
    text += fmt::format("path {} {} {}\n", object.first, object.second, motion_text(motion));
  for (const auto& [object, animation] : clip.animations)
    text += fmt::format("animation {} {} \"{}\" from {} to {}{} speed {}\n", object.first, object.second,
                        animation.name, animation.from_s,
                        animation.to_s ? fmt::format("{}", *animation.to_s) : std::string("its end"),
                        animation.repeats ? " again and again" : "", animation.speed);
  for (const auto& [scene, motion] : clip.cameras) {
    text += fmt::format("camera of {}", scene);
    for (const CameraKey& key : motion.keys) text += settings_text(key);
    text += "\n";
  }
  for (const auto& [condition, clock] : clip.clocks)
    if (clock != DepthClock{})
      text +=
          fmt::format("depth clock {} {} per s late {} ms\n", condition, clock.frames_per_s, clock.delay_ms);
  return text;
}

}  // namespace seamline::inline stimuli
