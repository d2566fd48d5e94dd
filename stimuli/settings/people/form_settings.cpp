#include "stimuli/settings/people/form_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_name(const FormField& field) {
  const bool is_plain =
      field.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  return is_plain ? "" : "lower-case letters, digits and _";
}

}  // namespace seamline::inline stimuli
