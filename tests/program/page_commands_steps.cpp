#include "page_commands_steps.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace seamline::page_commands {
namespace {

std::string without_spaces_before(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? "" : line.substr(begin);
}

/// Lines of a block; those that end in a backslash go on.
std::vector<std::string> joined_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  bool goes_on = false;
  for (std::string line; std::getline(in, line); goes_on = line.ends_with('\\'))
    if (goes_on)
      lines.back() += "\n" + line;
    else
      lines.push_back(without_spaces_before(line));
  return lines;
}

bool is_of_another_program(const std::string& line) {
  return std::any_of(other_programs.begin(), other_programs.end(),
                     [&](const OtherProgram& other) { return line.starts_with(other.begins); });
}

void add_file(std::vector<PageStep>& steps, const std::string& name, std::istringstream& words,
              const std::string& text) {
  if (name.starts_with("stimuli/")) return;  // a part of that study
  if (name != "append") return steps.push_back({PageStep::Kind::file, text, name});
  std::string file;
  words >> file;
  steps.push_back({PageStep::Kind::lines_of_file, text, file});
}

}  // namespace

const std::vector<NotRun>& not_run() {
  static const std::vector<NotRun> table = {
      {"documentation/how-to/check_the_observer.md", "seamline observe   ",
       "18 s; `seamline observe --pictures` on the same page says the same, and writes pictures"},
      {"documentation/evidence/remake.md", "seamline lab evidence all --out measured ",
       "minutes even with --small; pages of evidence run theirs by name"},
      {"documentation/evidence/remake.md",
       "seamline lab evidence stability --pages documentation/evidence   #",
       "measures for some minutes; Evidence.PagesAreRenewedFromTheTablesBesideThem has its last part"}};
  return table;
}

bool is_own(std::string_view line) {
  return line.starts_with("seamline ") || line.starts_with("build/release/seamline ");
}

std::vector<PageStep> steps_of(const test::ManualPage& page) {
  std::vector<PageStep> steps;
  for (const test::PageBlock& block : page.blocks) {
    std::istringstream words(block.kind);
    std::string language, name;
    words >> language >> name;
    if ((language == "toml" || language == "csv") && !name.empty()) {
      add_file(steps, name, words, block.text);
      continue;
    }
    if (!language.empty() && language != "sh") continue;
    const std::vector<std::string> lines = joined_lines(block.text);
    const bool has_command =
        language == "sh" || std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
          return is_own(line) || is_of_another_program(line);
        });
    for (const std::string& line : lines)
      if (has_command && !line.empty() && line.front() != '#')
        steps.push_back({is_own(line) ? PageStep::Kind::command : PageStep::Kind::other_program, line});
  }
  return steps;
}

bool has_commands(const test::ManualPage& page) {
  const std::vector<PageStep> steps = steps_of(page);
  return std::any_of(steps.begin(), steps.end(),
                     [](const PageStep& step) { return step.kind == PageStep::Kind::command; });
}

std::vector<std::string> words_of_line(const std::string& line) {
  std::string plain;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part);) {
    part = part.substr(0, part.find(" #"));
    if (part.ends_with('\\')) part.pop_back();
    plain += part + " ";
  }
  std::vector<std::string> words = test::words_of(plain);
  for (std::string& word : words) std::erase_if(word, [](char c) { return c == '"' || c == '\''; });
  return words;
}

namespace {

struct Replacement {
  std::string pattern, by;
};

/// In this order.
const std::vector<Replacement>& replacements() {
  static const std::vector<Replacement> table = {
      {R"(build/release/seamline)", "seamline"},
      // Places and words that stand for others.
      {R"(/shared/)", "shared/"},
      {R"(192\.168\.1\.20)", "127.0.0.1"},
      {R"(picture SCENE)", "picture room.gltf"},
      {R"(STIMULUS)", "bedroom-receiver-statue-0512"},
      {R"((RESULTS|FROM\.sqlite)\.\.\.)", "$1"},
      {R"((log (exclude|forget) LOG\.sqlite) CODE)", "$1 sim-0001"},
      // Smaller pictures of fewer samples.
      {R"(--spp [0-9]+)", "--spp 2"},
      {R"(--error 0\.00[0-9]+)", "--error 0.1"},
      {R"((seamline +(picture|composite|record|sense|lab marker) )(?![\s\S]*--(spp|error)))", "$1--spp 2 "},
      {R"((seamline composite ))", "$1--tolerance 1e-2 "},
      {R"((seamline picture )(?![\s\S]*--width))", "$1--width 96 --height 54 "},
      {R"(--size 800x600)", "--size 80x60"},
      {R"((seamline export x3d builtin:[a-z_]+ [a-z]+ )(?![\s\S]*--spp))", "$1--spp 2 "},
      {R"(--(view|size) [0-9]{3,}x[0-9]{3,})", "--$1 96x54"},
      {R"(--width (1024|4096) --height (512|2048))", "--width 128 --height 64"},
      {R"(--width (480|640) --height (270|360))", "--width 96 --height 54"},
      {R"(--width 1024)", "--width 128"},
      {R"(--frames [0-9]{2,})", "--frames 3"},
      // Fewer of what is simulated or tried.
      {R"((lab scenes .*)--count 10)", "$1--count 2"},
      {R"((seamline settle )(?![\s\S]*--frames ))", "$1--frames 3 --frames-to-rest 1 "},
      {R"((seamline lab convergence ))", "$1--seconds 2 "},
      {R"((seamline lab convergence )(?![\s\S]*--parts))", "$1--tolerances 1e-2 "},
      {R"((seamline lab marker ))", "$1--frames 3 "},
      {R"(--studies [0-9]+)", "--studies 5"},
      {R"((seamline plan )(?![\s\S]*--studies))", "$1--studies 2 "},
      {R"((seamline plan )(?![\s\S]*--participants))", "$1--participants 5,10 "},
      {R"((seamline freeze )(?![\s\S]*--participants))", "$1--studies 5 "},
      {R"((seamline analyze )(?![\s\S]*--frozen))", "$1--bootstrap 100 "},
      {R"(--no-seam-at 4096)", "--no-seam-at 512"},
      {R"((lab evidence [a-z_]+)(?![\s\S]*--(small|tables|pages)))", "$1 --small"}};
  return table;
}

}  // namespace

