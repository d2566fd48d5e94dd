#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace seamline {

/// How the codes of an RGB picture stand for light: an embedded ICC profile. Linear light is that of sRGB's
/// primaries, in which colours outside of them have negative parts; relative colorimetry, unbounded.
class ColourProfile {
 public:
  /// Of a profile's bytes. Null with an empty `complaint`: it is sRGB, to half an 8-bit step over all
  /// colours. Null with a complaint: it cannot be used (another colour space than RGB, damage, a build
  /// without lcms2).
  [[nodiscard]] static std::shared_ptr<const ColourProfile> of(const std::string& bytes,
                                                               std::string& complaint);

  /// x and y of red, green, blue and white (chromaticities of EXR files, primaries of Radiance files): a
  /// matrix into linear sRGB, row by row, white onto white (Bradford); XYZ as its own primaries stay XYZ.
  /// None where the numbers are no colours.
  [[nodiscard]] static bool matrix_of(const std::array<float, 8>& chromaticities,
                                      std::array<double, 9>& matrix);

  ColourProfile(const ColourProfile&) = delete;
  ColourProfile& operator=(const ColourProfile&) = delete;
  ~ColourProfile();

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Codes, 0 to 1, of so many pixels of three channels, as linear light, in place; and back.
  void to_linear(float* rgb, std::size_t pixels) const;
  void from_linear(float* rgb, std::size_t pixels) const;

 private:
  ColourProfile() = default;

  std::string bytes_, name_;
  void* to_ = nullptr;  // lcms2's transforms
  void* from_ = nullptr;
};

}  // namespace seamline
