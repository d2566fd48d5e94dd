// The only file that includes OpenImageIO, and all of a library of its own.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <optional>

#include "support/codec/picture_codec.h"

namespace seamline {
namespace {

/// Asked by the library between pieces of a picture.
bool asked_to_stop(void* stop, float) {
  return (*static_cast<bool (**)()>(stop))();
}

CodedPicture::Values values_of(const OIIO::TypeDesc& type) {
  if (type.is_floating_point()) return CodedPicture::Values::floats;
  if (type == OIIO::TypeDesc::UINT8) return CodedPicture::Values::bytes;
  if (type == OIIO::TypeDesc::UINT16) return CodedPicture::Values::words;
  return CodedPicture::Values::other_integers;
}

std::string profile_of(const OIIO::ImageSpec& spec) {
  const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
  if (profile == nullptr || profile->type().basetype != OIIO::TypeDesc::UINT8) return {};
  return {static_cast<const char*>(profile->data()), profile->type().size()};
}

std::optional<std::array<float, 8>> chromaticities_of(const OIIO::ImageSpec& spec) {
  std::array<float, 8> values{};
  const OIIO::TypeDesc eight(OIIO::TypeDesc::FLOAT, 8);
  if (!spec.getattribute("chromaticities", eight, values.data())) return std::nullopt;
  return values;
}

class Reader final : public PictureReader {
 public:
  Reader(std::unique_ptr<OIIO::ImageInput> input, bool alpha_apart) : input_(std::move(input)) {
    if (alpha_apart) wishes_.attribute("oiio:UnassociatedAlpha", 1);
  }

  ~Reader() override {
    if (!input_) return;
    input_->close();
    (void)input_->geterror();  // errors that nobody asked the library about, it would print
  }

  std::string open(const std::string& path) override {
    OIIO::ImageSpec spec;
    if (input_ && input_->open(path, spec, wishes_)) return {};
    return complaint();
  }

  std::string open(std::string_view bytes) override {
    memory_.emplace(bytes.data(), bytes.size());
    OIIO::ImageSpec spec;
    if (input_ && input_->set_ioproxy(&*memory_) &&
        input_->open(std::string("memory.") + input_->format_name(), spec, wishes_))
      return {};
    return complaint();
  }

  std::string open_part(int part) override {
    return input_->seek_subimage(part, 0) ? std::string() : complaint();
  }

  CodedPicture picture() const override {
    const OIIO::ImageSpec& spec = input_->spec();
    // PNG and TIFF have offsets too, which say where a printer puts a page.
    const bool has_window = std::string_view(input_->format_name()) == "openexr";
    return {spec.width,
            spec.height,
            spec.nchannels,
            !spec.deep && spec.depth <= 1,
            values_of(spec.format),
            spec.get_string_attribute("compression"),
            std::uint64_t{spec.image_bytes(true)},
            input_->format_name(),
            spec.get_int_attribute("Orientation", 1),
            spec.channelnames,
            has_window ? spec.x - spec.full_x : 0,
            has_window ? spec.y - spec.full_y : 0,
            has_window ? spec.full_width : spec.width,
            has_window ? spec.full_height : spec.height,
            profile_of(spec),
            chromaticities_of(spec),
            part_names()};
  }

  std::string read(float* values, bool (*stop)()) override {
    return decode(OIIO::TypeDesc::FLOAT, values, stop);
  }
  std::string read(std::uint16_t* values, bool (*stop)()) override {
    return decode(OIIO::TypeDesc::UINT16, values, stop);
  }
  std::string read(std::uint8_t* values, bool (*stop)()) override {
    return decode(OIIO::TypeDesc::UINT8, values, stop);
  }

 private:
  std::string complaint() const {
    std::string text = input_ ? input_->geterror() : OIIO::geterror();
    text = text.substr(0, text.find('\n'));
    return text.empty() ? "one that cannot" : text;
  }

  /// Of a file of several parts.
  std::vector<std::string> part_names() const {
    std::vector<std::string> names;
    if (std::string_view(input_->format_name()) != "openexr") return names;
    constexpr int most_parts = 256;
    for (int part = 0; part < most_parts && input_->spec_dimensions(part).width > 0; ++part)
      names.push_back(input_->spec(part).get_string_attribute("oiio:subimagename"));
    (void)input_->geterror();  // of the part after the last one
    if (names.size() < 2) names.clear();
    return names;
  }

