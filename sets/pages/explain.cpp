#include "sets/pages/explain.h"

#include <fmt/core.h>

#include <algorithm>

#include "support/text/counted.h"

namespace seamline::renderer {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Rows with aligned columns, indented; nothing is padded at line ends.
std::string table(const Rows& rows, int indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths.resize(std::max(widths.size(), i + 1));
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::string out;
  for (const auto& row : rows) {
    out += fmt::format("{:{}}", "", indent);
    for (std::size_t i = 0; i < row.size(); ++i)
      out += i + 1 < row.size() ? fmt::format("{:{}}", row[i], widths[i] + 2) : row[i];
    out += "\n";
  }
  return out;
}

const char* letter(Who who) {
  switch (who) {
    case Who::truth:
      return "T";
    case Who::depth:
      return "D";
  }
  return "";
}

const char* kept(Keep keep) {
  switch (keep) {
    case Keep::everything:
      return "everything";
    case Keep::object_only:
      return "the object";
    case Keep::all_but_object:
      return "all but the object";
  }
  return "";
}

std::string none_or_counted(int number, const char* one) {
  return number == 0 ? fmt::format("no {}", one) : counted(number, one);
}

std::string light_text(const ScenePlan& plan) {
  const LightFacts& light = plan.light;
  const char* sky = light.sky_is_mapped ? "an environment map" : light.sky_is_dark ? "no sky" : "sky";
  std::string text = "  Light: " + none_or_counted(light.suns, "sun") + ", ";
  if (light.lamps > 0) text += counted(light.lamps, "lamp") + ", ";
  text += fmt::format("{}, {}{}.", sky, none_or_counted(plan.choices.bounces, "bounce"),
                      light.emits ? ", surfaces that emit" : "");
  if (light.emitting_triangles > 0)
    text += fmt::format(" {} sampled as lamps.",
                        counted(light.emitting_triangles, "triangle of the background is",
                                "triangles of the background are"));
  return text + fmt::format(" Surfaces reflect at most {:.2f} of it.\n", light.brightest_albedo);
}

std::string filter_text(const FilterStrength& filter) {
  return filter.levels == 0 ? "none" : counted(filter.levels, "level");
}

/// What the estimator holds to, besides what it leaves out.
std::string choices_text(const EstimatorChoices& choices) {
  const bool fast = choices.estimator == Estimator::fast;
  Rows rows = {{"samples", fmt::format("{} a pixel", choices.first_spp)}};
  if (choices.error)
    rows = {{"samples", fmt::format("{} a pixel first, at most {}", choices.first_spp, choices.most_spp)},
            {"photograph", fmt::format("until its estimated error is below {:.4f}",
                                       *choices.error * choices.photograph_share)}};
  if (choices.first_ratio_spp && choices.first_difference_spp)
    rows.push_back(
        {"depth mesh", fmt::format("{} samples first for a ratio, {} for what it adds on the object",
                                   *choices.first_ratio_spp, *choices.first_difference_spp)});
  rows.push_back({"of a sample", none_or_counted(choices.sky_rays, "ray") + " to the sky"});
  if (choices.tail_every > 1) rows.back()[1] += fmt::format(", a tail every {} samples", choices.tail_every);
  if (fast)
    rows.push_back(
        {"filters", fmt::format("{} at most {}, what only decides a ratio {}",
                                choices.filters_sky ? "bounce light and sky" : "bounce light",
                                filter_text(choices.filters.back()), filter_text(choices.ratio_filter))});
  return "  How it is sampled:\n" + table(rows, 4);
}

std::string answers_text(const ScenePlan& plan) {
  Rows rows = {{"artifact", "shadow lands on", "real lit", "object lit", "in front", "bounce light"}};
  if (plan.light.is_glossy) rows[0].push_back("mirrored");
  rows[0].push_back("kept");
  for (const PlannedAnswers& one : plan.answers) {
    const Answers& a = one.recipe.answers;
    rows.push_back({std::string(word(one.artifact)), letter(a.receiver), letter(a.real_lit),
                    letter(a.object_lit), letter(a.occlusion), letter(a.bounce)});
    if (plan.light.is_glossy) rows.back().push_back(letter(a.mirrored));
    rows.back().push_back(kept(one.recipe.keep));
  }
  return "  Who answers, T the truth or D the depth mesh:\n" + table(rows, 4);
}

std::string omissions_text(const ScenePlan& plan) {
  Rows rows = {{"name", "saves", "change of the picture"}};
  for (const PlannedOmission& one : plan.omissions)
    rows.push_back({one.name + (one.always ? " (always)" : ""), one.saves, one.change});
  std::string out = "  Left out:\n" + table(rows, 4) + "  Because:\n";
  Rows reasons;
  for (const PlannedOmission& one : plan.omissions) reasons.push_back({one.name, one.why});
  out += table(reasons, 4);
  if (plan.not_omitted.empty()) return out;
  Rows needed;
  for (const NotOmitted& one : plan.not_omitted) needed.push_back({one.name, one.why});
  return out + "  Not left out:\n" + table(needed, 4);
}

const char* mesh_albedo_text(MeshAlbedo albedo) {
  switch (albedo) {
    case MeshAlbedo::constant:
      return "the study's, one number";
    case MeshAlbedo::truth:
      return "the truth's by direction, a ray a texel";
    case MeshAlbedo::photograph:
      return "the photograph's radiance over the local scene's irradiance, by direction (0.01 to 0.95); the "
             "study's where the photograph shows nothing";
  }
  return "";
}

/// Each link of the depth that a condition's meshes are made of, and what is absent.
std::string depth_text(const StudyDefinition& study) {
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  const bool exact = std::none_of(conditions.begin(), conditions.end(),
                                  [](const ConditionDefinition& one) { return one.depth.chain.has_value(); });
  const bool painted = std::any_of(conditions.begin(), conditions.end(), [](const ConditionDefinition& one) {
    return one.depth.albedo != MeshAlbedo::constant;
  });
  std::string beside;
  if (painted)
    for (const ConditionDefinition& condition : conditions)
      beside += fmt::format("Albedo of the depth mesh{}: {}.\n",
                            condition.name.empty() ? "" : " in the condition " + condition.name,
                            mesh_albedo_text(condition.depth.albedo));
  for (const ConditionDefinition& condition : conditions)
    if (condition.depth.mitigation != Mitigation{})
      beside += fmt::format("Mitigation{}: {}.\n",
                            condition.name.empty() ? "" : " in the condition " + condition.name,
                            canonical_text(condition.depth.mitigation));
  for (const ConditionDefinition& condition : conditions)
    if (condition.depth.pipeline != Pipeline{})
      beside += fmt::format("Pipeline{}: {}; what it does not name is traced.\n",
                            condition.name.empty() ? "" : " of the condition " + condition.name,
                            canonical_text(condition.depth.pipeline));
  for (const ConditionDefinition& condition : conditions)
    if (!condition.scenes.empty() && !condition.scenes.front().view.is_mono())
      beside +=
          fmt::format("View{}: {}.\n", condition.name.empty() ? "" : " of the condition " + condition.name,
                      canonical_text(condition.scenes.front().view));
  if (exact)
    return "Depth: exact panoramas; no noise, repair, registration, calibration error or delay; sheets where "
           "it jumps.\n" +
           beside;
  std::string out;
  for (const ConditionDefinition& condition : conditions) {
    Rows rows;
    for (const auto& [link, what] : depth_links(condition.depth.chain, condition.depth.width_px))
      rows.push_back({link, what});
    rows.push_back({"level", std::string(facts(study.level.quantity).key)});
    out += condition.name.empty() ? "Depth:\n" : fmt::format("Depth of the condition {}:\n", condition.name);
    out += table(rows, 2);
  }
  return out + beside;
}

std::string millions(double number) {
  return fmt::format("{:.2f} M", number * 1e-6);
}

}  // namespace

