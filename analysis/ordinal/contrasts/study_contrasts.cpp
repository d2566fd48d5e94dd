#include "analysis/ordinal/contrasts/study_contrasts.h"

// The questions that a study's model answers, as weights on its coefficients.
#include <fmt/format.h>

#include "analysis/scores/level_words.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

using Weights = Eigen::VectorXd;

class Builder {
 public:
  Builder(const StudyDesign& design, bool robust)
      : design_(design), words_(level_words(design.axis)), robust_(robust) {}

  [[nodiscard]] std::vector<ContrastFamily> families() const {
    std::vector<ContrastFamily> all = {width_family(),     level_family(),           slope_family(),
                                       condition_family(), condition_slope_family(), object_family(),
                                       group_family()};
    std::erase_if(all, [](const ContrastFamily& family) { return family.contrasts.empty(); });
    return all;
  }

  [[nodiscard]] std::array<ContrastFamily, 2> of_conditions() const {
    return {condition_family(), condition_slope_family()};
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

  /// An artifact over its conditions: mean columns of level and slope.
  struct WholeArtifact {
    std::string_view name;
    Weights level, slope;
    bool has_slope = false;
  };

  [[nodiscard]] std::vector<WholeArtifact> whole_artifacts() const {
    std::vector<WholeArtifact> whole;
    for (std::size_t first = 0; first < design_.artifacts.size();) {
      std::size_t next = first;
      WholeArtifact one{.name = word(design_.artifacts[first].artifact),
                        .level = column(-1),
                        .slope = column(-1),
                        .has_slope = design_.artifacts[first].slope_column >= 0};
      for (; next < design_.artifacts.size() &&
             design_.artifacts[next].artifact == design_.artifacts[first].artifact;
           ++next) {
        one.level += column(design_.artifacts[next].level_column);
        one.slope += column(design_.artifacts[next].slope_column);
      }
      one.level /= static_cast<double>(next - first);
      one.slope /= static_cast<double>(next - first);
      whole.push_back(std::move(one));
      first = next;
    }
    return whole;
  }

  /// "with every doubling of the width", "with every degree more".
  [[nodiscard]] std::string each_step() const {
    if (!is_linear(design_.axis))
      return fmt::format("with every doubling of the {}", level_word(design_.axis));
    return fmt::format("with every {} more", step_text(design_.axis));
  }

  [[nodiscard]] ContrastFamily width_family() const {
    ContrastFamily family{
        .question = fmt::format("Does noticeability {} {}?", words_.fall, words_.with_level),
        .contrasts = {},
        .degrees_of_freedom = degrees(1)};
    for (const DesignArtifact& artifact : design_.artifacts) {
      if (artifact.slope_column < 0) continue;
      const std::string name = name_of(artifact);
      family.contrasts.push_back(
          {.name = fmt::format("{}, {}", name, slope_text(design_.axis)),
           .weights = column(artifact.slope_column),
           .more = fmt::format("{} is noticed more {}", name, each_step()),
           .less = fmt::format("{} is noticed less {}", name, each_step()),
           .undecided = fmt::format("No effect of {} on {} was shown", level_word(design_.axis), name)});
    }
    return family;
  }

  [[nodiscard]] ContrastFamily level_family() const {
    const std::string at = at_reference(design_);
    ContrastFamily family{.question = fmt::format("Do artifacts differ {}?", at),
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1),
                          .differences = true};
    const std::vector<WholeArtifact> whole = whole_artifacts();
    for_pairs(whole.size(), [&](std::size_t i, std::size_t j) {
      family.contrasts.push_back(
          noticed_more(whole[j].name, whole[i].name, at, whole[j].level - whole[i].level));
    });
    return family;
  }

