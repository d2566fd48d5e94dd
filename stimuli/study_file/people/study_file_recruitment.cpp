#include "stimuli/study_file/people/study_file_recruitment.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/settings/people/form_settings.h"
#include "stimuli/settings/people/recruitment_settings.h"
#include "stimuli/settings/read_settings.h"
#include "support/text/pattern.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::size_t most_code_bytes = 100, most_identifiers = 20;

void check_no_field_is_unknown(const TomlTable& table, const std::string& key, const std::string& name,
                               std::span<const FormField> form) {
  if (std::any_of(form.begin(), form.end(), [&](const FormField& field) { return field.name == name; }))
    return;
  throw table.complaint(key, "the name of a [[form_field]]", "\"" + name + "\"");
}

FormRule read_form_rule(const TomlTable& table, std::span<const FormField> form) {
  FormRule rule;
  read_setting(table, "field", rule);
  check_no_field_is_unknown(table, "field", rule.field, form);
  const FormField& field =
      *std::find_if(form.begin(), form.end(), [&](const FormField& one) { return one.name == rule.field; });
  if (!number_of(field)) {
    const std::vector<std::string>& options = *options_of(field);
    read_setting(table, "answers", rule);
    for (const std::string& answer : rule.answers)
      if (std::find(options.begin(), options.end(), answer) == options.end())
        throw table.complaint("answers", "options of the field \"" + rule.field + "\"", "\"" + answer + "\"");
    return rule;
  }
  read_setting(table, "least", rule);
  read_setting(table, "most", rule);
  if (!rule.least && !rule.most)
    throw table.complaint("least", "least, most or both, since the field is a number", "neither");
  if (rule.least && rule.most && *rule.least > *rule.most)
    throw table.complaint("most", fmt::format("at least {}", *rule.least), fmt::format("{}", *rule.most));
  return rule;
}

/// "2026-12-31 23:59", in universal time, as seconds since 1970.
std::int64_t read_closing(const TomlTable& table) {
  using namespace std::chrono;
  const std::string text = table.text("closes");
  static const Pattern minute(R"((\d{4})-(\d\d)-(\d\d) (\d\d):(\d\d))");
  if (const std::vector<std::string> part = minute.parts(text); !part.empty()) {
    const auto number = [&](std::size_t i) { return std::stoi(part[i]); };
    const year_month_day day(year(number(1)), month(static_cast<unsigned>(number(2))),
                             std::chrono::day(static_cast<unsigned>(number(3))));
    if (day.ok() && number(4) < 24 && number(5) < 60)
      return duration_cast<seconds>(sys_days(day).time_since_epoch()).count() + number(4) * 3600 +
             number(5) * 60;
  }
  throw table.complaint("closes", "a minute of universal time such as \"2026-12-31 23:59\"",
                        "\"" + text + "\"");
}

std::vector<std::string> read_identifiers(const TomlTable& table) {
  if (!table.has("identifiers")) return {};
  std::vector<std::string> names = table.texts("identifiers");
  static const Pattern name("[A-Za-z][A-Za-z0-9_]{0,39}");
  static const std::set<std::string> taken = {"token", "visit", "lang", "code", "random"};
  for (const std::string& one : names)
    if (!name.matches(one) || taken.contains(one) || std::count(names.begin(), names.end(), one) > 1)
      throw table.complaint("identifiers",
                            "names of the link that differ, of letters, figures and _, none of token, visit, "
                            "lang, code and random",
                            "\"" + one + "\"");
  if (names.size() > most_identifiers)
    throw table.complaint("identifiers", fmt::format("at most {}", most_identifiers),
                          fmt::format("{}", names.size()));
  return names;
}

