#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "composites/photo_composite.h"
#include "stimuli/definition/artifact.h"

namespace seamline::renderer {

/// What is known of one artifact's seam: the widths W of a panorama from which nothing is noticed (PT), from
/// which it is noticed slightly (SN), and from which fewer than half of the people see it (detection).
struct SeamThresholds {
  Artifact artifact = Artifact::receiver;
  std::optional<double> perceptual_px = {}, slightly_px = {}, detection_px = {};
  bool rated = true;       ///< false: people said yes or no only, so that there is neither PT nor SN
  bool corrected = false;  ///< PT and SN for lucky guesses, since the others lie in the guess floor
};

/// Those of a report.
struct StudyThresholds {
  std::vector<SeamThresholds> artifacts;
  bool joint = false;      ///< those of the joint model; else the paper's way
  bool simulated = false;  ///< some or all of the people are simulated
  std::string source;      ///< whose answers: "12 simulated observers (threshold)"; empty: not said
};

/// The paper's Table 1.
[[nodiscard]] std::vector<SeamThresholds> paper_thresholds();

/// The numbers of record of a study, from the `thresholds.json` of `seamline analyze`: those that its
/// `headline` names. A threshold below every width that was tested is the smallest of them, or the upper end
/// of its interval where that is larger; one above is none. Of a study with conditions `condition` names one.
/// Throws InputError naming the file where it is none such, is not of depth widths, or the condition is not
/// there.
[[nodiscard]] StudyThresholds read_thresholds(const std::filesystem::path& path,
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
  std::optional<int> width_px;  ///< none: no width is known that suffices
  std::string rule;             ///< "PT", or what was taken in its place and what to give instead
};
struct SeamlessWidth {
  std::vector<WidthNeed> needs;  ///< of the artifacts present
  std::optional<int> width_px;   ///< the smallest that suffices for all, even; none: the full map
};
/// PT where there is one; else SN, which leaves a slightly noticeable seam; else none. Where people said yes
/// or no only, detection.
[[nodiscard]] SeamlessWidth seamless_width(const PresentArtifacts& present,
                                           const std::vector<SeamThresholds>& thresholds);

}  // namespace seamline::renderer
