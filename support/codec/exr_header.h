#pragma once
#include <filesystem>

namespace seamline {

/// Throws InputError unless every attribute in the headers of an EXR file lies inside the file. The library
/// takes the memory that an attribute claims (up to 2 GB) before it reads it.
void check_exr_header(const std::filesystem::path& path);

}  // namespace seamline
