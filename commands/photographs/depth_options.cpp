#include "commands/photographs/depth_options.h"

#include <fmt/core.h>

#include <array>

#include "commands/options/setting_option.h"
#include "sensors/files/depth_units.h"
#include "sensors/files/depth_words.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

constexpr NumberRange any_line_term{-1e12, 1e12};

std::string unit_names() {
  std::string names;
  for (const sensors::DepthUnit& unit : sensors::depth_units())
    names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

std::vector<sensors::KnownPoint> points_of(const std::vector<double>& numbers) {
  if (numbers.size() % 3 != 0)
    throw input_error({.field = "--depth-point",
                       .wanted = "three numbers a point, X,Y,METRES",
                       .found = fmt::format("{} numbers", numbers.size())});
  std::vector<sensors::KnownPoint> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    if (!(numbers[i + 2] > 0))
      throw input_error({.field = "--depth-point",
                         .wanted = "a distance above 0 m",
                         .found = fmt::format("{:g} m", numbers[i + 2])});
    points.push_back({.x_px = numbers[i], .y_px = numbers[i + 1], .depth_m = numbers[i + 2]});
  }
  return points;
}

}  // namespace

void add_depth_file_options(CLI::App& command, DepthOptions& options, PhotoDepthRequest& request) {
  command.add_option(
      "--depth-channel", request.channel,
      "its channel of depth, such as Z or depth.V, where the file has several and names do not say");
  add_number(
      command, "--metres-per-step", options.metres_per_step, {1e-9, 1e9, "m"},
      "what 1 in the depth map is worth: 0.001 for millimetres (default: 1 of floating-point numbers; of "
      "whole numbers this or --depth-unit must be given)");
  command.add_option("--depth-unit", options.unit,
                     "the same by name, with that source's codes for nothing: " + unit_names());
  add_number(
      command, "--nothing", options.nothing, {-1e30, 1e30},
      "values of the file that stand for no depth, beside 0, negative ones and no number (default: 65535 "
      "of whole numbers of 16 bits)")
      ->delimiter(',');
  add_choice(
      command, "--depth-value", options.value,
      std::array{sensors::DepthValue::metres, sensors::DepthValue::inverse, sensors::DepthValue::relative},
      "what its values are: metres (in the unit), or an estimate's: inverse (1 / distance = scale * "
      "value + shift) or relative (distance = scale * value + shift)");
  add_number(command, "--depth-scale", options.scale, any_line_term, "of an estimate, stated");
  add_number(command, "--depth-shift", options.shift, any_line_term, "of an estimate, stated (default: 0)");
  add_number(
      command, "--depth-point", options.points, {-1e9, 1e9},
      "a point of the photograph whose distance is known, for an estimate's scale and shift: X,Y in pixels "
      "from the upper left corner, and METRES; two or more, one after another")
      ->delimiter(',')
      ->type_name("X,Y,METRES");
  command.add_option("--depth-reference", request.reference,
                     "a measured map of the same view, for an estimate's scale and shift by least squares; "
                     "--metres-per-step or --depth-unit is then its unit");
}

void take_depth_options(const DepthOptions& options, const CLI::App& command, PhotoDepthRequest& request) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  const auto refuse = [&](const char* name, const std::string& wanted, const std::string& found) {
    if (given(name)) throw input_error({.field = name, .wanted = wanted, .found = found});
  };
  if (given("--metres-per-step")) request.metres_per_step = options.metres_per_step;
  if (given("--depth-unit")) {
    refuse("--metres-per-step", "--metres-per-step or --depth-unit, not both", "both");
    const sensors::DepthUnit& unit = sensors::depth_unit(options.unit, "--depth-unit");
    request.metres_per_step = unit.metres_per_step;
    request.nothing = unit.nothing;
  }
  if (given("--nothing")) request.nothing = options.nothing;
  constexpr std::array lines = {"--depth-scale", "--depth-point", "--depth-reference"};
  if (options.value == sensors::DepthValue::metres) {
    for (const char* name : {"--depth-scale", "--depth-shift", "--depth-point", "--depth-reference"})
      refuse(name, "--depth-value inverse or relative beside it", "a map of distances");
    return;
  }
  sensors::DepthEstimate estimate;
  estimate.value = options.value;
  int ways = 0;
  for (const char* name : lines) ways += given(name) ? 1 : 0;
  if (ways > 1)
    throw input_error({.field = "--depth-scale",
                       .wanted = "one of --depth-scale, --depth-point and --depth-reference",
                       .found = "several"});
  if (!given("--depth-scale")) refuse("--depth-shift", "--depth-scale beside it", "a shift alone");
  if (!given("--depth-reference"))
    for (const char* name : {"--metres-per-step", "--depth-unit"})
      refuse(name, "--depth-reference beside it, whose unit it is: an estimate has none",
             "--depth-value " + std::string(word(options.value)));
  if (given("--depth-scale")) {
    if (!(options.scale > 0))
      throw input_error({.field = "--depth-scale",
                         .wanted = "a scale above 0",
                         .found = fmt::format("{:g}", options.scale)});
    estimate.stated = sensors::DepthLine{.scale = options.scale, .shift = options.shift};
  }
  estimate.points = points_of(options.points);
  estimate.reference = request.reference;
  estimate.reference_metres_per_step = request.metres_per_step;
  request.metres_per_step.reset();
  request.estimate = estimate;
}

}  // namespace seamline::renderer
