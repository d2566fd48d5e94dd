#include "laboratory/stability/light/ratio_cases.h"

#include <fmt/core.h>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/worst.h"

namespace seamline::stability {
namespace {

constexpr int side = 4;

/// Every pixel lit by 2, on surfaces that have nothing in common, so that no pocket borrows from another.
StimulusSums bright_layers(float light = 2.0F) {
  StimulusSums sums{.width_px = side, .height_px = side, .spp = 2};
  sums.depth_lights_uncovered = true;
  for (auto& half : sums.halves) half.resize(side * side);
  for (int i = 0; i < side * side; ++i) {
    sums.guides.push_back({Eigen::Vector3f(static_cast<float>(i % 3 == 0), static_cast<float>(i % 3 == 1),
                                           static_cast<float>(i % 3 == 2)),
                           1.0F + 10.0F * static_cast<float>(i)});
    StimulusPixel& pixel = sums.halves[0][i];
    pixel.uncovered_surfaces = 2;
    pixel.background = pixel.without_object = pixel.with_object = Rgb::Constant(light);
  }
  return sums;
}

/// Largest difference of two pictures.
double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = worse(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return largest;
}

StabilityCase denominator_case(const std::string& name, float denominator, const std::string& tried) {
  return {.group = "light",
          .name = name,
          .tried = "a composite's ratio whose denominator is " + tried,
          .expected = "the photograph, unchanged",
          .unit = "radiance of 1",
          .tolerance = 0,
          .reason = "the rule says 1 where there is no light to compare: nothing is rounded",
          .run = [denominator](const StabilityOptions&) { return try_denominator(denominator); }};
}

}  // namespace

Finding try_denominator(float denominator, const ComposeRule& rule) {
  StimulusSums sums = bright_layers();
  for (const std::size_t dark : {5U, 10U}) {
    sums.halves[0][dark].without_object = Rgb::Constant(denominator);
    sums.halves[0][dark].with_object = Rgb::Constant(dark == 5 ? 0.0F : 1e-3F);
  }
  const Composite composite = rule(sums);
  const double error =
      largest_difference(composite.picture.values, std::vector<float>(side * side * 3, 1.0F));
  return {error, fmt::format("pixels {:g} and {:g}", composite.picture.at(1, 1), composite.picture.at(2, 2))};
}

Finding try_brightened(float brighter, const ComposeRule& rule) {
  StimulusSums sums = bright_layers();
  sums.halves[0][5].with_object = Rgb::Constant(2.0F * brighter);
  const double ratio = rule(sums).ratio.at(1, 1);
  return {std::abs(ratio - 4), fmt::format("ratio {:g}", ratio)};
}

Finding try_unchanged(const ComposeRule& rule) {
  double error = 0;
  int tried = 0;
  for (int power = -38; power <= 30; power += 2, ++tried) {
    StimulusSums sums = bright_layers();
    sums.halves[0][5].without_object = sums.halves[0][5].with_object =
        Rgb::Constant(std::pow(10.0F, static_cast<float>(power)));
    error = worse(error,
                  largest_difference(rule(sums).picture.values, std::vector<float>(side * side * 3, 1.0F)));
  }
  return {error, fmt::format("{} strengths", tried)};
}

Finding try_exposures(const ComposeRule& rule) {
  const auto ratios = [&](int power) {
    StimulusSums sums = bright_layers(std::ldexp(2.0F, power));
    sums.halves[0][5].with_object *= 0.3F;
    sums.halves[0][6].without_object *= 0.05F;  // sealed: the photograph is bright there
    sums.halves[0][6].with_object *= 0.01F;
    sums.halves[0][9].with_object *= 3.1F;
    return rule(sums).ratio.values;
  };
  const std::vector<float> at_1 = ratios(0);
  double error = 0;
  for (int power = -80; power <= 80; power += 8)
    error = worse(error, largest_difference(ratios(power), at_1));
  return {error, fmt::format("21 exposures, ratio {:.6g} in a shadow", at_1[15])};
}

StabilityCases ratio_cases() {
  return {
      denominator_case("ratio-denominator-0", 0.0F, "0"),
      denominator_case("ratio-denominator-1e-30", 1e-30F, "1e-30"),
      denominator_case("ratio-denominator-denormal", 1e-40F, "1e-40, a denormal number"),
      {.group = "light",
       .name = "ratio-brightened-1e30",
       .tried = "an object that makes a pixel of the local scene 1e30 times brighter",
       .expected = "a ratio of 4, where it is clamped",
       .unit = "ratio",
       .tolerance = 0,
       .reason = "a clamp does not round",
       .run = [](const StabilityOptions&) { return try_brightened(1e30F); }},
      {.group = "light",
       .name = "ratio-unchanged",
       .tried = "pixels that the object does not change, lit by 1e-38 to 1e30",
       .expected = "the photograph, unchanged",
       .unit = "radiance of 1",
       .tolerance = 0,
       .reason = "written 1 + change / light, the ratio is exactly 1 where nothing changes",
       .run = [](const StabilityOptions&) { return try_unchanged(); }},
      {.group = "light",
       .name = "ratio-exposures",
       .tried = "shadow, sealed well and brightened pixel with all light times 2^-80 to 2^80",
       .expected = "the same ratios",
       .unit = "ratio",
       .tolerance = 0,
       .reason = "powers of two scale floating-point numbers without rounding",
       .run = [](const StabilityOptions&) { return try_exposures(); }},
  };
}

}  // namespace seamline::stability
