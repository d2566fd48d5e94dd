#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace seamline::renderer {

/// C_ijk, the integral of the product of three harmonics (paper 001, Eq. 8), where it is not 0.
struct TripleTable {
  struct Entry {
    std::uint16_t i, j, k;
    float c;
  };
  int bands = 0;
  std::vector<Entry> entries;
};

/// The table of so many bands, computed once: Gaunt's integrals by Wigner's 3j symbols, Racah's formula,
/// turned from complex into real harmonics.
[[nodiscard]] const TripleTable& triple_table(int bands);

/// One of its values, by the same formula; any degrees below `most_bands`.
[[nodiscard]] double triple_coefficient(int i, int j, int k);

/// Coefficients of the product of two functions, cut off after the table's bands (001, Eq. 8):
/// e_k = sum_ij a_i b_j C_ijk. All three as long as the bands have coefficients.
void multiply_harmonics(const TripleTable& table, std::span<const float> a, std::span<const float> b,
                        std::span<float> product);

}  // namespace seamline::renderer
