// The build tool that writes the built-in scenes, objects and environment maps: generate_scenes OUTDIR
#include <exception>
#include <iostream>

#include "scenes/builtin.h"
#include "scenes/skies/skies.h"
#include "support/files/atomic_file.h"
#include "support/running/parallel.h"

int main(int argc, char** argv) {
  using namespace seamline;
  using namespace seamline::scenes;
  if (argc != 2) {
    std::cerr << "usage: generate_scenes OUTDIR\n";
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    prepare_output_folder(folder);
    for (const std::string_view name : builtin_scene_names)
      write_glb(folder / (std::string(name) + ".glb"), builtin_scene(name));
    for (const std::string_view name : builtin_sky_names)
      write_exr(folder / (std::string(name) + ".exr"), builtin_sky(name));
    for (const std::string_view name : builtin_furniture_names)
      write_glb(folder / (std::string(name) + ".glb"),
                {.parts = {builtin_furniture(name)}, .camera = {}, .sun = {}});
    // One object a thread: decimation does not divide.
    run_parallel(static_cast<int>(builtin_object_names.size()), 0, [&](int index) {
      const std::string name(builtin_object_names[static_cast<std::size_t>(index)]);
      const SceneContents object{
          .parts = {{name, builtin_object(name, {.threads = 1})}}, .camera = {}, .sun = {}};
      write_glb(folder / (name + ".glb"), object);
    });
  } catch (const std::exception& error) {
    std::cerr << "generate_scenes: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