/// An address that leads to one host, on which only what stands behind it may be filled in.
std::string read_return_link(const TomlTable& table, const std::vector<std::string>& identifiers) {
  const std::string link = table.text("return_link", "");
  if (link.empty()) return link;
  static const Pattern address(
      R"(https://[A-Za-z0-9.-]+(:\d+)?[/?][!-~]*|http://(localhost|127\.0\.0\.1)(:\d+)?[/?][!-~]*)");
  if (!address.matches(link))
    throw table.complaint("return_link",
                          "an address like \"https://app.prolific.com/submissions/complete?cc={code}\"",
                          "\"" + link + "\"");
  for (const std::string& place : places_in(link))
    if (place != "code" && std::find(identifiers.begin(), identifiers.end(), place) == identifiers.end())
      throw table.complaint("return_link", "{code} and names of identifiers as places",
                            "\"{" + place + "}\"");
  return link;
}

std::map<VisitOutcome, std::string> read_codes(const TomlTable& table, const RecruitmentDefinition& read) {
  std::map<VisitOutcome, std::string> codes;
  for (const VisitOutcome outcome : every_visit_outcome) {
    const std::string key(word(outcome));
    if (!table.has(key)) continue;
    codes[outcome] = table.text(key);
    for (const std::string& place : places_in(codes[outcome]))
      if (place != "random") throw table.complaint(key, "{random} as the only place", "\"{" + place + "}\"");
    if (codes[outcome].size() > most_code_bytes)
      throw table.complaint(key, fmt::format("at most {} bytes", most_code_bytes), "more");
  }
  table.finish();
  if (codes.contains(VisitOutcome::failed_attention) && read.least_attention == 0)
    throw table.complaint("failed_attention", "least_attention in [recruitment] beside it", "none");
  if (codes.contains(VisitOutcome::screened_out) && read.screen.empty())
    throw table.complaint("screened_out", "a [[recruitment.screen]] beside it", "none");
  return codes;
}

}  // namespace

std::vector<std::string> places_in(const std::string& text) {
  std::vector<std::string> places;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) break;
    places.push_back(text.substr(open + 1, close - open - 1));
  }
  return places;
}

std::map<std::string, std::string> read_page_texts(const TomlTable& texts, std::span<const PageText> known) {
  std::map<std::string, std::string> read;
  for (const PageText& entry : known) {
    const std::string key(entry.key);
    if (!texts.has(key)) continue;
    read[key] = texts.text(key);
    const std::vector<std::string> allowed = places_in(std::string(entry.english));
    for (const std::string& place : places_in(read[key]))
      if (std::find(allowed.begin(), allowed.end(), place) == allowed.end())
        throw texts.complaint(key, fmt::format("only places that \"{}\" has", entry.english),
                              "\"{" + place + "}\"");
  }
  return read;
}

std::shared_ptr<const RecruitmentDefinition> read_recruitment(const TomlTable& study,
                                                              std::span<const FormField> form,
                                                              int attention_trials) {
  const auto table = study.table("recruitment");
  if (!table) return nullptr;
  RecruitmentDefinition read;
  read.identifiers = read_identifiers(*table);
  read_settings(*table, read);
  read.return_link = read_return_link(*table, read.identifiers);
  for (const TomlTable& rule : table->tables("screen")) {
    read.screen.push_back(read_form_rule(rule, form));
    rule.finish();
  }
  for (const TomlTable& quota : table->tables("quota")) {
    QuotaDefinition& added = read.quotas.emplace_back();
    read_settings(quota, added);
    added.rule = read_form_rule(quota, form);
    quota.finish();
  }
  if (table->has("closes")) read.closes_unix_s = read_closing(*table);
  if (read.least_attention > attention_trials)
    throw table->complaint("least_attention",
                           fmt::format("at most the {} attention trials of [catch]", attention_trials),
                           fmt::format("{}", read.least_attention));
  if (const auto codes = table->table("codes")) read.codes = read_codes(*codes, read);
  if (!read.return_link.empty() && read.codes.empty())
    throw table->complaint("codes", "a code for at least one outcome, since there is a return_link", "none");
  if (const auto texts = study.table("texts")) read.texts = read_page_texts(*texts, every_recruitment_text());
  table->finish();
  return std::make_shared<const RecruitmentDefinition>(std::move(read));
}

}  // namespace seamline::inline stimuli
