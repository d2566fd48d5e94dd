#pragma once
#include <cstdlib>
#include <filesystem>

namespace seamline::test {

/// Where tables of documentation/evidence/ go: the folder that `seamline lab evidence` names, else the
/// tests'.
inline std::filesystem::path evidence_file(const char* name) {
  const char* named = std::getenv("SEAMLINE_EVIDENCE_FOLDER");
  const std::filesystem::path folder = named == nullptr ? SEAMLINE_TEST_OUTPUT : named;
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace seamline::test
