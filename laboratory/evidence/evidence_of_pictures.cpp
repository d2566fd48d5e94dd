#include "laboratory/evidence/evidence_page.h"

#include <tuple>
#include <utility>

namespace seamline::laboratory {
namespace {

const std::vector<std::string> convergence_artifacts = {"receiver", "shadow", "occlusion", "overlap"};

/// A table of the four artifacts, a row each, from one table of each.
EvidenceTable of_artifacts(const std::string& file, const std::string& table,
                           std::vector<SummaryColumn> columns) {
  EvidenceTable made{
      .file = file, .from = {}, .heading = "artifact", .row_of = {}, .columns = std::move(columns)};
  for (const std::string& artifact : convergence_artifacts)
    made.from.push_back({artifact, artifact + "/" + table});
  return made;
}

SummaryColumn one_number(const std::string& heading, const std::string& of, RowFilter where, int decimals) {
  return {
      .heading = heading, .of = of, .where = std::move(where), .shows = Summary::mean, .decimals = decimals};
}

/// Errors at four samples a pixel of every way to get light with and without the object.
EvidenceTable errors_of_ways() {
  std::vector<SummaryColumn> columns;
  for (const auto& [error, where] : {std::pair{"rmse", ""}, std::pair{"rmse_given", "given photograph: "}})
    for (const auto& [series, way] :
         {std::pair{"path coupled", "coupled"}, std::pair{"path independent", "independent"},
          std::pair{"fast", "fast"}})
      columns.push_back(one_number(std::string(where) + way, error, {{"series", series}, {"spp", "4"}}, 4));
  return of_artifacts("errors.csv", "samples.csv", columns);
}

EvidenceTable errors_of_meshes() {
  const RowFilter usual = {{"tolerance", "0.0001"}};
  return of_artifacts(
      "meshes.csv", "mesh.csv",
      {one_number("triangles", "triangles", usual, 0),
       one_number("of the full mesh", "triangles", {{"tolerance", ""}}, 0),
       one_number("error", "rmse", usual, 5),
       one_number("share of pixels that change by more than a step", "changed_share", usual, 5),
       one_number("largest change, steps", "largest_change", usual, 0)});
}

EvidenceTable errors_of_widths() {
  std::vector<SummaryColumn> columns;
  for (const char* width : {"64", "512", "4096"})
    columns.push_back(one_number(std::string("W = ") + width, "rmse", {{"width", width}}, 4));
  return of_artifacts("widths.csv", "width.csv", columns);
}

EvidenceTable errors_of_compositing() {
  std::vector<SummaryColumn> columns;
  for (const auto& [column, heading, decimals] :
       {std::tuple{"rmse", "error", 4}, std::tuple{"below_black", "share of pixels under black", 5}})
    for (const char* way : {"ratio", "additive"})
      columns.push_back(one_number(std::string(way) + ": " + heading, column,
                                   {{"compositing", way}, {"renders", "coupled"}}, decimals));
  return of_artifacts("compositing.csv", "compositing.csv", columns);
}

EvidenceTable errors_of_light_samples() {
  EvidenceTable table{
      .file = "light.csv",
      .from = {{"map of a room", "light-interior/light.csv"}, {"sky map with a sun", "light-sky/light.csv"}},
      .heading = "map",
      .row_of = {},
      .columns = {},
      .where = {{"light", "environment map"}, {"spp", "64"}, {"rays", "1"}}};
  for (const auto& [strategy, heading] :
       {std::pair{"map", "by the map alone"}, std::pair{"cosine", "by the surface alone"},
        std::pair{"both", "by both"}})
    table.columns.push_back(one_number(heading, "error", {{"strategy", strategy}}, 3));
  return table;
}

}  // namespace

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
  const auto masks = [](const char* name, const char* stimulus) {
    return EvidenceStep{
        name,
        std::string("seamline lab convergence stimuli/depth_resolution_isolated.toml --only ") + stimulus +
            "-0512 --size 160x90 --spp 16 --parts mitigation,filter --out " + name,
        Printed::progress};
  };
  EvidencePage page{.name = "convergence",
                    .shows = "error of a picture against run time, mesh tolerance and depth width",
                    .takes = "26 minutes",
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
                 "sensor,repair,registration,fit,joint,interval,plan --out estimates",
                 Printed::progress},
                masks("masks-occlusion", "atrium-occlusion-teapot_middle"),
                masks("masks-overlap", "gazebo-overlap-lion")};
  page.small_steps = {
      {"estimates",
       "seamline lab convergence stimuli/quick.toml --only bedroom-receiver-statue-0064 --size "
       "32x18 --parts sensor,repair --out estimates",
       Printed::progress}};
  for (const std::string& artifact : convergence_artifacts)
    for (const char* file : {"samples.svg", "mesh.svg", "width.svg", "slopes.csv"})
      page.shown.push_back(artifact + "/" + file);
  for (const char* file :
       {"light-interior/light.svg", "masks-occlusion/mitigation.svg", "masks-occlusion/slopes.csv",
        "masks-overlap/filter.svg", "masks-overlap/slopes.csv", "estimates/slopes.csv"})
    page.shown.emplace_back(file);
  for (const char* part : {"sensor", "repair", "registration", "fit", "joint", "interval", "plan"})
    page.shown.push_back(std::string("estimates/") + part + ".svg");
  page.tables = {errors_of_ways(), errors_of_meshes(), errors_of_widths(), errors_of_compositing(),
                 errors_of_light_samples()};
  return page;
}

