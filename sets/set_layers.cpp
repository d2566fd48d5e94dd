#include "sets/set_layers.h"

#include "raytracer/scene/seen_surface.h"
#include "support/files/atomic_file.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

fs::path layer_folder(const fs::path& set_folder, const Stimulus& stimulus) {
  return set_folder / "layers" / stimulus_id(stimulus);
}

Image difference(const Image& a, const Image& b) {
  Image out = a;
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] -= b.values[i];
  return out;
}

}  // namespace

Image shaded_picture(const Camera& camera, const Geometry& geometry) {
  Image picture(camera.width_px, camera.height_px, 3);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      if (const auto hit = seen_surface(camera, geometry, x, y))
        picture.set_rgb(x, y,
                        Rgb::Constant(0.05F + 0.75F * std::abs(hit->geometric_normal.dot(
                                                          camera.centre_direction(x, y)))));
    }
  return picture;
}

bool has_layers(const fs::path& set_folder, const Stimulus& stimulus, const std::string& inputs) {
  const fs::path made_from = layer_folder(set_folder, stimulus) / "inputs";
  return fs::exists(made_from) && read_file(made_from) == inputs;
}

void write_layers(const LayerTarget& target, const TruthScene& scene, const Geometry* depth,
                  const LayerSources& parts) {
  const fs::path folder = layer_folder(target.set_folder, target.stimulus);
  prepare_output_folder(folder);
  fs::remove(folder / "inputs");
  const LayerImages images = layer_images(parts.layers);
  const Image reference = reference_image(parts.truth);
  write_picture_exr(folder / "background.exr", background_image(parts.truth));
  write_picture_exr(folder / "reference.exr", reference);
  write_picture_exr(folder / "with.exr", images.with_object);
  write_picture_exr(folder / "without.exr", images.without_object);
  write_picture_exr(folder / "ratio.exr", parts.composite.ratio);
  write_picture_exr(folder / "matte.exr", matte_image(parts.truth));
  write_picture_exr(folder / "difference.exr", difference(parts.composite.picture, reference));
  write_picture_exr(folder / "additive.exr", compose(parts.layers, Compositing::additive).picture);
  if (depth != nullptr)
    write_png(folder / "local_scene.png", display_image(shaded_picture(scene.camera, *depth)));
  write_picture_exr(folder / "composite.exr", parts.composite.picture);
  write_file_atomically(folder / "inputs", target.inputs);
}

}  // namespace seamline::renderer
