#pragma once
#include <compare>
#include <string>

#include "sensors/repair/repaired.h"
#include "support/files/image.h"

namespace seamline::sensors {

/// The joint bilateral filter (Kopf, Cohen, Lischinski and Uyttendaele, "Joint Bilateral Upsampling", ACM
/// Transactions on Graphics 26(3), 2007, their Eq. 2): a mean of the measured depths D of the window W round
/// p, weighted by how near they lie in the picture and how alike they look in the photograph I, which is in
/// the depth camera's own pixels:
///
///     D'_p = sum_{q in W} D_q w_pq / sum_{q in W} w_pq
///     w_pq = exp(-|p - q|^2 / (2 sigma_px^2)) exp(-|I_p - I_q|^2 / (2 sigma_colour^2))
///
/// Holes have no weight. Where two depths meet in one colour the mean lies between them, where nothing is:
/// that is the method's known fault.
struct JointBilateralRepair {
  int radius_px = 5;
  double sigma_px = 2.5;
  double sigma_colour = 0.1;  ///< of the length of a difference of colours, in the photograph's own units
  bool fills = true;          ///< whether holes get a depth where the weights sum up to `least_weight`
  double least_weight = 0.1;

  auto operator<=>(const JointBilateralRepair&) const = default;
};

/// Throws InputError naming `where`: a radius outside 1 to 50, sigmas or least weight that are not above 0.
void require_valid(const JointBilateralRepair& bilateral, const std::string& where);

/// Filters a frame by its photograph. The same bytes for any number of threads (0: one for each core). Throws
/// InputError as `require_valid`, for a photograph of another size, and for one with values that are no
/// numbers.
[[nodiscard]] Repaired smooth_by_photograph(const DepthFrame& measured, const Image& photograph,
                                            const JointBilateralRepair& bilateral, int threads = 0);

}  // namespace seamline::sensors
