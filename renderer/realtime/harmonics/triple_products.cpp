#include "renderer/realtime/harmonics/triple_products.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>

#include "renderer/realtime/harmonics/spherical_harmonics.h"

namespace seamline::renderer {
namespace {

double factorial(int n) {
  double product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

/// Wigner's 3j symbol (a b c; x y z) of whole numbers, by Racah's formula.
double wigner_3j(int a, int b, int c, int x, int y, int z) {
  if (x + y + z != 0 || c < std::abs(a - b) || c > a + b || std::abs(x) > a || std::abs(y) > b ||
      std::abs(z) > c)
    return 0;
  const double triangle =
      factorial(a + b - c) * factorial(a - b + c) * factorial(-a + b + c) / factorial(a + b + c + 1);
  const double orders = factorial(a + x) * factorial(a - x) * factorial(b + y) * factorial(b - y) *
                        factorial(c + z) * factorial(c - z);
  double sum = 0;
  for (int t = std::max({0, b - c - x, a - c + y}); t <= std::min({a + b - c, a - x, b + y}); ++t)
    sum += (t % 2 == 0 ? 1 : -1) / (factorial(t) * factorial(c - b + t + x) * factorial(c - a + t - y) *
                                    factorial(a + b - c - t) * factorial(a - t - x) * factorial(b - t + y));
  return ((a - b - z) % 2 == 0 ? 1 : -1) * std::sqrt(triangle * orders) * sum;
}

/// Degree and order of a harmonic's number.
struct Harmonic {
  int l, m;

  explicit Harmonic(int number)
      : l(static_cast<int>(std::sqrt(static_cast<double>(number)))), m(number - l * (l + 1)) {}
};

/// A complex harmonic that a real one is made of, and its weight.
struct Term {
  int m;
  std::complex<double> weight;
};

/// At most two; the second has no weight where there is one.
std::array<Term, 2> terms_of(const Harmonic& real) {
  const double half = 1 / std::numbers::sqrt2;
  const int m = std::abs(real.m);
  const double sign = m % 2 == 0 ? 1 : -1;  // the complex ones' phase of Condon and Shortley
  if (m == 0) return {{{0, 1.0}, {0, 0.0}}};
  if (real.m > 0) return {{{m, sign * half}, {-m, half}}};
  const std::complex<double> i(0, 1);
  return {{{m, sign * half / i}, {-m, -half / i}}};
}

}  // namespace

double triple_coefficient(int i, int j, int k) {
  const Harmonic first(i), second(j), third(k);
  const double middle = wigner_3j(first.l, second.l, third.l, 0, 0, 0);
  if (middle == 0) return 0;
  std::complex<double> sum = 0;
  for (const Term& a : terms_of(first))
    for (const Term& b : terms_of(second))
      for (const Term& c : terms_of(third))
        if (a.m + b.m + c.m == 0)
          sum += a.weight * b.weight * c.weight * wigner_3j(first.l, second.l, third.l, a.m, b.m, c.m);
  return std::sqrt((2 * first.l + 1) * (2 * second.l + 1) * (2 * third.l + 1) / (4 * std::numbers::pi)) *
         middle * sum.real();
}

const TripleTable& triple_table(int bands) {
  assert(bands >= 1 && bands <= most_bands);
  static std::array<TripleTable, most_bands + 1> tables;
  static std::array<std::once_flag, most_bands + 1> made;
  const auto number = static_cast<std::size_t>(bands);
  std::call_once(made[number], [&] {
    TripleTable& table = tables[number];
    table.bands = bands;
    const int count = coefficient_count(bands);
    for (int k = 0; k < count; ++k)
      for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
          if (const double c = triple_coefficient(i, j, k); std::abs(c) > 1e-12)
            table.entries.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                                     static_cast<std::uint16_t>(k), static_cast<float>(c)});
  });
  return tables[number];
}

void multiply_harmonics(const TripleTable& table, std::span<const float> a, std::span<const float> b,
                        std::span<float> product) {
  std::fill(product.begin(), product.end(), 0.0F);
  for (const TripleTable::Entry& entry : table.entries) product[entry.k] += a[entry.i] * b[entry.j] * entry.c;
}

}  // namespace seamline::renderer
