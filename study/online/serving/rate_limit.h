#pragma once
#include <chrono>
#include <mutex>
#include <string>
#include <unordered_map>

namespace seamline::study::online {

/// How many requests a second somebody may make for long, and how many at once.
struct RequestRate {
  double a_second = 20;
  double at_once = 100;
};

/// Counts requests by whoever makes them. Safe for several threads.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RateLimit(const RequestRate& rate) : rate_(rate) {}

  /// Whether one more may be made now; then it is counted.
  [[nodiscard]] bool allows(const std::string& who, Clock::time_point now);

 private:
  struct Allowance {
    double left = 0;
    Clock::time_point at;
  };
  RequestRate rate_;
  std::mutex lock_;
  std::unordered_map<std::string, Allowance> of_;
};

}  // namespace seamline::study::online
