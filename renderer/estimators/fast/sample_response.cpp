#include "renderer/estimators/fast/sample_response.h"

#include <algorithm>
#include <cmath>

namespace seamline::renderer {
namespace {

constexpr int times_as_many = 4;
constexpr int fewest = 8;             ///< samples from which a block's noise says anything
constexpr double surely_stays = 0.6;  ///< of the noise, or chance may have done it

}  // namespace

void SampleResponse::learn(const std::vector<int>& spp, const std::vector<double>& noise,
                           const std::vector<int>& least_spp) {
  spp_.resize(spp.size(), 0);
  noise_.resize(spp.size(), 0);
  stays_.resize(spp.size(), 0);
  for (std::size_t b = 0; b < spp.size(); ++b) {
    if (spp_[b] > 0 && (spp[b] < times_as_many * spp_[b] || spp[b] < least_spp[b])) continue;
    if (spp_[b] > 0) {
      const double falls_to = std::pow(static_cast<double>(spp_[b]) / spp[b], 1.1);
      const double rest = std::clamp((noise[b] - noise_[b] * falls_to) / (1 - falls_to), 0.0, noise[b]);
      stays_[b] = rest > surely_stays * noise[b] ? rest : 0;
    }
    if (spp[b] < fewest) continue;
    spp_[b] = spp[b];
    noise_[b] = noise[b];
  }
}

void SampleResponse::forget(std::size_t block) {
  if (block >= spp_.size()) return;
  spp_[block] = 0;
  stays_[block] = 0;
}

}  // namespace seamline::renderer
