#pragma once

namespace seamline {

/// Keeps memory that was freed inside the process, for the next buffer of its size, instead of giving it back
/// at once: pictures' buffers come and go by the hundred megabytes, and a fresh page costs more than what is
/// computed on it (a fifth of a set's time). Called once, when the program starts.
void keep_freed_memory();

/// Gives back what was freed since: between scenes, whose buffers differ in size, so that holes of one do not
/// add to the needs of the next.
void give_back_freed_memory();

}  // namespace seamline
