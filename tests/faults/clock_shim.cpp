// Preloaded into the program: the wall clock starts SEAMLINE_CLOCK_START_S after 1970 and moves by
// SEAMLINE_CLOCK_STEP_S, which may be negative, with every look at it. The monotonic clock stays what it is.
#include <dlfcn.h>
#include <time.h>

#include <atomic>
#include <cstdlib>

namespace {

long long number_of(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atoll(text);
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* now) {
  using Function = int (*)(clockid_t, timespec*);
  static const auto real = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "clock_gettime"));
  static std::atomic<long long> looks = 0;
  if (clock != CLOCK_REALTIME) return real(clock, now);
  now->tv_sec = number_of("SEAMLINE_CLOCK_START_S") + looks++ * number_of("SEAMLINE_CLOCK_STEP_S");
  now->tv_nsec = 0;
  return 0;
}
