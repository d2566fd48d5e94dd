#include <cmath>

#include "scenes/objects/clay.h"
#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace lion_parts {
namespace {

using V = Eigen::Vector3d;
using std::cos;
using std::sin;
constexpr int z_axis = 2;

void add_body(Sculpture& s) {
  s.strokes.push_back(limb({{{-0.62, 0.68, 0}, 0.12},
                            {{-0.45, 0.68, 0}, 0.165},
                            {{-0.15, 0.65, 0}, 0.16},
                            {{0.18, 0.64, 0}, 0.195},
                            {{0.42, 0.70, 0}, 0.19},
                            {{0.60, 0.82, 0}, 0.15}},
                           0.0, 8));
  add_pair(s, lump({-0.48, 0.62, 0.10}, {0.15, 0.2, 0.075}, 0.05, upright_to({0.25, 1, 0})), z_axis);
  add_pair(s, lump({0.36, 0.66, 0.13}, {0.11, 0.2, 0.075}, 0.05, upright_to({-0.2, 1, 0})), z_axis);
  for (int rib = 0; rib < 5; ++rib) {
    const double x = 0.14 - 0.08 * rib;
    add_pair(
        s,
        limb({{{x + 0.03, 0.74, 0.13}, 0.012}, {{x, 0.63, 0.167}, 0.016}, {{x + 0.05, 0.53, 0.12}, 0.012}},
             0.03),
        z_axis);
  }
}

void add_paw(Sculpture& s, const V& wrist, double lift) {
  const V pad = wrist + V(0.04, -0.045 + 0.3 * lift, 0);
  s.strokes.push_back(lump(pad, {0.085, 0.05, 0.068}, 0.025));
  for (int toe = 0; toe < 4; ++toe) {
    const V tip = pad + V(0.068 - 0.012 * std::abs(toe - 1.5), -0.008, 0.034 * (toe - 1.5));
    s.strokes.push_back(lump(tip, {0.04, 0.03, 0.021}, 0.006));
    s.strokes.push_back(spike(tip + V(0.028, 0.004, 0), tip + V(0.062, -0.02, 0), 0.012, 0.003));
  }
}

/// A leg through its joints, shoulder or hip first.
void add_leg(Sculpture& s, const std::vector<Knot>& joints, double lift) {
  s.strokes.push_back(limb(joints, 0.045));
  add_paw(s, joints.back().position_m, lift);
}

void add_legs(Sculpture& s) {
  add_leg(s,
          {{{0.36, 0.62, 0.13}, 0.115},
           {{0.30, 0.47, 0.16}, 0.085},
           {{0.40, 0.33, 0.165}, 0.065},
           {{0.50, 0.17, 0.16}, 0.052},
           {{0.55, 0.09, 0.16}, 0.053}},
          0.0);
  add_leg(s,
          {{{0.36, 0.62, -0.13}, 0.115},
           {{0.22, 0.47, -0.16}, 0.085},
           {{0.17, 0.32, -0.165}, 0.065},
           {{0.10, 0.17, -0.16}, 0.05},
           {{0.11, 0.09, -0.16}, 0.053}},
          0.0);
  add_leg(s,
          {{{-0.48, 0.60, 0.12}, 0.155},
           {{-0.46, 0.44, 0.155}, 0.115},
           {{-0.60, 0.30, 0.16}, 0.065},
           {{-0.73, 0.22, 0.155}, 0.05},
           {{-0.71, 0.09, 0.15}, 0.052}},
          0.0);
  add_leg(s,
          {{{-0.48, 0.60, -0.12}, 0.155},
           {{-0.28, 0.45, -0.155}, 0.115},
           {{-0.30, 0.31, -0.16}, 0.068},
           {{-0.40, 0.20, -0.155}, 0.05},
           {{-0.31, 0.09, -0.15}, 0.052}},
          0.0);
}

void add_head(Sculpture& s) {
  const V h(0.865, 0.985, 0);
  s.strokes.push_back(lump(h, {0.125, 0.125, 0.115}, 0.04));
  s.strokes.push_back(limb(
      {{h + V(0.06, -0.02, 0), 0.085}, {h + V(0.17, -0.045, 0), 0.068}, {h + V(0.205, -0.055, 0), 0.056}},
      0.02));
  s.strokes.push_back(
      limb({{h + V(0.02, -0.10, 0), 0.06}, {h + V(0.14, -0.145, 0), 0.042}, {h + V(0.185, -0.145, 0), 0.03}},
           0.012));
  add_pair(s, lump(h + V(0.205, -0.07, 0.032), {0.05, 0.042, 0.04}, 0.012), z_axis);
  s.strokes.push_back(lump(h + V(0.245, -0.022, 0), {0.022, 0.02, 0.032}, 0.008));
  s.strokes.push_back(carved(limb({{h + V(0.29, -0.105, -0.06), 0.008},
                                   {h + V(0.27, -0.115, 0), 0.014},
                                   {h + V(0.29, -0.105, 0.06), 0.008}},
                                  0.004)));
  s.strokes.push_back(limb({{h + V(0.06, 0.075, 0), 0.03}, {h + V(0.22, 0.0, 0), 0.024}}, 0.03, 1));
  add_pair(s,
           limb({{h + V(0.13, 0.03, 0.03), 0.018},
                 {h + V(0.115, 0.062, 0.065), 0.026},
                 {h + V(0.05, 0.05, 0.10), 0.02}},
                0.012),
           z_axis);
  add_pair(s, carved(lump(h + V(0.135, 0.018, 0.068), {0.026, 0.018, 0.022}, 0.008)), z_axis);
  add_pair(s, lump(h + V(0.118, 0.02, 0.06), {0.02, 0.016, 0.018}, 0.0), z_axis);
  add_pair(s, lump(h + V(0.02, 0.115, 0.095), {0.022, 0.05, 0.042}, 0.012, upright_to({-0.2, 1, 0.5})),
           z_axis);
  add_pair(s, carved(lump(h + V(0.04, 0.12, 0.10), {0.016, 0.034, 0.026}, 0.006, upright_to({-0.2, 1, 0.5}))),
           z_axis);
}

/// One lock: it rises from the skin, falls along `hang` in a wave, and its tip turns outwards.
Stroke lock(const V& root, const V& out, const V& hang, double size, double hand) {
  const V side = hand * out.cross(hang).normalized();
  std::vector<Knot> knots;
  for (int i = 0; i <= 6; ++i) {
    const double t = i / 6.0;
    const double turn = std::max(0.0, t - 0.6) / 0.4;
    const V along =
        1.55 * t * hang + (0.34 * sin(2.2 * t) + 0.34 * turn * turn) * out + 0.17 * sin(6.0 * t) * side;
    knots.push_back(
        {root + size * along, size * (0.06 + 0.2 * std::pow(1 - t, 0.7) * (0.75 + 0.5 * sin(3.1 * t)))});
  }
  return limb(knots, 0.003, 3);
}

/// Rings of locks from the face back over the shoulders; they hang more the lower they grow.
void add_mane(Sculpture& s) {
  s.strokes.push_back(limb(
      {{{0.80, 0.98, 0}, 0.13}, {{0.68, 0.91, 0}, 0.185}, {{0.52, 0.80, 0}, 0.21}, {{0.36, 0.74, 0}, 0.19}},
      0.02));
  constexpr int rings = 8;
  for (int ring = 0; ring < rings; ++ring) {
    const double t = ring / (rings - 1.0);
    const V centre = V(0.83, 0.985, 0) + t * V(-0.45, -0.225, 0);
    const V up = V(-0.42, 1.0, 0).normalized();
    const double radius = 0.125 + 0.085 * sin(2.3 * t);
    const int locks = 15 + ring;
    for (int i = 0; i < locks; ++i) {
      const double a = 6.2832 * (i + 0.5 * (ring % 2)) / locks;
      const double low = 0.5 - 0.5 * cos(a);
      const V radial = cos(a) * up + sin(a) * V::UnitZ();
      const V out = (radial + V(0.45 * (1 - t), 0, 0)).normalized();
      const V hang =
          (V(-0.9 + 0.25 * low, -0.15 - 0.75 * low * (0.4 + 0.6 * t), 0) + 0.30 * radial).normalized();
      const double size = 0.088 + 0.02 * t + 0.025 * low + 0.012 * ((i * 7 + ring * 3) % 3);
      s.strokes.push_back(
          lock(centre + 0.92 * radius * radial, out, hang, size, (i + ring) % 2 ? 1.0 : -1.0));
    }
  }
  for (int i = 0; i < 12; ++i) {  // beard and chest
    const double across = 0.05 * (i % 3 - 1);
    s.strokes.push_back(lock({0.86 - 0.035 * i, 0.84 - 0.022 * i, across},
                             V(0.6, -0.2, 4 * across).normalized(), V(-0.25, -1, across).normalized(), 0.10,
                             i % 2 ? 1.0 : -1.0));
  }
}

void add_tail(Sculpture& s) {
  s.strokes.push_back(limb({{{-0.68, 0.72, 0}, 0.06},
                            {{-0.84, 0.66, 0.03}, 0.038},
                            {{-1.0, 0.46, 0.07}, 0.03},
                            {{-1.17, 0.38, 0.08}, 0.027},
                            {{-1.31, 0.50, 0.06}, 0.025},
                            {{-1.33, 0.62, 0.04}, 0.024}},
                           0.03, 8));
  for (int i = 0; i < 9; ++i) {
    const double a = 0.7 * i;
    const V out(0.6 * cos(a), 0.3, 0.6 * sin(a));
    s.strokes.push_back(lock(V(-1.33, 0.60 + 0.01 * i, 0.04), out.normalized(),
                             V(0.1 * cos(a), 1, 0.1 * sin(a)).normalized(), 0.10 + 0.012 * (i % 3),
                             i % 2 ? 1.0 : -1.0));
  }
}

}  // namespace
}  // namespace lion_parts

Sculpture sculpt_lion() {
  using namespace lion_parts;
  Sculpture s;
  add_body(s);
  add_legs(s);
  add_mane(s);
  add_head(s);
  add_tail(s);
  return s;
}

}  // namespace seamline::scenes
