#include "commands/study/render_options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>

#include "commands/options/setting_option.h"
#include "commands/photographs/asset_root_option.h"
#include "sets/set_manifest.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace fs = std::filesystem;

void add_render_options(CLI::App& command, RenderOptions& options) {
  command.add_option("study", options.study, "study file (.toml)")->required();
  add_asset_root_option(command, options.asset_root);
  command.add_option("--out", options.set, "folder of the set; an interrupted job continues there");
  command.add_option("--only", options.only, "only stimuli whose id matches; * stands for any text");
  add_number(command, "--threads", options.threads, {1, 4096}, "worker threads (default: all cores)");
  add_number(command, "--spp", options.spp, {1, 65536}, "samples per pixel, instead of the study's");
  add_number(command, "--error", options.error, {0.002, 1},
             "instead of a number of samples: sample until each picture's estimated error is below "
             "this (display units, 0 to 1) and below three times this in its worst 32 x 32 tile")
      ->excludes("--spp");
  add_choice(command, "--estimator", options.estimator, std::array{Estimator::fast, Estimator::path},
             "fast: shared and filtered; path: unbiased, for reference");
  add_choice(command, "--mesh", options.mesh, std::array{MeshDensity::adaptive, MeshDensity::full},
             "depth mesh, instead of the study's");
  command
      .add_option("--no-omit", options.no_omit,
                  "turn off an omission that --explain names; may be given several times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_flag("--layers", options.layers, "also write float EXR layers");
}

StudyDefinition study_of(const RenderOptions& options) {
  // A set that an earlier version began may have idle settings, and is finished with them.
  const bool is_begun = !options.set.empty() && is_begun_set(options.set);
  return read_study(options.study, AssetCheck::must_exist, options.asset_root,
                    is_begun ? IdleSettings::kept : IdleSettings::refused);
}

RenderRequest request_of(const RenderOptions& options) {
  RenderRequest request{
      .set_folder = options.set, .only = options.only, .threads = options.threads, .layers = options.layers};
  if (options.spp > 0) request.spp = options.spp;
  if (options.error > 0) request.error = options.error;
  request.estimator = options.estimator;
  request.mesh = options.mesh;
  request.omit = omissions_without(options.no_omit);
  return request;
}

std::vector<std::string> options_for_pieces(const RenderOptions& options) {
  std::vector<std::string> out = {"--estimator=" + std::string(word(options.estimator))};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) out.push_back(std::string(name) + "=" + value);
  };
  if (!options.asset_root.empty()) add("--asset-root", fs::absolute(options.asset_root).string());
  add("--only", options.only);
  if (options.mesh) add("--mesh", std::string(word(*options.mesh)));
  if (options.spp > 0) add("--spp", std::to_string(options.spp));
  if (options.error > 0) add("--error", fmt::format("{}", options.error));
  for (const std::string& name : options.no_omit) add("--no-omit", name);
  if (options.layers) out.emplace_back("--layers");
  return out;
}

}  // namespace seamline::renderer
