#include "stimuli/settings/people/session_settings.h"

#include <regex>

namespace seamline::inline stimuli {

std::string fault_of_language(const SessionDefinition& session) {
  static const std::regex tag("[A-Za-z]{1,8}(-[A-Za-z0-9]{1,8}){0,7}");
  return std::regex_match(session.language, tag) ? "" : "a tag such as \"en\" or \"pt-BR\"";
}

}  // namespace seamline::inline stimuli
