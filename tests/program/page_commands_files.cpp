#include "page_commands_files.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/stimuli/png_parts.h"

namespace seamline::page_commands {
namespace {

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

std::string two_bytes(int value) {
  return bytes_of({value >> 8, value & 0xFF});
}

std::string jpeg_part(int marker, const std::string& data) {
  return bytes_of({0xFF, marker}) + two_bytes(static_cast<int>(data.size()) + 2) + data;
}

/// Bits of a scan; a byte of ones is followed by a zero.
class ScanBits {
 public:
  void put(int value, int count) {
    for (int bit = count - 1; bit >= 0; --bit) {
      byte_ = byte_ * 2 + (value >> bit & 1);
      if (++filled_ < 8) continue;
      bytes_ += static_cast<char>(byte_);
      if (byte_ == 0xFF) bytes_ += '\0';
      byte_ = filled_ = 0;
    }
  }
  [[nodiscard]] std::string ended() {
    while (filled_ != 0) put(1, 1);
    return bytes_;
  }

 private:
  std::string bytes_;
  int byte_ = 0, filled_ = 0;
};

/// Luminance and the two differences of colour of JFIF, each the mean of a block.
std::array<int, 3> block_of(const ByteImage& picture, int left, int top) {
  std::array<double, 3> sum{};
  for (int i = 0; i < 64; ++i) {
    const int x = std::min(left + i % 8, picture.width_px - 1),
              y = std::min(top + i / 8, picture.height_px - 1);
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width_px) +
                         static_cast<std::size_t>(x));
    const double red = picture.values[at], green = picture.values[at + 1], blue = picture.values[at + 2];
    const double luma = 0.299 * red + 0.587 * green + 0.114 * blue;
    sum[0] += luma - 128;
    sum[1] += (blue - luma) / 1.772;
    sum[2] += (red - luma) / 1.402;
  }
  std::array<int, 3> means{};
  for (std::size_t i = 0; i < 3; ++i) means[i] = static_cast<int>(std::lround(sum[i] / 64));
  return means;
}

}  // namespace

std::string jpeg_of(const ByteImage& picture) {
  // One table of steps of 8: a block's first coefficient is 8 times its mean.
  const std::string steps = std::string(1, '\0') + std::string(64, '\x08');
  const std::string frame = bytes_of({8}) + two_bytes(picture.height_px) + two_bytes(picture.width_px) +
                            bytes_of({3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0});
  // Twelve codes of four bits for the length of a difference; one of a bit: nothing else in the block.
  std::string lengths = bytes_of({0x00, 0, 0, 0, 12}) + std::string(12, '\0');
  for (int length = 0; length < 12; ++length) lengths += static_cast<char>(length);
  const std::string ends = bytes_of({0x10, 1}) + std::string(15, '\0') + std::string(1, '\0');
  ScanBits bits;
  std::array<int, 3> before{};
  for (int top = 0; top < picture.height_px; top += 8)
    for (int left = 0; left < picture.width_px; left += 8) {
      const std::array<int, 3> block = block_of(picture, left, top);
      for (std::size_t i = 0; i < 3; ++i) {
        const int difference = block[i] - before[i];
        int length = 0;
        while (std::abs(difference) >> length != 0) ++length;
        bits.put(length, 4);
        bits.put(difference < 0 ? difference + (1 << length) - 1 : difference, length);
        bits.put(0, 1);
      }
      before = block;
    }
  return bytes_of({0xFF, 0xD8}) +
         jpeg_part(0xE0, std::string("JFIF\0", 5) + bytes_of({1, 1, 0, 0, 1, 0, 1, 0, 0})) +
         jpeg_part(0xDB, steps) + jpeg_part(0xC0, frame) + jpeg_part(0xC4, lengths) + jpeg_part(0xC4, ends) +
         jpeg_part(0xDA, bytes_of({3, 1, 0, 2, 0, 3, 0, 0, 63, 0})) + bits.ended() + bytes_of({0xFF, 0xD9});
}

std::string hdr_of(const Image& radiance) {
  std::string bytes = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", radiance.height_px,
                                  radiance.width_px);
  for (int y = 0; y < radiance.height_px; ++y)
    for (int x = 0; x < radiance.width_px; ++x) {
      const float most = radiance.rgb(x, y).maxCoeff();
      int exponent = 0;
      const double scale = most < 1e-30F ? 0 : 256 * std::frexp(most, &exponent) / double{most};
      for (int channel = 0; channel < 3; ++channel)
        bytes += static_cast<char>(static_cast<int>(double{radiance.at(x, y, channel)} * scale));
      bytes += static_cast<char>(scale > 0 ? exponent + 128 : 0);
    }
  return bytes;
}

