#include "laboratory/convergence/convergence_tables.h"

#include <fmt/format.h>

#include <functional>

namespace seamline::renderer {
namespace {

/// Slope of one value in another over the rows that `use` lets through.
template <class Row>
std::optional<double> slope_of(const std::vector<Row>& rows, const std::function<double(const Row&)>& x,
                               const std::function<double(const Row&)>& y,
                               const std::function<bool(const Row&)>& use) {
  std::vector<double> xs, ys;
  for (const Row& row : rows) {
    if (!use(row)) continue;
    if (!(y(row) > 0)) continue;
    xs.push_back(x(row));
    ys.push_back(y(row));
  }
  // Two points always lie on a line, whatever they mean.
  return xs.size() < 3 ? std::nullopt : log_log_slope(xs, ys);
}

/// Nearer to the reference's own noise than this factor, an error says as much about the reference.
constexpr double clear_of_noise = 3;

double mega(std::int64_t value) {
  return value / 1e6;
}

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

}  // namespace

PartTables tables_of(const SampleResult& result) {
  PartTables out{.table = {.name = "samples",
                           .columns = {{"series", "", "estimator"},
                                       {"spp", "", "samples a pixel"},
                                       {"seconds", "s", "run time of all passes and of compositing"},
                                       {"rays", "million", "rays traced"},
                                       {"rmse", "", "error of the stimulus, display units 0 to 1"},
                                       {"rmse_given", "", "error off the object on a given photograph"}},
                           .rows = {}},
                 .slopes = {},
                 .remarks = {}};
  for (const SeriesRow& row : result.rows)
    out.table.rows.push_back(
        {row.series, std::int64_t{row.spp}, row.seconds, mega(row.rays), row.rmse, row.rmse_given});
  using Row = SeriesRow;
  const auto add = [&](const std::string& series, bool given, bool in_seconds, const std::string& why) {
    const auto error = [given](const Row& row) { return given ? row.rmse_given : row.rmse; };
    const double noise = given ? result.reference_noise_given : result.reference_noise;
    const std::optional<double> found = slope_of<Row>(
        result.rows, [&](const Row& row) { return in_seconds ? row.seconds : row.spp; }, error,
        [&](const Row& row) { return row.series == series && error(row) > clear_of_noise * noise; });
    out.slopes.push_back({"samples", series,
                          fmt::format("error in {}{}", in_seconds ? "seconds" : "samples",
                                      given ? ", off the object, background given" : ""),
                          found, -0.5, why});
  };
  for (const auto& [name, meaning] : result.meanings)
    for (const bool given : {false, true})
      for (const bool in_seconds : {true, false})
        add(name, given, in_seconds, in_seconds && !given ? meaning : "");
  out.remarks.push_back(fmt::format(
      "Reference: path coupled, {} samples a pixel, another seed, {:.3g} s; its own noise is estimated at "
      "{:.2g} (off the object on a given background {:.2g}). Slopes are fitted where the error is at least "
      "{:g} times that. -0.5 is the slope of independent random numbers; stratified sample points, as here, "
      "may reach -0.75 at edges; in seconds, what does not grow with the samples steepens the left end.",
      result.reference_spp, result.reference_seconds, result.reference_noise, result.reference_noise_given,
      clear_of_noise));
  return out;
}

PartTables tables_of(const MeshResult& result) {
  PartTables out{
      .table = {.name = "mesh",
                .columns = {{"tolerance", "", "bound on the relative error along rays; empty: full density"},
                            {"triangles", "", "of the depth mesh"},
                            {"build_seconds", "s", "mesh from the depth map"},
                            {"bvh_seconds", "s", "Embree's hierarchy"},
                            {"mesh_mb", "MB", "vertices and triangles"},
                            {"embree_mb", "MB", "as Embree counts it, its copy of the mesh included"},
                            {"mrays_per_second", "million/s", "camera ray and one bounce, one thread"},
                            {"depth_error", "", "largest |t - r| / r"},
                            {"rmse", "", "of the stimulus against full density, display units 0 to 1"},
                            {"changed_share", "", "of the pixels, by more than one 8-bit step"},
                            {"largest_change", "steps", "of any pixel's channel, 8-bit steps"}},
                .rows = {}},
      .slopes = {},
      .remarks = {}};
  for (const MeshRow& row : result.rows)
    out.table.rows.push_back({row.tolerance ? CsvValue(*row.tolerance) : CsvValue(), row.triangles,
                              row.build_seconds, row.bvh_seconds, mega(row.mesh_bytes),
                              mega(row.embree_bytes), row.rays_per_second / 1e6, row.depth_error, row.rmse,
                              row.changed_share, std::int64_t{row.largest_change_steps}});
  using Row = MeshRow;
  const auto tolerance = [](const Row& row) { return row.tolerance.value_or(0); };
  // Towards full density the tolerance no longer decides.
  const std::int64_t full_triangles = result.rows.back().triangles;
  const auto adaptive = [&](const Row& row) { return row.tolerance && 2 * row.triangles < full_triangles; };
  const auto add = [&](const std::string& of, const std::function<double(const Row&)>& y, double expected,
                       const std::string& why) {
    out.slopes.push_back(
        {"mesh", "adaptive", of, slope_of<Row>(result.rows, tolerance, y, adaptive), expected, why});
  };
  add(
      "depth error in tolerance", [](const Row& row) { return row.depth_error; }, 1, "the bound is used up");
  add(
      "picture error in tolerance", [](const Row& row) { return row.rmse; }, 1,
      "an edge moves in proportion; 1/2 where so little that single samples flip");
  add(
      "triangles in tolerance", [](const Row& row) { return static_cast<double>(row.triangles); }, -1,
      "on smooth surfaces; cells at depth jumps and straight walls do not change");
  out.remarks.push_back(fmt::format(
      "At the study's tolerance {:g} the rule (at most {} of the pixels change by more than one 8-bit step, "
      "none by more than {}) {}; {}. Slopes are fitted where under half of the triangles of full density "
      "are left.",
      result.default_tolerance, percent(allowed_changed_share), allowed_change_steps,
      result.default_keeps_rule ? "holds" : "DOES NOT HOLD",
      result.largest_that_keeps
          ? fmt::format("the largest tolerance tried that keeps it is {:g}", *result.largest_that_keeps)
          : "no tolerance tried keeps it"));
  return out;
}

PartTables tables_of(const std::vector<WidthRow>& rows) {
  PartTables out{.table = {.name = "width",
                           .columns = {{"width", "px", "of the depth map"},
                                       {"texels_per_pixel", "", "at the middle of the picture"},
                                       {"rmse", "", "against the reference, display units 0 to 1"},
                                       {"capture_seconds", "s", "depth map from the truth"},
                                       {"mesh_seconds", "s", "mesh and Embree's hierarchy"},
                                       {"stimulus_seconds", "s", "stimulus pass and compositing"},
                                       {"triangles", "", "of the depth mesh"},
                                       {"rays", "million", "of the stimulus pass"}},
                           .rows = {}},
                 .slopes = {},
                 .remarks = {}};
  for (const WidthRow& row : rows)
    out.table.rows.push_back({std::int64_t{row.width_px}, row.texels_per_pixel, row.rmse, row.capture_seconds,
                              row.mesh_seconds, row.stimulus_seconds, row.triangles, mega(row.rays)});
  using Row = WidthRow;
  const auto width = [](const Row& row) { return static_cast<double>(row.width_px); };
  const auto add = [&](const std::string& of, const std::function<double(const Row&)>& y,
                       const std::function<bool(const Row&)>& use, double expected, const std::string& why) {
    if (const auto found = slope_of<Row>(rows, width, y, use))
      out.slopes.push_back({"width", "depth width", of, found, expected, why});
  };
  const auto rmse = [](const Row& row) { return row.rmse; };
  const auto all = [](const Row&) { return true; };
  add(
      "error in width, texel wider than a pixel", rmse,
      [](const Row& row) { return row.texels_per_pixel < 1; }, -0.5,
      "a hard edge misplaced by more than a pixel");
  add(
      "error in width, texel within a pixel", rmse, [](const Row& row) { return row.texels_per_pixel >= 1; },
      -1, "a hard edge misplaced by a part of a pixel");
  add(
      "capture seconds in width", [](const Row& row) { return row.capture_seconds; },
      [](const Row& row) { return row.width_px >= 512; }, 2, "a ray a texel, from W = 512");
  add(
      "stimulus seconds in width", [](const Row& row) { return row.stimulus_seconds; }, all, 0,
      "a ray costs the logarithm of the triangles");
  return out;
}

PartTables tables_of(const std::vector<LinkRow>& rows) {
  PartTables out{.table = {.name = "links",
                           .columns = {{"link", "", "of the chain that depth goes through, which varies"},
                                       {"variant", "", "of this link; none: it is not there"},
                                       {"rmse", "", "against the reference, display units 0 to 1"},
                                       {"scene_seconds", "s", "from the truth to the local scene"},
                                       {"stimulus_seconds", "s", "stimulus pass and compositing"},
                                       {"triangles", "", "of the local scene"}},
                           .rows = {}},
                 .slopes = {},
                 .remarks = {}};
  for (const LinkRow& row : rows)
    out.table.rows.push_back(
        {row.link, row.variant, row.rmse, row.scene_seconds, row.stimulus_seconds, row.triangles});
  return out;
}

PartTables tables_of(const std::vector<RealtimeRow>& rows) {
  PartTables out{
      .table = {.name = "realtime",
                .columns = {{"method", "", "of real time, in place of rays; traced: rays"},
                            {"setting", "", "of the method"},
                            {"rmse", "", "against rays through the same local scene, display units 0 to 1"},
                            {"prepare_seconds", "s", "what is made before the first pixel"},
                            {"ask_seconds", "s", "one sample of every pixel"},
                            {"frame_seconds", "s", "both"}},
                .rows = {}},
      .slopes = {},
      .remarks = {"The depth mesh answers everything but bounce light and mirrors; seconds are processor "
                  "time, medians of three."}};
  for (const RealtimeRow& row : rows)
    out.table.rows.push_back({row.method, row.setting, row.rmse, row.prepare_seconds, row.ask_seconds,
                              row.prepare_seconds + row.ask_seconds});
  return out;
}

PartTables tables_of(const LightResult& result) {
  PartTables out{
      .table = {.name = "light",
                .columns = {{"light", "", "what alone shines"},
                            {"strategy", "", "how directions to it are chosen"},
                            {"rays", "", "times that every sample chooses"},
                            {"spp", "", "samples a pixel, each with a camera ray"},
                            {"seconds", "s", "processor time"},
                            {"traced", "million", "rays traced"},
                            {"error", "", "root mean square over the pixels, over their mean radiance"}},
                .rows = {}},
      .slopes = {},
      .remarks = {}};
  for (const LightRow& row : result.rows)
    out.table.rows.push_back({row.light, row.strategy, std::int64_t{row.rays}, std::int64_t{row.spp},
                              row.seconds, mega(row.traced), row.error});
  std::string agree;
  for (const LightResult::Agreement& one : result.agreements)
    agree += fmt::format("{}{} by {} {:+.2f} % ({:.2f})", agree.empty() ? "" : ", ", one.light, one.strategy,
                         100 * one.excess, 100 * one.standard_error);
  out.remarks.push_back(
      fmt::format("Light that reaches the truth's first surfaces straight. The reference of each "
                  "kind has {} samples by its last strategy; mean radiance with the most samples "
                  "above it, with standard error: {}.",
                  result.reference_spp, agree));
  return out;
}

PartTables tables_of(const CompositingResult& result) {
  PartTables out{
      .table = {.name = "compositing",
                .columns = {{"compositing", "", "ratio: B with / without; additive: B + with - without"},
                            {"renders", "", "how the renderings with and without share random numbers"},
                            {"spp", "", "samples a pixel"},
                            {"seconds", "s", "of rendering the local scene"},
                            {"noise", "", "between seeds, off the object, display units 0 to 1"},
                            {"rmse", "", "against the perfect insertion, off the object"},
                            {"below_black", "", "share of pixels off the object"},
                            {"above_white", "", "share of pixels off the object"}},
                .rows = {}},
      .slopes = {},
      .remarks = {}};
  for (const CompositingRow& row : result.rows)
    out.table.rows.push_back({std::string(row.compositing == Compositing::ratio ? "ratio" : "additive"),
                              row.renders, std::int64_t{row.spp}, row.seconds, row.noise, row.rmse,
                              row.below_black, row.above_white});
  out.remarks.push_back(fmt::format(
      "Everything is answered by the depth mesh, as in the paper; of the perfect insertion {} of the pixels "
      "are over display white.",
      percent(result.reference_above_white)));
  return out;
}

CsvTable slope_table(const std::vector<SlopeRow>& rows) {
  CsvTable table{.name = "slopes",
                 .columns = {{"part", "", "figure"},
                             {"series", "", "line of the figure"},
                             {"of", "", "what, in what"},
                             {"found", "", "least squares in log-log"},
                             {"expected", "", ""},
                             {"why", "", ""}},
                 .rows = {}};
  for (const SlopeRow& row : rows)
    table.rows.push_back(
        {row.part, row.series, row.of, row.found ? CsvValue(*row.found) : CsvValue(), row.expected, row.why});
  return table;
}

}  // namespace seamline::renderer
