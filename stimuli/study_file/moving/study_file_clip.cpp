#include "stimuli/study_file/moving/study_file_clip.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/settings/clip_settings.h"
#include "stimuli/settings/read_settings.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::size_t most_keys = 1000;

LineMotion read_line(const TomlTable& path, const Eigen::Vector3d& position_m, Quantity level) {
  LineMotion line;
  refuse_level<LineMotion>(path, level);
  read_settings(path, line);
  if ((line.to_m - position_m).norm() < 1e-6)
    throw path.complaint("to_m", "another place than the object's position_m", "the same");
  if (!path.has("speed_m_s") && level != Quantity::object_speed_m_s)
    throw path.missing("speed_m_s", "a speed, because the level is another quantity");
  return line;
}

/// The keys of a path, which rise. `read` fills one from its table.
template <class Key, class Read>
std::vector<Key> read_keys(const TomlTable& path, const Read& read) {
  std::vector<Key> keys;
  for (const TomlTable& one : path.tables("keys")) {
    Key key;
    read(one, key);
    one.finish();
    if (!keys.empty() && key.time_s <= keys.back().time_s)
      throw one.complaint("time_s",
                          fmt::format("a time after {} s, that of the key before", keys.back().time_s),
                          fmt::format("{} s", key.time_s));
    keys.push_back(key);
  }
  if (keys.size() < 2 || keys.size() > most_keys)
    throw path.complaint("keys", fmt::format("2 to {} keys", most_keys), fmt::format("{}", keys.size()));
  return keys;
}

/// Or down, or nowhere.
bool looks_straight_up(const CameraKey& key) {
  const Eigen::Vector3d view = key.look_at_m - key.position_m;
  return view.cross(Eigen::Vector3d::UnitY()).norm() <= 1e-9 * view.norm();
}

KeyedMotion read_keyed(const TomlTable& path) {
  return {read_keys<MotionKey>(path, [](const TomlTable& one, MotionKey& key) {
    read_settings(one, key);
    read_settings(one, key.pose);
  })};
}

/// Why a condition's pictures cannot be frames of a clip: key, wanted, found.
struct ClipRefusal {
  const char* key;
  std::string wanted, found;
};

/// Whether the sensor may be where it is not believed to be; that is drawn once, by the seed of the noise.
bool has_calibration_error(const DepthChain& chain, Quantity level) {
  return chain.calibration_error_deg > 0 || chain.calibration_error_m > 0 ||
         level == Quantity::calibration_error_deg || level == Quantity::calibration_error_m;
}

std::optional<ClipRefusal> refusal_of(const ConditionDefinition& condition, Quantity level) {
  if (condition.task) return ClipRefusal{"task", "the task \"object\" in a study with [clip]", "another one"};
  if (condition.look) return ClipRefusal{"look", "one fixed view in a study with [clip]", "[look]"};
  for (const SceneDefinition& scene : condition.scenes)
    if (!scene.view.is_mono())
      return ClipRefusal{"view", "pictures for one eye in a study with [clip]", "another view"};
  if (!condition.depth.chain) return std::nullopt;
  if (has_noise(*condition.depth.chain) && has_calibration_error(*condition.depth.chain, level))
    return ClipRefusal{"depth",
                       "noise or an error of calibration in a study with [clip], because one seed draws both "
                       "and noise is new in every frame",
                       "both"};
  for (const DepthSource& source : condition.depth.chain->sources)
    if (std::holds_alternative<FileSource>(source) || is_estimated(source))
      return ClipRefusal{
          "depth", "a captured panorama or a pinhole in a study with [clip]: an estimate shows one moment",
          "a file or stereo"};
  return std::nullopt;
}

bool some_line_moves(const ClipDefinition& clip, const std::string& scene) {
  return std::any_of(clip.motions.begin(), clip.motions.end(), [&](const auto& one) {
    return one.first.first == scene && std::holds_alternative<LineMotion>(one.second);
  });
}

/// Whether the noise of a depth camera moves what stands still.
bool some_depth_boils(const StudyDefinition& study) {
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  return std::any_of(conditions.begin(), conditions.end(), [](const ConditionDefinition& one) {
    return one.depth.chain && has_noise(*one.depth.chain);
  });
}

/// A late depth map would be of another place than the photograph.
void check_cameras(const TomlTable& table, const StudyDefinition& study) {
  const ClipDefinition& clip = *study.clip;
  if (clip.cameras.empty()) return;
  const Quantity level = study.level.quantity;
  const bool is_late = std::any_of(clip.clocks.begin(), clip.clocks.end(),
                                   [](const auto& one) { return one.second != DepthClock{}; });
  if (is_late || level == Quantity::depth_delay_ms || level == Quantity::depth_frames_per_s)
    throw table.complaint("scene.camera.path", "depth of the picture's own moment beside a camera that moves",
                          "late or held depth");
  for (const auto& [scene, motion] : clip.cameras)
    for (int frame = 0; frame < clip.frames; ++frame) {
      const CameraKey key = camera_at(motion, frame / clip.frames_per_s);
      if (looks_straight_up(key))
        throw table.complaint("scene.camera.path", "a camera that never looks straight up, down or at itself",
                              fmt::format("one that does in frame {} of the scene \"{}\"", frame, scene));
    }
}

