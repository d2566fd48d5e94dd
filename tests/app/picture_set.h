// A small set made by hand: pictures of noise in which three discs stand for the objects.
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
  std::string widths = "64, 128";   ///< depth widths: three stimuli for each
  std::size_t different = 1000000;  ///< picture files; stimuli beyond them show the first ones again
  std::string session = {};         ///< further lines of [session]
  std::string top = {};             ///< further keys of the top level
  std::string more = {};            ///< further tables
};

inline int disc_at(int x, int y, int width_px, int height_px) {
  for (int object = 1; object <= 3; ++object) {
    const int dx = x - width_px * object / 4, dy = y - height_px / 2, radius = height_px / 8;
    if (dx * dx + dy * dy <= radius * radius) return object;
  }
  return 0;
}

/// Noise, so that no wrong place, size or filter goes unnoticed; discs of their own brightness.
inline ByteImage noise_with_discs(int width_px, int height_px, std::uint64_t seed) {
  ByteImage picture{width_px, height_px, 3, {}};
  Random random(seed);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const int disc = disc_at(x, y, width_px, height_px);
      for (int c = 0; c < 3; ++c)
        picture.values.push_back(
            static_cast<std::uint8_t>(disc == 0 ? random.below(256) : 60U * static_cast<unsigned>(disc)));
    }
  return picture;
}

inline ByteImage disc_ids(int width_px, int height_px) {
  ByteImage ids{width_px, height_px, 1, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      ids.values.push_back(static_cast<std::uint8_t>(disc_at(x, y, width_px, height_px)));
  return ids;
}

inline RenderedSet write_picture_set(const std::filesystem::path& folder, const PictureSetRequest& request) {
  std::string text = fmt::format(
      "format = \"seamline study 1\"\nname = \"discs\"\nseed = 7\nwidth_px = {}\nheight_px = {}\n"
      "depth_width_px = [{}]\n{}\n[session]\n{}\n"
      "[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n",
      request.width_px, request.height_px, request.widths, request.top, request.session);
  for (const char* object : {"ball", "disc", "coin"})
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n", object);
  text += request.more;
  Manifest manifest = begin_set_of_text(folder, text);
  write_png(folder / "room.png", noise_with_discs(request.width_px, request.height_px, 0));
  write_png(folder / "room-ids.png", disc_ids(request.width_px, request.height_px));
  manifest.references.push_back({"room", "room.png", "room-ids.png", sha256_of_file(folder / "room.png"),
                                 sha256_of_file(folder / "room-ids.png")});
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i) {
    ManifestStimulus& record = manifest.stimuli[i];
    const std::size_t number = i % request.different;
    record.image = fmt::format("picture-{:04}.png", number);
    record.object_ids = "room-ids.png";
    record.reference = "room.png";
    if (number == i)
      write_png(folder / record.image, noise_with_discs(request.width_px, request.height_px, number + 1));
    record.sha256 = sha256_of_file(folder / record.image);
  }
  write_manifest(folder, manifest);
  return load_rendered_set(folder);
}

}  // namespace seamline::test
