// The questions that a study's model answers, as weights on its coefficients.
#include <fmt/format.h>

#include "analysis/ordinal/contrasts/study_design.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

using Weights = Eigen::VectorXd;

class Builder {
 public:
  Builder(const StudyDesign& design, bool robust) : design_(design), robust_(robust) {}

  [[nodiscard]] std::vector<ContrastFamily> families() const {
    std::vector<ContrastFamily> all = {width_family(), level_family(), slope_family(), object_family(),
                                       group_family()};
    std::erase_if(all, [](const ContrastFamily& family) { return family.contrasts.empty(); });
    return all;
  }

 private:
  [[nodiscard]] Weights column(int index) const {
    Weights weights = Weights::Zero(design_.data.predictors.cols());
    if (index >= 0) weights[index] = 1;
    return weights;
  }

  /// An object's departure from the mean of its artifact.
  [[nodiscard]] Weights object(const DesignArtifact& artifact, std::size_t index) const {
    Weights weights = column(-1);
    const auto others = static_cast<Eigen::Index>(artifact.objects.size()) - 1;
    if (static_cast<Eigen::Index>(index) == others)
      weights.segment(artifact.first_object_column, others).setConstant(-1);
    else
      weights[artifact.first_object_column + static_cast<Eigen::Index>(index)] = 1;
    return weights;
  }

  [[nodiscard]] double degrees(int estimated_means) const {
    return robust_ ? design_.participants - estimated_means : infinity;
  }

  [[nodiscard]] ContrastFamily width_family() const {
    ContrastFamily family{
        .question = "Does noticeability fall with width?", .contrasts = {}, .degrees_of_freedom = degrees(1)};
    for (const DesignArtifact& artifact : design_.artifacts) {
      if (artifact.slope_column < 0) continue;
      const std::string_view name = word(artifact.artifact);
      family.contrasts.push_back(
          {.name = fmt::format("{}, per octave of width", name),
           .weights = column(artifact.slope_column),
           .more = fmt::format("{} is noticed more with every doubling of the width", name),
           .less = fmt::format("{} is noticed less with every doubling of the width", name),
           .undecided = fmt::format("No effect of width on {} was shown", name)});
    }
    return family;
  }

  [[nodiscard]] ContrastFamily level_family() const {
    const std::string at = fmt::format("at {:.0f} px", design_.reference_width_px);
    ContrastFamily family{.question = fmt::format("Do artifacts differ {}?", at),
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1),
                          .differences = true};
    for_pairs(design_.artifacts.size(), [&](std::size_t i, std::size_t j) {
      const DesignArtifact &b = design_.artifacts[i], &a = design_.artifacts[j];
      family.contrasts.push_back(noticed_more(word(a.artifact), word(b.artifact), at,
                                              column(a.level_column) - column(b.level_column)));
    });
    return family;
  }

  [[nodiscard]] ContrastFamily slope_family() const {
    ContrastFamily family{.question = "Do artifacts differ in how noticeability falls with width?",
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1)};
    for_pairs(design_.artifacts.size(), [&](std::size_t i, std::size_t j) {
      const DesignArtifact &b = design_.artifacts[i], &a = design_.artifacts[j];
      if (a.slope_column < 0 || b.slope_column < 0) return;
      const std::string_view name = word(a.artifact), other = word(b.artifact);
      family.contrasts.push_back(
          {.name = fmt::format("{} - {}, per octave of width", name, other),
           .weights = column(a.slope_column) - column(b.slope_column),
           .more = fmt::format("{} falls less steeply with width than {}", name, other),
           .less = fmt::format("{} falls more steeply with width than {}", name, other),
           .undecided = fmt::format("No difference was shown between the slopes of {} and {}", name, other)});
    });
    return family;
  }

  [[nodiscard]] ContrastFamily object_family() const {
    ContrastFamily family{.question = "Do objects differ within an artifact, at equal width?",
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1),
                          .differences = true};
    for (const DesignArtifact& artifact : design_.artifacts)
      for_pairs(artifact.objects.size(), [&](std::size_t i, std::size_t j) {
        Contrast contrast = noticed_more(artifact.objects[j], artifact.objects[i],
                                         fmt::format("under {}, at equal width", word(artifact.artifact)),
                                         object(artifact, j) - object(artifact, i));
        contrast.name =
            fmt::format("{}: {} - {}", word(artifact.artifact), artifact.objects[j], artifact.objects[i]);
        family.contrasts.push_back(std::move(contrast));
      });
    return family;
  }

  [[nodiscard]] ContrastFamily group_family() const {
    ContrastFamily family{.question = "Do groups of participants differ?",
                          .contrasts = {},
                          .degrees_of_freedom = degrees(static_cast<int>(design_.groups.size())),
                          .differences = true};
    for_pairs(design_.groups.size(), [&](std::size_t i, std::size_t j) {
      const auto group = [&](std::size_t g) {
        return column(g == 0 ? -1 : design_.first_group_column + static_cast<int>(g) - 1);
      };
      const std::string &name = design_.groups[j], &other = design_.groups[i];
      family.contrasts.push_back(
          {.name = fmt::format("{} - {}", name, other),
           .weights = group(j) - group(i),
           .more = fmt::format("Group '{}' notices artifacts more than '{}'", name, other),
           .less = fmt::format("Group '{}' notices artifacts less than '{}'", name, other),
           .undecided = fmt::format("No difference was shown between groups '{}' and '{}'", name, other)});
    });
    return family;
  }

  static Contrast noticed_more(std::string_view name, std::string_view other, const std::string& where,
                               Weights weights) {
    return {.name = fmt::format("{} - {} {}", name, other, where),
            .weights = std::move(weights),
            .more = fmt::format("{} is noticed more than {} {}", name, other, where),
            .less = fmt::format("{} is noticed less than {} {}", name, other, where),
            .undecided = fmt::format("No difference was shown between {} and {} {}", name, other, where)};
  }

  template <class Use>
  static void for_pairs(std::size_t count, const Use& use) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) use(i, j);
  }

  const StudyDesign& design_;
  bool robust_;
};

}  // namespace

std::vector<ContrastFamily> study_contrasts(const StudyDesign& design, bool robust) {
  return Builder(design, robust).families();
}

}  // namespace seamline::analysis
