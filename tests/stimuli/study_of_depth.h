#pragma once
#include <string>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

// Studies of which only `[depth]` and the levels matter.
namespace seamline::test {

/// A study whose files are not there; `top` says what its levels are.
inline StudyDefinition study_of_depth(const std::string& varied,
                                      const std::string& top = "depth_width_px = [64, 512]") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\n" + top + "\n" + varied +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml", IdleSettings::refused);
}

/// A study of one pinhole, whose level is the mesh's tolerance.
inline StudyDefinition sensor_study(const std::string& depth, const std::string& more = "") {
  return study_of_depth("[depth]\n" + depth + "\n" + more,
                        "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.001, 0.01]");
}

/// The same with other levels.
inline StudyDefinition levels_study(const std::string& quantity, const std::string& values,
                                    const std::string& depth) {
  return study_of_depth("[depth]\n" + depth, "[level]\nquantity = \"" + quantity + "\"\nvalues = " + values);
}

inline std::string depth_complaint(const std::string& depth, const std::string& more = "") {
  return complaint_of([&] { (void)sensor_study(depth, more); });
}

inline std::string levels_complaint(const std::string& quantity, const std::string& values,
                                    const std::string& depth) {
  return complaint_of([&] { (void)levels_study(quantity, values, depth); });
}

inline constexpr const char* plain = "source = \"pinhole\"\nsize_px = [320, 240]\nfield_of_view_deg = 60\n";

}  // namespace seamline::test
