#pragma once
#include <stdlib.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "support/text/error.h"
#include "support/text/printable.h"

/// What the fuzz targets share.
namespace seamline::fuzz {

[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The one rule: a reader returns, or throws an InputError whose sentence says what was wanted. Everything
/// else leaves this function and is a finding.
template <class Read>
int only_input_errors(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find("wanted ") == std::string_view::npos) {
      std::fprintf(stderr, "a complaint that does not say what was wanted: %s\n", error.what());
      abort();
    }
    if (const std::string line = error.what(); printable(line, line.size()) != line) {
      std::fprintf(stderr, "a complaint that is not one printable line: %s\n", error.what());
      abort();
    }
  }
  return 0;
}

/// A folder of this process, in memory where the machine has such a place (TMPDIR, which fuzz/run sets).
[[nodiscard]] inline const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    std::string name = (std::filesystem::temp_directory_path() / "seamline-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) abort();
    static const std::string kept = name;
    ::atexit([] {
      std::error_code error;
      std::filesystem::remove_all(kept, error);
    });
    return std::filesystem::path(name);
  }();
  return made;
}

/// Puts the bytes into `name` in that folder and returns its path. Not synced: nothing here has to last.
[[nodiscard]] inline std::filesystem::path file_of(const char* name, std::string_view bytes) {
  const std::filesystem::path path = folder() / name;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() ||
      std::fclose(file) != 0)
    abort();
  return path;
}

}  // namespace seamline::fuzz
