// The only file that includes lcms2.
#include "support/codec/colour_profile.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/arithmetic/colour.h"
#ifdef SEAMLINE_HAS_LCMS
#include <lcms2.h>
#endif

namespace seamline {
namespace {

/// Colours as columns X Y Z of their x and y.
Eigen::Vector3d xyz_of(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

/// From linear RGB of these primaries into CIE XYZ, white having Y = 1.
bool xyz_from_rgb(const std::array<double, 8>& places, Eigen::Matrix3d& matrix) {
  if (!std::all_of(places.begin(), places.end(), [](double place) { return std::isfinite(place); }))
    return false;
  if (!(places[7] > 1e-4)) return false;
  Eigen::Matrix3d primaries;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto at = 2 * static_cast<std::size_t>(c);
    // In no unit, so that those of XYZ itself, which have no luminance, are some too.
    primaries.col(c) = Eigen::Vector3d(places[at], places[at + 1], 1 - places[at] - places[at + 1]);
  }
  if (!(std::abs(primaries.determinant()) > 1e-9)) return false;
  const Eigen::Vector3d amounts = primaries.inverse() * xyz_of(places[6], places[7]);
  matrix = primaries * amounts.asDiagonal();
  return matrix.allFinite();
}

constexpr std::array<double, 8> srgb_places = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

/// White of one picture as the white of another (Lam 1985).
Eigen::Matrix3d bradford(const Eigen::Vector3d& from_white, const Eigen::Vector3d& to_white) {
  Eigen::Matrix3d cones;
  cones << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
  const Eigen::Vector3d gain = (cones * to_white).cwiseQuotient(cones * from_white);
  return cones.inverse() * gain.asDiagonal() * cones;
}

}  // namespace

bool ColourProfile::matrix_of(const std::array<float, 8>& chromaticities, std::array<double, 9>& matrix) {
  std::array<double, 8> places{};
  std::copy(chromaticities.begin(), chromaticities.end(), places.begin());
  Eigen::Matrix3d from, to;
  if (!xyz_from_rgb(places, from) || !xyz_from_rgb(srgb_places, to)) return false;
  // XYZ itself has every white: its own is a name.
  const bool is_xyz = places[0] == 1 && places[1] == 0 && places[2] == 0 && places[3] == 1 &&
                      places[4] == 0 && places[5] == 0;
  if (is_xyz) from.setIdentity();
  const Eigen::Matrix3d adapt =
      is_xyz ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
             : bradford(xyz_of(places[6], places[7]), xyz_of(srgb_places[6], srgb_places[7]));
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> all = to.inverse() * adapt * from;
  if (!all.allFinite()) return false;
  std::copy(all.data(), all.data() + 9, matrix.begin());
  return true;
}

#ifdef SEAMLINE_HAS_LCMS
namespace {

/// A profile of lcms2 that goes with its scope.
struct OpenProfile {
  cmsHPROFILE handle;
  explicit OpenProfile(cmsHPROFILE opened) : handle(opened) {}
  OpenProfile(const OpenProfile&) = delete;
  OpenProfile& operator=(const OpenProfile&) = delete;
  ~OpenProfile() {
    if (handle) cmsCloseProfile(handle);
  }
};

cmsHPROFILE linear_srgb() {
  const cmsCIExyY white{srgb_places[6], srgb_places[7], 1};
  const cmsCIExyYTRIPLE primaries{{srgb_places[0], srgb_places[1], 1},
                                  {srgb_places[2], srgb_places[3], 1},
                                  {srgb_places[4], srgb_places[5], 1}};
  cmsToneCurve* straight = cmsBuildGamma(nullptr, 1);
  const std::array<cmsToneCurve*, 3> curves = {straight, straight, straight};
  cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves.data());
  cmsFreeToneCurve(straight);
  return profile;
}

cmsHTRANSFORM float_transform(cmsHPROFILE from, cmsHPROFILE to) {
  return cmsCreateTransform(from, TYPE_RGB_FLT, to, TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC,
                            cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE);
}

std::string profile_name(cmsHPROFILE profile) {
  std::array<char, 128> text{};
  cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", text.data(), text.size() - 1);
  std::string name = text.data();
  return name.empty() ? "without a name" : name;
}

/// Whether a profile's codes are sRGB's, to two 8-bit steps: so much do the tables and rounded primaries of
/// sRGB's own profiles differ in saturated colours.
bool is_srgb(const ColourProfile& profile) {
  constexpr int steps = 9;
  std::vector<float> rgb;
  for (int r = 0; r < steps; ++r)
    for (int g = 0; g < steps; ++g)
      for (int b = 0; b < steps; ++b)
        for (const int code : {r, g, b}) rgb.push_back(static_cast<float>(code) / (steps - 1));
  const std::vector<float> codes = rgb;
  profile.to_linear(rgb.data(), rgb.size() / 3);
  for (std::size_t i = 0; i < rgb.size(); ++i)
    if (std::abs(srgb_from_linear(std::max(0.0F, rgb[i])) - codes[i]) > 2.0F / 255) return false;
  return true;
}

}  // namespace

std::shared_ptr<const ColourProfile> ColourProfile::of(const std::string& bytes, std::string& complaint) {
  constexpr std::size_t largest_profile_bytes = 1U << 24U;
  complaint = "an ICC profile that cannot be used";
  if (bytes.size() > largest_profile_bytes) return nullptr;
  const OpenProfile profile(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!profile.handle) return nullptr;
  if (cmsGetColorSpace(profile.handle) != cmsSigRgbData) {
    complaint = "an ICC profile of another colour space than RGB";
    return nullptr;
  }
  const OpenProfile linear(linear_srgb());
  std::shared_ptr<ColourProfile> made(new ColourProfile);
  made->bytes_ = bytes;
  made->name_ = profile_name(profile.handle);
  made->to_ = float_transform(profile.handle, linear.handle);
  made->from_ = float_transform(linear.handle, profile.handle);
  if (!made->to_ || !made->from_) return nullptr;
  complaint.clear();
  return is_srgb(*made) ? nullptr : made;
}

ColourProfile::~ColourProfile() {
  if (to_) cmsDeleteTransform(to_);
  if (from_) cmsDeleteTransform(from_);
}

void ColourProfile::to_linear(float* rgb, std::size_t pixels) const {
  cmsDoTransform(to_, rgb, rgb, static_cast<cmsUInt32Number>(pixels));
}

void ColourProfile::from_linear(float* rgb, std::size_t pixels) const {
  cmsDoTransform(from_, rgb, rgb, static_cast<cmsUInt32Number>(pixels));
}
#else
std::shared_ptr<const ColourProfile> ColourProfile::of(const std::string&, std::string& complaint) {
  complaint = "an ICC profile, which this build, made without liblcms2-dev, cannot use";
  return nullptr;
}
ColourProfile::~ColourProfile() = default;
void ColourProfile::to_linear(float*, std::size_t) const {}
void ColourProfile::from_linear(float*, std::size_t) const {}
#endif

}  // namespace seamline
