#include "support/running/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace seamline {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

/// For tests of signals: with SEAMLINE_STAND_STILL_AT_ASK=n in the environment the program stops itself
/// (SIGSTOP) when `interrupted()` is asked for the n-th time, until it gets SIGCONT. A signal so comes at a
/// stated point of its work, on a machine of any speed. How many asks are left; 0: it never stands still.
std::atomic<int> asks_until_standstill = 0;

void stand_still_at_the_last_ask() {
  if (asks_until_standstill.fetch_sub(1, std::memory_order_relaxed) == 1) std::raise(SIGSTOP);
}

void end_by(int number) {
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void on_signal(int number) {
  if (stop_requested != 0) end_by(number);
  stop_requested = number;
  alarm(patience_after_signal_s);
}

void on_alarm(int) {
  end_by(stop_requested == 0 ? SIGALRM : stop_requested);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGALRM, on_alarm);
  std::signal(SIGXFSZ, SIG_IGN);
  if (const char* asks = std::getenv("SEAMLINE_STAND_STILL_AT_ASK"); asks != nullptr)
    asks_until_standstill = std::atoi(asks);
}

bool interrupted() {
  if (asks_until_standstill.load(std::memory_order_relaxed) > 0) stand_still_at_the_last_ask();
  return stop_requested != 0;
}

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted{};
}

}  // namespace seamline
