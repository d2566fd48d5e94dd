#include "stimuli/settings/people/session_settings.h"

#include "support/text/pattern.h"

namespace seamline::inline stimuli {

std::string fault_of_language(const SessionDefinition& session) {
  static const Pattern tag("[A-Za-z]{1,8}(-[A-Za-z0-9]{1,8}){0,7}");
  return tag.matches(session.language) ? "" : "a tag such as \"en\" or \"pt-BR\"";
}

}  // namespace seamline::inline stimuli
