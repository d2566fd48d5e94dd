#include "stimuli/study_file/study_file_depth.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string_view>

#include "stimuli/definition/methods/depth_file_names.h"
#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/study_file_depth_source.h"

namespace seamline::inline stimuli {
namespace {

constexpr int widest_panorama_px = 16384;

/// `repair`: a word, or a table whose `method` is the word, with that method's settings beside it.
void read_repair(const TomlTable& table, DepthChain& chain) {
  if (!table.has("repair") || table.is_text("repair")) return read_setting(table, "repair", chain);
  const TomlTable repair = *table.table("repair");
  if (!repair.has("method")) throw repair.missing("method", "the name of a repair");
  const auto& choice = std::get<Choice<DepthChain>>(setting<DepthChain>("repair").slot);
  choice.choose(chain, read_word(repair, "method", choice.words));
  std::visit([&](auto& method) { read_settings(repair, method); }, chain.repair);
  repair.finish();
}

void require_something_to_repair(const TomlTable& table, const DepthChain& chain) {
  if (!table.has("repair_after") || !chain.repair_after) return;
  if (std::holds_alternative<sensors::NoRepair>(chain.repair))
    throw table.complaint("repair_after", "a repair beside it", "repair = \"none\"");
  if (chain.registration == Registration::none)
    throw table.complaint("repair_after", "registration = \"points\" or \"mesh\", whose picture is repaired",
                          "registration = \"none\"");
}

/// The settings of a depth buffer stand in the same table.
void read_buffer(const TomlTable& table, DepthChain& chain) {
  if (chain.occlusion == Occlusion::depth_buffer)
    read_settings(table, chain.buffer);
  else
    refuse_settings<sensors::DepthBuffer>(table, "occlusion = \"depth_buffer\"",
                                          fmt::format("occlusion = \"{}\"", word(chain.occlusion)));
}

/// A test a pixel needs depth in the photograph's pixels.
void require_pixels_to_test(const TomlTable& table, const DepthChain& chain, const LevelDefinition& level) {
  if (!tests_pixels(chain.occlusion)) return;
  const bool level_moves =
      chain.registration == Registration::none &&
      (level.quantity == Quantity::calibration_error_m || level.quantity == Quantity::depth_delay_ms);
  if (is_in_photographs_place(chain) && !level_moves) return;
  throw table.complaint(
      "occlusion",
      "\"mesh\", or registration = \"points\" or \"mesh\": a pixel's depth is compared in the photograph",
      fmt::format("\"{}\" with a sensor elsewhere and no registration", word(chain.occlusion)));
}

/// Of clips the age of the depth is the clock's, and its camera stands still.
void move_to_clock(const TomlTable& table, DepthChain& chain, DepthClock& clock) {
  if (table.has("velocity_m_s"))
    throw table.complaint("velocity_m_s", "nothing in a study with [clip]: its camera stands still",
                          "a speed of the rig");
  clock.frames_per_s = table.number("frames_per_s", clock.frames_per_s, {0, 1000, "frames per second"});
  if (table.has("delay_ms")) clock.delay_ms = chain.delay_ms;
  chain.delay_ms = 0;
}

/// What a panorama from the photograph's own position cannot have is refused where it is said, and left out
/// where it is only inherited.
void keep_panorama_links(const TomlTable& table, bool is_clip, DepthChain& chain) {
  const DepthChain usual;
  const auto left_out = [&](const char* key, const char* wanted) {
    if (table.has(key)) throw table.complaint(key, wanted, "source = \"panorama\"");
  };
  if (chain.registration != Registration::none) {
    left_out("registration", "a pinhole or a file: a panorama is in the photograph's camera already");
    chain.registration = usual.registration;
  }
  if (chain.jumps == Jumps::layer) {
    left_out("jumps", "a pinhole or a file for \"layer\"");
    chain.jumps = Jumps::cut;
  }
  if (chain.guide == RepairGuide::photograph) {
    left_out("repair_guide", "a pinhole or a file: no photograph shows all of a panorama");
    chain.guide = usual.guide;
  }
  if (std::holds_alternative<sensors::PlaneRepair>(chain.repair)) {
    left_out("repair", "a pinhole or a file for \"planes\", which are flat in its picture only");
    chain.repair = usual.repair;
  }
  for (const char* key : {"calibration_error_deg", "calibration_error_m", "delay_ms", "velocity_m_s"})
    if (!is_clip || key != std::string_view("delay_ms"))
      left_out(key, "a pinhole or a file, which has a pose");
  chain.calibration_error_deg = chain.calibration_error_m = chain.delay_ms = 0;
  chain.velocity_m_s = usual.velocity_m_s;
}

/// Keys that would change nothing.
void refuse_idle(const TomlTable& table, const DepthChain& chain, const LevelDefinition& level) {
  const bool moves = chain.velocity_m_s != std::array<double, 3>{0, 0, 0};
  if (table.has("delay_ms") && chain.delay_ms != 0 && !moves)
    throw table.complaint("delay_ms", "velocity_m_s beside it: late depth of a rig at rest is the same",
                          "none");
  if (table.has("velocity_m_s") && chain.delay_ms == 0 && level.quantity != Quantity::depth_delay_ms)
    throw table.complaint("velocity_m_s", "delay_ms beside it", "none");
  if (table.has("noise_sigmas") && !has_noise(chain))
    throw table.complaint("noise_sigmas", "a source with noise", "none");
}

/// What samples that are spent unevenly cannot have; there is no other than the mesh that they make.
void refuse_beside_budget(const TomlTable& table, const DepthChain& chain, const LevelDefinition& level) {
  if (!is_budgeted(chain)) return;
  const auto& source = std::get<PanoramaSource>(chain.sources.front());
  const std::string beside = fmt::format(" beside reduction = \"{}\"", word(source.reduction));
  const auto refuse = [&](bool is, const char* key, const char* wanted, const std::string& found) {
    if (is) throw table.complaint(key, wanted + beside, found);
  };
  refuse(source.noise.has_value(), "noise", "no noise", "a model");
  refuse(source.range != sensors::SensorRange{}, "range_m", "no range", "one");
  refuse(chain.jumps != Jumps::stretch, "jumps", "\"stretch\"", fmt::format("\"{}\"", word(chain.jumps)));
  refuse(!std::holds_alternative<sensors::NoRepair>(chain.repair), "repair", "\"none\"",
         fmt::format("\"{}\"", word(chain.repair)));
  refuse(level.quantity == Quantity::mesh_tolerance, "reduction", "another level than mesh_tolerance",
         "a mesh that is made of its samples");
}

/// Of the table `depth`, or of one source.
void refuse_levels(const TomlTable& table, Quantity level) {
  if (level == Quantity::depth_frames_per_s && table.has("frames_per_s"))
    throw table.complaint("frames_per_s", "nothing, because depth_frames_per_s is the level",
                          "a setting of its own");
  refuse_level<DepthChain>(table, level);
  refuse_level<sensors::PinholeCamera>(table, level);
  refuse_level<FileEstimate>(table, level);
  if (!table.has("noise") || table.is_text("noise")) return;
  const TomlTable noise = *table.table("noise");
  refuse_level<SourceNoise>(noise, level);
  refuse_level<sensors::Outliers>(noise, level);
}

}  // namespace

std::optional<DepthChain> read_depth_chain(const TomlTable& settings, const std::optional<DepthChain>& usual,
                                           const LevelDefinition& level, std::uint64_t seed,
                                           DepthClock* clock) {
  const std::optional<TomlTable> table = settings.table("depth");
  if (!table) return usual;
  DepthChain chain = usual.value_or(DepthChain{});
  refuse_levels(*table, level.quantity);
  if (table->has("source") && !table->is_text("source"))
    for (const TomlTable& one : table->tables("source")) refuse_levels(one, level.quantity);
  chain.sources = read_sources(*table, chain.sources, level.quantity);
  read_repair(*table, chain);
  read_settings(*table, chain);
  read_buffer(*table, chain);
  if (clock != nullptr) move_to_clock(*table, chain, *clock);
  require_something_to_repair(*table, chain);
  chain.seed = seed;
  if (is_panorama(chain)) keep_panorama_links(*table, clock != nullptr, chain);
  refuse_idle(*table, chain, level);
  require_pixels_to_test(*table, chain, level);
  refuse_beside_budget(*table, chain, level);
  table->finish();
  // What is the level needs what `meaningful` drops beside a delay or an error of 0.
  const std::array<double, 3> velocity_m_s = chain.velocity_m_s;
  std::optional<DepthChain> kept = meaningful(std::move(chain));
  if (kept && level.quantity == Quantity::depth_delay_ms && clock == nullptr)
    kept->velocity_m_s = velocity_m_s;
  if (kept &&
      (level.quantity == Quantity::calibration_error_deg || level.quantity == Quantity::calibration_error_m))
    kept->seed = seed;
  return kept;
}

void require_level_in_chain(const TomlTable& settings, const std::optional<DepthChain>& chain, int width_px,
                            const LevelDefinition& level, bool is_clip) {
  const auto wanted = [&](const std::string& what, const std::string& found) {
    return settings.complaint(
        "depth", fmt::format("{}, because {} is the level", what, facts(level.quantity).key), found);
  };
  const bool sensor = chain && !is_panorama(*chain);
  const auto require_sizes = [&](const auto& camera_at) {
    if (!sensor || chain->sources.size() != 1 ||
        !std::holds_alternative<PinholeSource>(chain->sources.front()))
      throw wanted("one pinhole", sensor ? "other sources" : "a panorama");
    for (const double value : level.values) {
      const sensors::PinholeCamera camera = camera_at(*camera_of(chain->sources.front()), value);
      if (camera.width_px < 2 || camera.height_px < 2 || camera.width_px > 8192 || camera.height_px > 8192)
        throw wanted(fmt::format("a depth map of 2 to 8192 pixels at {}", level_text(level.quantity, value)),
                     fmt::format("{} x {}", camera.width_px, camera.height_px));
    }
  };
  const auto require_captured = [&] {
    if (chain && !sensor && is_estimated(*chain))
      throw wanted("a panorama that is captured at any width", "one that lies in a file");
  };
  switch (level.quantity) {
    case Quantity::depth_width_px:
    case Quantity::depth_samples:
      if (sensor) throw wanted("a panorama", "a " + std::string(kind_of(chain->sources.front())));
      require_captured();
      break;
    case Quantity::texels_per_degree:
      if (sensor) require_sizes(with_texels_per_degree);
      require_captured();
      break;
    case Quantity::estimate_share:
      if (!chain || !is_estimated(*chain)) throw wanted("source = \"file\" or \"stereo\"", "exact depth");
      break;
    case Quantity::depth_noise:
    case Quantity::outlier_share:
      if (!chain || !has_noise(*chain)) throw wanted("a source with a noise model", "none");
      break;
    case Quantity::calibration_error_deg:
    case Quantity::calibration_error_m:
      if (!sensor) throw wanted("a pinhole or a file, which has a pose", "a panorama");
      break;
    case Quantity::depth_delay_ms:
      if (is_clip) break;
      if (!sensor || chain->velocity_m_s == std::array<double, 3>{0, 0, 0})
        throw wanted("a pinhole or a file with velocity_m_s", sensor ? "a rig at rest" : "a panorama");
      break;
    case Quantity::depth_field_of_view_deg:
      require_sizes(with_field_of_view);
      break;
    case Quantity::mesh_tolerance:
    case Quantity::sun_radius_deg:
    case Quantity::shadow_map_px:
    case Quantity::shadow_bias_texels:
    case Quantity::light_count:
    case Quantity::field_bands:
    case Quantity::field_shells:
    case Quantity::object_speed_m_s:
    case Quantity::depth_frames_per_s:
      break;
  }
  if (!chain || sensor) return;
  const int factor = std::get<PanoramaSource>(chain->sources.front()).reduction_factor;
  const double widest_px = width_px > 0                                    ? width_px
                           : level.quantity == Quantity::texels_per_degree ? level.values.back() * 360
                           : level.quantity == Quantity::depth_samples ? std::sqrt(2 * level.values.back())
                                                                       : level.values.back();
  if (factor * widest_px > widest_panorama_px)
    throw settings.complaint("depth.reduction_factor",
                             fmt::format("a finer map of at most {} px", widest_panorama_px),
                             fmt::format("{} x {} px", factor, widest_px));
}

namespace {

/// A file, or one for each stimulus that names it: then the path keeps the places of the names.
template <class File>
void find_depth_file(File& file, const StudyDefinition& study, const AssetFolders& folders) {
  if (!is_named_by_stimulus(file.file)) {
    file.path = resolve_asset(file.file, folders, "depth.file");
    return;
  }
  for (const SceneDefinition& scene : study.scenes)
    for (const ObjectDefinition& object : scene.objects) {
      const std::string name = depth_file_name(file.file, scene.name, object.name);
      const std::string found = resolve_asset(name, folders, "depth.file").string();
      const std::filesystem::path path = found.substr(0, found.size() - name.size()) + file.file;
      if (!file.path.empty() && file.path != path)
        throw input_error({.file = folders.study_file.string(),
                           .field = "depth.file",
                           .wanted = "all of its files in one folder",
                           .found = found + " in another"});
      file.path = path;
    }
}

}  // namespace

void find_depth_files(StudyDefinition& study, const AssetFolders& folders) {
  const auto find = [&](std::optional<DepthChain>& chain) {
    if (!chain) return;
    for (DepthSource& source : chain->sources) {
      if (auto* panorama = std::get_if<PanoramaSource>(&source); panorama != nullptr && panorama->file)
        find_depth_file(*panorama->file, study, folders);
      if (auto* file = std::get_if<FileSource>(&source)) find_depth_file(*file, study, folders);
    }
  };
  find(study.depth.chain);
  for (ConditionDefinition& condition : study.conditions) find(condition.depth.chain);
}

}  // namespace seamline::inline stimuli
