#pragma once
#include "laboratory/convergence/convergence_figure.h"
#include "laboratory/convergence/estimates/estimates.h"

namespace seamline::renderer {

[[nodiscard]] PartTables tables_of(const EstimateResult& result);
/// Error against the amount, and against processor time with the machine's limit.
void draw_figure(const EstimateResult& result, const FigureText& text);

}  // namespace seamline::renderer