void check_motions(const TomlTable& table, const StudyDefinition& study) {
  const ClipDefinition& clip = *study.clip;
  if (clip.motions.empty() && clip.animations.empty() && clip.cameras.empty() && !some_depth_boils(study))
    throw table.complaint(
        "clip",
        "an object with a path, an animation, or a camera with a path in some scene, or depth with noise",
        "nothing of these");
  check_cameras(table, study);
  for (const SceneDefinition& scene : study.scenes) {
    if (study.level.quantity == Quantity::object_speed_m_s && !some_line_moves(clip, scene.name))
      throw table.complaint("level.quantity", "an object on a line in every scene",
                            "none in the scene \"" + scene.name + "\"");
    for (const ObjectDefinition& object : scene.objects)
      if (object.rest && (clip.motions.contains({scene.name, object.name}) ||
                          clip.animations.contains({scene.name, object.name})))
        throw table.complaint("scene.object.rest", "one of rest and path, or of rest and animation",
                              "both of the object \"" + object.name + "\"");
  }
}

}  // namespace

ClipDefinition read_clip(const TomlTable& table) {
  ClipDefinition clip;
  read_settings(table, clip);
  table.finish();
  if (clip.question == ClipQuestion::after && clip.loops)
    throw table.complaint("question", "plays = \"once\" beside \"after\": a loop has no end",
                          "plays = \"loop\"");
  return clip;
}

ObjectMotion read_motion(const TomlTable& path, const Eigen::Vector3d& position_m, Quantity level) {
  ObjectMotion motion;
  settings::set_place(motion, read_word(path, "kind", words_of<ObjectMotion>));
  if (std::holds_alternative<LineMotion>(motion)) motion = read_line(path, position_m, level);
  if (auto* turn = std::get_if<TurnMotion>(&motion)) read_settings(path, *turn);
  if (std::holds_alternative<KeyedMotion>(motion)) motion = read_keyed(path);
  path.finish();
  return motion;
}

FileAnimation read_animation(const TomlTable& animation, const std::string& file) {
  const NamedFile named = split_moment(file);
  if (named.moment && named.moment->is_animated)
    throw animation.complaint("name", "a file without a moment beside `animation`, which says the moment",
                              "\"" + file + "\"");
  FileAnimation out;
  read_settings(animation, out);
  animation.finish();
  if (out.to_s && *out.to_s <= out.from_s)
    throw animation.complaint("to_s", fmt::format("a time after from_s, {} s", out.from_s),
                              fmt::format("{} s", *out.to_s));
  if (out.repeats && !out.to_s) throw animation.missing("to_s", "where in the animation it begins anew");
  return out;
}

CameraMotion read_camera_motion(const TomlTable& path) {
  if (const std::string kind = path.text("kind"); kind != "keys")
    throw path.complaint("kind", "\"keys\" for a camera", "\"" + kind + "\"");
  CameraMotion motion{read_keys<CameraKey>(path, [](const TomlTable& one, CameraKey& key) {
    read_settings(one, key);
    if (looks_straight_up(key))
      throw one.complaint("look_at_m", "a point that is not straight above, below or at the camera",
                          "no such point");
  })};
  path.finish();
  return motion;
}

void check_clip(const TomlTable& table, const StudyDefinition& study) {
  const Quantity level = study.level.quantity;
  if (!study.clip) {
    if (level == Quantity::object_speed_m_s || level == Quantity::depth_frames_per_s)
      throw table.complaint("clip", fmt::format("a table [clip], because {} is the level", facts(level).key),
                            "nothing");
    return;
  }
  for (const ConditionDefinition& condition : list_conditions(study))
    if (const auto why = refusal_of(condition, level))
      throw table.complaint(why->key, why->wanted, why->found);
  if (study.look) throw table.complaint("look", "one fixed view in a study with [clip]", "[look]");
  if (is_panorama(study))
    throw table.complaint("scene.camera.projection", "\"perspective\" in a study with [clip]",
                          "\"panorama\"");
  check_motions(table, study);
  const std::size_t frames = list_stimuli(study).size() * static_cast<std::size_t>(study.clip->frames);
  if (frames > static_cast<std::size_t>(limits::most_stimuli))
    throw table.complaint("clip.frames",
                          fmt::format("at most {} frames of all stimuli", limits::most_stimuli),
                          fmt::format("{}", frames));
}

}  // namespace seamline::inline stimuli
