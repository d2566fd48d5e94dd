#pragma once
#include <span>
#include <string>

#include "study/log/origin.h"
#include "study/online/messages/shown_names.h"
#include "study/online/page/web_pictures.h"
#include "study/trials/participant_trials.h"
#include "study/trials/rendered_set.h"
#include "study/visit/session.h"

namespace seamline::study::online {

/// What of a page is not in the set.
struct WebStudy {
  const RenderedSet& set;
  const TrialRules& rules;
  const ShownNames& names;
  const WebPictures& pictures;
  const std::map<std::string, WebFile>& files;  ///< of the pictures, at least
  int slots = 0;
  Origin host = Origin::static_host;
  bool pilot = false;
  std::string font = {};                                         ///< its file; empty: none
  std::vector<std::vector<std::string>> instruction_files = {};  ///< by page
};

/// `languages/TAG.json`: what of `study.json` is other in that language. `read`: the study in it
/// (`in_language`); `font`: its file.
[[nodiscard]] std::string web_language_text(const WebStudy& web, const StudyDefinition& read,
                                            const std::string& font);

/// `languages/de.json`.
[[nodiscard]] std::string language_file(const std::string& tag);

/// `study.json`: everything that the page shows and asks, without right answers but those of the practice.
/// Stimuli and catch trials stand in the order of their shown names, because the set's own order tells
/// objects.
[[nodiscard]] std::string web_study_text(const WebStudy& web);

/// What the trials of a page are told by.
struct WebParts {
  const ShownNames& names;
  const WebPictures& pictures;
  const TrialRules& rules;
  std::vector<int> own_task = {};  ///< of each stimulus its place among the study's tasks; else none
  BriefedBlocks briefed = {};
};

/// Of each stimulus of a set whose conditions have tasks of their own the place of its task among
/// `task_groups`; else none.
[[nodiscard]] std::vector<int> places_of_tasks(const RenderedSet& set);

/// `orders/SLOT.json`: the trials of a slot, as the window has them.
[[nodiscard]] std::string order_text(const WebParts& parts, std::span<const Trial> trials);

/// `orders/0000.json` of slot 0.
[[nodiscard]] std::string order_file(int slot);

}  // namespace seamline::study::online
