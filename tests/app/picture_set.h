// A small set made by hand: pictures of noise in which discs stand for the objects.
#pragma once
#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "support/arithmetic/random.h"
#include "support/files/hash.h"
#include "support/files/image.h"
#include "tests/study/temporary_set.h"

namespace seamline::test {
using namespace study;

struct PictureSetRequest {
  int width_px = 400, height_px = 240;
  std::string widths = "64, 128";  ///< depth widths: a stimulus of each object for each
  int objects = 3;
  std::size_t different = 1000000;  ///< picture files; stimuli beyond them show the first ones again
  std::string session = {};         ///< further lines of [session]
  std::string top = {};             ///< further keys of the top level
  std::string more = {};            ///< further tables
};

inline int disc_at(int x, int y, int width_px, int height_px, int objects = 3) {
  for (int object = 1; object <= objects; ++object) {
    const int dx = x - width_px * object / (objects + 1), dy = y - height_px / 2, radius = height_px / 8;
    if (dx * dx + dy * dy <= radius * radius) return object;
  }
  return 0;
}

/// Noise, so that no wrong place, size or filter goes unnoticed; discs of their own brightness.
inline ByteImage noise_with_discs(int width_px, int height_px, std::uint64_t seed, int objects = 3) {
  ByteImage picture{width_px, height_px, 3, {}};
  Random random(seed);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const int disc = disc_at(x, y, width_px, height_px, objects);
      for (int c = 0; c < 3; ++c)
        picture.values.push_back(static_cast<std::uint8_t>(
            disc == 0 ? random.below(256) : (objects > 3 ? 30U : 60U) * static_cast<unsigned>(disc)));
    }
  return picture;
}

inline ByteImage disc_ids(int width_px, int height_px, int objects = 3) {
  ByteImage ids{width_px, height_px, 1, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      ids.values.push_back(static_cast<std::uint8_t>(disc_at(x, y, width_px, height_px, objects)));
  return ids;
}

inline RenderedSet write_picture_set(const std::filesystem::path& folder, const PictureSetRequest& request) {
  std::string text = fmt::format(
      "format = \"seamline study 1\"\nname = \"discs\"\nseed = 7\nwidth_px = {}\nheight_px = {}\n"
      "depth_width_px = [{}]\n{}\n[session]\n{}\n"
      "[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n",
      request.width_px, request.height_px, request.widths, request.top, request.session);
  const std::vector<const char*> names = {"ball", "disc", "coin", "pea", "plum", "sun", "moon", "dot"};
  for (int object = 0; object < request.objects; ++object)
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n",
                        names.at(static_cast<std::size_t>(object)));
  text += request.more;
  Manifest manifest = begin_set_of_text(folder, text);
  write_png(folder / "room.png", noise_with_discs(request.width_px, request.height_px, 0, request.objects));
  write_png(folder / "room-ids.png", disc_ids(request.width_px, request.height_px, request.objects));
  manifest.references.push_back({"room", "room.png", "room-ids.png", sha256_of_file(folder / "room.png"),
                                 sha256_of_file(folder / "room-ids.png")});
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i) {
    ManifestStimulus& record = manifest.stimuli[i];
    const std::size_t number = i % request.different;
    record.image = fmt::format("picture-{:04}.png", number);
    record.object_ids = "room-ids.png";
    record.reference = "room.png";
    if (number == i)
      write_png(folder / record.image,
                noise_with_discs(request.width_px, request.height_px, number + 1, request.objects));
    record.sha256 = sha256_of_file(folder / record.image);
  }
  write_manifest(folder, manifest);
  return load_rendered_set(folder);
}

}  // namespace seamline::test
