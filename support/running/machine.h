#pragma once
#include <string>

namespace seamline {

/// The processor's name as Linux gives it, e.g. "AMD EPYC 9554 64-Core Processor"; "unknown" where it gives
/// none.
[[nodiscard]] std::string processor_name();

}  // namespace seamline
