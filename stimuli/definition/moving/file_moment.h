#pragma once
#include <optional>
#include <string>

namespace seamline::inline stimuli {

/// A moment of an animation of a glTF file.
struct FileMoment {
  std::string animation;  ///< its name, or its number from 0; empty: the file's only one
  double time_s = 0;
};

/// A scene file as studies write it: `door.glb`, or `door.glb#Open@0.25`, which is the file 0.25 s into its
/// animation "Open".
struct NamedFile {
  std::string file;
  std::optional<FileMoment> moment = {};
};

/// What stands before and behind the mark. Only what ends in .gltf or .glb before it has a moment, so that
/// other files keep a # in their names.
[[nodiscard]] NamedFile split_moment(const std::string& written);

/// The same file in another moment.
[[nodiscard]] std::string with_moment(const std::string& written, const FileMoment& moment);

}  // namespace seamline::inline stimuli
