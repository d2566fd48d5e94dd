#include <algorithm>
#include <cmath>

#include "scenes/objects/clay.h"
#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace creature_parts {
namespace {

using V = Eigen::Vector3d;
constexpr int x_axis = 0;
constexpr double leather_depth_m = 0.006;

void add_trunk(Sculpture& s) {
  s.strokes.push_back(limb({{{0, 0.56, -0.03}, 0.17},
                            {{0, 0.74, 0.02}, 0.215},
                            {{0, 0.98, 0.01}, 0.205},
                            {{0, 1.17, 0.0}, 0.15},
                            {{0, 1.31, 0.06}, 0.105}},
                           0.0));
  add_pair(s, lump({0.085, 1.08, 0.14}, {0.105, 0.085, 0.06}, 0.03), x_axis);
  for (int i = 0; i < 6; ++i) {  // belly plates
    const V centre(0, 0.61 + 0.07 * i, 0.155 + 0.045 * std::sin(0.6 * i + 0.3));
    s.strokes.push_back(
        lump(centre, {0.15 - 0.007 * i, 0.042, 0.052}, 0.004, upright_to({0, 1, 0.35 - 0.12 * i})));
  }
}

/// Overlapping bands over the back, each a flat ellipsoid tilted along the spine, with a row of knobs on its
/// rim.
void add_shell(Sculpture& s) {
  constexpr int bands = 9;
  for (int i = 0; i < bands; ++i) {
    const double t = i / (bands - 1.0);
    const double angle = -0.75 + 1.5 * t;
    const double width = 0.19 + 0.12 * std::sin(3.1 * (0.12 + 0.8 * t));
    const V centre(0, 0.93 + 0.37 * std::sin(angle), -0.10 - 0.08 * std::cos(1.3 * angle));
    const Eigen::Quaterniond tilt = upright_to({0, std::cos(angle * 0.9), 0.85 * std::sin(angle)});
    s.strokes.push_back(lump(centre, {width, 0.062, width * 0.78}, 0.006, tilt));
    for (int k = -4; k <= 4; ++k) {
      const double around = 0.36 * k;
      const V rim(width * std::sin(around), 0.03, -0.78 * width * std::cos(around));
      const V out = V(std::sin(around), 0.55, -std::cos(around)).normalized();
      s.strokes.push_back(spike(centre + tilt * rim, centre + tilt * (rim + 0.055 * out), 0.022, 0.012));
    }
  }
}

void add_legs(Sculpture& s) {
  add_pair(s,
           limb({{{0.12, 0.60, -0.02}, 0.15},
                 {{0.235, 0.45, 0.08}, 0.125},
                 {{0.265, 0.33, 0.09}, 0.085},
                 {{0.265, 0.2, -0.02}, 0.072},
                 {{0.27, 0.1, -0.05}, 0.065}},
                0.05),
           x_axis);
  add_pair(s, lump({0.262, 0.385, 0.16}, {0.07, 0.085, 0.045}, 0.008, upright_to({0.1, 1, 0.25})), x_axis);
  add_pair(s, lump({0.268, 0.27, 0.10}, {0.056, 0.075, 0.04}, 0.008, upright_to({0, 1, 0.35})), x_axis);
  add_pair(s,
           limb({{{0.27, 0.06, -0.10}, 0.055}, {{0.285, 0.07, 0.02}, 0.07}, {{0.3, 0.05, 0.13}, 0.06}}, 0.03),
           x_axis);
  for (int toe = -1; toe <= 1; ++toe) {
    const V root(0.3 + 0.05 * toe, 0.045, 0.13);
    const V knuckle = root + V(0.025 * toe, 0.02, 0.06);
    add_pair(s, limb({{root, 0.036}, {knuckle, 0.034}, {root + V(0.035 * toe, -0.005, 0.10), 0.024}}, 0.012),
             x_axis);
    add_pair(s,
             limb({{knuckle + V(0.01 * toe, 0, 0.03), 0.02},
                   {knuckle + V(0.018 * toe, -0.015, 0.085), 0.014},
                   {knuckle + V(0.022 * toe, -0.045, 0.12), 0.004}},
                  0.004),
             x_axis);
  }
}

/// An arm of which only the joints differ from side to side.
struct Arm {
  V shoulder, elbow, wrist, palm;
  V spread;  ///< from finger to finger
};

void add_arm(Sculpture& s, const Arm& arm) {
  const V& e = arm.elbow;
  s.strokes.push_back(limb({{arm.shoulder, 0.10},
                            {0.5 * (arm.shoulder + e), 0.083},
                            {e, 0.062},
                            {0.55 * e + 0.45 * arm.wrist, 0.071},
                            {arm.wrist, 0.045},
                            {arm.palm, 0.05}},
                           0.04));
  const V fore = (arm.wrist - e).normalized();
  for (int i = 0; i < 3; ++i) {  // plates down the outside
    const V centre = e + (0.02 + 0.08 * i) * fore + V(0.028 * (e.x() > 0 ? 1 : -1), -0.005, -0.02);
    s.strokes.push_back(lump(centre, {0.066 - 0.007 * i, 0.05, 0.062 - 0.006 * i}, 0.006, upright_to(fore)));
  }
  s.strokes.push_back(
      lump(arm.shoulder + V(0.02 * (e.x() > 0 ? 1 : -1), 0.03, 0), {0.125, 0.1, 0.115}, 0.01));
  s.strokes.push_back(spike(e, e - 0.5 * (arm.wrist - e) * 0.35 + V(0, -0.03, -0.05), 0.032, 0.02));
  const V reach = (arm.palm - arm.wrist).normalized();
  for (int finger = 0; finger < 4; ++finger) {
    const double side = finger - 1.5;
    const V root = arm.palm + 0.03 * side * arm.spread;
    const V knuckle = root + 0.07 * reach + 0.026 * side * arm.spread + V(0, 0, 0.01);
    const V tip = knuckle + 0.05 * reach + 0.014 * side * arm.spread + V(0, 0, 0.025);
    s.strokes.push_back(limb({{root, 0.028}, {knuckle, 0.025}, {tip, 0.019}}, 0.012));
    s.strokes.push_back(limb({{tip, 0.017},
                              {tip + 0.04 * reach + V(0, 0, 0.02), 0.012},
                              {tip + 0.065 * reach + V(0, 0, 0.045), 0.004}},
                             0.004));
  }
  const V thumb = arm.palm - 0.055 * arm.spread + 0.01 * reach;
  s.strokes.push_back(limb(
      {{arm.palm, 0.03}, {thumb + 0.02 * reach, 0.025}, {thumb - 0.03 * arm.spread + 0.055 * reach, 0.01}},
      0.012));
}

void add_head(Sculpture& s) {
  s.strokes.push_back(limb({{{0, 1.22, 0.02}, 0.12}, {{0, 1.36, 0.07}, 0.095}}, 0.04));
  s.strokes.push_back(lump({0, 1.43, 0.10}, {0.105, 0.098, 0.125}, 0.03));
  s.strokes.push_back(limb({{{0, 1.42, 0.17}, 0.085},
                            {{0, 1.40, 0.27}, 0.058},
                            {{0, 1.385, 0.36}, 0.043},
                            {{0, 1.395, 0.41}, 0.036}},
                           0.02));
  s.strokes.push_back(
      limb({{{0, 1.355, 0.13}, 0.06}, {{0, 1.325, 0.24}, 0.04}, {{0, 1.325, 0.33}, 0.024}}, 0.006));
  add_pair(s, carved(lump({0.018, 1.41, 0.44}, {0.011, 0.011, 0.02}, 0.004)), x_axis);
  add_pair(s,
           limb({{{0.03, 1.49, 0.2}, 0.022}, {{0.075, 1.495, 0.16}, 0.03}, {{0.1, 1.46, 0.1}, 0.02}}, 0.012),
           x_axis);
  add_pair(s, carved(lump({0.078, 1.455, 0.192}, {0.028, 0.022, 0.026}, 0.006)), x_axis);
  add_pair(s, lump({0.068, 1.454, 0.178}, {0.019, 0.017, 0.02}, 0.0), x_axis);
  for (int i = 0; i < 5; ++i) {  // plates from brow to nape
    const double z = 0.19 - 0.055 * i;
    s.strokes.push_back(lump({0, 1.515 - 0.004 * i * i, z}, {0.068 - 0.006 * std::abs(i - 1), 0.026, 0.042},
                             0.005, upright_to({0, 1, -0.12 * i + 0.25})));
  }
  for (const double side : {-1.0, 1.0}) {
    const V root(0.075 * side, 1.49, 0.06);
    const V tip(0.185 * side, 1.70, 0.015);
    const V across = V(0.25 * side, 0.15, 1).normalized();
    s.strokes.push_back(
        blade({{root, 0.035}, {0.55 * root + 0.45 * tip + V(0.02 * side, 0, 0), 0.062}, {tip, 0.012}}, across,
              2.6, 0.02));
    s.strokes.push_back(carved(blade({{root + V(0.01 * side, 0.03, 0.028), 0.012},
                                      {0.55 * root + 0.45 * tip + V(0.02 * side, 0, 0.026), 0.04},
                                      {0.2 * root + 0.8 * tip + V(0, 0, 0.014), 0.008}},
                                     across, 2.2, 0.01)));
  }
}

/// Scales all over but for the face and ears.
double leather(const V& p) {
  const bool head_above = std::abs(p.x()) < 0.27 && p.y() > 1.24;
  return (head_above ? std::clamp((1.36 - p.y()) / 0.12, 0.15, 1.0) : 1.0) *
         scales(p, 0.062, leather_depth_m);
}

}  // namespace
}  // namespace creature_parts

