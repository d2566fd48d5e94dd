#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/foresight/plan_study.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace seamline::analysis {

/// What the command line says of a plan; options of `plan` and of `freeze`.
struct PlanOptions {
  PlanRequest request;
  std::string estimator = "joint";
  std::optional<double> no_seam_at, no_seam_margin;
};

/// What is wanted, what is assumed of people, and how it is simulated. Returns the options, for others to
/// exclude.
std::vector<CLI::Option*> add_plan_options(CLI::App& command, PlanOptions& options);

/// The request that the options make. Throws InputError where two of them do not fit each other.
[[nodiscard]] PlanRequest plan_request(const PlanOptions& options);

}  // namespace seamline::analysis
