// A program that is not Seamline: an object in a photograph, and thresholds of simulated people, by the
// rooms' public headers alone.
//   forty_lines STUDY FOLDER
#include <cstdio>

#include "analysis/analysis.h"
#include "composites/composites.h"
#include "sets/sets.h"
#include "stimuli/stimuli.h"
#include "study/study.h"
#include "support/support.h"

int main(int, char** arguments) try {
  using namespace seamline;  // NOLINT(google-build-using-namespace): a program of its own
  const std::filesystem::path folder = arguments[2];
  std::filesystem::remove_all(folder);  // of a run before
  std::filesystem::create_directories(folder);

  // A room 3 m around the camera, photographed as a panorama that is its own light.
  write_exr(folder / "photograph.exr", Image(64, 32, 3, 0.5F));
  write_exr(folder / "depth.exr", Image(64, 32, 1, 3.0F));
  renderer::CompositeRequest composite;
  composite.photograph = folder / "photograph.exr";
  composite.depth.file = folder / "depth.exr";
  composite.objects.resize(1);
  composite.objects[0].path = resolve_named_file("builtin:statue", "object");
  composite.objects[0].position_m = {0, -1, -2};
  composite.light.given.environment_radiance = {0, 0, 0};
  composite.spp = 4;
  composite.out = folder / "composite.png";
  renderer::make_composite(composite);

  // Study file -> set -> log -> thresholds.
  const StudyDefinition definition = read_study(arguments[1], AssetCheck::must_exist);
  const renderer::RenderSummary set = renderer::render_set(definition, {.set_folder = folder / "set"});
  const study::SimulationSummary people =
      study::run_simulated_study({.set_folder = folder / "set", .log = folder / "log.sqlite", .count = 12});
  const analysis::Analysis found =
      analysis::analyze(study::read_log(folder / "log.sqlite"), false, {.replicates = 200, .seed = 1}, {});
  std::printf("%d stimuli, %d people\n%s", set.rendered, people.participants_run,
              analysis::table_text(found).c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
