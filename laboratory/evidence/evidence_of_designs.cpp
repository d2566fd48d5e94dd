#include "laboratory/evidence/evidence_page.h"

#include <array>
#include <utility>

namespace seamline::laboratory {
namespace {

/// Studies whose widths or levels differ from one another; a plan knows nothing else of them.
constexpr std::array planned_studies = {
    "depth_resolution", "quick",         "soft_light",     "environment_light",  "discontinuity",
    "realtime_methods", "field_of_view", "mesh_tolerance", "registration_error", "stereo_seams"};

/// The bias of all thresholds of each study, by one way to estimate them.
void add_plans(EvidencePage& page, const std::string& estimator, const std::string& file) {
  EvidenceTable table{
      .file = file,
      .from = {},
      .heading = "study",
      .row_of = {},
      .columns = {
          {.heading = "lowest bias, octaves", .of = "bias", .shows = Summary::lowest, .decimals = 2},
          {.heading = "highest bias, octaves", .of = "bias", .shows = Summary::highest, .decimals = 2}}};
  for (const std::string study : planned_studies) {
    const std::string name = study + "-" + estimator;
    page.steps.push_back(
        {name,
         "seamline plan stimuli/" + study + ".toml --participants 5 --studies 1 --estimator " + estimator,
         Printed::progress});
    page.printed.push_back({.file = name + ".csv",
                            .step = name,
                            .columns = {"threshold", "levels", "true", "bias", "interval"}});
    table.from.push_back({study, name + ".csv"});
    table.where = {{"levels", "all"}};
  }
  page.tables.push_back(table);
}

}  // namespace

EvidencePage planning_page() {
  EvidencePage page{
      .name = "planning",
      .shows = "what the levels of a study cost, and what QUEST+ gains",
      .takes = "10 seconds",
      .needs = tests_needed,
      .steps = {{"quest_plus", "tests/study_quick_tests --gtest_filter=QuestPlusRecovery.*"}},
      .small_steps = {{"quick-joint", "seamline plan stimuli/quick.toml --participants 5 --studies 1",
                       Printed::progress}},
      .printed = {{.file = "quest_plus.csv",
                   .step = "quest_plus",
                   .columns = {"answers", "way", "14 trials", "28 trials", "42 trials", "84 trials"}}}};
  add_plans(page, "joint", "bias_joint.csv");
  add_plans(page, "straight-lines", "bias_lines.csv");
  return page;
}

EvidencePage depth_cameras_page() {
  const std::string fall =
      "seamline settle builtin:furnished_room --sensor tof_160x120 --at 0 1.6 1 --look-at 0 0 -1 --noise 0.3 ";
  EvidenceTable table{
      .file = "shake.csv",
      .from = {{"teapot of 30 cm", "teapot/shake.csv"}, {"statue of 60 cm", "statue/shake.csv"}},
      .heading = "object",
      .row_of = {},
      .columns = {},
      .where = {{"steps_per_s", "240"}}};
  for (const auto& [depth, heading] : {std::pair{"measured", "as measured"},
                                       std::pair{"planes", "with planes"}, std::pair{"exact", "exact"}})
    for (const auto& [column, unit] : {std::pair{"jump_mm", " mm"}, std::pair{"turn_deg", " degrees"}})
      table.columns.push_back({.heading = std::string(heading) + "," + unit,
                               .of = column,
                               .where = {{"depth", depth}},
                               .shows = Summary::highest,
                               .decimals = 4});
  return {
      .name = "depth_cameras",
      .shows = "how much things shake that rest on measured depth",
      .takes = "80 seconds",
      .needs = "a build with Bullet",
      .steps =
          {{"teapot",
            fall + "--object builtin:teapot --scale 0.3 --position 0 0.03 -0.9 --filter median --out teapot",
            Printed::progress},
           {"statue",
            fall + "--object builtin:statue --scale 0.35 --position 0 0.03 -0.9 --filter median --out statue",
            Printed::progress}},
      .small_steps =
          {{"teapot",
            fall +
                "--frames 3 --frames-to-rest 3 --object builtin:teapot --scale 0.3 --position 0 0.03 -0.9 --out teapot",
            Printed::progress}},
      .shown = {"teapot/shake.svg", "statue/shake.svg"},
      .tables = {table}};
}

EvidencePage pictures_page() {
  const auto sheet = [](const char* study, const char* only, const char* name) {
    return EvidenceStep{name,
                        std::string("seamline render stimuli/") + study + ".toml --only " + only +
                            " --error 0.0078 --contact-sheet --out " + study,
                        Printed::progress};
  };
  return {.name = "pictures",
          .shows = "contact sheets: what the stimuli look like",
          .takes = "30 minutes",
          .needs = "",
          .steps = {sheet("depth_resolution", "*", "mask"),
                    sheet("depth_resolution_isolated", "bedroom-receiver-*", "query_receiver"),
                    sheet("depth_resolution_isolated", "atrium-occlusion-*", "query_occlusion"),
                    sheet("soft_light", "bedroom-receiver-statue-*", "soft_light"),
                    sheet("mesh_tolerance", "bedroom-receiver-statue-*", "mesh_tolerance")},
          .small_steps = {{"quick",
                           "seamline render stimuli/quick.toml --only bedroom-receiver-statue-0064 --spp 1 "
                           "--contact-sheet --out quick",
                           Printed::progress}},
          .shown = {"depth_resolution/contact-receiver.png", "depth_resolution/contact-shadow.png",
                    "depth_resolution/contact-occlusion.png", "depth_resolution/contact-overlap.png",
                    "depth_resolution_isolated/contact-receiver.png",
                    "depth_resolution_isolated/contact-occlusion.png", "soft_light/contact-receiver.png",
                    "mesh_tolerance/contact-receiver.png"}};
}

}  // namespace seamline::laboratory
