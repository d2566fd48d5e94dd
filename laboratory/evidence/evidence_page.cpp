#include "laboratory/evidence/evidence_page.h"

#include <algorithm>
#include <utility>

#include "support/text/error.h"
#include "support/text/suggest.h"

namespace seamline::laboratory {
namespace {

EvidencePage stability_page() {
  return {
      .name = "stability",
      .shows = "stiff and extreme input; orders of convergence",
      .takes = "75 seconds",
      .needs = "",
      .steps = {{"cases", "seamline lab stability --figure orders.svg --csv cases.csv", Printed::progress}},
      .small_steps = {{"cases", "seamline lab stability --only quest_plus --csv cases.csv",
                       Printed::progress}},
      .shown = {"orders.svg", "cases.csv"},
      .tables = {
          {.file = "groups.csv",
           .from = {{"", "cases.csv"}},
           .heading = "group",
           .row_of = {"group"},
           .columns = {
               {.heading = "cases", .of = "", .shows = Summary::rows},
               {.heading = "passed", .of = "", .where = {{"verdict", "pass"}}, .shows = Summary::rows}}}}};
}

EvidencePage speed_page() {
  return {
      .name = "speed",
      .shows = "rays, captures, meshes and pictures beside bare Embree and Blender's Cycles",
      .takes = "36 minutes",
      .needs = "for Cycles the source and Blender, else it is left out",
      .steps = {{"bench", "seamline lab bench --csv bench.csv", Printed::progress},
                {"cycles", "benchmarks/cycles/compare SEAMLINE SCENES cycles 128 160"}},
      .small_steps = {{"bench", "seamline lab bench --only capture --quick --csv bench.csv",
                       Printed::progress}},
      .shown = {"bench.csv"},
      .figures = {{"ratios.csv", "speed beside what ran in the same seconds",
                   LabelledDots{.labels = {"measurement"}, .x = "ratio", .x_label = "ratio", .wanted = 1}}},
      .printed = {{.file = "cycles.csv",
                   .step = "cycles",
                   .columns = {"materials", "Seamline, s", "Cycles, s", "Cycles over Seamline"}}},
      .tables = {{.file = "ratios.csv",
                  .from = {{"", "bench.csv"}},
                  .heading = "measurement",
                  .row_of = {"measurement"},
                  .columns = {{.heading = "unit", .of = "unit"},
                              {.heading = "found", .of = "found", .shows = Summary::mean_of_3_digits},
                              {.heading = "beside", .of = "beside", .shows = Summary::mean_of_3_digits},
                              {.heading = "ratio", .of = "ratio", .shows = Summary::mean_of_3_digits},
                              {.heading = "wanted", .of = "wanted"}},
                  .but_not = {{"wanted", ""}}}}};
}

EvidencePage faults_page() {
  return {.name = "faults",
          .shows = "kills, full disks, damaged logs, two programs at once; load",
          .takes = "10 minutes",
          .needs = tests_needed,
          .steps = {{"faults", "tests/seamline_faults SEAMLINE tries"},
                    {"load", "tests/seamline_faults --load SEAMLINE load"}},
          .small_steps = {{"faults", "tests/seamline_faults --quick SEAMLINE tries"}},
          .printed = {{.file = "faults.csv",
                       .step = "faults",
                       .columns = {"fault", "tries", "committed", "lost", "reruns", "equal", "note"}},
                      {.file = "damage.csv",
                       .step = "faults",
                       .columns = {"damaged log", "tries", "refused", "unnoticed", "answers", "recovered",
                                   "without code", "changed", "nothing recovered"}},
                      {.file = "load.csv",
                       .step = "load",
                       .columns = {"answers", "participants", "making, s", "analysis, s",
                                   "s a 10,000 answers", "memory, MB"}}}};
}

EvidencePage growth_page() {
  return {.name = "growth",
          .shows = "how time and memory of each command grow",
          .takes = "39 minutes",
          .needs = python_needed,
          .steps = {{"growth", "benchmarks/growth SEAMLINE work --large"}},
          .small_steps = {{"growth", "benchmarks/growth SEAMLINE work --only nodes"}},
          .printed = {{.file = "growth.csv",
                       .step = "growth",
                       .columns = {"quantity", "command", "from", "to", "time, s", "memory, MB",
                                   "slope of time", "slope of memory"}}}};
}

EvidencePage scale_page() {
  EvidenceTable wide{.file = "by_command.csv",
                     .from = {{"", "scale.csv"}},
                     .heading = "command",
                     .row_of = {"command"},
                     .columns = {}};
  for (const char* stimuli : {"1200", "5040", "19920"})
    for (const auto& [column, unit] : {std::pair{"processor s", " s"}, std::pair{"memory, MB", " MB"}})
      wide.columns.push_back({.heading = std::string(stimuli) + " stimuli," + unit,
                              .of = column,
                              .where = {{"stimuli", stimuli}}});
  return {.name = "scale",
          .shows = "sets of up to 20,000 stimuli",
          .takes = "5 minutes",
          .needs = "the source, Python, a build with -DSEAMLINE_BENCHMARKS=ON",
          .steps = {{"scale", "benchmarks/scale BUILD work"}},
          .small_steps = {{"scale", "benchmarks/scale BUILD work 240"}},
          .printed = {{.file = "scale.csv",
                       .step = "scale",
                       .columns = {"command", "stimuli", "processor s", "memory, MB"}}},
          .tables = {wide}};
}

}  // namespace

std::span<const EvidencePage> evidence_pages() {
  static const std::vector<EvidencePage> pages = {
      convergence_page(), coverage_page(),    replication_page(),   joint_model_page(),
      statistics_page(),  stability_page(),   speed_page(),         predictions_page(),
      real_time_page(),   true_errors_page(), faults_page(),        growth_page(),
      scale_page(),       planning_page(),    depth_cameras_page(), pictures_page()};
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