Sculpture sculpt_creature() {
  using namespace creature_parts;
  Sculpture s;
  add_trunk(s);
  add_legs(s);
  add_shell(s);
  add_arm(s, {.shoulder = {0.215, 1.165, 0.0},
              .elbow = {0.46, 1.08, 0.04},
              .wrist = {0.565, 1.30, 0.13},
              .palm = {0.575, 1.375, 0.15},
              .spread = V(0.9, -0.25, -0.35).normalized()});
  add_arm(s, {.shoulder = {-0.215, 1.165, 0.0},
              .elbow = {-0.455, 1.16, 0.06},
              .wrist = {-0.50, 1.41, 0.11},
              .palm = {-0.49, 1.485, 0.13},
              .spread = V(0.95, 0.05, 0.3).normalized()});
  add_head(s);
  s.strokes.push_back(ringed_limb({{{0, 0.56, -0.15}, 0.135},
                                   {{0.04, 0.36, -0.33}, 0.105},
                                   {{0.20, 0.17, -0.45}, 0.08},
                                   {{0.43, 0.10, -0.42}, 0.058},
                                   {{0.60, 0.14, -0.28}, 0.04},
                                   {{0.66, 0.27, -0.2}, 0.018}},
                                  18, 0.014, 0.03));
  s.relief = leather;
  s.relief_m = leather_depth_m;
  return s;
}

}  // namespace seamline::scenes
