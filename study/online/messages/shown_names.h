#pragma once
#include <string>
#include <string_view>

#include "study/placement/trial.h"
#include "study/trials/rendered_set.h"

namespace seamline::study::online {

/// Which names of a stimulus are understood.
enum class KnownNames {
  shown,           ///< what today's pages say: the only one where a participant hears the reply (a server)
  also_of_the_set  ///< also the set's own id, which downloads of older pages hold: for the experimenter alone
};

/// What a page calls its stimuli. An id of the set names the inserted object
/// ("bedroom-receiver-statue-0512"), so whoever reads a page's source would read the right answer. A shown
/// name is `t-` and 24 digits of a hash keyed with the bytes of the set's manifest: the same for the same
/// set, and without the manifest, which no page holds, nobody can go back from it. Kinds of trials have names
/// of their own, because the picture of an attention trial shows which object its stimulus is about.
class ShownNames {
 public:
  /// Throws InputError when the set's manifest cannot be read.
  explicit ShownNames(const RenderedSet& set);

  [[nodiscard]] std::string name_of(const Trial& trial) const;

  /// Whether a page that says `name` means `trial`. The set's own id names a trial only under
  /// `KnownNames::also_of_the_set`: whoever may ask again and again would read the right answers off it.
  [[nodiscard]] bool is_name_of(const Trial& trial, std::string_view name, KnownNames known) const;

 private:
  [[nodiscard]] const std::string& id_of(const Trial& trial) const;

  const Manifest& manifest_;
  std::string key_;
};

}  // namespace seamline::study::online
