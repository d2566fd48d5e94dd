#include "stimuli/study_file/study_file_depth.h"

#include <fmt/core.h>

#include <array>

#include "stimuli/study_file/study_file_depth_source.h"
#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

constexpr int widest_panorama_px = 16384;

sensors::RepairMethod read_repair(const TomlTable& table, const sensors::RepairMethod& usual) {
  using namespace sensors;
  if (!table.has("repair")) return usual;
  static const Words<RepairMethod> words = {{"none", NoRepair{}},
                                            {"nearest", NearestRepair{}},
                                            {"median", MedianRepair{}},
                                            {"joint_bilateral", JointBilateralRepair{}},
                                            {"planes", PlaneRepair{}}};
  if (table.is_text("repair")) return one_of<RepairMethod>(table, "repair", usual, words);
  const TomlTable repair = *table.table("repair");
  if (!repair.has("method")) throw repair.complaint("method", "the name of a repair", "nothing");
  RepairMethod method = one_of<RepairMethod>(repair, "method", usual, words);
  constexpr Range window{1, 50, "px"}, positive{1e-9, 1e9};
  if (auto* median = std::get_if<MedianRepair>(&method)) {
    median->radius_px = repair.integer("radius_px", median->radius_px, window);
    median->fills = repair.boolean("fills", median->fills);
  }
  if (auto* bilateral = std::get_if<JointBilateralRepair>(&method)) {
    bilateral->radius_px = repair.integer("radius_px", bilateral->radius_px, window);
    bilateral->sigma_px = repair.number("sigma_px", bilateral->sigma_px, positive);
    bilateral->sigma_colour = repair.number("sigma_colour", bilateral->sigma_colour, positive);
    bilateral->fills = repair.boolean("fills", bilateral->fills);
    bilateral->least_weight = repair.number("least_weight", bilateral->least_weight, positive);
  }
  if (auto* planes = std::get_if<PlaneRepair>(&method)) {
    planes->most_planes = repair.integer("most_planes", planes->most_planes, {1, 100});
    planes->least_share = repair.number("least_share", planes->least_share, {1e-6, 1});
    planes->tolerance_m = repair.number("tolerance_m", planes->tolerance_m, {1e-9, 1e3, "m"});
    planes->tolerance_relative = repair.number("tolerance_relative", planes->tolerance_relative, {0, 1});
    planes->draws = repair.integer("draws", planes->draws, {1, 100000});
    planes->seed =
        static_cast<std::uint64_t>(repair.integer("seed", static_cast<int>(planes->seed), {0, 2147483647}));
  }
  repair.finish();
  return method;
}

/// What says how a repair is done, beside its method.
void read_repair_order(const TomlTable& table, DepthChain& chain) {
  const bool guided = std::holds_alternative<sensors::JointBilateralRepair>(chain.repair);
  if (table.has("repair_guide") && !guided)
    throw table.complaint("repair_guide", "repair = \"joint_bilateral\"",
                          fmt::format("repair = \"{}\"", word(chain.repair)));
  chain.guide =
      one_of<RepairGuide>(table, "repair_guide", chain.guide,
                          {{"own_light", RepairGuide::own_light}, {"photograph", RepairGuide::photograph}});
  chain.repair_after = table.boolean("repair_after", chain.repair_after);
  if (!table.has("repair_after") || !chain.repair_after) return;
  if (std::holds_alternative<sensors::NoRepair>(chain.repair))
    throw table.complaint("repair_after", "a repair beside it", "repair = \"none\"");
  if (chain.registration == Registration::none)
    throw table.complaint("repair_after", "registration = \"points\" or \"mesh\", whose picture is repaired",
                          "registration = \"none\"");
}

void read_jumps(const TomlTable& table, DepthChain& chain) {
  chain.jumps = one_of<Jumps>(table, "jumps", chain.jumps,
                              {{"stretch", Jumps::stretch}, {"cut", Jumps::cut}, {"layer", Jumps::layer}});
  if (table.has("jump_ratio")) {
    if (chain.jumps == Jumps::stretch)
      throw table.complaint("jump_ratio", "jumps = \"cut\" or \"layer\": sheets have no ratio",
                            "jumps = \"stretch\"");
    chain.jump_ratio = table.number("jump_ratio", chain.jump_ratio, {-1e6, 1e6});
    if (!(chain.jump_ratio > 1))
      throw table.complaint("jump_ratio", "a ratio above 1", fmt::format("{}", chain.jump_ratio));
  }
  if (table.has("layer_px") && chain.jumps != Jumps::layer)
    throw table.complaint("layer_px", "jumps = \"layer\"", fmt::format("jumps = \"{}\"", word(chain.jumps)));
  chain.layer_px = table.integer("layer_px", chain.layer_px, {1, 1024, "px"});
}

