#include "support/text/request_name.h"

#include <atomic>

namespace seamline {
namespace {

std::string as_written(std::string_view member) {
  return std::string(member);
}

std::atomic<SpellRequest> spelling = &as_written;

}  // namespace

std::string request_name(std::string_view member) {
  return spelling.load()(member);
}

RequestSpelling::RequestSpelling(SpellRequest spell) : before_(spelling.exchange(spell)) {}
RequestSpelling::~RequestSpelling() {
  spelling.store(before_);
}

}  // namespace seamline
