#pragma once
#include <string>

namespace seamline::test {

/// A study whose files are not there: `top` among its first lines, `tables` before its one scene.
inline std::string study_of_no_files(const std::string& top, const std::string& tables) {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 4096]\n" + top +
                     "\n" + tables +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return text;
}

}  // namespace seamline::test
