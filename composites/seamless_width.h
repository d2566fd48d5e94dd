#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "composites/photo_composite.h"
#include "stimuli/definition/artifact.h"

namespace seamline::renderer {

/// What is known of one artifact's seam: the widths W of a panorama from which nothing is noticed (PT), and
/// from which it is noticed slightly (SN).
struct SeamThresholds {
  Artifact artifact = Artifact::receiver;
  std::optional<double> perceptual_px, slightly_px;
};

/// The paper's Table 1.
[[nodiscard]] std::vector<SeamThresholds> paper_thresholds();

/// Those of a study, from the `thresholds.json` of `seamline analyze`. A threshold below every width that was
/// tested is the smallest of them; one above is none. Of a study with conditions `condition` names one.
/// Throws InputError naming the file where it is none such, is not of depth widths, or the condition is not
/// there.
[[nodiscard]] std::vector<SeamThresholds> read_thresholds(const std::filesystem::path& path,
                                                          const std::string& condition);

/// Which artifacts a composite can have, from a ray or two a pixel.
struct PresentArtifacts {
  bool receiver = false;   ///< the objects change the light of real surfaces in the picture
  bool shadow = false;     ///< something real stands between a light and a visible part of an object
  bool occlusion = false;  ///< something real hides a part of an object
  bool overlap = false;    ///< an object's shadow meets one of something real
};
/// `masked_occlusion`, `matted_shadow`: a mask or matte answers in place of depth. Shadows are those of suns
/// and lamps; where there are none, real things may shade an object from the environment.
[[nodiscard]] PresentArtifacts present_artifacts(const PhotoScene& scene, bool masked_occlusion,
                                                 bool matted_shadow);

/// One artifact's part in the choice.
struct WidthNeed {
  Artifact artifact = Artifact::receiver;
  std::optional<int> width_px;  ///< none: no width that was tested suffices
  std::string rule;             ///< "PT", or what was taken in its place and what to give instead
};
struct SeamlessWidth {
  std::vector<WidthNeed> needs;  ///< of the artifacts present
  std::optional<int> width_px;   ///< the smallest that suffices for all, even; none: the full map
};
/// PT where there is one; else SN, which leaves a slightly noticeable seam; else none.
[[nodiscard]] SeamlessWidth seamless_width(const PresentArtifacts& present,
                                           const std::vector<SeamThresholds>& thresholds);

}  // namespace seamline::renderer
