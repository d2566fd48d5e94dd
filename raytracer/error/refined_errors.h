#pragma once
#include <initializer_list>
#include <vector>

#include "raytracer/error/error_estimate.h"

namespace seamline::renderer {

/// The errors of a picture that is refined in rounds: what `estimate_error` says of its halves, bit for bit.
/// Only blocks whose pictures have changed since they were last taken are looked at again.
class RefinedErrors {
 public:
  RefinedErrors(double exposure_ev, bool panorama);

  /// The picture from half of the samples (0 or 1), from all, and from half of them without a filter.
  void take_filtered(std::size_t half, Image picture);
  void take_whole(Image picture);
  void take_sampled(std::size_t half, Image picture);

  /// Of the whole picture; without a bias where the pictures without a filter are not those of this round.
  [[nodiscard]] ErrorEstimate of_filtered(bool with_bias, int threads);
  /// Of the mean of the halves without a filter.
  [[nodiscard]] ErrorEstimate of_sampled(int threads);
  /// Those taken; without `with_sampled` the filtered ones stand for the others.
  [[nodiscard]] HalfPictures pictures(bool with_sampled) const;

 private:
  void take(Image picture, Image& last, std::initializer_list<std::vector<char>*> depending);
  [[nodiscard]] ErrorEstimate joined(const std::vector<double>& noise, const std::vector<double>* bias) const;

  float gain_;
  BlockGrid blocks_;
  HalfPictures last_;
  /// Of each block; a flag each says whether it is that of the pictures.
  std::vector<double> noise_, bias_, noise_of_sampled_;
  std::vector<char> knows_noise_, knows_bias_, knows_sampled_;
};

}  // namespace seamline::renderer
