// A scene file: .gltf, or .glb by its first bytes. A buffer file of 48 bytes lies beside it as buffer.bin.
#include "fuzz/fuzz_target.h"
#include "raytracer/scene/scene_moment.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  using namespace seamline::renderer;
  static const std::filesystem::path buffer = fuzz::file_of("buffer.bin", std::string(48, '\0'));
  const std::filesystem::path file = fuzz::file_of("scene.gltf", fuzz::text_of(data, size));
  return fuzz::only_input_errors([&] {
    const auto moment = size % 3 == 0 ? std::optional(FileMoment{"", 0.5}) : std::nullopt;
    const SceneFile scene = read_scene_moment(
        file, size % 2 == 0 ? MaterialModel::diffuse : MaterialModel::gltf, Transparency::refused, moment);
    for (const FileMesh& mesh : scene.meshes) {
      if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions_m.size()) abort();
      for (const auto& uvs : mesh.uvs)
        if (!uvs.empty() && uvs.size() != mesh.positions_m.size()) abort();
      if (!mesh.tangents.empty() && mesh.tangents.size() != mesh.positions_m.size()) abort();
      for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
          if (corner >= mesh.positions_m.size()) abort();
    }
  });
}
