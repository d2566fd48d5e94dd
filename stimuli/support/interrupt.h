#pragma once

namespace seamline {

/// From here on Ctrl-C (SIGINT) and SIGTERM only set a flag, which long jobs ask between pieces of work.
/// A second Ctrl-C ends the program at once. A limit on file sizes (SIGXFSZ) fails the write, as a full disk
/// does, and does not end the program.
void catch_interrupts();

/// Whether the person has asked the program to stop.
[[nodiscard]] bool interrupted();

/// Thrown by a long job that stopped because `interrupted()`; what was finished is kept. Exit status 130.
struct Interrupted {};

}  // namespace seamline
