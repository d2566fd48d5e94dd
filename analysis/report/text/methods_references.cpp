#include "analysis/report/text/methods_references.h"

#include <algorithm>

namespace seamline::analysis {
namespace {

/// Every work that a method names, by the words the text names it with.
struct Reference {
  const char* cited;
  const char* work;
};
constexpr Reference works[] = {
    {"Agresti, 2010", "Agresti, A. (2010). Analysis of Ordinal Categorical Data, 2nd ed. Wiley."},
    {"Barlow et al., 1972",
     "Barlow, R. E., Bartholomew, D. J., Bremner, J. M., & Brunk, H. D. (1972). Statistical Inference under "
     "Order Restrictions. Wiley."},
    {"Boos, 1992",
     "Boos, D. D. (1992). On generalized score tests. The American Statistician, 46(4), 327–333."},
    {"Cameron, Gelbach and Miller, 2011",
     "Cameron, A. C., Gelbach, J. B., & Miller, D. L. (2011). Robust inference with multiway clustering. "
     "Journal of Business & Economic Statistics, 29(2), 238–249."},
    {"Dempster, Laird and Rubin, 1977",
     "Dempster, A. P., Laird, N. M., & Rubin, D. B. (1977). Maximum likelihood from incomplete data via the "
     "EM algorithm. Journal of the Royal Statistical Society B, 39(1), 1–38."},
    {"Hesterberg, 2015",
     "Hesterberg, T. C. (2015). What teachers should know about the bootstrap. The American Statistician, "
     "69(4), 371–386."},
    {"Hothorn, Bretz and Westfall, 2008",
     "Hothorn, T., Bretz, F., & Westfall, P. (2008). Simultaneous inference in general parametric models. "
     "Biometrical Journal, 50(3), 346–363."},
    {"ITU-R BT.500",
     "ITU-R BT.500. Methodologies for the subjective assessment of the quality of television images."},
    {"Levitt, 1971",
     "Levitt, H. (1971). Transformed up-down methods in psychoacoustics. The Journal of the Acoustical "
     "Society of America, 49(2B), 467–477."},
    {"Watson, 2017",
     "Watson, A. B. (2017). QUEST+: A general multidimensional Bayesian adaptive psychometric method. "
     "Journal of Vision, 17(3), 10."},
    {"Wichmann and Hill, 2001",
     "Wichmann, F. A., & Hill, N. J. (2001). The psychometric function: I. Fitting, sampling, and goodness "
     "of fit. Perception & Psychophysics, 63(8), 1293–1313."}};

}  // namespace

std::vector<std::string> references_in(const std::vector<std::string>& paragraphs) {
  std::vector<std::string> references;
  for (const Reference& reference : works)
    if (std::any_of(paragraphs.begin(), paragraphs.end(), [&](const std::string& paragraph) {
          return paragraph.find(reference.cited) != std::string::npos;
        }))
      references.emplace_back(reference.work);
  references.emplace_back(
      "Visual Perception of Real World Depth Map Resolution for Mixed Reality Rendering.");
  return references;
}

}  // namespace seamline::analysis
