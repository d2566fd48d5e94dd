#pragma once
#include <vector>

#include "stimuli/definition/form_definition.h"
#include "study/trials/rendered_set.h"
#include "study/visit/session.h"

namespace seamline::study {

/// What is the same for every visit to a study.
struct VisitScript {
  std::vector<FormField> form = {};
  int instruction_pages = 0;
  std::vector<Trial> training = {};
  std::vector<int> training_right = {};  ///< the right choice of each, from 1
  SessionPace pace = {};
  RightRule training_rule = {};
};

/// The script of a set's study. Throws InputError when a training stimulus is not in the set.
[[nodiscard]] VisitScript make_visit_script(const RenderedSet& set);

}  // namespace seamline::study
