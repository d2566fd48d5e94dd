#include "study/online/page/web_export.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "stimuli/study_file/parts/study_file_task.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "study/online/page/web_study.h"
#include "study/trials/study_languages.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/hash.h"
#include "support/files/temporary_folder.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/html.h"
#include "support/text/limits.h"
#include "support/text/request_name.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

constexpr int usual_slots = 200;
/// To try all that are smaller, at a microsecond for an order, takes one processor fifty days or less.
constexpr std::uint64_t least_secret_seed = std::uint64_t{1} << 42;

std::string study_file_name(const RenderedSet& set) {
  return (set.folder / set.manifest.study_file).string();
}

void check_request(const RenderedSet& set, const WebRequest& request) {
  if (!request.pilot && is_default_consent(set.study.consent))
    throw input_error({.file = study_file_name(set),
                       .field = "consent.text",
                       .wanted = "your own consent text (for a trial run with the shipped one use " +
                                 request_name("pilot") + ")",
                       .found = "the shipped template"});
  for (const SceneDefinition& scene : list_truths(set.study))
    if (!scene.view.is_mono() && scene.view.kind != ViewKind::anaglyph &&
        scene.view.kind != ViewKind::omnidirectional)
      throw input_error(
          {.file = study_file_name(set),
           .field = "view.kind",
           .wanted =
               "\"mono\", \"anaglyph\" or \"omnidirectional\": a page in a browser does not know where on which "
               "screen its pixels are (the window does: seamline study SET --participant)",
           .found = "\"" + std::string(word(scene.view.kind)) + "\""});
  const bool adaptive = is_placed_by_answers(set.study);
  if (adaptive && request.host != Origin::serve)
    throw input_error(
        {.file = study_file_name(set),
         .field = "procedure",
         .wanted = "constant stimuli, because a static host or JATOS cannot place trials (with " +
                   request_name("serve") + " `seamline serve` will)",
         .found = set.study.task && set.study.task->staircase ? "\"staircase\"" : "\"quest_plus\""});
  if (set.study.recruitment && request.host != Origin::serve)
    throw input_error({.file = study_file_name(set),
                       .field = "recruitment",
                       .wanted = "a page with " + request_name("serve") +
                                 ", because a page on a host of files or JATOS would tell "
                                 "everybody the codes (in JATOS set the study's end redirect URL instead)",
                       .found = request.host == Origin::jatos ? request_name("jatos") : "a host of files"});
  const int orders = set.study.session.orders;
  if (orders > 0 && request.slots && *request.slots > orders)
    throw input_error({.field = request_name("slots"),
                       .wanted = fmt::format("at most {}, the orders of the study (session.orders)", orders),
                       .found = fmt::format("{}", *request.slots)});
}

void check_place(const fs::path& folder) {
  std::error_code error;
  const bool is_free = !fs::exists(fs::symlink_status(folder, error)) ||
                       (fs::is_directory(folder, error) && fs::is_empty(folder, error));
  if (!is_free)
    throw input_error({.file = folder.string(),
                       .wanted = "a folder that is empty or not there yet",
                       .found = "something of that name"});
}

int slots_of(const RenderedSet& set, const WebRequest& request) {
  if (request.slots) return *request.slots;
  return set.study.session.orders > 0 ? set.study.session.orders : usual_slots;
}

/// Without the line that sends debuggers to a map elsewhere: nothing of the page leaves the host.
std::string without_source_map(std::string script) {
  const std::size_t at = script.rfind("\n//# sourceMappingURL=");
  return at == std::string::npos ? script : script.substr(0, at + 1);
}

/// A page of HTML with a value for each `@place@` of it; values are put in as they are, and not looked into.
std::string filled(std::string_view page, const std::map<std::string, std::string>& values) {
  std::string whole;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t end = page[at] == '@' ? page.find('@', at + 1) : std::string_view::npos;
    const auto value = end == std::string_view::npos
                           ? values.end()
                           : values.find(std::string(page.substr(at + 1, end - at - 1)));
    whole += value == values.end() ? std::string(1, page[at]) : value->second;
    at = value == values.end() ? at + 1 : end + 1;
  }
  return whole;
}

/// A script within a page, as the page's policy names it (Content Security Policy, hash-source).
std::string hash_source(const std::string& script) {
  std::string digest;
  const std::string hex = sha256(script);
  for (std::size_t at = 0; at < hex.size(); at += 2)
    digest += static_cast<char>(std::stoi(hex.substr(at, 2), nullptr, 16));
  return "'sha256-" + base64(digest) + "'";
}

/// `index.html`: it speaks the study's language before anything else has arrived, and has the script within
/// itself that asks again for everything else.
std::string first_page(std::string_view page, const std::string& start, const StudyDefinition& study) {
  return filled(page, {{"language", html_escape(study.session.language)},
                       {"script", hash_source(start)},
                       {"wait", html_escape(phrase_text(study.texts, Phrase::online_wait))},
                       {"start", start}});
}

