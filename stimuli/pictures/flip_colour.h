#pragma once
#include <Eigen/Core>

namespace seamline::inline stimuli {

// The colours of LDR-FLIP (Andersson et al. 2020, sections 4.1 and 4.2). Every triple is of doubles; linear
// RGB has Rec. 709 primaries, and the white point is that of linear RGB (1, 1, 1).

/// Linear RGB to the linear opponent space YCxCz (an L*a*b* without its cube roots): Y = 116 y - 16,
/// Cx = 500 (x - y), Cz = 200 (y - z), with x, y, z relative to white.
[[nodiscard]] Eigen::Array3d ycxcz_from_linear(const Eigen::Array3d& rgb);

/// The inverse of `ycxcz_from_linear`; may leave 0..1.
[[nodiscard]] Eigen::Array3d linear_from_ycxcz(const Eigen::Array3d& ycxcz);

/// Linear RGB to CIE L*a*b*.
[[nodiscard]] Eigen::Array3d lab_from_linear(const Eigen::Array3d& rgb);

/// The Hunt effect (section 4.1, Eq. 7): chroma grows with lightness, a = 0.01 L* a*, b = 0.01 L* b*.
[[nodiscard]] Eigen::Array3d hunt_adjusted(const Eigen::Array3d& lab);

/// The HyAB distance |dL| + sqrt(da^2 + db^2) (Abasi et al. 2020), made for large colour differences.
[[nodiscard]] double hyab_distance(const Eigen::Array3d& a, const Eigen::Array3d& b);

/// A HyAB distance between Hunt-adjusted colours to the colour difference 0..1 (section 4.1, Eqs. 9 and 10):
/// to the power q_c = 0.7, then 0..p_c c_max linearly onto 0..p_t and the rest onto p_t..1, p_c = 0.4, p_t =
/// 0.95; c_max is that power of the distance between pure green and pure blue.
[[nodiscard]] double colour_difference_of_distance(double hyab);

}  // namespace seamline::inline stimuli
