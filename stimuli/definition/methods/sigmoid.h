#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace seamline::inline stimuli {

/// A sigmoid F on the real line, each shifted so that F(0) = 0.5 (thresholds of different sigmoids then mean
/// the same). A closed set without data: its words are here, its functions in
/// study/placement/sigmoid_shape.cpp, each in a switch without a default branch; nothing else lists sigmoids.
enum class Sigmoid {
  logistic,  ///< F(z) = 1 / (1 + exp(-z))
  normal,    ///< F(z) = Phi(z)
  gumbel  ///< F(z) = 1 - 2^(-exp(z)); a Weibull function on a log axis. The textbook's 1 - exp(-exp(z)) is ln
          ///< ln 2 away
};

inline constexpr std::array<Sigmoid, 3> every_sigmoid = {Sigmoid::logistic, Sigmoid::normal, Sigmoid::gumbel};

/// The word used in study files, commands and reports: "logistic", "norm", "gumbel".
[[nodiscard]] std::string_view word(Sigmoid sigmoid);
[[nodiscard]] std::optional<Sigmoid> sigmoid_from_word(std::string_view text);

}  // namespace seamline::inline stimuli
