#pragma once
#include <filesystem>

#include "laboratory/stability/common/orders.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// The exponent that was observed against the expected one; the error is their distance.
[[nodiscard]] Finding try_order(const OrderSeries& series);

/// Measures the series and draws them with their expected slopes as an SVG (a panel for each estimator).
/// Throws InputError without gnuplot or when the file cannot be written.
void draw_orders(const std::vector<OrderSeries>& series, const std::filesystem::path& svg);

}  // namespace seamline::stability
