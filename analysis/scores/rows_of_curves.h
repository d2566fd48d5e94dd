#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/scores/cells.h"

namespace seamline::analysis {

/// Rows of a table by their curve, each curve's in their order.
template <class Row>
using RowsOfCurves = std::map<std::pair<Artifact, std::string>, std::vector<const Row*>>;

template <class Row>
[[nodiscard]] RowsOfCurves<Row> rows_of_curves(const std::vector<Row>& rows) {
  RowsOfCurves<Row> of_curves;
  for (const Row& row : rows) of_curves[{row.artifact, row.condition}].push_back(&row);
  return of_curves;
}

template <class Row, class Curve>
[[nodiscard]] std::vector<const Row*> rows_of(const RowsOfCurves<Row>& of_curves, const Curve& curve) {
  const auto found = of_curves.find({curve.artifact, curve.condition});
  return found == of_curves.end() ? std::vector<const Row*>() : found->second;
}

}  // namespace seamline::analysis
