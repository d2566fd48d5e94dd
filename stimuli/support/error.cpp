#include "stimuli/support/error.h"

namespace seamline {

InputError input_error(const Complaint& complaint) {
  std::string sentence;
  for (const std::string& where : {complaint.file, complaint.field})
    if (!where.empty()) sentence += where + ": ";
  sentence += "wanted " + complaint.wanted;
  if (!complaint.found.empty()) sentence += ", found " + complaint.found;
  return InputError(sentence);
}

}  // namespace seamline
