#pragma once
#include <filesystem>

namespace seamline {

/// Throws InputError unless a PNG file is whole: its chunks lie inside it, the sums of those that decide
/// pixels are right, and its pixels unpack to exactly as many bytes as its header promises. Needs little
/// memory whatever the header says. Only then a decoder may see the file: libpng prints lines of its own
/// about damage and leaves its callers no way to be silent, and takes the memory of all pixels before it
/// looks for the first.
void check_png(const std::filesystem::path& path);

}  // namespace seamline
