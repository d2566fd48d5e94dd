#pragma once
#include <stdexcept>
#include <string>

namespace seamline {

/// The user's input is wrong. `what()` is one clear sentence; main() prints it and exits with status 1.
/// Everything else that is thrown is a bug in Seamline and exits with status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where something was wrong, what was wanted and what was found. Empty parts are left out of the sentence.
struct Complaint {
  std::string file = {};    ///< path as the user gave it
  std::string field = {};   ///< e.g. `scene[0].object[1].scale`
  std::string wanted = {};  ///< e.g. "a positive number"
  std::string found = {};   ///< e.g. "-1"
};

/// Builds the sentence `FILE: FIELD: wanted WANTED, found FOUND`.
[[nodiscard]] InputError input_error(const Complaint& complaint);

}  // namespace seamline
