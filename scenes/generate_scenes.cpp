// The build tool that writes the built-in scenes and objects: generate_scenes OUTDIR
#include <exception>
#include <iostream>
#include <thread>

#include "scenes/builtin.h"
#include "scenes/shapes/lattice.h"
#include "support/files/atomic_file.h"

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
    // One object a thread: decimation does not divide.
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for_each_parallel(static_cast<int>(builtin_object_names.size()), threads, [&](int index) {
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