namespace {

/// PT and SN of every curve of the ready studies, by people who know where to look and by people who search.
EvidenceTable thresholds_of_studies() {
  EvidenceTable table{.file = "by_study.csv",
                      .from = {{"", "studies.csv"}},
                      .heading = "study, condition, artifact",
                      .row_of = {"study", "condition", "artifact"},
                      .columns = {}};
  for (const auto& [people, heading] :
       {std::pair{"know", "who know where"}, std::pair{"search", "who search"}})
    for (const char* quantity : {"PT", "SN"})
      table.columns.push_back({.heading = std::string(quantity) + " of people " + heading,
                               .of = quantity,
                               .where = {{"people", people}}});
  return table;
}

}  // namespace

EvidencePage predictions_page() {
  return {
      .name = "predictions",
      .shows = "the order in which artifacts are predicted to be seen, and thresholds of the ready studies",
      .takes = "29 minutes",
      .needs = "for the ready studies the source and Python",
      .steps = {{"render", "seamline render stimuli/depth_resolution_isolated.toml --error 0.0039 --out set",
                 Printed::progress},
                {"calibrated", "seamline predict set --calibrate"},
                {"published_gain", "seamline predict set"},
                {"studies", "benchmarks/predictions SEAMLINE studies --csv studies.csv", Printed::progress}},
      .small_steps =
          {{"render", "seamline render stimuli/quick.toml --only *-lion-* --spp 1 --out set",
            Printed::progress},
           {"published_gain", "seamline predict set"},
           {"studies",
            "benchmarks/predictions SEAMLINE studies --csv studies.csv --only sensor_noise --width 64 "
            "--spp 1 --people 4",
            Printed::progress}},
      .shown = {"studies.csv"},
      .tables = {thresholds_of_studies()}};
}

namespace {

/// Ways to run `seamline live`, a step each.
struct LiveWay {
  const char *name, *options, *says;
};
constexpr LiveWay live_ways[] = {{"bare", " --shadows none --occlusion none", "mapping and the object"},
                                 {"whole", "", "with occlusion and shadows"},
                                 {"views", " --views 5", "with five views"},
                                 {"physics", " --physics", "with physics, the object touching"}};

EvidenceStep live_step(const LiveWay& way, const char* size) {
  return {std::string("frames_") + way.name,
          std::string("seamline live rates --object builtin:teapot --headless --time --frames ") + size +
              way.options};
}

}  // namespace

