#include "study/app/screens/instruction_pictures.h"

#include "support/files/confined_path.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

/// Three channels; what is transparent shows the card.
ByteImage opaque(const ByteImage& picture) {
  if (picture.channels == 1 || picture.channels == 3) return picture;
  ByteImage result{picture.width_px, picture.height_px, 3, {}};
  const std::size_t channels = picture.channels;
  const bool grey_only = channels == 2;
  for (std::size_t at = 0; at + channels <= picture.values.size(); at += channels) {
    const int alpha = picture.values[at + channels - 1];
    for (std::size_t c = 0; c < 3; ++c) {
      const int code = picture.values[at + (grey_only ? 0 : c)];
      result.values.push_back(
          static_cast<std::uint8_t>((code * alpha + look::card.red * (255 - alpha)) / 255));
    }
  }
  return result;
}

}  // namespace

std::vector<std::vector<WindowTexture>> load_instruction_pictures(const RenderedSet& set) {
  std::vector<std::vector<WindowTexture>> pages;
  for (const InstructionPage& page : set.study.instructions) {
    std::vector<WindowTexture>& pictures = pages.emplace_back();
    for (const std::string& name : page.pictures) {
      const std::filesystem::path file =
          path_below(set.folder, name,
                     {.file = (set.folder / set.manifest.study_file).string(), .field = "instructions"});
      pictures.emplace_back().upload(opaque(read_bytes_image(file)));
      pictures.back().smooth(true);
    }
  }
  return pages;
}

}  // namespace seamline::study::app
