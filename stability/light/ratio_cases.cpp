#include "stability/light/ratio_cases.h"

#include <fmt/core.h>

#include "stability/common/groups.h"
#include "stability/common/worst.h"

namespace seamline::stability {
namespace {

constexpr int side = 4;

/// Every pixel lit by 2, on surfaces that have nothing in common, so that no pocket borrows from another.
StimulusLayers bright_layers(float light = 2.0F) {
  StimulusLayers layers{.width_px = side, .height_px = side, .spp = 2};
  layers.depth_lights_rest = true;
  for (auto& half : layers.halves) half.resize(side * side);
  for (int i = 0; i < side * side; ++i) {
    layers.guides.push_back({Eigen::Vector3f(static_cast<float>(i % 3 == 0), static_cast<float>(i % 3 == 1),
                                             static_cast<float>(i % 3 == 2)),
                             1.0F + 10.0F * static_cast<float>(i)});
    StimulusSums& pixel = layers.halves[0][static_cast<std::size_t>(i)];
    pixel.rest = 2;
    pixel.background = pixel.no = pixel.with = Rgb::Constant(light);
  }
  return layers;
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
  StimulusLayers layers = bright_layers();
  for (const std::size_t dark : {5U, 10U}) {
    layers.halves[0][dark].no = Rgb::Constant(denominator);
    layers.halves[0][dark].with = Rgb::Constant(dark == 5 ? 0.0F : 1e-3F);
  }
  const Composite composite = rule(layers);
  const double error =
      largest_difference(composite.picture.values, std::vector<float>(side * side * 3, 1.0F));
  return {error, fmt::format("pixels {:g} and {:g}", composite.picture.at(1, 1), composite.picture.at(2, 2))};
}

Finding try_brightened(float brighter, const ComposeRule& rule) {
  StimulusLayers layers = bright_layers();
  layers.halves[0][5].with = Rgb::Constant(2.0F * brighter);
  const double ratio = static_cast<double>(rule(layers).ratio.at(1, 1));
  return {std::abs(ratio - 4), fmt::format("ratio {:g}", ratio)};
}

Finding try_unchanged(const ComposeRule& rule) {
  double error = 0;
  int tried = 0;
  for (int power = -38; power <= 30; power += 2, ++tried) {
    StimulusLayers layers = bright_layers();
    layers.halves[0][5].no = layers.halves[0][5].with =
        Rgb::Constant(std::pow(10.0F, static_cast<float>(power)));
    error = worse(error,
                  largest_difference(rule(layers).picture.values, std::vector<float>(side * side * 3, 1.0F)));
  }
  return {error, fmt::format("{} strengths", tried)};
}

Finding try_exposures(const ComposeRule& rule) {
  const auto ratios = [&](int power) {
    StimulusLayers layers = bright_layers(std::ldexp(2.0F, power));
    layers.halves[0][5].with *= 0.3F;
    layers.halves[0][6].no *= 0.05F;  // sealed: the photograph is bright there
    layers.halves[0][6].with *= 0.01F;
    layers.halves[0][9].with *= 3.1F;
    return rule(layers).ratio.values;
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
