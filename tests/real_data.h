#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace seamline::test {

/// Scanned meshes, panoramas and frames of a Kinect that the project may not copy: meshes/, environments/ and
/// rgbd/ in the folder that SEAMLINE_REAL_DATA names. tests/data/README.md says which files and whose. Empty
/// where it names none; only tests that are run by hand (*_full_test.cpp) ask.
inline std::filesystem::path real_data() {
  const char* named = std::getenv("SEAMLINE_REAL_DATA");
  return named == nullptr ? "" : named;
}

}  // namespace seamline::test

#define SKIP_WITHOUT_REAL_DATA() \
  if (seamline::test::real_data().empty()) GTEST_SKIP() << "SEAMLINE_REAL_DATA names no folder"
