#include "support/running/interrupt.h"

#include <unistd.h>

#include <csignal>

namespace seamline {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

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
}

bool interrupted() {
  return stop_requested != 0;
}

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted{};
}

}  // namespace seamline
