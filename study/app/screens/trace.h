#pragma once
#include <filesystem>
#include <string>

#include "study/app/screens/stage.h"

namespace seamline::study::app {

/// Writes what is on the screen into a file, a JSON object a line, whenever it has changed: for tests that
/// drive the program from outside as a person would, and must know when to press what. Hidden option
/// `--trace FILE`.
class Trace {
 public:
  /// Empty: no trace. Throws InputError when the file cannot be written.
  explicit Trace(const std::filesystem::path& file);
  ~Trace();
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  /// Call after a frame was shown.
  void shown(const Visit& visit, const Stage& stage);

 private:
  int descriptor_ = -1;
  std::string last_;
};

}  // namespace seamline::study::app
