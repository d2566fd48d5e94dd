#include "laboratory/evidence/evidence_page.h"

#include <algorithm>

#include "support/text/error.h"
#include "support/text/suggest.h"

namespace seamline::laboratory {
namespace {

constexpr const char* tests_needed = "a build with its tests: cmake --build build/release";
constexpr const char* python_needed = "the source, Python";

EvidencePage convergence_page() {
  const auto step = [](const char* name, const char* stimulus) {
    return EvidenceStep{
        name,
        std::string("seamline lab convergence stimuli/depth_resolution_isolated.toml --only ") + stimulus +
            "-0512 --size 480x270 --spp 64 --seconds 240 --out " + name,
        Printed::progress};
  };
  const auto light = [](const char* name, const char* study, const char* stimulus) {
    return EvidenceStep{name,
                        std::string("seamline lab convergence stimuli/") + study + ".toml --only " +
                            stimulus + "-0064 --size 64x36 --spp 64 --seconds 60 --parts light --out " + name,
                        Printed::progress};
  };
  EvidencePage page{.name = "convergence",
                    .shows = "error of a picture against run time, mesh tolerance and depth width",
                    .takes = "40 minutes",
                    .needs = "",
                    .steps = {},
                    .small_steps = {}};
  page.steps = {step("receiver", "bedroom-receiver-statue"),
                step("shadow", "gazebo-shadow-lion"),
                step("occlusion", "atrium-occlusion-teapot_middle"),
                step("overlap", "gazebo-overlap-lion"),
                light("light-interior", "environment_light", "gazebo-shadow-lion-interior"),
                light("light-sky", "environment_light", "gazebo-shadow-lion-sky"),
                {"estimates",
                 "seamline lab convergence stimuli/quick.toml --only bedroom-receiver-statue-0064 --parts "
                 "sensor,repair,registration,fit,joint,interval --out estimates",
                 Printed::progress}};
  page.small_steps = {
      {"estimates",
       "seamline lab convergence stimuli/quick.toml --only bedroom-receiver-statue-0064 --size "
       "32x18 --parts sensor,repair --out estimates",
       Printed::progress}};
  for (const EvidenceStep& one : page.steps) {
    for (const char* figure : {"samples", "mesh", "width", "light", "sensor", "repair", "registration", "fit",
                               "joint", "interval"})
      page.shown.push_back(one.name + "/" + figure + ".svg");
    page.shown.push_back(one.name + "/slopes.csv");
  }
  return page;
}

EvidencePage coverage_page() {
  return {.name = "coverage",
          .shows = "how often intervals hold the truth",
          .takes = "4 hours",
          .needs = tests_needed,
          .steps = {{"lines",
                     "SEAMLINE_TRUE_STUDIES=2000 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.OfThePapersWay",
                     Printed::progress},
                    {"joint",
                     "SEAMLINE_TRUE_STUDIES=60 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.OfTheJointModel",
                     Printed::progress},
                    {"false_alarms",
                     "SEAMLINE_TRUE_STUDIES=300 tests/analysis_full_tests "
                     "--gtest_filter=TrueCoverage.FalseSentencesOfBothModels",
                     Printed::progress},
                    {"papers_way", "tests/analysis_full_tests --gtest_filter=Coverage.*"}},
          .small_steps = {{"small", "tests/analysis_quick_tests --gtest_filter=SmallCoverage.*",
                           Printed::progress}},
          .shown = {"true_coverage.csv", "true_sentences.csv"},
          .figures = {{"true_coverage.csv", "intervals of 95 %, all populations, widths, artifacts",
                       MeanCurves{.x = "people",
                                  .y = "coverage_percent",
                                  .curve = "way",
                                  .x_label = "people of a study",
                                  .y_label = "studies whose interval holds the truth, %"}}}};
}

EvidencePage joint_model_page() {
  return {.name = "joint_model_checks",
          .shows = "the joint model on real people, and where curves differ",
          .takes = "1 hour",
          .needs = tests_needed,
          .steps = {{"sharing",
                     "SEAMLINE_TRUE_STUDIES=200 tests/analysis_full_tests --gtest_filter=SharingCoverage.*",
                     Printed::progress},
                    {"real_people", "tests/analysis_quick_tests --gtest_filter=RealPeople.*:JointMaxima.*"}},
          .small_steps = {{"real_people",
                           "tests/analysis_quick_tests --gtest_filter=RealPeople.*:JointMaxima.*"}},
          .shown = {"sharing_coverage.csv"}};
}

EvidencePage statistics_page() {
  const auto step = [](const char* name, const char* filter) {
    return EvidenceStep{name, std::string("tests/analysis_full_tests --gtest_filter=") + filter};
  };
  return {
      .name = "statistics",
      .shows = "fits, groups, comparisons, screening",
      .takes = "20 minutes",
      .needs = tests_needed,
      .steps = {step("fit_intervals", "PsychometricSimulated.*"),
                step("fit_groups", "PsychometricCoverage.*"),
                step("guess_correction", "GuessCorrectionCoverage.*"),
                step("ordinal_false_alarms", "OrdinalStudyFull.*"), step("screening", "ScreeningRates.*")},
      .small_steps = {{"recovery", "tests/analysis_quick_tests --gtest_filter=PsychometricSciPy.*"}}};
}

EvidencePage stability_page() {
  return {
      .name = "stability",
      .shows = "stiff and extreme input; orders of convergence",
      .takes = "2 minutes",
      .needs = "",
      .steps = {{"cases", "seamline lab stability --figure orders.svg --markdown", Printed::markdown}},
      .small_steps = {{"cases", "seamline lab stability --only quest_plus --markdown", Printed::markdown}},
      .shown = {"orders.svg"}};
}

EvidencePage speed_page() {
  return {
      .name = "speed",
      .shows = "rays, captures, meshes and pictures beside bare Embree and Blender's Cycles",
      .takes = "20 minutes",
      .needs = "for Cycles the source and Blender, else it is left out",
      .steps = {{"bench", "seamline lab bench --csv bench.csv", Printed::progress},
                {"cycles", "benchmarks/cycles/compare SEAMLINE SCENES cycles 128 160"}},
      .small_steps = {{"bench", "seamline lab bench --only capture --quick --csv bench.csv",
                       Printed::progress}},
      .shown = {"bench.csv"},
      .figures = {{"bench.csv", "Seamline beside bare Embree",
                   LabelledDots{.labels = {"measurement"}, .x = "ratio", .x_label = "ratio", .wanted = 1}}}};
}

EvidencePage predictions_page() {
  return {
      .name = "predictions",
      .shows = "the order in which artifacts are predicted to be seen",
      .takes = "10 minutes",
      .needs = "",
      .steps = {{"render", "seamline render stimuli/depth_resolution_isolated.toml --error 0.0039 --out set",
                 Printed::progress},
                {"calibrated", "seamline predict set --calibrate"},
                {"published_gain", "seamline predict set"}},
      .small_steps = {{"render", "seamline render stimuli/quick.toml --only *-lion-* --spp 1 --out set",
                       Printed::progress},
                      {"published_gain", "seamline predict set"}}};
}

EvidencePage real_time_page() {
  return {
      .name = "real_time",
      .shows = "frames a second, and real-time methods beside rays",
      .takes = "5 minutes",
      .needs = "",
      .steps = {{"record",
                 "seamline record builtin:bedroom --preset structured_light_640x480 --frames 3 --spp 12 --at "
                 "0.4 1.5 -1.5 --look-at 0.1 0.5 -4.2 --angle 6 --out rates",
                 Printed::progress},
                {"frames",
                 "seamline live rates --object builtin:teapot --headless --time --frames 100 --size 800x600"},
                {"methods",
                 "seamline lab convergence stimuli/realtime_methods.toml --only "
                 "gazebo-all-lion-traced-0512 --parts realtime --spp 8 --out methods",
                 Printed::progress}},
      .small_steps = {{"methods",
                       "seamline lab convergence stimuli/realtime_methods.toml --only "
                       "gazebo-all-lion-traced-0512 --parts realtime --spp 2 --size 32x18 --out methods",
                       Printed::progress}},
      .shown = {"methods/realtime.svg", "methods/realtime.csv"}};
}

EvidencePage true_errors_page() {
  return {
      .name = "true_errors",
      .shows = "told errors of pictures beside true ones",
      .takes = "35 minutes",
      .needs = python_needed,
      .steps = {{"scenes", "benchmarks/true_errors/measure SEAMLINE scenes --csv told_and_true.csv"},
                {"contact", "benchmarks/true_errors/contact SEAMLINE contact --csv contact.csv"}},
      .small_steps = {{"scenes",
                       "benchmarks/true_errors/measure SEAMLINE scenes --csv told_and_true.csv --only rods "
                       "--seeds 1 --truth-spp 8 --error 0.05"},
                      {"contact",
                       "benchmarks/true_errors/contact SEAMLINE contact --csv contact.csv --only "
                       "floor_overcast_linear --truth-spp 8 --error 0.05"}},
      .shown = {"told_and_true.csv", "contact.csv"},
      .figures = {
          {"told_and_true.csv", "told error over true error",
           LabelledDots{
               .labels = {"scene", "seed"}, .x = "told_over_true", .x_label = "told / true", .wanted = 1}}}};
}

EvidencePage faults_page() {
  return {.name = "faults",
          .shows = "kills, full disks, damaged logs, two programs at once; load",
          .takes = "10 minutes",
          .needs = tests_needed,
          .steps = {{"faults", "tests/seamline_faults SEAMLINE tries"},
                    {"load", "tests/seamline_faults --load SEAMLINE load"}},
          .small_steps = {{"faults", "tests/seamline_faults --quick SEAMLINE tries"}}};
}

EvidencePage growth_page() {
  return {
      .name = "growth",
      .shows = "how time and memory of each command grow",
      .takes = "3 hours",
      .needs = python_needed,
      .steps = {{"growth", "benchmarks/growth SEAMLINE work --large --markdown growth-table.md",
                 Printed::progress}},
      .small_steps = {{"growth", "benchmarks/growth SEAMLINE work --only slots --markdown growth-table.md",
                       Printed::progress}},
      .shown = {"growth-table.md"}};
}

EvidencePage scale_page() {
  return {.name = "scale",
          .shows = "sets of up to 20,000 stimuli",
          .takes = "10 minutes",
          .needs = "the source, Python, a build with -DSEAMLINE_BENCHMARKS=ON",
          .steps = {{"scale", "benchmarks/scale BUILD work"}},
          .small_steps = {{"scale", "benchmarks/scale BUILD work 240"}}};
}

}  // namespace

std::span<const EvidencePage> evidence_pages() {
  static const std::vector<EvidencePage> pages = {convergence_page(), coverage_page(),  joint_model_page(),
                                                  statistics_page(),  stability_page(), speed_page(),
                                                  predictions_page(), real_time_page(), true_errors_page(),
                                                  faults_page(),      growth_page(),    scale_page()};
  return pages;
}

const EvidencePage& evidence_page(const std::string& name) {
  std::vector<std::string> names;
  for (const EvidencePage& page : evidence_pages()) {
    if (page.name == name) return page;
    names.push_back(page.name);
  }
  const std::string nearest = nearest_word(name, names);
  throw input_error(
      {.field = "page",
       .wanted = "a page that `seamline lab evidence` lists",
       .found = "\"" + name + "\"" + (nearest.empty() ? "" : "; did you mean " + nearest + "?")});
}

}  // namespace seamline::laboratory
