#include "stability/catalogue.h"

#include <iterator>

#include "stability/groups.h"
#include "stimuli/support/error.h"

namespace seamline {
namespace {

StabilityCases put_together() {
  StabilityCases all;
  for (const auto& part : {ratio_cases, radiosity_cases, sun_cases, pocket_cases, contact_cases,
                           space_scale_cases, triangle_cases}) {
    StabilityCases cases = part();
    all.insert(all.end(), std::make_move_iterator(cases.begin()), std::make_move_iterator(cases.end()));
  }
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
    throw input_error({.field = "--only",
                       .wanted = "the name or the group of a case (see --list)",
                       .found = "\"" + only + "\""});
  return chosen;
}

}  // namespace seamline
