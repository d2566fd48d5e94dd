#include <cmath>

#include "scenes/objects/clay.h"
#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace beast_parts {
namespace {

using V = Eigen::Vector3d;
constexpr int z_axis = 2;

const std::vector<Knot> spine = {{{-1.42, 0.34, 0.16}, 0.012}, {{-1.22, 0.22, 0.20}, 0.03},
                                 {{-0.98, 0.20, 0.10}, 0.05},  {{-0.74, 0.32, 0.0}, 0.085},
                                 {{-0.50, 0.44, 0.0}, 0.14},   {{-0.25, 0.50, 0.0}, 0.165},
                                 {{0.02, 0.46, 0.0}, 0.145},   {{0.28, 0.48, 0.0}, 0.18},
                                 {{0.50, 0.56, 0.0}, 0.145},   {{0.68, 0.64, 0.0}, 0.105}};

void add_body(Sculpture& s) {
  s.strokes.push_back(limb(spine, 0.0, 8));
  add_pair(s, lump({-0.42, 0.42, 0.11}, {0.17, 0.16, 0.085}, 0.05, upright_to({0.3, 1, 0})), z_axis);
  add_pair(s, lump({0.34, 0.48, 0.12}, {0.13, 0.17, 0.085}, 0.05, upright_to({-0.3, 1, 0})), z_axis);
  for (int rib = 0; rib < 7; ++rib) {
    const double x = 0.19 - 0.075 * rib;
    add_pair(s,
             limb({{{x + 0.04, 0.60 + 0.005 * rib, 0.05}, 0.016},
                   {{x, 0.49, 0.158 - 0.003 * rib}, 0.02},
                   {{x + 0.05, 0.36, 0.09}, 0.014}},
                  0.02),
             z_axis);
  }
}

void add_foot(Sculpture& s, const V& ankle, double side) {
  const V sole = ankle + V(0.05, -0.03, 0);
  s.strokes.push_back(limb({{ankle, 0.042}, {sole, 0.045}, {sole + V(0.06, 0, 0), 0.035}}, 0.02));
  for (int toe = -1; toe <= 1; ++toe) {
    const V out(0.1, 0.0, 0.035 * toe + 0.01 * side);
    s.strokes.push_back(limb({{sole + V(0.05, 0, 0.025 * toe), 0.027},
                              {sole + 0.75 * out + V(0.05, 0.012, 0), 0.027},
                              {sole + out + V(0.055, -0.008, 0), 0.018}},
                             0.01));
    s.strokes.push_back(limb({{sole + out + V(0.05, 0.01, 0), 0.015},
                              {sole + 1.25 * out + V(0.065, 0.005, 0), 0.011},
                              {sole + 1.4 * out + V(0.075, -0.03, 0), 0.004}},
                             0.003));
  }
}

void add_front_leg(Sculpture& s, double side, double step) {
  const V ankle(0.46 + step, 0.075, 0.23 * side);
  s.strokes.push_back(limb({{{0.34, 0.47, 0.13 * side}, 0.1},
                            {{0.25 + 0.3 * step, 0.33, 0.225 * side}, 0.075},
                            {{0.30 + 0.6 * step, 0.24, 0.245 * side}, 0.055},
                            {{0.42 + step, 0.13, 0.235 * side}, 0.042},
                            {ankle, 0.042}},
                           0.04));
  s.strokes.push_back(
      spike({0.26 + 0.3 * step, 0.33, 0.24 * side}, {0.10 + 0.3 * step, 0.40, 0.30 * side}, 0.035, 0.02));
  add_foot(s, ankle, side);
}

void add_hind_leg(Sculpture& s, double side, double step) {
  const V ankle(-0.47 + step, 0.075, 0.22 * side);
  s.strokes.push_back(limb({{{-0.42, 0.42, 0.12 * side}, 0.13},
                            {{-0.27 + 0.5 * step, 0.31, 0.21 * side}, 0.092},
                            {{-0.36 + 0.7 * step, 0.225, 0.225 * side}, 0.06},
                            {{-0.55 + step, 0.16, 0.22 * side}, 0.042},
                            {ankle, 0.04}},
                           0.04));
  s.strokes.push_back(
      spike({-0.55 + step, 0.165, 0.22 * side}, {-0.66 + step, 0.22, 0.23 * side}, 0.028, 0.015));
  add_foot(s, ankle, side);
}

void add_head(Sculpture& s) {
  s.strokes.push_back(lump({0.79, 0.71, 0}, {0.13, 0.085, 0.088}, 0.03, upright_to({0.15, 1, 0})));
  s.strokes.push_back(limb({{{0.82, 0.715, 0}, 0.068},
                            {{0.95, 0.69, 0}, 0.05},
                            {{1.06, 0.665, 0}, 0.042},
                            {{1.10, 0.645, 0}, 0.03}},
                           0.02));
  s.strokes.push_back(limb({{{0.76, 0.645, 0}, 0.055},
                            {{0.88, 0.585, 0}, 0.036},
                            {{1.00, 0.565, 0}, 0.027},
                            {{1.05, 0.585, 0}, 0.016}},
                           0.012));
  for (int tooth = 0; tooth < 5; ++tooth) {
    const double x = 1.08 - 0.042 * tooth;
    add_pair(s,
             spike({x, 0.645 + 0.006 * tooth, 0.03}, {x + 0.005, 0.595 + 0.01 * tooth, 0.034}, 0.012, 0.003),
             z_axis);
    add_pair(s, spike({x - 0.04, 0.585, 0.02}, {x - 0.03, 0.625, 0.024}, 0.010, 0.003), z_axis);
  }
  add_pair(s,
           limb({{{0.93, 0.735, 0.035}, 0.014}, {{0.86, 0.775, 0.06}, 0.026}, {{0.76, 0.775, 0.075}, 0.022}},
                0.01),
           z_axis);
  add_pair(s, carved(lump({0.868, 0.735, 0.078}, {0.03, 0.018, 0.022}, 0.006)), z_axis);
  add_pair(s, lump({0.86, 0.733, 0.062}, {0.022, 0.017, 0.018}, 0.0), z_axis);
  add_pair(s,
           limb({{{0.72, 0.78, 0.05}, 0.036},
                 {{0.60, 0.90, 0.085}, 0.028},
                 {{0.46, 0.95, 0.12}, 0.018},
                 {{0.36, 0.93, 0.13}, 0.004}},
                0.015),
           z_axis);
  add_pair(s,
           blade({{{0.71, 0.70, 0.07}, 0.03}, {{0.63, 0.72, 0.14}, 0.05}, {{0.52, 0.75, 0.20}, 0.008}},
                 V(0.2, 1, -0.3), 2.6, 0.012),
           z_axis);
  add_pair(s, spike({0.74, 0.64, 0.05}, {0.64, 0.56, 0.12}, 0.026, 0.012), z_axis);
}

void add_spines(Sculpture& s) {
  Crest back{.knots = {}, .rise_m = {}, .count = 22, .blend_m = 0.012};
  const std::vector<double> heights = {0.02, 0.06, 0.08, 0.11, 0.15, 0.19, 0.17, 0.22, 0.2, 0.12};
  for (std::size_t i = 0; i < spine.size(); ++i) {
    const double r = spine[i].radius_m;
    back.knots.push_back({spine[i].position_m + V(0, 0.82 * r, 0), 0.02 + 0.075 * r});
    back.rise_m.emplace_back(-0.55 * heights[i], heights[i] + 0.1 * r, 0);
  }
  add_crest(s, back);
  for (const double side : {-1.0, 1.0}) {  // two lower rows along the flanks
    Crest row{.knots = {}, .rise_m = {}, .count = 15, .blend_m = 0.01};
    for (std::size_t i = 2; i < spine.size(); ++i) {
      const double r = spine[i].radius_m;
      row.knots.push_back({spine[i].position_m + V(0, 0.6 * r, 0.72 * r * side), 0.012 + 0.05 * r});
      row.rise_m.emplace_back(-0.4 * heights[i], 0.35 * heights[i], 0.42 * heights[i] * side);
    }
    add_crest(s, row);
  }
  for (const double side : {-1.0, 1.0})  // the tail's end is a thagomizer
    s.strokes.push_back(spike({-1.34, 0.29, 0.17}, {-1.46, 0.37, 0.17 + 0.13 * side}, 0.026, 0.01));
}

}  // namespace
}  // namespace beast_parts

Sculpture sculpt_beast() {
  using namespace beast_parts;
  Sculpture s;
  add_body(s);
  add_front_leg(s, 1.0, 0.02);
  add_front_leg(s, -1.0, -0.14);
  add_hind_leg(s, 1.0, -0.08);
  add_hind_leg(s, -1.0, 0.12);
  add_head(s);
  add_spines(s);
  s.relief_m = 0.004;
  s.relief = [](const V& p) { return (p.x() > 0.7 ? 0.3 : 1.0) * scales(p, 0.055, 0.004); };
  return s;
}

}  // namespace seamline::scenes
