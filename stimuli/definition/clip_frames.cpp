#include "stimuli/definition/clip_frames.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "stimuli/definition/moving/file_moment.h"
#include "support/arithmetic/random.h"

namespace seamline::inline stimuli {
namespace {

/// In a condition's name before the number of a frame.
constexpr char frame_mark = '@';
/// A moment that is meant to be a capture's own may have been rounded to just before it.
constexpr double just_captured = 1e-6;

/// The condition that a frame's is made of, and the frame's time.
struct FrameName {
  std::string condition;
  double time_s = 0;
};

FrameName frame_name(const StudyDefinition& study, const std::string& condition) {
  const std::size_t mark = condition.find(frame_mark);
  return {.condition = condition.substr(0, mark),
          .time_s = std::stoi(condition.substr(mark + 1)) / study.clip->frames_per_s};
}

DepthClock clock_of(const ClipDefinition& clip, const std::string& condition, const LevelDefinition& levels,
                    double level) {
  DepthClock clock = clip.clocks.at(condition);
  if (levels.quantity == Quantity::depth_frames_per_s) clock.frames_per_s = level;
  if (levels.quantity == Quantity::depth_delay_ms) clock.delay_ms = level;
  return clock;
}

const SceneDefinition& scene_of(const StudyDefinition& study, const Stimulus& stimulus) {
  const auto condition =
      std::find_if(study.conditions.begin(), study.conditions.end(),
                   [&](const ConditionDefinition& one) { return one.name == stimulus.condition; });
  return *std::find_if(condition->scenes.begin(), condition->scenes.end(),
                       [&](const SceneDefinition& one) { return one.name == stimulus.scene; });
}

/// What a depth camera sees of a scene when one object is virtual.
std::string real_meaning(SceneDefinition scene, int virtual_index) {
  scene.objects.erase(scene.objects.begin() + virtual_index - 1);
  return canonical_text(scene);
}

/// Stimuli of frames that have the same have the same picture: truth, artifact, object, isolation, depth, and
/// what the depth was captured of.
using PictureMeaning = std::tuple<std::string, Artifact, int, Isolation, DepthSettings, std::string>;

PictureMeaning picture_meaning(const StudyDefinition& frames, const Stimulus& stimulus) {
  const std::optional<SceneDefinition> captured = captured_scene(frames, stimulus);
  return {truth_of(stimulus),    stimulus.artifact,
          stimulus.object_index, stimulus.isolation,
          stimulus.depth,        captured ? real_meaning(*captured, stimulus.object_index) : std::string()};
}

}  // namespace

StudyDefinition still_study(const StudyDefinition& study) {
  if (!study.clip) return study;
  StudyDefinition frames = study;
  ClipDefinition clip = *study.clip;
  clip.are_conditions = true;
  frames.conditions.clear();
  for (const ConditionDefinition& condition : list_conditions(study))
    for (int frame = 0; frame < clip.frames; ++frame) {
      frames.conditions.push_back(condition);
      frames.conditions.back().name += fmt::format("{}{:03}", frame_mark, frame);
    }
  frames.clip = std::make_shared<const ClipDefinition>(std::move(clip));
  return frames;
}

bool is_of_frames(const StudyDefinition& study) {
  return study.clip && study.clip->are_conditions;
}

SceneDefinition scene_at(SceneDefinition scene, const StudyDefinition& study, double level, double time_s) {
  std::optional<double> speed_m_s;
  if (study.level.quantity == Quantity::object_speed_m_s) speed_m_s = level;
  const auto animate = [&](const std::string& object, std::string& file) {
    const auto animation = study.clip->animations.find({scene.name, object});
    if (animation != study.clip->animations.end())
      file = with_moment(file, {animation->second.name, animation_time_s(animation->second, time_s)});
  };
  animate("", scene.file);
  for (const auto& [place, motion] : study.clip->motions) {
    const std::optional<std::string> node = moved_node(place.second);
    if (place.first != scene.name || !node) continue;
    const PlacedNode start = node_of(scene.file, *node);
    const ObjectPose pose = pose_at(motion, {start.position_m, start.rotation_deg}, time_s, speed_m_s);
    scene.file = with_node(scene.file, {*node, pose.position_m, pose.rotation_deg});
  }
  if (const auto motion = study.clip->cameras.find(scene.name); motion != study.clip->cameras.end()) {
    const CameraKey key = camera_at(motion->second, time_s);
    scene.camera->position_m = key.position_m;
    scene.camera->look_at_m = key.look_at_m;
  }
  for (ObjectDefinition& object : scene.objects) {
    animate(object.name, object.file);
    const auto motion = study.clip->motions.find({scene.name, object.name});
    if (motion == study.clip->motions.end()) continue;
    const ObjectPose pose =
        pose_at(motion->second, {object.position_m, object.rotation_deg}, time_s, speed_m_s);
    object.position_m = pose.position_m;
    object.rotation_deg = pose.rotation_deg;
  }
  return scene;
}

SceneDefinition scene_of_frame(const StudyDefinition& frames, const std::string& condition,
                               SceneDefinition scene, double level) {
  return scene_at(std::move(scene), frames, level, frame_name(frames, condition).time_s);
}

std::optional<SceneDefinition> captured_scene(const StudyDefinition& frames, const Stimulus& stimulus) {
  if (!is_of_frames(frames)) return std::nullopt;
  const FrameName frame = frame_name(frames, stimulus.condition);
  const double then_s =
      capture_time_s(clock_of(*frames.clip, frame.condition, frames.level, stimulus.level), frame.time_s);
  if (then_s == frame.time_s) return std::nullopt;
  const SceneDefinition& scene = scene_of(frames, stimulus);
  SceneDefinition then = scene_at(scene, frames, stimulus.level, then_s);
  then.truth = stimulus.truth;
  const SceneDefinition now = scene_at(scene, frames, stimulus.level, frame.time_s);
  if (real_meaning(then, stimulus.object_index) == real_meaning(now, stimulus.object_index))
    return std::nullopt;
  return then;
}

DepthSettings depth_of_frame(const StudyDefinition& study, const std::string& condition, DepthSettings depth,
                             double level) {
  if (!is_of_frames(study) || !depth.chain || !has_noise(*depth.chain)) return depth;
  const FrameName frame = frame_name(study, condition);
  const DepthClock clock = clock_of(*study.clip, frame.condition, study.level, level);
  const double captures_per_s = clock.frames_per_s > 0 ? clock.frames_per_s : study.clip->frames_per_s;
  const std::int64_t capture =
      std::llround(std::floor(capture_time_s(clock, frame.time_s) * captures_per_s + just_captured));
  if (capture != 0) depth.chain->seed = mix_bits(depth.chain->seed + static_cast<std::uint64_t>(capture));
  return depth;
}

std::vector<Stimulus> without_twins(const StudyDefinition& frames, std::vector<Stimulus> stimuli) {
  std::set<PictureMeaning> seen;
  std::erase_if(stimuli,
                [&](const Stimulus& one) { return !seen.insert(picture_meaning(frames, one)).second; });
  return stimuli;
}

std::vector<Clip> list_clips(const StudyDefinition& study) {
  const StudyDefinition rendered = still_study(study);
  const std::vector<Stimulus> shown = list_stimuli(study);
  const std::vector<Stimulus> frames = list_every_stimulus(rendered);
  const std::size_t levels = study.level.values.size();
  const auto frames_of_clip = static_cast<std::size_t>(study.clip->frames);
  std::map<PictureMeaning, std::size_t> first;
  for (std::size_t i = 0; i < frames.size(); ++i) first.emplace(picture_meaning(rendered, frames[i]), i);
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    Clip clip{.shown = shown[i], .frames = {}};
    const std::size_t level = i % levels, before = i / levels * frames_of_clip;
    for (std::size_t frame = 0; frame < frames_of_clip; ++frame) {
      const Stimulus& one = frames.at((before + frame) * levels + level);
      clip.frames.push_back(frames[first.at(picture_meaning(rendered, one))]);
    }
    clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace seamline::inline stimuli
