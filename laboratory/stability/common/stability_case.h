#pragma once
#include <functional>
#include <string>
#include <vector>

namespace seamline::stability {

/// How a case may run.
struct StabilityOptions {
  int threads = 1;
};

/// What one run of a case found.
struct Finding {
  double error = 0;   ///< in the case's unit; NaN is a failure
  std::string found;  ///< in words, with the numbers that the error was computed from
};

/// A stiff or extreme input to real functions of the product, and what must come out.
struct StabilityCase {
  std::string group;     ///< light, space, depth, bounds, statistics, quest_plus or convergence
  std::string name;      ///< unique
  std::string tried;     ///< what goes in
  std::string expected;  ///< what must come out
  std::string unit;      ///< of error and tolerance
  double tolerance = 0;  ///< the case passes when its error is not above it
  std::string reason;    ///< where the tolerance comes from
  std::function<Finding(const StabilityOptions&)> run;
  bool slow = false;  ///< takes seconds or hundreds of megabytes
};

/// Groups of a catalogue are put together from several files.
using StabilityCases = std::vector<StabilityCase>;

/// What is said of cases that count what must not happen at all.
inline const std::string exact_count = "a count of what must not happen";

/// A case that counts contradictions between what was found and what must come out: none is tolerated.
[[nodiscard]] inline StabilityCase counted_case(const std::string& group, const std::string& name,
                                                const std::string& tried, const std::string& expected,
                                                Finding (*attempt)()) {
  return {.group = group,
          .name = name,
          .tried = tried,
          .expected = expected,
          .unit = "contradictions",
          .tolerance = 0,
          .reason = exact_count,
          .run = [attempt](const StabilityOptions&) { return attempt(); }};
}

}  // namespace seamline::stability
