#include "study/online/messages/shown_names.h"

#include <fmt/core.h>

#include "support/files/atomic_file.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace {

constexpr std::size_t digits = 24;  // 96 bits: no two of a million alike

}  // namespace

// The set's own hash, which every page carries, is of the manifest alone; the key says nothing of it, nor it
// of the key.
ShownNames::ShownNames(const RenderedSet& set)
    : manifest_(set.manifest),
      key_(sha256("seamline shown names 1\n" + read_file(set.folder / "manifest.json"))) {}

const std::string& ShownNames::id_of(const Trial& trial) const {
  return manifest_.stimuli.at(trial.stimulus).id;
}

std::string ShownNames::name_of(const Trial& trial) const {
  return "t-" + sha256(fmt::format("{}\n{}\n{}", key_, word(trial.kind), id_of(trial))).substr(0, digits);
}

bool ShownNames::is_name_of(const Trial& trial, std::string_view name, KnownNames known) const {
  return name == name_of(trial) || (known == KnownNames::also_of_the_set && name == id_of(trial));
}

}  // namespace seamline::study::online
