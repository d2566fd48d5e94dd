#include "renderer/transport/omissions.h"

#include <algorithm>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

Omissions omissions_without(const std::vector<std::string>& names) {
  Omissions omissions;
  for (const std::string& name : names) {
    const auto found = std::find_if(omission_names.begin(), omission_names.end(),
                                    [&](const OmissionName& known) { return known.name == name; });
    if (found == omission_names.end()) {
      std::string known;
      for (const OmissionName& one : omission_names)
        known += (known.empty() ? "" : ", ") + std::string(one.name);
      throw input_error(
          {.field = request_name("no_omit"), .wanted = "one of " + known, .found = "\"" + name + "\""});
    }
    omissions.*(found->on) = false;
  }
  return omissions;
}

std::string turned_off(const Omissions& omissions) {
  std::string names;
  for (const OmissionName& one : omission_names)
    if (!(omissions.*one.on)) names += (names.empty() ? "" : " ") + std::string(one.name);
  return names;
}

}  // namespace seamline::renderer
