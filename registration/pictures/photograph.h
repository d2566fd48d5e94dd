#pragma once
#include <filesystem>

#include "registration/frame/registered_frame.h"
#include "support/files/image.h"

namespace seamline::registration {

/// Reads the photograph that a camera took, linear. Throws InputError naming the file: for fewer than three
/// channels, another size than the camera's, and colours that are no numbers.
[[nodiscard]] Image read_photograph(const std::filesystem::path& path, const sensors::PinholeCamera& colour);

/// What the photograph shows in the pixels of the depth camera, by which a repair is guided: the colour of
/// the pixel nearest to where each depth lands. A hole is taken as deep as the nearest measured pixel of the
/// picture; what lands outside the photograph takes the pixel at its edge, and what does not land at all is
/// black.
[[nodiscard]] Image photograph_in_depth_pixels(const Image& photograph, const sensors::DepthFrame& measured,
                                               const Eigen::Isometry3d& colour_from_depth,
                                               const sensors::PinholeCamera& colour, int threads = 0);

/// The edges of registered depth over the photograph (paper 000, Fig. 4): red where depth changes the most,
/// by more than `ratio`, across as many pixels of the photograph as one of the depth camera covers, because a
/// mesh spreads a jump over them; on either side the median of three pixels of the depth camera counts, and
/// what was extruded has no edges. Pixels without a depth are darkened to a third, extruded ones to two
/// thirds of their code. Where depth and photograph agree, red runs along the outlines of things.
[[nodiscard]] ByteImage edges_over_photograph(const RegisteredFrame& registered, const Image& photograph,
                                              double ratio, double depth_pixel_px = 1);

/// Marks of pixels as a picture: 255 where the mask is 1, else 0.
[[nodiscard]] ByteImage mask_picture(const sensors::PinholeCamera& camera,
                                     std::span<const std::uint8_t> mask);

}  // namespace seamline::registration