namespace {

std::string big_words(const DepthNumbers& depth, bool is_png) {
  std::string bytes;
  for (int y = 0; y < depth.height_px; ++y) {
    if (is_png) bytes += '\0';  // no filter
    for (int x = 0; x < depth.width_px; ++x)
      bytes += two_bytes(static_cast<int>(std::lround(std::clamp(depth.value_at(x, y), 0.0, 65535.0))));
  }
  return bytes;
}

/// A stream of zlib whose blocks are stored as they are.
std::string stored_blocks(const std::string& bytes) {
  std::string stream = "\x78\x01";
  constexpr std::size_t most = 65535;
  for (std::size_t at = 0; at < bytes.size(); at += most) {
    const std::size_t size = std::min(most, bytes.size() - at);
    const auto low = static_cast<int>(size);
    stream +=
        bytes_of({at + size == bytes.size() ? 1 : 0, low & 0xFF, low >> 8, ~low & 0xFF, (~low >> 8) & 0xFF});
    stream += bytes.substr(at, size);
  }
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return stream + test::big_endian(b << 16 | a);
}

}  // namespace

std::string png_of(const DepthNumbers& depth) {
  return test::png_head(static_cast<std::uint32_t>(depth.width_px),
                        static_cast<std::uint32_t>(depth.height_px), bytes_of({16, 0, 0})) +
         test::png_part("IDAT", stored_blocks(big_words(depth, true))) + test::png_part("IEND", "");
}

std::string pgm_of(const DepthNumbers& depth) {
  return fmt::format("P5\n{} {}\n65535\n", depth.width_px, depth.height_px) + big_words(depth, false);
}

namespace {

struct FigureJoint {
  const char *name, *parent;
  std::array<double, 3> from_parent_m;
};
constexpr std::array figure_joints = {FigureJoint{"torso", "", {0, 1, 0}},
                                      FigureJoint{"neck", "torso", {0, 0.45, 0}},
                                      FigureJoint{"head", "neck", {0, 0.2, 0}},
                                      FigureJoint{"left_shoulder", "torso", {0.2, 0.4, 0}},
                                      FigureJoint{"left_elbow", "left_shoulder", {0, -0.3, 0}},
                                      FigureJoint{"left_hand", "left_elbow", {0, -0.28, 0}},
                                      FigureJoint{"right_shoulder", "torso", {-0.2, 0.4, 0}},
                                      FigureJoint{"right_elbow", "right_shoulder", {0, -0.3, 0}},
                                      FigureJoint{"right_hand", "right_elbow", {0, -0.28, 0}}};

std::size_t number_of_joint(const std::string& name) {
  for (std::size_t i = 0; i < figure_joints.size(); ++i)
    if (figure_joints[i].name == name) return i;
  return figure_joints.size();
}

}  // namespace

std::string jointed_figure() {
  std::string nodes;
  for (const FigureJoint& joint : figure_joints) {
    std::string children;
    for (std::size_t i = 0; i < figure_joints.size(); ++i)
      if (std::string(figure_joints[i].parent) == joint.name)
        children += (children.empty() ? "" : ",") + std::to_string(i);
    nodes += fmt::format(R"({}{{"name":"{}","translation":[{},{},{}]{}}})", nodes.empty() ? "" : ",",
                         joint.name, joint.from_parent_m[0], joint.from_parent_m[1], joint.from_parent_m[2],
                         children.empty() ? "" : ",\"children\":[" + children + "]");
  }
  std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "]}";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 255U);
    return bytes;
  };
  return "glTF" + word(2) + word(20 + text.size()) + word(text.size()) + "JSON" + text;
}

std::string recorded_joints() {
  std::string rows = "time_s,joint,x_m,y_m,z_m\n";
  for (int moment = 0; moment < 3; ++moment) {
    std::array<std::array<double, 3>, figure_joints.size()> at{};
    for (std::size_t i = 0; i < figure_joints.size(); ++i) {
      const FigureJoint& joint = figure_joints[i];
      const std::size_t parent = number_of_joint(joint.parent);
      // The left arm goes up, from moment to moment.
      const bool is_left_arm =
          joint.name == std::string("left_elbow") || joint.name == std::string("left_hand");
      const double turn = is_left_arm ? 1.2 * moment : 0, down = joint.from_parent_m[1];
      at[i] = joint.from_parent_m;
      if (is_left_arm) at[i] = {-down * std::sin(turn), down * std::cos(turn), 0};
      for (std::size_t axis = 0; axis < 3 && parent < at.size(); ++axis) at[i][axis] += at[parent][axis];
      rows += fmt::format("{},{},{},{},{}\n", 0.5 * moment, joint.name, at[i][0], at[i][1], at[i][2]);
    }
  }
  return rows;
}

}  // namespace seamline::page_commands
