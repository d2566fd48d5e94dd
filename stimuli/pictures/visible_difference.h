#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "stimuli/set/manifest.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// Exponent of Quick's (1974) pooling of what is seen at many places: between the sum (1) and the strongest
/// place alone (infinite). 3 is in the middle of what detection experiments find, 2 to 4.
inline constexpr double pooling_exponent = 3;

/// The FLIP of one pair of pictures as one number: (sum of FLIP^p / pixels_per_degree^2)^(1/p), the sum over
/// all pixels, so over the artifact, because elsewhere FLIP is 0. The unit of area is the square degree: a
/// square degree of FLIP 1 has 1, and a larger picture around the artifact changes nothing.
[[nodiscard]] double pooled_difference(const Image& flip, double pixels_per_degree);

/// What remains of a pooled difference when a floor was pooled with it: (F^p - F0^p)^(1/p), at least 0.
[[nodiscard]] double above_floor(double pooled, double floor);

struct VisibleDifference {
  double pooled = 0;       ///< pooled FLIP between stimulus and reference
  double above_floor = 0;  ///< without the floor: what an `image` observer sees
};

/// Stimuli by id.
using VisibleDifferences = std::map<std::string, VisibleDifference>;

/// Pooled FLIP of `none` stimuli, by truth and object: rendering noise, which is not a seam.
using DifferenceFloors = std::map<std::string, double>;

/// The visible difference of every stimulus of a set from its reference; of clips, pooled over their frames
/// too, (mean of F^p over frames)^(1/p), which nobody has tested on people. `floors` are used as well as the
/// `none` stimuli of the set itself, which come first; where there are neither the floor is 0. The same for
/// any number of threads (0: as many as the machine has). Throws InputError when a picture is missing or has
/// another size than its reference.
[[nodiscard]] VisibleDifferences visible_differences(const std::filesystem::path& set_folder,
                                                     const Manifest& manifest, double pixels_per_degree,
                                                     const DifferenceFloors& floors = {}, int threads = 0);

/// The floors that a set's `none` stimuli tell: the mean over those of one truth and object.
[[nodiscard]] DifferenceFloors difference_floors(const Manifest& manifest,
                                                 const VisibleDifferences& differences);

/// What a floor is known by, the truth and the object: "bedroom/statue".
[[nodiscard]] std::string floor_key(const Stimulus& stimulus);

}  // namespace seamline::inline stimuli
