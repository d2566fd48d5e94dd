#pragma once
#include <string>

#include "analysis/foresight/predict.h"

namespace seamline::analysis {

/// The table for a terminal: PT, SN and IP of each artifact beside Table 1 of the paper, the order of the
/// artifacts in both, and what the prediction rests on.
[[nodiscard]] std::string prediction_text(const Prediction& prediction);

}  // namespace seamline::analysis