EvidencePage real_time_page() {
  EvidencePage page{
      .name = "real_time",
      .shows = "frames a second, and real-time methods beside rays",
      .takes = "2 minutes",
      .needs = "",
      .steps = {{"record",
                 "seamline record builtin:bedroom --preset structured_light_640x480 --frames 3 --spp 12 --at "
                 "0.4 1.5 -1.5 --look-at 0.1 0.5 -4.2 --angle 6 --out rates",
                 Printed::progress}},
      .small_steps =
          {{"record",
            "seamline record builtin:bedroom --preset tof_160x120 --frames 2 --spp 1 --at 0.4 1.5 -1.5 "
            "--look-at 0.1 0.5 -4.2 --angle 6 --out rates",
            Printed::progress},
           live_step(live_ways[1], "3 --size 160x120")},
      .shown = {"methods/realtime.svg"},
      .figures = {},
      .printed = {},
      .tables = {
          {.file = "frames.csv",
           .from = {},
           .heading = "what",
           .row_of = {},
           .columns = {{.heading = "at 800 x 600", .of = "rate"}},
           .where = {{"part", "total"}}},
          {.file = "by_method.csv",
           .from = {{"", "methods/realtime.csv"}},
           .heading = "method",
           .row_of = {"method"},
           .columns = {
               {.heading = "settings", .of = "", .shows = Summary::rows},
               {.heading = "error", .of = "rmse", .shows = Summary::range, .decimals = 4},
               {.heading = "frame, s", .of = "frame_seconds", .shows = Summary::range, .decimals = 2}}}}};
  for (const LiveWay& way : live_ways) {
    const EvidenceStep step = live_step(way, "100 --size 800x600");
    page.steps.push_back(step);
    page.printed.push_back(
        {.file = step.name + ".csv", .step = step.name, .columns = {"part", "time", "rate"}});
    page.tables.front().from.push_back({way.says, step.name + ".csv"});
  }
  page.steps.push_back({"methods",
                        "seamline lab convergence stimuli/realtime_methods.toml --only "
                        "gazebo-all-lion-traced-0512 --parts realtime --spp 8 --out methods",
                        Printed::progress});
  return page;
}

EvidencePage true_errors_page() {
  return {
      .name = "true_errors",
      .shows = "told errors of pictures beside true ones",
      .takes = "67 minutes",
      .needs = python_needed,
      .steps = {{"scenes", "benchmarks/true_errors/measure SEAMLINE scenes --csv told_and_true.csv"},
                {"clips",
                 "benchmarks/true_errors/clips SEAMLINE clips --csv told_and_true_clips.csv --only "
                 "moving_bedroom,moving_objects"},
                {"contact", "benchmarks/true_errors/contact SEAMLINE contact --csv contact.csv"}},
      .small_steps =
          {{"scenes",
            "benchmarks/true_errors/measure SEAMLINE scenes --csv told_and_true.csv --only thin_rods "
            "--seeds 1 --truth-spp 8 --error 0.05"},
           {"clips",
            "benchmarks/true_errors/clips SEAMLINE clips --csv told_and_true_clips.csv --only "
            "moving_bedroom --seeds 1 --truth-spp 8 --error 0.05 --frames 2 --size 32x18"},
           {"contact",
            "benchmarks/true_errors/contact SEAMLINE contact --csv contact.csv --only "
            "floor_overcast_linear --truth-spp 8 --error 0.05 --no-cycles"}},
      .shown = {"told_and_true.csv", "by_scene.csv", "told_and_true_clips.csv", "by_clip.csv", "contact.csv"},
      .figures = {{"by_scene.csv", "told error over true error, over the seeds of a scene",
                   LabelledDots{
                       .labels = {"scene"}, .x = "told_over_true", .x_label = "told / true", .wanted = 1}}},
      .tables = {
          {.file = "by_kind.csv",
           .from = {{"", "by_scene.csv"}},
           .heading = "kind",
           .row_of = {"kind"},
           .columns =
               {{.heading = "scenes", .of = "", .shows = Summary::rows},
                {.heading = "pictures", .of = "seeds", .shows = Summary::sum},
                {.heading = "told / true", .of = "told_over_true", .shows = Summary::range, .decimals = 2},
                {.heading = "told", .of = "told", .shows = Summary::range, .decimals = 4},
                {.heading = "true", .of = "true", .shows = Summary::range, .decimals = 4}}},
          {.file = "by_study_of_clips.csv",
           .from = {{"", "by_clip.csv"}},
           .heading = "study",
           .row_of = {"study"},
           .columns = {
               {.heading = "clips", .of = "", .shows = Summary::rows},
               {.heading = "told / true", .of = "told_over_true", .shows = Summary::range, .decimals = 2},
               {.heading = "told", .of = "told", .shows = Summary::range, .decimals = 4},
               {.heading = "told / true of changes",
                .of = "told_over_true_change",
                .shows = Summary::range,
                .decimals = 2},
               {.heading = "told of changes", .of = "told_change", .shows = Summary::range, .decimals = 4},
               {.heading = "true of changes",
                .of = "true_change",
                .shows = Summary::range,
                .decimals = 4}}}}};
}

}  // namespace seamline::laboratory
