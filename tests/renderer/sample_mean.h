#pragma once
#include <algorithm>
#include <cmath>

namespace seamline::test {

struct SampleMean {
  double mean = 0, standard_error = 0;
};

/// Of `sample(0)` to `sample(count - 1)`.
template <class Sample>
SampleMean sample_mean(int count, const Sample& sample) {
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double value = sample(i);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1))};
}

}  // namespace seamline::test
