#pragma once
#include <array>
#include <cstddef>

namespace seamline::renderer {

/// The least roughness squared that is rendered: 0.01 degrees, less than a pixel of any picture. Below it the
/// directions themselves, in single precision, would not be exact enough.
inline constexpr float least_alpha = 1e-4F;

/// How much of the light a rough surface of perfect mirrors sends back after one reflection, E(mu, alpha);
/// the rest meets further mirrors. Computed by quadrature over visible normals, in some 10 ms, when first
/// asked for.
///
/// Rows are even steps of roughness (the root of alpha); along a row lie even steps of
/// x = mu (1 + alpha) / (mu + alpha), in which E looks alike for every alpha: it falls only near the angle
/// alpha above the horizon. Between entries everything is linear in x and roughness, and the integrals over
/// it are those of the interpolated function, so that no energy is gained or lost by interpolation.
struct ReflectanceTable {
  static constexpr int rows = 32;
  static constexpr int angles = 48;     ///< of x
  static constexpr int averages = 256;  ///< steps of roughness

  template <std::size_t size>
  using Rows = std::array<std::array<float, size>, rows>;

  Rows<angles> lost{};            ///< 1 - E
  Rows<angles - 1> lost_share{};  ///< of 2 int (1 - E) mu dmu, by step of x
  Rows<angles>
      schlick_short{};  ///< 1 - mu less the fifth root of the mean of (1 - c)^5, which is nearly that
  std::array<float, averages + 1> mean_lost{};     ///< 2 int (1 - E) mu dmu / alpha^2
  std::array<float, averages + 1> mean_schlick{};  ///< 2 int E (mean of (1 - c)^5) mu dmu
};

/// Made by quadrature; `reflectance_table` makes it once.
[[nodiscard]] ReflectanceTable make_reflectance_table();

/// The one table, made by whoever asks first; safe from many threads.
[[nodiscard]] const ReflectanceTable& reflectance_table();

/// The table for one alpha, at least `least_alpha` and at most 1.
struct ReflectanceRow {
  const ReflectanceTable* table = nullptr;
  float alpha = 1.0F;
  std::size_t row = 0;        ///< and the next
  float part = 0.0F;          ///< of the next
  float mean_lost = 0.0F;     ///< 2 int (1 - E) mu dmu
  float mean_schlick = 0.0F;  ///< 2 int E schlick mu dmu

  /// 1 - E(mu): light that one reflection does not send back.
  [[nodiscard]] float lost(float mu) const;
  /// Mean of Schlick's (1 - c)^5 over the light that one reflection sends back.
  [[nodiscard]] float schlick(float mu) const;
  /// A cosine, about as often as light that one reflection lost leaves there; `point` is of [0, 1).
  [[nodiscard]] float lost_cosine(float point) const;
  /// The density of `lost_cosine` at mu, as a multiple of 2 mu.
  [[nodiscard]] float lost_density(float mu) const;
  /// What rows of the table say of mu.
  [[nodiscard]] float between(const ReflectanceTable::Rows<ReflectanceTable::angles>& values, float mu) const;
};

[[nodiscard]] ReflectanceRow reflectance_row(const ReflectanceTable& table, float alpha);

}  // namespace seamline::renderer
