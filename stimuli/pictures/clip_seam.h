#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "stimuli/pictures/seam_measure.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// Area and widest band of a clip's seam beyond one of `seam_steps`.
struct ClipSeamExtent {
  double mean_area_px = 0, mean_band_px = 0;        ///< over the frames
  double largest_area_px = 0, largest_band_px = 0;  ///< of the frame that has the largest, each for itself
};

/// The seam of a clip: the difference d_k of frame k of the stimulus from frame k of its reference.
struct ClipSeam {
  std::array<ClipSeamExtent, seam_steps.size()> beyond;  ///< each of `seam_steps`
  /// How the seam changes from frame to frame, beside the seam itself:
  /// sqrt(sum |d_k+1 - d_k|^2 / sum (|d_k|^2 + |d_k+1|^2) / 2), over pixels where one of the two frames
  /// exceeds the first of `seam_steps`. 0: it stands still; 1.41: it is elsewhere in every frame; 2: it
  /// changes its sign. None where there is no seam.
  std::optional<double> flicker;
  /// The root of the mean square of that change, in steps of 255; 0 where there is no seam.
  double change_steps = 0;
};

/// Takes a clip frame by frame, in order.
class ClipSeamMeter {
 public:
  void add(const ByteImage& stimulus, const ByteImage& reference);  ///< of one shape, as all before
  [[nodiscard]] ClipSeam result() const;                            ///< after one frame at least

 private:
  int frames_ = 0;
  ClipSeam sum_;  ///< means are sums yet
  SignedDifference last_;
  PixelSet last_seam_;
  double change_ = 0, size_ = 0;  ///< sums of squares
  std::int64_t values_ = 0;       ///< behind them
};

}  // namespace seamline::inline stimuli
