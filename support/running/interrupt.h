#pragma once

namespace seamline {

/// How long a piece of work may go on after the person asked to stop; then the signal ends the program as if
/// nobody had caught it. Nothing that was accepted or finished is lost by that, as by any other kill.
inline constexpr unsigned patience_after_signal_s = 10;

/// From here on Ctrl-C (SIGINT) and SIGTERM set a flag, which every loop that can be long asks between pieces
/// of work. A second one ends the program at once, and so does a piece that takes longer than the patience.
/// A limit on file sizes (SIGXFSZ) fails the write, as a full disk does, and does not end the program.
void catch_interrupts();

/// Whether the person has asked the program to stop.
[[nodiscard]] bool interrupted();

/// Thrown by a long job that stopped because `interrupted()`; what was finished is kept. Exit status 130.
struct Interrupted {};

/// Throws Interrupted when `interrupted()`: what loops call between pieces of work.
void stop_if_interrupted();

}  // namespace seamline
