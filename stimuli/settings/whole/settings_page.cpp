#include "stimuli/settings/whole/settings_page.h"

#include <set>
#include <sstream>
#include <utility>

#include "stimuli/settings/clip_settings.h"
#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/look_settings.h"
#include "stimuli/settings/mitigation_settings.h"
#include "stimuli/settings/people/analysis_settings.h"
#include "stimuli/settings/people/form_settings.h"
#include "stimuli/settings/people/language_settings.h"
#include "stimuli/settings/people/procedure_settings.h"
#include "stimuli/settings/people/recruitment_settings.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/settings/people/task_settings.h"
#include "stimuli/settings/pipeline_settings.h"
#include "stimuli/settings/scene_settings.h"
#include "stimuli/settings/study_settings.h"
#include "stimuli/settings/view_settings.h"
#include "support/running/overloaded.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

/// "1e-9", "0.001", "20000" and "1e15": as people write them.
std::string number_cell(double number) {
  std::string text = fmt::format("{}", number);
  const std::string powers = fmt::format("{:g}", number);
  if (text.size() > 6 && powers.size() < text.size() && std::stod(powers) == number) text = powers;
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const bool is_small = text[exponent + 1] == '-';
  const std::size_t digits = text.find_first_not_of("+-0", exponent + 1);
  return text.substr(0, exponent) + (is_small ? "e-" : "e") + text.substr(digits);
}

template <class Three>
std::string three_cell(const Three& three) {
  return fmt::format("[{}, {}, {}]", three[0] + 0.0, three[1] + 0.0, three[2] + 0.0);  // no sign of zeros
}

template <class Two>
std::string two_cell(const Two& two) {
  return fmt::format("[{}, {}]", two[0], two[1]);
}

std::string plain_type_cell(const SettingValue& value) {
  return std::visit(
      Overloaded{[](std::monostate) { return std::string(); },
                 [](const double*) { return std::string("number"); },
                 [](const std::optional<double>*) { return std::string("number"); },
                 [](const int*) { return std::string("whole"); },
                 [](const std::uint64_t*) { return std::string("whole"); },
                 [](const bool*) { return std::string("boolean"); },
                 [](const std::string*) { return std::string("text"); },
                 [](const std::vector<double>*) { return std::string("numbers"); },
                 [](const std::vector<std::string>*) { return std::string("texts"); },
                 [](const std::array<int, 2>*) { return std::string("two whole"); },
                 [](const std::array<double, 2>*) { return std::string("two numbers"); },
                 [](const std::optional<std::array<double, 2>>*) { return std::string("two numbers"); },
                 [](const auto*) { return std::string("three numbers"); }},
      value);
}

/// A row of any struct, and its default as text.
struct PlainRow {
  std::string_view key, form, meaning;
  NumberRange range;
  std::span<const std::string_view> words;  ///< of a choice
  const Beside& beside;
  std::optional<Quantity> level;
  std::string type, usual;
};

std::string range_cell(const PlainRow& row) {
  std::string text(row.form);
  for (const std::string_view word : row.words)
    if (!word.empty()) text += fmt::format("{}`\"{}\"`", text.empty() ? "" : ", ", word);
  if (row.range.least == row.range.most || row.form == "not zero") return text;
  text += fmt::format("{}{} to {}", text.empty() ? "" : ", ", number_cell(row.range.least),
                      number_cell(row.range.most));
  return row.range.unit.empty() ? text : fmt::format("{} {}", text, row.range.unit);
}

std::string meaning_cell(const PlainRow& row) {
  std::string text(row.meaning);
  if (!row.beside.key.empty()) text += " Beside `" + beside_text(row.beside) + "`.";
  if (row.level && row.words.empty())
    text += row.key == facts(*row.level).key ? " Can be the level."
                                             : fmt::format(" Can be the level, `{}`.", facts(*row.level).key);
  return text;
}

std::string plain_usual_cell(const SettingValue& usual, const Wording& wording) {
  return std::visit(Overloaded{[](const double* number) { return number_cell(*number); },
                               [](const bool* is_so) { return std::string(*is_so ? "true" : "false"); },
                               [](const std::string* text) { return fmt::format("\"{}\"", *text); },
                               [](const std::optional<double>*) { return std::string("none"); },
                               [](const Eigen::Vector3d* three) { return three_cell(*three); },
                               [](const std::array<double, 3>* three) { return three_cell(*three); },
                               [](const std::array<int, 2>* two) { return two_cell(*two); },
                               [](const std::array<double, 2>* two) { return two_cell(*two); },
                               [&](const auto& /*one*/) { return value_text(usual, wording); }},
                    usual);
}

template <class Owner>
PlainRow plain(const Setting<Owner>& row) {
  const Owner usual{};
  const SettingValue value = value_of(row, usual);
  PlainRow made{.key = row.key,
                .form = row.form,
                .meaning = row.meaning,
                .range = row.range,
                .words = {},
                .beside = row.beside,
                .level = row.level,
                .type = plain_type_cell(value),
                .usual = std::string(row.usual)};
  const auto* choice = std::get_if<Choice<Owner>>(&row.slot);
  if (choice != nullptr) {
    made.type = "text";
    made.words = choice->words;
  }
  if (std::holds_alternative<Part<Owner>>(row.slot)) made.type = "table";
  if (const auto* described = std::get_if<Described>(&row.slot)) made.type = described->type;
  if (made.usual.empty() && !row.required.empty()) made.usual = "required";
  if (made.usual.empty())
    made.usual = choice != nullptr ? fmt::format("`\"{}\"`", choice->words[choice->place(usual)])
                                   : plain_usual_cell(value, row.wording);
  return made;
}