  std::string decode(OIIO::TypeDesc type, void* values, bool (*stop)()) {
    const bool decoded =
        input_->read_image(input_->current_subimage(), 0, 0, input_->spec().nchannels, type, values,
                           OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride, asked_to_stop, &stop);
    return decoded && !input_->has_error() ? std::string() : complaint();
  }

  std::optional<OIIO::Filesystem::IOMemReader> memory_;  // lives longer than the input that reads from it
  OIIO::ImageSpec wishes_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

OIIO::ImageSpec spec_of(const PictureToEncode& picture) {
  OIIO::ImageSpec spec(picture.width_px, picture.height_px, picture.channels,
                       picture.floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  if (!picture.floats) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 3);  // a third of the time of the usual 6, 7 % more bytes
    return spec;
  }
  if (picture.channels == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("DateTime", "");  // else the library writes the time of day
  return spec;
}

bool reads_last_part(const std::string& path, const std::vector<OIIO::ImageSpec>& specs) {
  const auto input = OIIO::ImageInput::create("openexr");
  OIIO::ImageSpec first;
  const int last = static_cast<int>(specs.size()) - 1;
  if (!input || !input->open(path, first) || !input->seek_subimage(last, 0)) return false;
  std::vector<float> values(static_cast<std::size_t>(specs.back().image_pixels()) *
                            static_cast<std::size_t>(specs.back().nchannels));
  return input->spec().image_pixels() == specs.back().image_pixels() &&
         input->read_image(last, 0, 0, specs.back().nchannels, OIIO::TypeDesc::FLOAT, values.data());
}

class Codec final : public PictureCodec {
 public:
  std::unique_ptr<PictureReader> reader(const std::string& format, bool alpha_apart) const override {
    return std::make_unique<Reader>(OIIO::ImageInput::create(format), alpha_apart);
  }

  std::vector<unsigned char> encode(const PictureToEncode& picture, bool (*stop)(),
                                    std::string& complaint) const override {
    const OIIO::ImageSpec spec = spec_of(picture);
    const void* pixels = picture.floats;
    if (!pixels) pixels = picture.codes;
    OIIO::Filesystem::IOVecOutput bytes;
    const auto output = OIIO::ImageOutput::create("picture" + picture.extension);
    const bool encoded = output && output->set_ioproxy(&bytes) &&
                         output->open("picture" + picture.extension, spec) &&
                         output->write_image(spec.format, pixels, OIIO::AutoStride, OIIO::AutoStride,
                                             OIIO::AutoStride, asked_to_stop, &stop) &&
                         output->close();
    if (!encoded) complaint = output ? output->geterror() : OIIO::geterror();
    if (!encoded && complaint.empty()) complaint = "another kind";
    return bytes.buffer();
  }

  std::string write_parts(const std::string& path, const std::vector<NamedPart>& parts,
                          bool (*stop)()) const override {
    std::vector<OIIO::ImageSpec> specs;
    for (const NamedPart& part : parts) {
      specs.push_back(spec_of(part.picture));
      specs.back().attribute("oiio:subimagename", part.name);
    }
    const auto output = OIIO::ImageOutput::create("openexr");
    bool written = output && output->open(path, static_cast<int>(specs.size()), specs.data());
    for (std::size_t i = 0; i < parts.size() && written; ++i)
      written = (i == 0 || output->open(path, specs[i], OIIO::ImageOutput::AppendSubimage)) &&
                output->write_image(OIIO::TypeDesc::FLOAT, parts[i].picture.floats, OIIO::AutoStride,
                                    OIIO::AutoStride, OIIO::AutoStride, asked_to_stop, &stop);
    written = written && output->close();
    if (written && reads_last_part(path, specs)) return {};
    const std::string text = output ? output->geterror() : OIIO::geterror();
    return text.empty() ? "a file that was cut" : text;
  }

  void draw_text(const PictureToEncode& picture, std::uint8_t* codes, int x, int y, const std::string& text,
                 int height_px, const std::string& font, std::uint8_t code) const override {
    const OIIO::ImageSpec spec(picture.width_px, picture.height_px, picture.channels, OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf buffer(spec, codes);
    const float grey = static_cast<float>(code) / 255.0F;
    const std::vector<float> colour(static_cast<std::size_t>(picture.channels), grey);
    OIIO::ImageBufAlgo::render_text(buffer, x, y, text, height_px, font, colour);
  }
};

}  // namespace
}  // namespace seamline

extern "C" const seamline::PictureCodec* seamline_picture_codec(const char* version) {
  static const seamline::Codec codec;
  return std::string_view(version) == SEAMLINE_VERSION_TEXT ? &codec : nullptr;
}
