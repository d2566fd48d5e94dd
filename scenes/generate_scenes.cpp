// The build tool that writes the built-in scenes and objects: generate_scenes OUTDIR
#include <exception>
#include <iostream>
#include <thread>

#include "scenes/builtin.h"
#include "stimuli/support/atomic_file.h"

int main(int argc, char** argv) {
  using namespace seamline;
  if (argc != 2) {
    std::cerr << "usage: generate_scenes OUTDIR\n";
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    prepare_output_folder(folder);
    const ModelOptions options{.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
    for (const std::string_view name : builtin_scene_names)
      write_scene_file(folder / (std::string(name) + ".glb"), builtin_scene(name));
    for (const std::string_view name : builtin_object_names) {
      const SceneContents object{.parts = {{std::string(name), builtin_object(name, options)}}, .camera = {}, .sun = {}};
      write_scene_file(folder / (std::string(name) + ".glb"), object);
    }
  } catch (const std::exception& error) {
    std::cerr << "generate_scenes: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