std::string explain(const StudyDefinition& study, const RenderPlan& plan) {
  const RenderSettings& settings = plan.settings;
  std::string out = fmt::format(
      "{}: {} x {} px, {} estimator, {}, isolation {}\n", study.name, study.width_px, study.height_px,
      word(settings.estimator),
      settings.error ? fmt::format("estimated error below {} of the display range", *settings.error)
                     : counted(settings.spp, "sample") + " a pixel",
      word(plan.isolation));
  out += depth_text(study);
  for (const ScenePlan& scene : plan.scenes)
    out += fmt::format("\n{}\n", scene.scene) + light_text(scene) + choices_text(scene.choices) +
           answers_text(scene) + omissions_text(scene);
  return out + "\n--no-omit NAME turns one off, except those marked (always).\n";
}

std::string explain_savings(const std::string& scene, const Savings& savings) {
  const RayCounts counts = savings.counts();
  double rays = 0;
  Rows rows;
  const auto row = [&](const char* name, double saved_rays, const std::string& text) {
    if (saved_rays <= 0) return;
    rays += saved_rays;
    rows.push_back({name, millions(saved_rays) + " rays", text});
  };
  const auto shared = static_cast<double>(savings.joint.traced) * static_cast<double>(savings.stimuli);
  row("shared_truth", shared,
      fmt::format("{} times the joint pass of {} rays", savings.stimuli, millions(savings.joint.traced)));
  if (counts.tails_traced > 0) {
    const double rays_each = static_cast<double>(counts.tail_rays) / static_cast<double>(counts.tails_traced);
    const double left_out = counts.tails_left_out;
    row("path_tails", left_out * rays_each,
        fmt::format("{} tails at {:.2f} rays", millions(left_out), rays_each));
  }
  if (const FrameBlocks& blocks = savings.frames; blocks.count() > 0) {
    const double percent = 100.0 / blocks.count();
    row("shared_frames", blocks.rays_spared,
        fmt::format("{:.0f} % of the blocks as in the clip's base, {:.0f} % beside it",
                    percent * blocks.as_in_base, percent * blocks.beside_base));
  }
  row("ratio_samples", savings.ratio_rays,
      fmt::format("{} samples of the depth mesh", millions(savings.ratio_samples)));
  row("untouched_tiles", savings.untouched_rays,
      fmt::format("{} blocks of pixels, camera rays alone", savings.untouched_blocks));
  row("dark_sky", counts.dark_sky_rays, "last rays of paths");
  if (savings.order_bytes > 0)
    rows.push_back(
        {"who_is_in_front", fmt::format("{:.1f} MB", savings.order_bytes * 1e-6), "of samples, not kept"});
  const double traced = counts.traced;
  std::string out =
      fmt::format("\n{}: {} rays traced, about {} left out\n", scene, millions(traced), millions(rays));
  return out + table(rows, 4);
}

}  // namespace seamline::renderer
