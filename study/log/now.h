#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>

namespace seamline::study {

/// Seconds since 1970 by the wall clock, for people who look after a log: nothing is ordered or measured by
/// it, so it may be set back at any time. A clock before 1970 reads as 1970.
[[nodiscard]] inline std::int64_t now_unix_s() {
  using namespace std::chrono;
  return std::max<std::int64_t>(0, duration_cast<seconds>(system_clock::now().time_since_epoch()).count());
}

}  // namespace seamline::study
