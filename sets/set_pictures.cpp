#include "sets/set_pictures.h"

#include <fmt/core.h>

#include "renderer/views/view_picture.h"
#include "stimuli/pictures/difference.h"
#include "support/files/hash.h"
#include "support/files/image.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

std::string reference_picture(const std::string& truth) {
  return "references/" + truth + ".png";
}
std::string click_map_picture(const std::string& truth) {
  return "references/" + truth + "-ids.png";
}

/// Writes what people are shown, or its click map; of panoramas for each eye also those of the other eyes,
/// which are returned: "stimuli/NAME-eye2.png" beside "stimuli/NAME.png".
std::vector<EyePicture> write_eyes(const fs::path& set_folder, const std::string& image, const View& view,
                                   const ByteImage& bytes) {
  write_png(set_folder / image, eye_of(view, bytes, 0));
  std::vector<EyePicture> more;
  for (int eye = 1; view.kind == ViewKind::omnidirectional && eye < view.views; ++eye) {
    const std::string file = fmt::format("{}-eye{}.png", image.substr(0, image.rfind('.')), eye + 1);
    write_png(set_folder / file, eye_of(view, bytes, eye));
    more.push_back({file, sha256_of_file(set_folder / file)});
  }
  return more;
}

}  // namespace

ManifestStimulus write_stimulus(const fs::path& set_folder, const Stimulus& stimulus,
                                const StimulusPicture& picture) {
  require_numbers(picture.composite.picture, stimulus_id(stimulus));
  const StimulusSums& layers = picture.made.sums;
  const Image shown = compose_view(picture.view, picture.composite.picture);
  ManifestStimulus record{.id = stimulus_id(stimulus),
                          .stimulus = stimulus,
                          .isolation = stimulus.isolation,
                          .image = "stimuli/" + stimulus_id(stimulus) + ".png",
                          .object_ids = click_map_picture(truth_of(stimulus)),
                          .reference = reference_picture(truth_of(stimulus)),
                          .spp = layers.spp,
                          .rays = layers.rays,
                          .rmse = picture.made.rmse,
                          .mesh = {},
                          .tiny_denominators = picture.composite.tiny_denominators,
                          .clipped_share = clipped_share(shown, picture.exposure_ev),
                          .sha256 = {}};
  record.more_eyes = write_eyes(set_folder, record.image, picture.view,
                                shown_bytes(picture.view, shown, picture.exposure_ev, picture.planar_m));
  record.sha256 = sha256_of_file(set_folder / record.image);
  return record;
}

ManifestReference write_reference(const fs::path& set_folder, const std::string& truth,
                                  const ReferencePicture& picture) {
  const SceneReference& reference = picture.made;
  require_numbers(reference.radiance, "scene \"" + truth + "\"");
  ManifestReference record{.truth = truth,
                           .image = reference_picture(truth),
                           .object_ids = click_map_picture(truth),
                           .image_sha256 = {},
                           .object_ids_sha256 = {}};
  record.more_eyes = write_eyes(set_folder, record.image, picture.view,
                                shown_bytes(picture.view, compose_view(picture.view, reference.radiance),
                                            picture.exposure_ev, picture.planar_m));
  record.more_object_ids = write_eyes(set_folder, record.object_ids, picture.view,
                                      view_click_map(picture.view, reference.object_ids));
  record.image_sha256 = sha256_of_file(set_folder / record.image);
  record.object_ids_sha256 = sha256_of_file(set_folder / record.object_ids);
  return record;
}

}  // namespace seamline::renderer
