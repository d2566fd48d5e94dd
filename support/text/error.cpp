#include "support/text/error.h"

#include "support/text/printable.h"

namespace seamline {
namespace {

constexpr std::size_t longest_place = 400;  ///< letters of a path or field
constexpr std::size_t longest_part = 600;   ///< of what was wanted or found

}  // namespace

InputError input_error(const Complaint& complaint) {
  std::string sentence;
  const auto add = [&](const char* between, const std::string& part) {
    if (!sentence.empty()) sentence += between;
    sentence += part;
  };
  for (const std::string& where : {complaint.file, complaint.field})
    if (!where.empty()) add(": ", printable(where, longest_place));
  if (!complaint.wanted.empty()) add(": ", "wanted " + printable(complaint.wanted, longest_part));
  if (!complaint.found.empty()) add(", ", "found " + printable(complaint.found, longest_part));
  return InputError(sentence);
}

}  // namespace seamline
