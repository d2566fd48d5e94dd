#pragma once

namespace seamline {

/// Keeps memory that was freed inside the process, for the next buffer of its size, instead of giving it back
/// at once: pictures' buffers come and go by the hundred megabytes, and a fresh page costs more than what is
/// computed on it (a fifth of a set's time). Called once, when the program starts.
void keep_freed_memory();

}  // namespace seamline
