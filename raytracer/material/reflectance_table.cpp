#include "raytracer/material/reflectance_table.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracer/material/microfacets.h"

namespace seamline::renderer {
namespace {

using Table = ReflectanceTable;

constexpr int heights = 48, turns = 24;  ///< of the quadrature over visible normals
constexpr double least_roughness = 0.01;
static_assert(least_roughness * least_roughness >= least_alpha * (1 - 1e-6));

/// Roughness at a part, 0 to 1, of the way along a table's steps.
double alpha_at(double part) {
  const double roughness = least_roughness + (1 - least_roughness) * part;
  return std::clamp(roughness * roughness, double{least_alpha}, 1.0);
}

/// mu of x.
template <class Real>
Real cosine_at(Real x, Real alpha) {
  return std::min(Real(1), x * alpha / (1 + alpha - x));
}

/// What visible mirrors send back of the light of one direction.
struct SentBack {
  double all = 0;      ///< E
  double schlick = 0;  ///< mean of (1 - c)^5
};

SentBack sent_back(double mu, double alpha, const std::array<double, turns>& turn_cosines) {
  const double sine = std::sqrt(std::max(0.0, 1 - mu * mu));
  const double length = std::hypot(alpha * sine, mu);
  const double stretched_x = alpha * sine / length, stretched_z = mu / length;
  const double root = smith_root(mu, alpha);
  double all = 0, schlick = 0;
  for (int h = 0; h < heights; ++h) {
    // Denser where mirrors are steep, which is where light is lost.
    const double from_steep = (h + 0.5) / heights, weight = 2 * from_steep / (heights * turns);
    const double z = from_steep * from_steep * (1 + stretched_z) - stretched_z;
    const double ring = std::sqrt(std::max(0.0, 1 - z * z));
    const double mirror_z = z + stretched_z;
    for (const double turn_cosine : turn_cosines) {
      const double turn_sine_squared = 1 - turn_cosine * turn_cosine;
      const double mirror_x = alpha * (ring * turn_cosine + stretched_x);
      const double mirror_squared =
          mirror_x * mirror_x + alpha * alpha * ring * ring * turn_sine_squared + mirror_z * mirror_z;
      if (!(mirror_squared > 0)) continue;
      const double scale = 1 / std::sqrt(mirror_squared);
      const double cosine = (sine * mirror_x + mu * mirror_z) * scale;
      const double mu_i = 2 * cosine * mirror_z * scale - mu;
      if (mu_i <= 0) continue;
      const double share = mu_i * (mu + root) / (mu_i * root + mu * smith_root(mu_i, alpha));
      all += weight * share;
      schlick += weight * share * schlick_weight(cosine);
    }
  }
  return {std::min(1.0, all), all > 0 ? schlick / all : 0.0};
}

/// int g d(mu^2) over one step of x, g being linear in x and `from` and `to` at its ends.
double integral_of_step(double from, double to, int step, double alpha) {
  const double x0 = step / (Table::angles - 1.0), x1 = (step + 1) / (Table::angles - 1.0);
  const double t0 = 1 + alpha - x0, t1 = 1 + alpha - x1;
  const double mu0 = cosine_at(x0, alpha), mu1 = cosine_at(x1, alpha);
  const double slope = (to - from) / (x1 - x0);
  // int mu^2 dx, with mu = alpha (1 + alpha) / t - alpha.
  const double a = 1 + alpha;
  const auto antiderivative = [&](double t) { return -a * a / t - 2 * a * std::log(t) + t; };
  const double squares = alpha * alpha * (antiderivative(t0) - antiderivative(t1));
  return to * mu1 * mu1 - from * mu0 * mu0 - slope * squares;
}

void set_row(Table& table, std::size_t row, const std::array<double, turns>& turn_cosines) {
  const double alpha = alpha_at(static_cast<double>(row) / (Table::rows - 1));
  for (std::size_t i = 0; i < Table::angles; ++i) {
    const double mu = cosine_at(static_cast<double>(i) / (Table::angles - 1), alpha);
    const SentBack back = sent_back(mu, alpha, turn_cosines);
    table.lost[row][i] = static_cast<float>(1 - back.all);
    table.schlick_short[row][i] = static_cast<float>(schlick_weight(mu) - back.schlick);
  }
  double total = 0;
  std::array<double, Table::angles - 1> steps{};
  for (std::size_t i = 0; i + 1 < Table::angles; ++i) {
    steps[i] = integral_of_step(table.lost[row][i], table.lost[row][i + 1], static_cast<int>(i), alpha);
    total += steps[i];
  }
  for (std::size_t i = 0; i + 1 < Table::angles; ++i)
    table.lost_share[row][i] = static_cast<float>(steps[i] / total);
}

/// Of the interpolated table, so that what it says has no gap.
void set_averages(Table& table, std::size_t at) {
  const double alpha = alpha_at(static_cast<double>(at) / Table::averages);
  ReflectanceRow row = reflectance_row(table, static_cast<float>(alpha));
  const auto lost = [&](std::size_t i) {
    return (1 - row.part) * table.lost[row.row][i] + row.part * table.lost[row.row + 1][i];
  };
  double total = 0;
  for (std::size_t i = 0; i + 1 < Table::angles; ++i)
    total += integral_of_step(lost(i), lost(i + 1), static_cast<int>(i), alpha);
  table.mean_lost[at] = static_cast<float>(total / (alpha * alpha));
  constexpr int points = 64;
  double schlick = 0;
  for (int i = 0; i < points; ++i) {
    const float mu = (static_cast<float>(i) + 0.5F) / points;
    schlick += 2.0 * mu * (1 - row.lost(mu)) * row.schlick(mu) / points;
  }
  table.mean_schlick[at] = static_cast<float>(schlick);
}

/// A place between entries of a row.
struct TablePlace {
  std::size_t entry;  ///< and the next
  float part;         ///< of the next
};

TablePlace place(float at, int entries) {
  const float scaled = std::clamp(at, 0.0F, 1.0F) * static_cast<float>(entries - 1);
  const auto entry = std::min(static_cast<std::size_t>(scaled), static_cast<std::size_t>(entries - 2));
  return {entry, scaled - static_cast<float>(entry)};
}

float mixed(float a, float b, float part) {
  return a + part * (b - a);
}

float angle_of(float mu, float alpha) {
  return mu * (1.0F + alpha) / (mu + alpha);
}

}  // namespace

ReflectanceTable make_reflectance_table() {
  std::array<double, turns> turn_cosines{};
  for (int i = 0; i < turns; ++i) turn_cosines[i] = std::cos(std::numbers::pi * (i + 0.5) / turns);
  Table table;
  for (std::size_t row = 0; row < Table::rows; ++row) set_row(table, row, turn_cosines);
  for (std::size_t at = 0; at <= Table::averages; ++at) set_averages(table, at);
  return table;
}

const ReflectanceTable& reflectance_table() {
  static const ReflectanceTable table = make_reflectance_table();
  return table;
}

ReflectanceRow reflectance_row(const ReflectanceTable& table, float alpha) {
  constexpr auto least = static_cast<float>(least_roughness);
  const float along = (std::sqrt(alpha) - least) / (1.0F - least);
  const TablePlace row = place(along, Table::rows);
  const TablePlace average = place(along, Table::averages + 1);
  const auto of_averages = [&](const auto& values) {
    return mixed(values[average.entry], values[average.entry + 1], average.part);
  };
  return {.table = &table,
          .alpha = alpha,
          .row = row.entry,
          .part = row.part,
          .mean_lost = of_averages(table.mean_lost) * alpha * alpha,
          .mean_schlick = of_averages(table.mean_schlick)};
}

float ReflectanceRow::between(const ReflectanceTable::Rows<ReflectanceTable::angles>& values,
                              float mu) const {
  const TablePlace at = place(angle_of(mu, alpha), Table::angles);
  const auto along = [&](std::size_t r) {
    return mixed(values[r][at.entry], values[r][at.entry + 1], at.part);
  };
  return mixed(along(row), along(row + 1), part);
}

float ReflectanceRow::lost(float mu) const {
  return between(table->lost, mu);
}

float ReflectanceRow::schlick(float mu) const {
  return std::max(0.0F, schlick_weight(mu) - between(table->schlick_short, mu));
}

float ReflectanceRow::lost_cosine(float point) const {
  std::size_t step = 0;
  float share = 0.0F;
  for (;; ++step) {
    share = mixed(table->lost_share[row][step], table->lost_share[row + 1][step], part);
    if (point < share || step + 2 == Table::angles) break;
    point -= share;
  }
  const float across = share > 0.0F ? std::min(point / share, 1.0F) : 0.5F;
  constexpr float steps = Table::angles - 1;
  const float from = cosine_at(static_cast<float>(step) / steps, alpha);
  const float to = cosine_at(static_cast<float>(step + 1) / steps, alpha);
  return std::sqrt(mixed(from * from, to * to, across));
}

float ReflectanceRow::lost_density(float mu) const {
  const std::size_t step = place(angle_of(mu, alpha), Table::angles).entry;
  constexpr float steps = Table::angles - 1;
  const float from = cosine_at(static_cast<float>(step) / steps, alpha);
  const float to = cosine_at(static_cast<float>(step + 1) / steps, alpha);
  const float share = mixed(table->lost_share[row][step], table->lost_share[row + 1][step], part);
  return share / (to * to - from * from);
}

}  // namespace seamline::renderer
