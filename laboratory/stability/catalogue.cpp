#include "laboratory/stability/catalogue.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "laboratory/stability/common/groups.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::stability {
namespace {

StabilityCases put_together() {
  StabilityCases all;
  for (const auto& part : {ratio_cases, radiosity_cases, sun_cases, strong_light_cases, told_error_cases,
                           pocket_cases, contact_cases, space_scale_cases, triangle_cases, depth_value_cases,
                           depth_shape_cases, depth_size_cases, bound_cases, curve_fit_cases, interval_cases,
                           rating_cases, quest_plus_cases, convergence_cases}) {
    StabilityCases cases = part();
    all.insert(all.end(), std::make_move_iterator(cases.begin()), std::make_move_iterator(cases.end()));
  }
  // A file may hold cases of two groups; they are shown group by group.
  static constexpr std::array<std::string_view, 7> groups = {
      "light", "space", "depth", "bounds", "statistics", "quest_plus", "convergence"};
  std::stable_sort(all.begin(), all.end(), [&](const StabilityCase& a, const StabilityCase& b) {
    return std::find(groups.begin(), groups.end(), a.group) <
           std::find(groups.begin(), groups.end(), b.group);
  });
  return all;
}

}  // namespace

const StabilityCases& stability_catalogue() {
  static const StabilityCases catalogue = put_together();
  return catalogue;
}

StabilityCases chosen_cases(const std::string& only) {
  StabilityCases chosen;
  for (const StabilityCase& one : stability_catalogue())
    if (only.empty() || one.name == only || one.group == only) chosen.push_back(one);
  if (chosen.empty())
    throw input_error({.field = request_name("only"),
                       .wanted = "the name or the group of a case (see " + request_name("list") + ")",
                       .found = "\"" + only + "\""});
  return chosen;
}

}  // namespace seamline::stability
