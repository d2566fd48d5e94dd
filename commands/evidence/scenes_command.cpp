#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "laboratory/families/kept_scene.h"
#include "scenes/shapes/glb_file.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::laboratory {
namespace {

struct ScenesOptions {
  std::string family, out;
  int count = 10;
  std::uint64_t seed = 1;
};

void make_scenes(const ScenesOptions& options) {
  const std::optional<scenes::SceneFamily> family = scenes::scene_family_from_word(options.family);
  if (!family)
    throw input_error(
        {.field = "family", .wanted = "rooms, pavilions or arcades", .found = "\"" + options.family + "\""});
  const std::filesystem::path folder = options.out;
  prepare_output_folder(folder);
  std::vector<scenes::GeneratedScene> made;
  for (int number = 1; number <= options.count; ++number) {
    const KeptScene kept = scene_that_keeps_rules(*family, options.seed, number);
    const std::filesystem::path file = folder / (scene_name(*family, number) + ".glb");
    write_glb(file, kept.scene.background);
    fmt::print("{}: keeps the rules ({} drawn until one did, objects moved {} times)\n", file.string(),
               kept.scenes_drawn, kept.placements_drawn);
    made.push_back(kept.scene);
  }
  const std::filesystem::path study = folder / (options.family + ".toml");
  write_file_atomically(study, family_study_text(*family, made));
  fmt::print("{}\n", study.string());
}

}  // namespace

void add_scenes_command(CLI::App& app) {
  const auto options = std::make_shared<ScenesOptions>();
  CLI::App* command =
      app.add_subcommand("scenes", "generated scenes that keep the rules of `check`, and their study file");
  command->add_option("family", options->family, "rooms, pavilions or arcades")->required();
  command->add_option("--out", options->out, "folder for the scenes and their study file")->required();
  add_number(*command, "--count", options->count, {1, 99}, "how many scenes")->capture_default_str();
  add_number(*command, "--seed", options->seed, any_seed, "of the family's random numbers")
      ->capture_default_str();
  command->callback([options] { make_scenes(*options); });
}

}  // namespace seamline::laboratory
