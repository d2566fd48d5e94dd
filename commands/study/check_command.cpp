#include "commands/study/study_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "commands/photographs/asset_root_option.h"
#include "raytracer/scene/eyes.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "sets/check.h"
#include "sets/pages/artists_map.h"
#include "sets/pages/clip_seams.h"
#include "sets/pages/seams_page.h"
#include "sets/set_seams.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/set/level_notes.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/markdown_table.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct CheckOptions {
  std::string path, asset_root, out;
  bool artists = false;
  std::optional<int> coarse_px, fine_px;
};

/// Those with the first object of a scene whose depth comes through sensors.
using SensedStimuli = std::map<std::string, std::vector<Stimulus>>;  // by scene
SensedStimuli sensed_stimuli(const StudyDefinition& study) {
  SensedStimuli sensed;
  for (Stimulus& stimulus : list_stimuli(study))
    if (stimulus.object_index == 1 && stimulus.depth.chain)
      sensed[stimulus.scene].push_back(std::move(stimulus));
  return sensed;
}

/// What the study's sensors see of a scene without its first object, at every level and condition.
void add_holes_of_scene(const std::vector<Stimulus>& sensed, const TruthScene& truth,
                        std::vector<LevelHoles>& holes) {
  std::map<std::string, std::optional<SensorCounts>> counted;  // by what is captured
  std::set<std::pair<std::string, double>> seen;               // condition and level
  std::optional<Geometry> geometry;
  for (const Stimulus& stimulus : sensed) {
    if (!seen.insert({stimulus.condition, stimulus.level}).second) continue;
    stop_if_interrupted();
    if (!geometry) geometry.emplace(truth.geometry_without(1));
    const std::string what = fmt::format("{} {} {}", canonical_text(stimulus.depth.chain),
                                         stimulus.depth.width_px, stimulus.depth.yaw_texels);
    const auto [found, added] = counted.emplace(what, std::nullopt);
    if (added)
      found->second =
          count_captured(*geometry, stimulus.depth, centre_camera(truth.camera), default_thread_count());
    if (found->second) add_holes(holes, stimulus, *found->second);
  }
}

void check_study(const std::string& path, const std::string& asset_root) {
  const StudyDefinition study = read_study(path, AssetCheck::must_exist, asset_root);
  const SensedStimuli sensed = sensed_stimuli(study);
  int broken = 0;
  std::vector<LevelHoles> holes;
  for (const SceneDefinition& scene : study.scenes) {
    stop_if_interrupted();
    SceneDefinition by_one_eye = scene;  // the rules are of the scene, however it is shown
    if (study.clip) by_one_eye = scene_at(by_one_eye, study, study.level.values.front(), 0);
    by_one_eye.view = {};
    const TruthScene truth = load_truth_scene(by_one_eye, study.width_px, study.height_px);
    for (const std::string& said : left_out_sentences(truth)) fmt::print("note    {}\n", said);
    for (const std::string& said : truth.rests) fmt::print("note    {}\n", said);
    for (const RuleResult& result : check_scene(truth)) {
      fmt::print("{}  {:8}  {}: {}\n", result.met ? "ok    " : "BROKEN", result.scene, result.rule,
                 result.found);
      broken += result.met ? 0 : 1;
    }
    if (const auto found = sensed.find(scene.name); found != sensed.end())
      add_holes_of_scene(found->second, truth, holes);
  }
  for (const std::string& said : notes_on_levels(study)) fmt::print("note    {}\n", said);
  for (const std::string& said : sentences(holes)) fmt::print("note    {}\n", said);
  if (broken > 0)
    throw input_error({.file = path,
                       .wanted = "scenes that keep the study's rules",
                       .found = fmt::format("{} broken (above)", broken)});
}

void check_set(const CheckOptions& options) {
  const std::string &folder = options.path, &out = options.out;
  if (options.artists && out.empty())
    throw input_error({.field = "--artists", .wanted = "--out FOLDER beside it", .found = "no folder"});
  if (!options.artists && (options.coarse_px || options.fine_px))
    throw input_error({.field = options.coarse_px ? "--coarse" : "--fine",
                       .wanted = "only with --artists",
                       .found = std::to_string(options.coarse_px.value_or(options.fine_px.value_or(0)))});
  ArtistsRule rule;
  rule.coarse_px = options.coarse_px.value_or(rule.coarse_px);
  rule.fine_px = options.fine_px.value_or(rule.fine_px);
  if (rule.coarse_px > rule.fine_px)
    throw input_error({.field = "--coarse",
                       .wanted = fmt::format("at most --fine, {}", rule.fine_px),
                       .found = std::to_string(rule.coarse_px)});
  const Manifest manifest = read_manifest(folder);  // before anything is made
  if (!out.empty()) prepare_output_folder(out);
  if (options.artists) {
    for (const std::filesystem::path& file : write_artists_maps(out, folder, rule))
      fmt::print("{}\n", file.string());
    return;
  }
  const SetSeams seams = read_set_seams(folder);
  const std::vector<ClipSeam> clips = read_clip_seams(folder, seams);
  if (!out.empty()) write_seams_page(out, seams, clips);
  fmt::print("{}{}\n\n{}", clips.empty() ? "" : "Middle frames. ", seams_meaning(seams),
             markdown_table(seam_cells_table(seams)));
  if (!clips.empty())
    fmt::print("\n{}\n\n{}", clip_seams_meaning(), markdown_table(clip_cells_table(seams, clips)));
  for (const std::string& said : sentences(holes_of_set(manifest))) fmt::print("\n{}\n", said);
  if (!out.empty())
    fmt::print("\nFigure and tables: {}\n", (std::filesystem::path(out) / "seams.html").string());
}

/// Throws InputError at an option that the other kind of check would ignore.
void require_not_given(const char* option, const std::string& value, const char* only) {
  if (!value.empty())
    throw input_error(
        {.field = option, .wanted = std::string("only with ") + only, .found = "\"" + value + "\""});
}

void run_check(const CheckOptions& options) {
  std::error_code error;
  if (std::filesystem::is_directory(options.path, error)) {
    require_not_given("--asset-root", options.asset_root, "a study file");
    check_set(options);
  } else {
    require_not_given("--out", options.out, "the folder of a rendered set");
    require_not_given("--artists", options.artists ? options.path : "", "the folder of a rendered set");
    require_not_given("--coarse", options.coarse_px ? options.path : "", "the folder of a rendered set");
    require_not_given("--fine", options.fine_px ? options.path : "", "the folder of a rendered set");
    check_study(options.path, options.asset_root);
  }
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* check = app.add_subcommand("check", "do scenes keep the study's rules; how large is each seam");
  check
      ->add_option(
          "study", options->path,
          "study file (.toml), or the folder of a rendered set: then area and widest band in which its "
          "stimuli differ from their references")
      ->required();
  add_asset_root_option(*check, options->asset_root);
  check->add_option("--out", options->out,
                    "of a set: folder for seams.csv and seams.html; made when missing");
  check->add_flag(
      "--artists", options->artists,
      "of a set, with --out: artists-SCENE.png instead, the reference with regions coloured by the "
      "geometry they need: coarse is enough, fine, mask");
  add_number(*check, "--coarse", options->coarse_px, {4, 65536},
             "with --artists: the widest depth map that counts as coarse, in px (default: 256)");
  add_number(*check, "--fine", options->fine_px, {4, 65536},
             "with --artists: the widest depth map that may be asked for, in px (default: 1024)");
  check->callback([options] { run_check(*options); });
}

}  // namespace seamline::renderer
