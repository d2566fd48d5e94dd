#include "renderer/commands/check_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "renderer/commands/asset_root_option.h"
#include "renderer/set/check.h"
#include "stimuli/study_file/study_file.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

void run_check(const std::string& path, const std::string& asset_root) {
  const StudyDefinition study = read_study(path, AssetCheck::must_exist, asset_root);
  int broken = 0;
  for (const SceneDefinition& scene : study.scenes) {
    stop_if_interrupted();
    for (const RuleResult& result : check_scene(load_truth_scene(scene, study.width_px, study.height_px))) {
      fmt::print("{}  {:8}  {}: {}\n", result.met ? "ok    " : "BROKEN", result.scene, result.rule,
                 result.found);
      broken += result.met ? 0 : 1;
    }
  }
  if (broken > 0)
    throw input_error({.file = path,
                       .wanted = "scenes that keep the study's rules",
                       .found = fmt::format("{} broken (above)", broken)});
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto path = std::make_shared<std::string>(), asset_root = std::make_shared<std::string>();
  CLI::App* check = app.add_subcommand("check", "do the scenes keep the study's own rules");
  check->add_option("study", *path, "study file (.toml)")->required();
  add_asset_root_option(*check, *asset_root);
  check->callback([path, asset_root] { run_check(*path, *asset_root); });
}

}  // namespace seamline::renderer
