#include <cmath>

#include "scenes/objects/clay.h"
#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace dragon_parts {
namespace {

using V = Eigen::Vector3d;
using std::cos;
using std::sin;
constexpr int z_axis = 2;

/// The coiling body from the tail's tip to the nape.
const std::vector<Knot> coil = {
    {{-1.02, 0.88, 0.06}, 0.014},  {{-1.16, 0.78, 0.0}, 0.03},   {{-1.20, 0.60, -0.06}, 0.045},
    {{-1.06, 0.43, -0.08}, 0.06},  {{-0.92, 0.26, 0.0}, 0.075},  {{-0.74, 0.22, 0.10}, 0.09},
    {{-0.56, 0.38, 0.12}, 0.105},  {{-0.42, 0.58, 0.02}, 0.118}, {{-0.24, 0.66, -0.08}, 0.125},
    {{-0.06, 0.52, -0.12}, 0.128}, {{0.08, 0.34, -0.04}, 0.128}, {{0.28, 0.28, 0.06}, 0.125},
    {{0.46, 0.42, 0.10}, 0.12},    {{0.54, 0.62, 0.04}, 0.108},  {{0.58, 0.80, -0.02}, 0.095},
    {{0.70, 0.92, -0.02}, 0.085},  {{0.84, 0.93, 0.0}, 0.08}};

/// Where the back is at a knot: square to the body and as far up as can be, so that the crest never twists
/// round.
V back_of(std::size_t i) {
  const std::size_t a = i > 0 ? i - 1 : 0;
  const std::size_t b = std::min(i + 1, coil.size() - 1);
  const V along = (coil[b].position_m - coil[a].position_m).normalized();
  const V side =
      along.cross(V::UnitY()).norm() > 0.15 ? V(along.cross(V::UnitY()).normalized()) : V(V::UnitZ());
  const V back = side.cross(along).normalized();
  return i < 2 ? V(-0.6, 0.5, 0).normalized() : back;
}

void add_body(Sculpture& s) {
  s.strokes.push_back(ringed_limb(coil, 66, 0.011, 0.0));
  Crest fins{.knots = {}, .rise_m = {}, .count = 46, .blend_m = 0.008};
  for (std::size_t i = 0; i < coil.size(); ++i) {
    const double r = coil[i].radius_m;
    const V back = back_of(i);
    const V along =
        (coil[std::min(i + 1, coil.size() - 1)].position_m - coil[i > 0 ? i - 1 : 0].position_m).normalized();
    fins.knots.push_back({coil[i].position_m + 0.86 * r * back, 0.012 + 0.1 * r});
    fins.rise_m.push_back((0.035 + 0.55 * r) * back - 0.3 * r * along);
  }
  add_crest(s, fins);
  for (int i = 0; i < 7; ++i) {  // the tail ends in a plume of flames
    const double a = -0.5 + 0.33 * i;
    const V root(-1.04, 0.86, 0.055);
    const V tip = root + (0.13 + 0.03 * (i % 3)) * V(cos(a), sin(a) + 0.4, 0.25 * (i % 2 ? 1 : -1));
    s.strokes.push_back(
        limb({{root, 0.026}, {0.5 * (root + tip) + V(-0.02, 0.02, 0), 0.022}, {tip, 0.004}}, 0.008));
  }
}

/// A leg bent at elbow and wrist, with four long talons and a flame of hair at the elbow.
struct Leg {
  V shoulder, elbow, wrist, foot;
};

void add_leg(Sculpture& s, const Leg& leg) {
  s.strokes.push_back(limb({{leg.shoulder, 0.105},
                            {0.5 * (leg.shoulder + leg.elbow), 0.082},
                            {leg.elbow, 0.055},
                            {0.5 * (leg.elbow + leg.wrist), 0.05},
                            {leg.wrist, 0.036},
                            {leg.foot, 0.042}},
                           0.04));
  for (int i = 0; i < 4; ++i) {
    const V root = leg.elbow + V(0, 0.015 * i, 0);
    const V tip = root + V(-0.12 - 0.015 * i, 0.02 + 0.035 * i, 0.02 * (i % 2 ? 1 : -1));
    s.strokes.push_back(
        limb({{root, 0.026}, {0.55 * root + 0.45 * tip + V(0, -0.012, 0), 0.02}, {tip, 0.003}}, 0.008));
  }
  for (int toe = 0; toe < 4; ++toe) {
    const double a = toe < 3 ? -0.6 + 0.6 * toe : 3.0;
    const V out(cos(a), 0, sin(a));
    const V knuckle = leg.foot + 0.062 * out + V(0, 0.012, 0);
    s.strokes.push_back(
        limb({{leg.foot, 0.03}, {knuckle, 0.024}, {leg.foot + 0.10 * out + V(0, -0.012, 0), 0.019}}, 0.01));
    s.strokes.push_back(limb({{leg.foot + 0.095 * out + V(0, -0.005, 0), 0.016},
                              {leg.foot + 0.135 * out + V(0, -0.006, 0), 0.012},
                              {leg.foot + 0.155 * out + V(0, -0.035, 0), 0.003}},
                             0.004));
  }
}

void add_legs(Sculpture& s) {
  add_leg(s, {{0.46, 0.48, 0.17}, {0.42, 0.30, 0.28}, {0.58, 0.19, 0.31}, {0.66, 0.06, 0.31}});
  add_leg(s, {{0.50, 0.54, -0.04}, {0.62, 0.38, -0.17}, {0.80, 0.44, -0.22}, {0.90, 0.36, -0.23}});
  add_leg(s, {{-0.50, 0.46, 0.20}, {-0.34, 0.30, 0.30}, {-0.46, 0.17, 0.32}, {-0.40, 0.06, 0.32}});
  add_leg(s, {{-0.44, 0.52, -0.06}, {-0.36, 0.32, -0.20}, {-0.50, 0.18, -0.24}, {-0.42, 0.06, -0.25}});
}

void add_head(Sculpture& s) {
  const V h(0.90, 0.94, 0);
  s.strokes.push_back(lump(h, {0.12, 0.085, 0.092}, 0.03));
  s.strokes.push_back(limb({{h + V(0.06, 0.0, 0), 0.07},
                            {h + V(0.17, -0.015, 0), 0.052},
                            {h + V(0.27, 0.0, 0), 0.047},
                            {h + V(0.305, 0.005, 0), 0.04}},
                           0.02));
  s.strokes.push_back(limb({{h + V(0.0, -0.065, 0), 0.055},
                            {h + V(0.12, -0.125, 0), 0.036},
                            {h + V(0.24, -0.135, 0), 0.028},
                            {h + V(0.28, -0.115, 0), 0.018}},
                           0.012));
  add_pair(s, lump(h + V(0.30, 0.03, 0.025), {0.03, 0.024, 0.02}, 0.008), z_axis);
  for (int tooth = 0; tooth < 5; ++tooth) {
    const double x = 0.29 - 0.042 * tooth;
    add_pair(s, spike(h + V(x, -0.035, 0.03), h + V(x, -0.085, 0.033), 0.012, 0.003), z_axis);
    add_pair(s, spike(h + V(x - 0.05, -0.12, 0.018), h + V(x - 0.045, -0.075, 0.022), 0.010, 0.003), z_axis);
  }
  add_pair(s,
           limb({{h + V(0.15, 0.04, 0.03), 0.02},
                 {h + V(0.09, 0.08, 0.065), 0.032},
                 {h + V(0.0, 0.085, 0.09), 0.024},
                 {h + V(-0.06, 0.11, 0.11), 0.006}},
                0.012),
           z_axis);
  add_pair(s, lump(h + V(0.10, 0.045, 0.066), {0.026, 0.022, 0.022}, 0.002), z_axis);
  add_pair(s,
           limb({{h + V(-0.02, 0.07, 0.045), 0.032},
                 {h + V(-0.12, 0.16, 0.075), 0.026},
                 {h + V(-0.26, 0.20, 0.11), 0.02},
                 {h + V(-0.36, 0.28, 0.13), 0.005}},
                0.01),
           z_axis);
  add_pair(s,
           limb({{h + V(-0.14, 0.165, 0.08), 0.02},
                 {h + V(-0.17, 0.23, 0.09), 0.014},
                 {h + V(-0.15, 0.28, 0.10), 0.004}},
                0.008),
           z_axis);
  add_pair(s,
           limb({{h + V(0.29, -0.01, 0.045), 0.015},
                 {h + V(0.33, -0.09, 0.10), 0.0125},
                 {h + V(0.27, -0.19, 0.14), 0.011},
                 {h + V(0.32, -0.27, 0.15), 0.004}},
                0.006, 8),
           z_axis);
  for (int i = 0; i < 9; ++i) {  // mane: flames around the cheeks, swept back
    const double a = -2.1 + 0.525 * i;
    const V radial(0, cos(a), sin(a));
    const V root = h + V(-0.05, -0.01, 0) + 0.075 * radial;
    const V tip = root + V(-0.19 - 0.02 * (i % 3), 0.02 + 0.02 * cos(a), 0) + 0.13 * radial;
    s.strokes.push_back(
        limb({{root, 0.034}, {0.5 * (root + tip) + 0.03 * radial, 0.026}, {tip, 0.004}}, 0.01));
  }
  for (int i = 0; i < 4; ++i)  // beard
    s.strokes.push_back(limb({{h + V(0.20 - 0.05 * i, -0.15, 0), 0.018},
                              {h + V(0.18 - 0.05 * i, -0.21, 0.01 * (i % 2)), 0.016},
                              {h + V(0.13 - 0.05 * i, -0.27 - 0.01 * i, 0), 0.004}},
                             0.008));
}

}  // namespace
}  // namespace dragon_parts

Sculpture sculpt_dragon() {
  using namespace dragon_parts;
  Sculpture s;
  add_body(s);
  add_legs(s);
  add_head(s);
  return s;
}

}  // namespace seamline::scenes
