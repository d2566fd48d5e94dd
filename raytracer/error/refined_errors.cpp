#include "raytracer/error/refined_errors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

/// Whether two pictures have the same bits in a block.
bool same_block(const Image& a, const Image& b, const BlockGrid::Rectangle& block) {
  for (int y = block.top; y < block.bottom; ++y) {
    const std::size_t first = a.index(block.left, y);
    const std::size_t count = static_cast<std::size_t>(block.right - block.left) * 3;
    if (std::memcmp(&a.values[first], &b.values[first], count * sizeof(float)) != 0) return false;
  }
  return true;
}

/// Looks at the blocks that are not known.
template <class Error>
void learn(const BlockGrid& blocks, int threads, std::vector<char>& knows, std::vector<double>& errors,
           const Error& error) {
  parallel_for(blocks.rows(), threads, [&](int row) {
    for (int block = row * blocks.columns(); block < (row + 1) * blocks.columns(); ++block) {
      const auto b = static_cast<std::size_t>(block);
      if (knows[b] == 0) errors[b] = error(block);
      knows[b] = 1;
    }
  });
}

}  // namespace

RefinedErrors::RefinedErrors(double exposure_ev, bool panorama)
    : gain_(static_cast<float>(std::exp2(exposure_ev))), blocks_{0, 0, panorama} {}

void RefinedErrors::take(Image picture, Image& last, std::initializer_list<std::vector<char>*> depending) {
  require_numbers(picture);
  if (blocks_.width_px == 0) {
    blocks_.width_px = picture.width_px, blocks_.height_px = picture.height_px;
    const auto count = static_cast<std::size_t>(blocks_.count());
    for (std::vector<double>* errors : {&noise_, &bias_, &noise_of_sampled_}) errors->resize(count);
    for (std::vector<char>* known : {&knows_noise_, &knows_bias_, &knows_sampled_}) known->resize(count, 0);
  }
  for (int block = 0; block < blocks_.count(); ++block)
    if (last.values.empty() || !same_block(picture, last, blocks_.rectangle(block)))
      for (std::vector<char>* known : depending) (*known)[static_cast<std::size_t>(block)] = 0;
  last = std::move(picture);
}

void RefinedErrors::take_filtered(std::size_t half, Image picture) {
  take(std::move(picture), last_.filtered[half], {&knows_noise_, &knows_bias_});
}

void RefinedErrors::take_whole(Image picture) {
  take(std::move(picture), last_.whole, {&knows_noise_});
}

void RefinedErrors::take_sampled(std::size_t half, Image picture) {
  take(std::move(picture), last_.sampled[half], {&knows_bias_, &knows_sampled_});
}

ErrorEstimate RefinedErrors::of_filtered(bool with_bias, int threads) {
  learn(blocks_, threads, knows_noise_, noise_,
        [&](int block) { return block_noise(last_.filtered, last_.whole, blocks_, block, gain_); });
  if (!with_bias) return joined(noise_, nullptr);
  learn(blocks_, threads, knows_bias_, bias_,
        [&](int block) { return block_bias(last_.filtered, last_.sampled, blocks_, block, gain_); });
  return joined(noise_, &bias_);
}

ErrorEstimate RefinedErrors::of_sampled(int threads) {
  learn(blocks_, threads, knows_sampled_, noise_of_sampled_,
        [&](int block) { return block_noise(last_.sampled, {}, blocks_, block, gain_); });
  return joined(noise_of_sampled_, nullptr);
}

HalfPictures RefinedErrors::pictures(bool with_sampled) const {
  HalfPictures out = last_;
  if (!with_sampled) out.sampled = out.filtered;
  return out;
}

ErrorEstimate RefinedErrors::joined(const std::vector<double>& noise, const std::vector<double>* bias) const {
  std::vector<SquaredError> errors(noise.size());
  for (std::size_t b = 0; b < errors.size(); ++b) errors[b] = {noise[b], bias != nullptr ? (*bias)[b] : 0};
  return error_of_blocks(std::move(errors), blocks_);
}

}  // namespace seamline::renderer