  [[nodiscard]] ContrastFamily slope_family() const {
    ContrastFamily family{.question = fmt::format("Do artifacts differ in how noticeability {} {}?",
                                                  words_.falls, words_.with_level),
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1)};
    const std::vector<WholeArtifact> whole = whole_artifacts();
    for_pairs(whole.size(), [&](std::size_t i, std::size_t j) {
      if (!whole[i].has_slope || !whole[j].has_slope) return;
      family.contrasts.push_back(slope_contrast(std::string(whole[j].name), std::string(whole[i].name),
                                                whole[j].slope - whole[i].slope));
    });
    return family;
  }

  /// Every condition against the artifact's first.
  [[nodiscard]] ContrastFamily condition_family() const {
    const std::string at = at_reference(design_);
    ContrastFamily family{.question = fmt::format("Do conditions differ within an artifact, {}?", at),
                          .contrasts = {},
                          .degrees_of_freedom = degrees(1),
                          .differences = true};
    for_conditions([&](const DesignArtifact& a, const DesignArtifact& first) {
      family.contrasts.push_back(
          noticed_more(name_of(a), name_of(first), at, column(a.level_column) - column(first.level_column)));
    });
    return family;
  }

  [[nodiscard]] ContrastFamily condition_slope_family() const {
    ContrastFamily family{
        .question = fmt::format("Do conditions differ in how noticeability {} {}, within an artifact?",
                                words_.falls, words_.with_level),
        .contrasts = {},
        .degrees_of_freedom = degrees(1)};
    for_conditions([&](const DesignArtifact& a, const DesignArtifact& first) {
      if (a.slope_column < 0 || first.slope_column < 0) return;
      family.contrasts.push_back(
          slope_contrast(name_of(a), name_of(first), column(a.slope_column) - column(first.slope_column)));
    });
    return family;
  }

  [[nodiscard]] Contrast slope_contrast(const std::string& name, const std::string& other,
                                        Weights weights) const {
    const bool rises = design_.axis.noticeability == Direction::increasing;
    return {.name = fmt::format("{} - {}, {}", name, other, slope_text(design_.axis)),
            .weights = std::move(weights),
            .more = fmt::format("{} {} {} steeply {} than {}", name, words_.falls, rises ? "more" : "less",
                                words_.with_level, other),
            .less = fmt::format("{} {} {} steeply {} than {}", name, words_.falls, rises ? "less" : "more",
                                words_.with_level, other),
            .undecided = fmt::format("No difference was shown between the slopes of {} and {}", name, other)};
  }

  [[nodiscard]] ContrastFamily object_family() const {
    ContrastFamily family{
        .question = fmt::format("Do objects differ within an artifact, at equal {}?", words_.level),
        .contrasts = {},
        .degrees_of_freedom = degrees(1),
        .differences = true};
    for (std::size_t a = 0; a < design_.artifacts.size(); ++a) {
      const DesignArtifact& artifact = design_.artifacts[a];
      if (a > 0 && design_.artifacts[a - 1].artifact == artifact.artifact) continue;
      for_pairs(artifact.objects.size(), [&](std::size_t i, std::size_t j) {
        Contrast contrast = noticed_more(
            artifact.objects[j], artifact.objects[i],
            fmt::format("under {}, at equal {}", word(artifact.artifact), level_word(design_.axis)),
            object(artifact, j) - object(artifact, i));
        contrast.name =
            fmt::format("{}: {} - {}", word(artifact.artifact), artifact.objects[j], artifact.objects[i]);
        family.contrasts.push_back(std::move(contrast));
      });
    }
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
  void for_conditions(const Use& use) const {
    const DesignArtifact* first = nullptr;
    for (const DesignArtifact& artifact : design_.artifacts)
      if (first == nullptr || first->artifact != artifact.artifact)
        first = &artifact;
      else
        use(artifact, *first);
  }

  template <class Use>
  static void for_pairs(std::size_t count, const Use& use) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) use(i, j);
  }

  const StudyDesign& design_;
  LevelWords words_;
  bool robust_;
};

}  // namespace

std::vector<ContrastFamily> study_contrasts(const StudyDesign& design, bool robust) {
  return Builder(design, robust).families();
}

std::array<ContrastFamily, 2> condition_contrasts(const StudyDesign& design, bool robust) {
  return Builder(design, robust).of_conditions();
}

}  // namespace seamline::analysis
