#pragma once
#include <string>

namespace seamline::test {

/// A study whose files are not there: `top` among its first lines, `tables` before its one scene of so many
/// objects.
inline std::string study_of_no_files(const std::string& top, const std::string& tables, int objects = 3) {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 4096]\n" + top +
                     "\n" + tables +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
  for (int object = 0; object < objects; ++object)
    text += std::string("[[scene.object]]\nname = \"") + static_cast<char>('a' + object) +
            "\"\nfile = \"none.glb\"\n";
  return text;
}

}  // namespace seamline::test