void read_registration(const TomlTable& table, DepthChain& chain) {
  chain.registration = one_of<Registration>(
      table, "registration", chain.registration,
      {{"none", Registration::none}, {"points", Registration::points}, {"mesh", Registration::mesh}});
  if (table.has("border_extrusion_px") && chain.registration != Registration::mesh)
    throw table.complaint("border_extrusion_px", "registration = \"mesh\"",
                          fmt::format("registration = \"{}\"", word(chain.registration)));
  chain.border_extrusion_px = table.integer("border_extrusion_px", chain.border_extrusion_px, {0, 64, "px"});
}

constexpr std::array buffer_keys = {"buffer_bits", "buffer_near_m", "buffer_far_m"};

void read_occlusion(const TomlTable& table, DepthChain& chain) {
  const auto* usual = std::get_if<sensors::DepthBuffer>(&chain.occlusion);
  const sensors::DepthBuffer usual_buffer = usual != nullptr ? *usual : sensors::DepthBuffer{};
  chain.occlusion = one_of<OcclusionMethod>(
      table, "occlusion", chain.occlusion,
      {{"mesh", MeshOcclusion{}}, {"depth_test", DepthTestOcclusion{}}, {"depth_buffer", usual_buffer}});
  auto* buffer = std::get_if<sensors::DepthBuffer>(&chain.occlusion);
  if (buffer == nullptr) {
    for (const char* key : buffer_keys)
      if (table.has(key))
        throw table.complaint(key, "occlusion = \"depth_buffer\"",
                              fmt::format("occlusion = \"{}\"", word(chain.occlusion)));
    return;
  }
  buffer->bits = table.integer("buffer_bits", buffer->bits, {8, 32, "bits"});
  buffer->nearest_m = table.number("buffer_near_m", buffer->nearest_m, {1e-6, 1e9, "m"});
  buffer->farthest_m = table.number("buffer_far_m", buffer->farthest_m, {1e-6, 1e9, "m"});
  if (!(buffer->nearest_m < buffer->farthest_m))
    throw table.complaint("buffer_far_m", fmt::format("a plane beyond buffer_near_m = {}", buffer->nearest_m),
                          fmt::format("{}", buffer->farthest_m));
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

void read_displacement(const TomlTable& table, DepthChain& chain) {
  chain.calibration_error_deg =
      table.number("calibration_error_deg", chain.calibration_error_deg, {0, 45, "degrees"});
  chain.calibration_error_m = table.number("calibration_error_m", chain.calibration_error_m, {0, 10, "m"});
  chain.delay_ms = table.number("delay_ms", chain.delay_ms, {0, 10000, "ms"});
  chain.velocity_m_s = table.triple("velocity_m_s", chain.velocity_m_s, {-1e3, 1e3, "m/s"});
}

/// What a panorama from the photograph's own position cannot have is refused where it is said, and left out
/// where it is only inherited.
void keep_panorama_links(const TomlTable& table, DepthChain& chain) {
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

void refuse_level_of_depth(const TomlTable& table, const LevelDefinition& level) {
  const auto refuse = [&](const char* key) {
    if (table.has(key))
      throw table.complaint(key, fmt::format("nothing, because {} is the level", facts(level.quantity).key),
                            "a setting of its own");
  };
  switch (level.quantity) {
    case Quantity::calibration_error_deg:
      return refuse("calibration_error_deg");
    case Quantity::calibration_error_m:
      return refuse("calibration_error_m");
    case Quantity::depth_delay_ms:
      return refuse("delay_ms");
    case Quantity::depth_field_of_view_deg:
      return refuse("field_of_view_deg");
    case Quantity::texels_per_degree:
      return refuse("texels_per_degree");
    case Quantity::depth_noise:     // noise.scale: see read_noise
    case Quantity::outlier_share:   // noise.outlier_share
    case Quantity::depth_width_px:  // no key of this table
    case Quantity::mesh_tolerance:
    case Quantity::sun_radius_deg:
    case Quantity::shadow_map_px:
    case Quantity::shadow_bias_texels:
    case Quantity::light_count:
    case Quantity::field_bands:
    case Quantity::field_shells:
      return;
  }
}

void refuse_level_of_noise(const TomlTable& table, const LevelDefinition& level) {
  if (!table.has("noise") || table.is_text("noise")) return;
  const TomlTable noise = *table.table("noise");
  const char* key = level.quantity == Quantity::depth_noise     ? "scale"
                    : level.quantity == Quantity::outlier_share ? "outlier_share"
                                                                : nullptr;
  if (key != nullptr && noise.has(key))
    throw noise.complaint(key, fmt::format("nothing, because {} is the level", facts(level.quantity).key),
                          "a setting of its own");
}

}  // namespace

std::optional<DepthChain> read_depth_chain(const TomlTable& settings, const std::optional<DepthChain>& usual,
                                           const LevelDefinition& level, std::uint64_t seed) {
  const std::optional<TomlTable> table = settings.table("depth");
  if (!table) return usual;
  DepthChain chain = usual.value_or(DepthChain{});
  refuse_level_of_depth(*table, level);
  refuse_level_of_noise(*table, level);
  if (table->has("source") && !table->is_text("source"))
    for (const TomlTable& one : table->tables("source")) {
      refuse_level_of_depth(one, level);
      refuse_level_of_noise(one, level);
    }
  chain.sources = read_sources(*table, chain.sources);
  chain.repair = read_repair(*table, chain.repair);
  read_registration(*table, chain);
  read_repair_order(*table, chain);
  read_jumps(*table, chain);
  read_occlusion(*table, chain);
  read_displacement(*table, chain);
  chain.noise_sigmas = table->number("noise_sigmas", chain.noise_sigmas, {0, 100});
  chain.seed = seed;
  if (is_panorama(chain)) keep_panorama_links(*table, chain);
  refuse_idle(*table, chain, level);
  require_pixels_to_test(*table, chain, level);
  table->finish();
  // What is the level needs what `meaningful` drops beside a delay or an error of 0.
  const std::array<double, 3> velocity_m_s = chain.velocity_m_s;
  std::optional<DepthChain> kept = meaningful(std::move(chain));
  if (kept && level.quantity == Quantity::depth_delay_ms) kept->velocity_m_s = velocity_m_s;
  if (kept &&
      (level.quantity == Quantity::calibration_error_deg || level.quantity == Quantity::calibration_error_m))
    kept->seed = seed;
  return kept;
}

void require_level_in_chain(const TomlTable& settings, const std::optional<DepthChain>& chain, int width_px,
                            const LevelDefinition& level) {
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
  switch (level.quantity) {
    case Quantity::depth_width_px:
      if (sensor) throw wanted("a panorama", "a " + std::string(kind_of(chain->sources.front())));
      break;
    case Quantity::texels_per_degree:
      if (sensor) require_sizes(with_texels_per_degree);
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
      break;
  }
  if (!chain || sensor) return;
  const int factor = std::get<PanoramaSource>(chain->sources.front()).reduction_factor;
  const double widest_px = width_px > 0                                    ? width_px
                           : level.quantity == Quantity::texels_per_degree ? level.values.back() * 360
                                                                           : level.values.back();
  if (factor * widest_px > widest_panorama_px)
    throw settings.complaint("depth.reduction_factor",
                             fmt::format("a finer map of at most {} px", widest_panorama_px),
                             fmt::format("{} x {} px", factor, widest_px));
}

void find_depth_files(StudyDefinition& study, const AssetFolders& folders) {
  const auto find = [&](std::optional<DepthChain>& chain) {
    if (!chain) return;
    for (DepthSource& source : chain->sources)
      if (auto* file = std::get_if<FileSource>(&source))
        file->path = resolve_asset(file->file, folders, "depth.file");
  };
  find(study.depth.chain);
  for (ConditionDefinition& condition : study.conditions) find(condition.depth.chain);
}

}  // namespace seamline::inline stimuli