std::string smaller_line(std::string line) {
  for (const auto& [pattern, by] : replacements()) line = std::regex_replace(line, std::regex(pattern), by);
  return line;
}

std::vector<std::string> replaced_patterns() {
  std::vector<std::string> patterns;
  for (const Replacement& replacement : replacements()) patterns.push_back(replacement.pattern);
  return patterns;
}

namespace {

/// Three values of a list in brackets: every second one of a long list, the first ones of a short one.
std::string few_values(const std::string& list) {
  constexpr std::size_t few = 3;
  std::vector<std::string> values;
  std::istringstream in(list.substr(1, list.size() - 2));
  for (std::string value; std::getline(in, value, ',');) values.push_back(without_spaces_before(value));
  const std::size_t step = values.size() >= 2 * few - 1 ? 2 : 1;
  std::string kept;
  for (std::size_t i = 0; i < std::min(values.size(), step * few); i += step)
    kept += (kept.empty() ? "" : ", ") + values[i];
  return "[" + kept + "]";
}

/// A study's lines, table by table; the lines before the first one are the first.
std::vector<std::string> tables_of(const std::string& text) {
  std::vector<std::string> tables = {""};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (without_spaces_before(line).starts_with("[")) tables.emplace_back();
    tables.back() += line + "\n";
  }
  return tables;
}

bool begins_table(const std::string& table, const std::string& name) {
  return without_spaces_before(table).starts_with(name);
}

/// The artifacts of all scenes, each once, as a list in brackets.
std::string every_artifact(const std::string& text) {
  std::vector<std::string> names;
  const std::regex list(R"(\n *artifacts = \[([^\]]*)\])"), name(R"("[a-z_]+")");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), list); it != std::sregex_iterator(); ++it) {
    const std::string of_scene = (*it)[1];
    for (auto one = std::sregex_iterator(of_scene.begin(), of_scene.end(), name);
         one != std::sregex_iterator(); ++one)
      if (std::find(names.begin(), names.end(), one->str()) == names.end()) names.push_back(one->str());
  }
  std::string joined;
  for (const std::string& one : names) joined += (joined.empty() ? "" : ", ") + one;
  return "[" + joined + "]";
}

/// Without the tables of scenes and conditions behind the first ones.
std::string with_few_parts(const std::string& text) {
  constexpr int most_scenes = 1, most_conditions = 3;
  std::string kept;
  int scenes = 0, conditions = 0;
  for (const std::string& table : tables_of(text)) {
    if (begins_table(table, "[[scene]]")) ++scenes;
    if (begins_table(table, "[[condition]]")) ++conditions;
    if ((begins_table(table, "[[scene") || begins_table(table, "[scene")) && scenes > most_scenes) continue;
    if ((begins_table(table, "[[condition") || begins_table(table, "[condition")) &&
        conditions > most_conditions)
      continue;
    kept += table;
  }
  return kept;
}

}  // namespace

std::string smaller_study(const std::string& text, bool every_stimulus) {
  if (text.find("format = \"seamline study 1\"") == std::string::npos) return text;
  const auto number_of = [&](const char* key) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(std::string("(^|\n)") + key + " = ([0-9]+)"))
               ? std::stoi(found[2])
               : 0;
  };
  const int height_px = number_of("height_px");
  const bool is_panorama = height_px > 0 && number_of("width_px") == 2 * height_px;
  // Conditions may ask for an artifact that another scene has.
  const bool has_conditions = text.find("[[condition]]") != std::string::npos;
  const std::string artifacts = every_artifact(text);
  const std::regex key(R"(^( *)([a-z_]+) = (\[[^\]]*\]|[^ #]+))");
  std::string made;
  std::istringstream in(every_stimulus ? text : with_few_parts(text));
  for (std::string line; std::getline(in, line); made += line + "\n") {
    std::smatch part;
    if (!std::regex_search(line, part, key)) continue;
    const std::string name = part[2], value = part[3];
    std::string by = value;
    if (name == "width_px") by = is_panorama ? "128" : "96";
    if (name == "height_px") by = is_panorama ? "64" : "54";
    if (name == "samples_per_pixel") by = "2";
    if (name == "mesh_tolerance") by = "1e-2";
    if (name == "view_px") by = "[128, 72]";
    if (name == "frames") by = "4";
    if (name == "artifacts" && has_conditions && !every_stimulus) by = artifacts;
    if ((name == "depth_width_px" || name == "values") && value.front() == '[' && !every_stimulus)
      by = few_values(value);
    if (name == "depth_width_px" && value.front() != '[') by = "256";
    line = part[1].str().append(name).append(" = ").append(by).append(part.suffix());
    line = std::regex_replace(line, std::regex("(mask|matte)_width_px = 4096"), "$1_width_px = 256");
    line = std::regex_replace(line, std::regex(R"(panel_px = \[[0-9]+, [0-9]+\])"), "panel_px = [96, 54]");
    if (name == "samples_per_pixel" && text.find("mesh_tolerance") == std::string::npos)
      line += "\nmesh_tolerance = 1e-2";
  }
  return made;
}

}  // namespace seamline::page_commands
