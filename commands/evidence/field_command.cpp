#include "commands/evidence/evidence_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "commands/options/output_files.h"
#include "laboratory/figures/field_figure.h"
#include "raytracer/common/parallel.h"
#include "raytracer/scene/truth_scene.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct FieldOptions {
  std::string object, out;
  double shell = 1.25;
};

void run_field(const FieldOptions& options) {
  if (lower_case_ending(options.out) != ".png")
    throw input_error({.field = "--out", .wanted = "a name that ends in .png", .found = options.out});
  const SceneFile file = read_scene_file(resolve_named_file(options.object, "OBJECT"));
  Eigen::AlignedBox3d box;
  for (const FileMesh& mesh : file.meshes)
    for (const Eigen::Vector3d& place_m : mesh.positions_m) box.extend(place_m);
  const double radius_m = box.isEmpty() ? 0 : 0.5 * box.diagonal().norm();
  if (!(radius_m > 0))
    throw input_error({.file = options.object, .wanted = "an object with triangles", .found = "none"});
  const Geometry object(place_meshes(file, Eigen::Affine3d::Identity(), box.center(), 0.5, 1));
  const FieldFigure figure = field_figure(object, Eigen::Vector3f::Zero(), static_cast<float>(radius_m),
                                          options.shell, default_thread_count());
  write_png(options.out, figure.picture);
  for (std::size_t b = 0; b < figure.bands.size(); ++b) {
    std::string errors;
    for (const auto& of_sample : figure.rms) errors += fmt::format("{:8.3f}", of_sample[b]);
    fmt::print("{} bands: what is visible, off by (root mean square over directions, a number a sample){}\n",
               figure.bands[b], errors);
  }
}

}  // namespace

void add_field_command(CLI::App& app) {
  auto options = std::make_shared<FieldOptions>();
  CLI::App* command = app.add_subcommand(
      "field",
      "an object's occlusion field: a shell of its samples, and what harmonics keep of three of them");
  command->add_option("object", options->object, ".glb, .gltf or builtin:NAME")->required();
  command->add_option("--out", options->out, "picture to write, .png")->required();
  add_number(*command, "--shell", options->shell, {1.001, 100},
             "the shell's radius, as a multiple of that of the ball around the object")
      ->capture_default_str();
  command->callback([options, command] {
    require_outputs(*command, {"--out"});
    run_field(*options);
  });
}

}  // namespace seamline::renderer
