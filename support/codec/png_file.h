#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace seamline {

/// Throws InputError unless a PNG file is whole: its chunks lie inside it, the sums of those that decide
/// pixels are right, and its pixels unpack to exactly as many bytes as its header promises. Needs little
/// memory whatever the header says. Only then a decoder may see the file: libpng prints lines of its own
/// about damage and leaves its callers no way to be silent, and takes the memory of all pixels before it
/// looks for the first.
void check_png(const std::filesystem::path& path);

/// The same for one that was read already; `name` is for the complaint.
void check_png(std::string_view bytes, const std::string& name);

}  // namespace seamline