/// `endPage.html`, which JATOS shows at the end of a run where the study's settings lead nowhere else.
std::string end_page(std::string_view page, const StudyDefinition& study) {
  return filled(page, {{"language", html_escape(study.session.language)},
                       {"title", html_escape(phrase_text(study.texts, Phrase::thanks_title))},
                       {"text", html_escape(phrase_text(study.texts, Phrase::thanks_text))}});
}

/// The page itself: what is the same for every study, but for a few words.
void add_page(WebFiles& files, const StudyDefinition& study, Origin host) {
  const fs::path folder = web_page_folder();
  std::error_code error;
  if (!fs::is_regular_file(folder / "jspsych.js", error) ||
      !fs::is_regular_file(folder / "index.html", error))
    throw input_error(
        {.field = "seamline export web",
         .wanted = "a seamline that was built with its page (SEAMLINE_WEB, which needs jsPsych)",
         .found = "one without"});
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder).generic_string());
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    const std::string bytes = read_file(folder / name);
    if (name == "index.html")
      files.add(name, first_page(bytes, read_file(folder / "start.js"), study));
    else if (name == "endPage.html") {
      if (host == Origin::jatos) files.add(name, end_page(bytes, study));
    } else if (name != "start.js" &&
               name != "watch.html")  // the experimenter's, which `seamline serve` reads
      files.add(name, without_source_map(bytes));
  }
}

fs::path beside_study(const RenderedSet& set, const std::string& name, const char* field) {
  return path_below(set.folder, name, {.file = study_file_name(set), .field = field});
}

std::string add_font(const RenderedSet& set, const std::string& name, WebFiles& files) {
  if (name.empty()) return {};
  return files.add_by_content("fonts", read_file(beside_study(set, name, "session.font")),
                              lower_case_ending(name));
}

std::vector<std::vector<std::string>> add_instruction_pictures(const RenderedSet& set, WebFiles& files) {
  std::vector<std::vector<std::string>> pages;
  for (const InstructionPage& page : set.study.instructions) {
    std::vector<std::string>& names = pages.emplace_back();
    for (const std::string& name : page.pictures) {
      const std::string bytes =
          read_file(beside_study(set, name, "instructions"), limits::largest_picture_file_bytes);
      names.push_back(files.add_by_content("instructions", bytes, lower_case_ending(name)));
    }
  }
  return pages;
}

}  // namespace

WebSummary export_web(const WebRequest& request) {
  const RenderedSet set = load_rendered_set(request.set_folder);
  check_request(set, request);
  const fs::path target = fs::absolute(request.out_folder).lexically_normal();
  const fs::path out = target.has_filename() ? target : target.parent_path();  // "dir/" is dir
  check_place(out);
  fs::create_directories(out.parent_path());
  const TemporaryFolder work(out);
  const fs::path folder = work / "web";
  fs::create_directory(folder);

  WebFiles files(folder);
  add_page(files, set.study, request.host);
  const TrialRules rules = make_trial_rules(set);
  const ShownNames names(set);
  const WebPictures pictures = add_pictures(set, names, files);
  const WebParts parts{names, pictures, rules, places_of_tasks(set), make_visit_script(set).pace.briefed};
  const int slots = slots_of(set, request);
  for (int slot = 0; !rules.is_adaptive() && slot < slots; ++slot) {
    stop_if_interrupted();
    files.add(order_file(slot), order_text(parts, decided_trials(rules, slot, {})));
  }
  const std::string font = add_font(set, set.study.session.font, files);
  const std::vector<std::vector<std::string>> instructions = add_instruction_pictures(set, files);
  const WebStudy web{.set = set,
                     .rules = rules,
                     .names = names,
                     .pictures = pictures,
                     .files = files.files(),
                     .slots = slots,
                     .host = request.host,
                     .pilot = request.pilot,
                     .font = font,
                     .instruction_files = instructions};
  WebSummary summary{.slots = slots,
                     .adaptive = rules.is_adaptive(),
                     .guessable_orders = !rules.is_adaptive() && set.study.seed < least_secret_seed,
                     .pictures = static_cast<int>(pictures.map.size())};
  for (const StudyTexts& texts : whole_languages(set.study)) {
    const StudyDefinition read = in_language(set.study, texts);
    files.add(language_file(texts.tag),
              web_language_text(web, read, add_font(set, read.session.font, files)));
    if (texts.is_draft) summary.drafts.push_back(texts.tag);
  }
  files.add("study.json", web_study_text(web));
  write_file_atomically(folder / "files.json", files.index_text());
  files.give_one_time();
  publish_folder(folder, out);

  summary.files = static_cast<int>(files.files().size()) + 1;
  for (const auto& [name, file] : files.files()) summary.bytes += file.bytes;
  return summary;
}

}  // namespace seamline::study::online
