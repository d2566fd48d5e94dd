#include "study/online/serving/rate_limit.h"

#include <algorithm>

namespace seamline::study::online {
namespace {

/// Of more than so many, those that have rested longest are forgotten: they have their whole allowance
/// anyway.
constexpr std::size_t most_remembered = 100'000;

}  // namespace

bool RateLimit::allows(const std::string& who, Clock::time_point now) {
  const std::lock_guard guard(lock_);
  if (of_.size() >= most_remembered) {
    const auto rested = std::chrono::duration<double>(rate_.at_once / rate_.a_second);
    std::erase_if(of_, [&](const auto& one) { return now - one.second.at > rested; });
    if (of_.size() >= most_remembered) of_.clear();
  }
  const auto [found, is_new] = of_.try_emplace(who, Allowance{.left = rate_.at_once, .at = now});
  Allowance& own = found->second;
  const double seconds = std::chrono::duration<double>(now - own.at).count();
  own.left = std::min(rate_.at_once, own.left + std::max(0.0, seconds) * rate_.a_second);
  own.at = now;
  if (own.left < 1) return false;
  own.left -= 1;
  return true;
}

}  // namespace seamline::study::online
