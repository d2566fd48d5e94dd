#pragma once
#include <filesystem>
#include <vector>

namespace seamline {

/// An output folder that was prepared before long work. What is still empty of it and of the parents made for
/// it when this ends, by a refusal or by Ctrl-C, is removed: nothing was written there.
class PreparedFolder {
 public:
  explicit PreparedFolder(const std::filesystem::path& folder);
  ~PreparedFolder();
  PreparedFolder(const PreparedFolder&) = delete;
  PreparedFolder& operator=(const PreparedFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the deepest first
};

}  // namespace seamline
