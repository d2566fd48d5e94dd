#pragma once
#include <string>
#include <string_view>

namespace seamline {

// A library refuses a part of what it was asked for, and may name another part that would help. It knows the
// request's members and not the command line, so a message calls a part by its member's name. The program
// spells the same name as the option that sets it.

/// How a member of a request is spelled in messages.
using SpellRequest = std::string (*)(std::string_view member);

/// What a message calls a member of a request: "allow_scaling", or in the program "--allow-scaling".
[[nodiscard]] std::string request_name(std::string_view member);

/// While it lives, messages of all threads spell requests' members by `spell`. One lives at a time, or the
/// inner ends first.
class RequestSpelling {
 public:
  explicit RequestSpelling(SpellRequest spell);
  ~RequestSpelling();
  RequestSpelling(const RequestSpelling&) = delete;
  RequestSpelling& operator=(const RequestSpelling&) = delete;

 private:
  SpellRequest before_;
};

}  // namespace seamline
