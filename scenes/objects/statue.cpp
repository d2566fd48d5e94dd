#include <cmath>

#include "scenes/objects/clay.h"
#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace statue_parts {
namespace {

using V = Eigen::Vector3d;
constexpr int x_axis = 0;
constexpr double plinth_top_m = 0.17;

void add_plinth(Sculpture& s) {
  s.strokes.push_back(block({0, 0.035, 0}, {0.26, 0.035, 0.23}, 0.006, 0));
  s.strokes.push_back(drum({0, 0.06, 0}, 0.215, 0.05, 0.02, 0.0));
  s.strokes.push_back(drum({0, 0.09, 0}, 0.185, 0.08, 0.008, 0.012));
  s.strokes.push_back(drum({0, 0.145, 0}, 0.205, 0.03, 0.01, 0.006));
}

/// A piece of cloth hanging about a swaying axis: an oval tube whose wall is pleated.
struct Cloth {
  double bottom_m = 0, top_m = 1;
  double hem_radius_m = 0.2, waist_radius_m = 0.1;
  double pleats = 11;      ///< around
  double depth_m = 0.03;   ///< of the pleats at the hem; half of it remains at the top
  double swirl_rad = 0.5;  ///< how far pleats wander from top to bottom
  double lean_m = 0;       ///< the hem's shift in z
};

/// Rounded ridges with sharp valleys, as folds have; in 0..1.
double pleat(double phase) {
  return 1.0 - std::abs(std::sin(phase));
}

Stroke hanging(const Cloth& c, double blend_m) {
  const auto distance = [c](const V& p) {
    const double t = std::clamp((p.y() - c.bottom_m) / (c.top_m - c.bottom_m), 0.0, 1.0);
    const double flare = std::pow(1 - t, 1.5);
    const double sway = 0.025 * std::sin(2.6 * t);
    const double x = p.x() + sway;
    const double z = (p.z() - c.lean_m * flare) * 1.12;
    const double angle = std::atan2(x, z);
    const double wander =
        c.swirl_rad * (1 - t) * std::sin(angle + 0.6) + 0.35 * std::sin(3.1 * t + 2 * angle);
    const double depth = c.depth_m * (0.35 + 0.65 * flare);
    const double folds = 0.62 * pleat(0.5 * c.pleats * angle + wander) +
                         0.38 * pleat(0.5 * (c.pleats + 6) * angle - 1.7 * wander + 1.0);
    const double radius =
        c.waist_radius_m + (c.hem_radius_m - c.waist_radius_m) * flare + depth * (folds - 0.5);
    const double side = 0.75 * (std::hypot(x, z) - radius);
    const double end = std::max(c.bottom_m - p.y(), p.y() - c.top_m);
    return std::max(side, end);
  };
  const double reach = c.hem_radius_m + c.depth_m + 0.03;
  const Eigen::AlignedBox3d box(V(-reach, c.bottom_m, -reach - std::abs(c.lean_m)),
                                V(reach, c.top_m, reach + std::abs(c.lean_m)));
  return {.distance = distance, .bounds = box, .blend_m = blend_m};
}

void add_robe(Sculpture& s) {
  s.strokes.push_back(hanging({.bottom_m = plinth_top_m - 0.01,
                               .top_m = 1.06,
                               .hem_radius_m = 0.205,
                               .waist_radius_m = 0.108,
                               .pleats = 13,
                               .depth_m = 0.05,
                               .swirl_rad = 0.9,
                               .lean_m = -0.01},
                              0.01));
  s.strokes.push_back(limb({{{0.06, 0.93, 0.04}, 0.085},
                            {{0.085, 0.66, 0.125}, 0.062},
                            {{0.075, 0.4, 0.1}, 0.045},
                            {{0.08, 0.22, 0.13}, 0.03}},
                           0.05));
  s.strokes.push_back(lump({0.085, 0.185, 0.20}, {0.032, 0.024, 0.07}, 0.01));
  s.strokes.push_back(lump({-0.07, 0.185, 0.16}, {0.03, 0.022, 0.06}, 0.01));
  s.strokes.push_back(hanging({.bottom_m = 0.80,
                               .top_m = 1.06,
                               .hem_radius_m = 0.178,
                               .waist_radius_m = 0.105,
                               .pleats = 11,
                               .depth_m = 0.042,
                               .swirl_rad = 1.6},
                              0.004));
  s.strokes.push_back(limb({{{-0.12, 1.045, 0.0}, 0.018},
                            {{-0.07, 1.05, 0.09}, 0.02},
                            {{0.05, 1.055, 0.1}, 0.02},
                            {{0.115, 1.045, 0.02}, 0.018},
                            {{0.06, 1.045, -0.09}, 0.018},
                            {{-0.07, 1.045, -0.09}, 0.018},
                            {{-0.12, 1.045, 0.0}, 0.018}},
                           0.008));
  for (int i = 0; i < 4;
       ++i) {  // the cloak: ropes of folds from the left shoulder to the right hip, and its fall at the side
    const double d = 0.042 * i;
    s.strokes.push_back(limb({{{0.135 - 0.2 * d, 1.36 - 0.4 * d, 0.0}, 0.022},
                              {{0.09 - d, 1.26 - d, 0.105}, 0.019},
                              {{-0.02 - 0.6 * d, 1.12 - 0.7 * d, 0.118 + 0.02 * i}, 0.018},
                              {{-0.12, 1.0 - 1.1 * d, 0.06 + 0.012 * i}, 0.022},
                              {{-0.15, 0.93 - d, -0.02}, 0.014}},
                             0.004));
  }
}

void add_torso(Sculpture& s) {
  s.strokes.push_back(lump({0, 1.13, 0.0}, {0.112, 0.17, 0.088}, 0.03));
  s.strokes.push_back(lump({0, 1.26, -0.005}, {0.138, 0.115, 0.09}, 0.04));
  add_pair(s, lump({0.058, 1.225, 0.075}, {0.052, 0.055, 0.045}, 0.025), x_axis);
  s.strokes.push_back(
      limb({{{-0.13, 1.335, -0.01}, 0.05}, {{0, 1.365, -0.01}, 0.06}, {{0.13, 1.335, -0.01}, 0.05}}, 0.03));
  s.strokes.push_back(limb(
      {{{0, 1.36, -0.01}, 0.052}, {{-0.01, 1.44, 0.005}, 0.043}, {{-0.012, 1.48, 0.015}, 0.043}}, 0.025));
}

void add_head(Sculpture& s) {
  const V head(-0.015, 1.54, 0.02);
  s.strokes.push_back(lump(head, {0.066, 0.085, 0.078}, 0.02));
  s.strokes.push_back(lump(head + V(0, -0.045, 0.035), {0.043, 0.05, 0.042}, 0.02));
  s.strokes.push_back(
      limb({{head + V(0, 0.012, 0.077), 0.008}, {head + V(0, -0.022, 0.095), 0.013}}, 0.01, 1));
  for (const double side : {-1.0, 1.0}) {
    s.strokes.push_back(carved(lump(head + V(0.027 * side, 0.0, 0.082), {0.02, 0.013, 0.016}, 0.008)));
    s.strokes.push_back(
        limb({{head + V(0.01 * side, 0.022, 0.078), 0.009}, {head + V(0.045 * side, 0.02, 0.062), 0.009}},
             0.008, 1));
  }
  s.strokes.push_back(lump(head + V(0, -0.052, 0.077), {0.02, 0.008, 0.012}, 0.005));
  for (int i = 0; i < 13; ++i) {  // locks swept back from the brow into a knot
    const double a = -1.5 + 0.25 * i;
    const V brow = head + V(0.07 * std::sin(a), 0.035 + 0.045 * std::cos(a), 0.05);
    const V side = head + V(0.088 * std::sin(a), 0.02 + 0.075 * std::cos(a), -0.02);
    s.strokes.push_back(limb({{brow, 0.014},
                              {side, 0.02},
                              {head + V(0.05 * std::sin(a), 0.01 + 0.035 * std::cos(a), -0.085), 0.016}},
                             0.006));
  }
  s.strokes.push_back(lump(head + V(0, 0.025, -0.105), {0.045, 0.042, 0.04}, 0.008));
  for (const double side : {-1.0, 1.0})
    s.strokes.push_back(limb({{head + V(0.055 * side, -0.02, -0.05), 0.018},
                              {head + V(0.075 * side, -0.1, -0.03), 0.017},
                              {head + V(0.07 * side, -0.17, 0.03), 0.015},
                              {head + V(0.095 * side, -0.24, 0.06), 0.006}},
                             0.008));
  for (int i = -3; i <= 3; ++i)  // a diadem
    s.strokes.push_back(spike(head + V(0.022 * i, 0.065 - 0.004 * i * i, 0.055),
                              head + V(0.03 * i, 0.125 - 0.007 * i * i, 0.06), 0.012, 0.006));
}

void add_hand(Sculpture& s, const V& palm, const V& reach, const V& spread) {
  s.strokes.push_back(lump(palm, {0.03, 0.036, 0.026}, 0.012, upright_to(reach)));
  for (int finger = 0; finger < 4; ++finger) {
    const V root = palm + 0.014 * (finger - 1.5) * spread + 0.02 * reach;
    s.strokes.push_back(limb({{root, 0.012},
                              {root + 0.035 * reach + 0.02 * V::UnitZ(), 0.0115},
                              {root + 0.05 * reach + 0.045 * V::UnitZ(), 0.010}},
                             0.006));
  }
}

void add_arms(Sculpture& s) {
  s.strokes.push_back(limb({{{-0.15, 1.335, -0.01}, 0.056},
                            {{-0.245, 1.42, 0.02}, 0.046},
                            {{-0.315, 1.47, 0.06}, 0.038},
                            {{-0.335, 1.56, 0.085}, 0.035},
                            {{-0.345, 1.64, 0.1}, 0.024}},
                           0.03));
  add_hand(s, {-0.345, 1.675, 0.1}, V::UnitY(), V::UnitX());
  for (int i = 0; i < 3; ++i)  // the sleeve, fallen back from the raised arm
    s.strokes.push_back(blade({{{-0.21 - 0.035 * i, 1.38 + 0.045 * i, 0.0}, 0.045},
                               {{-0.215 - 0.045 * i, 1.26 + 0.03 * i, -0.01}, 0.05},
                               {{-0.20 - 0.06 * i, 1.13 + 0.04 * i, -0.02 + 0.015 * i}, 0.012}},
                              V(0.3, 0, 1), 2.2, 0.02));
  s.strokes.push_back(limb({{{0.155, 1.325, -0.01}, 0.055},
                            {{0.215, 1.2, -0.005}, 0.047},
                            {{0.25, 1.08, 0.02}, 0.039},
                            {{0.255, 0.98, 0.09}, 0.034},
                            {{0.26, 0.92, 0.14}, 0.024}},
                           0.03));
  add_hand(s, {0.262, 0.895, 0.155}, V(0.05, -0.95, 0.3).normalized(), V(0.6, 0, -0.8));
  for (int i = 0; i < 5; ++i) {  // the cloak's end over the left forearm
    const double d = 0.022 * i;
    s.strokes.push_back(limb({{{0.225 + d, 1.06 - d, 0.0 + d}, 0.026},
                              {{0.245 + d, 0.9 - d, 0.01 + 0.9 * d}, 0.024},
                              {{0.24 + 1.3 * d, 0.68 + 0.5 * d, 0.0 + d}, 0.026},
                              {{0.23 + 1.8 * d, 0.50 + 1.6 * d, 0.01 + d}, 0.012}},
                             0.008));
  }
}

void add_torch(Sculpture& s) {
  const V grip(-0.345, 1.675, 0.135);
  s.strokes.push_back(limb({{grip + V(0.01, -0.1, 0), 0.01},
                            {grip, 0.018},
                            {grip + V(-0.01, 0.13, 0), 0.026},
                            {grip + V(-0.012, 0.165, 0), 0.046},
                            {grip + V(-0.012, 0.185, 0), 0.05}},
                           0.006));
  s.strokes.push_back(drum(grip + V(-0.012, 0.165, 0), 0.062, 0.028, 0.01, 0.004));
  for (int i = 0; i < 6; ++i) {
    const double a = 1.047 * i;
    const V foot = grip + V(-0.012 + 0.03 * std::cos(a), 0.19, 0.03 * std::sin(a));
    const V waist = grip + V(-0.012 + 0.048 * std::cos(a + 0.6), 0.235, 0.048 * std::sin(a + 0.6));
    const V tip =
        grip + V(0.01 + 0.022 * std::cos(a + 1.8), 0.31 + 0.018 * (i % 3), 0.022 * std::sin(a + 1.8));
    s.strokes.push_back(limb({{foot, 0.025}, {waist, 0.02}, {tip, 0.004}}, 0.012));
  }
}

/// Feathers hang from the wing's bone like the fingers of a fan; a shorter row covers their roots.
void add_wing(Sculpture& s, double side) {
  const std::vector<Knot> bone = {{{0.05 * side, 1.24, -0.10}, 0.04},
                                  {{0.17 * side, 1.42, -0.17}, 0.036},
                                  {{0.30 * side, 1.55, -0.2}, 0.032},
                                  {{0.41 * side, 1.53, -0.2}, 0.026},
                                  {{0.49 * side, 1.44, -0.19}, 0.014}};
  s.strokes.push_back(limb(bone, 0.03));
  const std::vector<Knot> curve = smooth_curve(bone, 8);
  constexpr int feathers = 13;
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < feathers - 2 * row; ++i) {
      const double t = (i + 0.6 * row) / (feathers - 1.0);
      const V root =
          curve[static_cast<std::size_t>(4 + t * static_cast<double>(curve.size() - 6))].position_m;
      const double fan = -0.18 + 0.75 * t * t;
      const double length = (0.26 + 0.34 * std::sin(2.6 * t + 0.25)) * (1.0 - 0.33 * row);
      const V down(std::sin(fan) * side, -std::cos(fan), 0.06);
      const V front = V(0, 0, 0.02 * row + 0.008 * (i % 2));
      const V bend(0.035 * side, 0, 0);
      const double width = 0.03 - 0.002 * row;
      s.strokes.push_back(blade({{root + front, 0.6 * width},
                                 {root + 0.5 * length * down + bend + front, width},
                                 {root + length * down + 0.2 * bend + front, 0.3 * width}},
                                V(0.25 * side, 0, 1), 2.3, 0.003));
    }
}

}  // namespace
}  // namespace statue_parts

Sculpture sculpt_statue() {
  using namespace statue_parts;
  Sculpture s;
  add_plinth(s);
  add_robe(s);
  add_torso(s);
  add_head(s);
  add_arms(s);
  add_torch(s);
  add_wing(s, 1.0);
  add_wing(s, -1.0);
  return s;
}

}  // namespace seamline::scenes