/// The rows of these structs, each key once; `of` is what the second column says in place of the type.
class Table {
 public:
  explicit Table(std::string second = "type") : second_(std::move(second)) {}

  template <class Owner>
  void add(const std::string& of = {}) {
    for (const Setting<Owner>& row : settings_of<Owner>)
      if (!row.key.empty()) add(of, plain(row));
  }

  [[nodiscard]] std::string text() const {
    return fmt::format("| key | {} | range | default | meaning |\n| --- | --- | --- | --- | --- |\n",
                       second_) +
           lines_;
  }

 private:
  void add(const std::string& of, const PlainRow& row) {
    if (!keys_.emplace(of, row.key).second) return;
    const bool has_type = of.empty();
    std::string range = range_cell(row);
    if (!has_type && range.empty()) range = row.type;
    lines_ += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.key, has_type ? row.type : of, range,
                          row.usual, meaning_cell(row));
  }

  std::string second_, lines_;
  std::set<std::pair<std::string, std::string_view>> keys_;
};

template <class... Owners>
std::string table_of() {
  Table table;
  (table.add<Owners>(), ...);
  return table.text();
}

std::string noise_table() {
  Table table("model");
  table.add<SourceNoise>("all");
  table.add<sensors::Outliers>("all");
  table.add<sensors::GenericNoise>("generic");
  table.add<sensors::TimeOfFlightNoise>("time of flight");
  table.add<sensors::StructuredLightNoise>("structured light");
  return table.text();
}

std::string repair_table() {
  Table table("method");
  table.add<sensors::MedianRepair>("median");
  table.add<sensors::JointBilateralRepair>("joint bilateral");
  table.add<sensors::PlaneRepair>("planes");
  return table.text();
}

std::string path_table() {
  Table table("kind");
  table.add<LineMotion>("line");
  table.add<TurnMotion>("turn");
  table.add<KeyedMotion>("keys");
  return table.text();
}

/// The rows of every alternative of a variant.
template <class... Kinds>
void add_kinds(Table& table, std::string_view of, const std::variant<Kinds...>& /*any*/) {
  std::size_t place = 0;
  (table.add<Kinds>(fmt::format("{}, {}", of, words_of<std::variant<Kinds...>>.at(place++))), ...);
}

/// What participants are told and asked.
std::string people_table() {
  Table table("in");
  table.add<ConsentDefinition>("`consent`");
  table.add<FormField>("`form_field`");
  add_kinds(table, "`form_field`", FormField().kind);
  table.add<InstructionPage>("`instructions.page`");
  table.add<TrainingDefinition>("`training`");
  return table.text();
}

std::string recruitment_table() {
  Table table("in");
  table.add<RecruitmentDefinition>("`recruitment`");
  table.add<FormRule>("`screen`, `quota`");
  table.add<QuotaDefinition>("`quota`");
  return table.text();
}

std::string table_named(const std::string& name) {
  if (name == "study") return table_of<StudyDefinition, DepthSettings>();
  if (name == "depth")
    return table_of<sensors::PinholeCamera, sensors::SensorRange, PinholeSource, FileSource, FileEstimate,
                    StereoSource, PanoramaSource, DepthChain, sensors::DepthBuffer>();
  if (name == "depth.pose") return table_of<SensorPose>();
  if (name == "depth.noise") return noise_table();
  if (name == "depth.repair") return repair_table();
  if (name == "mitigation") return table_of<Mitigation>();
  if (name == "pipeline") return table_of<Pipeline>();
  if (name == "view") return table_of<View, LensSheet>();
  if (name == "scene") return table_of<SceneDefinition, EnvironmentDefinition>();
  if (name == "sun") return table_of<SunDefinition>();
  if (name == "lamp") return table_of<LampDefinition>();
  if (name == "camera") return table_of<CameraDefinition>();
  if (name == "object") return table_of<ObjectDefinition>();
  if (name == "session") return table_of<SessionDefinition>();
  if (name == "level") return table_of<LevelDefinition>();
  if (name == "clip") return table_of<ClipDefinition>();
  if (name == "path") return path_table();
  if (name == "node") return table_of<PlacedNode>();
  if (name == "animation") return table_of<FileAnimation>();
  if (name == "look") return table_of<LookDefinition>();
  if (name == "task") return table_of<TaskDefinition>();
  if (name == "staircase") return table_of<StaircaseDefinition>();
  if (name == "quest_plus") return table_of<QuestPlusDefinition>();
  if (name == "observer") return table_of<ObserverDefinition>();
  if (name == "condition") return table_of<ConditionDefinition>();
  if (name == "people") return people_table();
  if (name == "recruitment") return recruitment_table();
  if (name == "language") return table_of<LanguageDefinition>();
  if (name == "analysis") return table_of<AnalysisDefinition>();
  if (name == "catch") return table_of<CatchDefinition>();
  if (name == "analysis.clip") return table_of<LateFrames>();
  throw input_error(
      {.field = "<!-- settings " + name + " -->", .wanted = "the name of a table", .found = name});
}

}  // namespace

std::string with_settings_tables(const std::string& page) {
  const std::string begin = "<!-- settings ", close = " -->", end = "<!-- end -->";
  std::istringstream lines(page);
  std::string out, inside;
  for (std::string line; std::getline(lines, line);) {
    if (!inside.empty() && line != end) continue;
    inside.clear();
    out += line + "\n";
    if (!line.starts_with(begin) || !line.ends_with(close)) continue;
    inside = line.substr(begin.size(), line.size() - begin.size() - close.size());
    out += table_named(inside);
  }
  if (!inside.empty())
    throw input_error({.field = begin + inside + close, .wanted = end + " below it", .found = "none"});
  return out;
}

}  // namespace seamline::inline stimuli
